"""What the run writes: the cloud as OpenFOAM's own tools see it, the VTK series, the table, at three scales."""
import re

import numpy as np
import pytest

from dewCase import Case

MATERIAL = {'youngsModulus': 1e7, 'poissonsRatio': 0.3, 'density': 2500.0}


def foam_vectors(path):
    """Vectors of an ASCII field or positions file."""
    text = path.read_text()
    body = text[text.index('// * *'):]
    uniform = re.search(r'\n(\d+)\{\(([^)]*)\)\}', body)
    if uniform:
        return np.tile([float(v) for v in uniform[2].split()], (int(uniform[1]), 1))
    return np.array([[float(v) for v in m.groups()]
                     for m in re.finditer(r'\(([-+.\deE]+) ([-+.\deE]+) ([-+.\deE]+)\)', body)])


def packed(path, scale, ranks):
    """40 particles in a box of cells of 1e-3 scale."""
    case = Case(path, upper=(4e-3 * scale,)*3, cells=(4, 4, 4), deltaT=1e-4 * scale, endTime=2e-4 * scale,
                writeInterval=1, writeFormat='ascii', writePrecision=16, timePrecision=12)
    case.properties = {'engine': 'liggghts', 'materials': {'glass': MATERIAL},
                       'contacts': {'default': {'restitution': 0.5, 'friction': 0.3}},
                       'insertion': {'bed': {'type': 'packed', 'material': 'glass', 'number': 40,
                                             'velocity': (0.1, 0.05, 0),
                                             'diameter': {'type': 'mono', 'value': 3e-4 * scale},
                                             'region': {'type': 'box', 'min': (0, 0, 0), 'max': (4e-3 * scale,)*3}}},
                       'output': ('cloud', 'vtk', 'csv')}
    case.mesh()
    if ranks > 1:
        case.decompose(ranks)
    done = case.run('demFoam', ranks=ranks)
    assert done.code == 0, done.output
    return case


@pytest.mark.parametrize('scale', [1e-3, 1, 1e3])
@pytest.mark.parametrize('ranks', [1, 2])
def test_cloud_is_where_the_particles_are(tmp_path, scale, ranks):
    """Positions and velocities of the cloud, after reconstructPar, are those of the table; 1 um cells, too."""
    case = packed(tmp_path, scale, ranks)
    if ranks > 1:
        done = case.run('reconstructPar', '-latestTime')
        assert done.code == 0, done.output
    rows = case.table(2e-4 * scale)
    cloud = case.path / case.times()[-1] / 'lagrangian' / 'particles'
    text = (cloud / 'id').read_text()
    ids = np.array(re.search(r'\n\d+\s*\(([\d\s]+)\)', text)[1].split(), dtype=int)
    order = np.argsort(ids)
    assert np.array_equal(ids[order], rows['id'])
    x = foam_vectors(cloud / 'positions')[order]
    v = foam_vectors(cloud / 'U')[order]

    # blockMesh counts the cells along x, then y, then z
    cells = np.array(re.findall(r'\) (\d+)\n', (cloud / 'positions').read_text()), dtype=int)[order]
    i, j, k = (np.floor(x / (1e-3 * scale)).astype(int)).T
    assert np.array_equal(cells, i + 4 * j + 16 * k)
    assert np.abs(x - np.stack([rows[k] for k in 'xyz'], 1)).max() < 1e-12 * 4e-3 * scale
    assert np.abs(v - np.stack([rows['v' + k] for k in 'xyz'], 1)).max() < 1e-12


def test_foamToVTK_reads_the_cloud(tmp_path):
    case = packed(tmp_path, 1, 1)
    done = case.run('foamToVTK', '-latestTime', '-name', 'converted')
    assert done.code == 0, done.output
    assert 'vector: U' in done.output


@pytest.mark.parametrize('ranks', [1, 2])
def test_vtk_series(tmp_path, ranks):
    """Start and two times; the points of the last are those of the table."""
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
    from vtkmodules.util.numpy_support import vtk_to_numpy

    case = packed(tmp_path, 1, ranks)
    text = (case.path / 'VTK' / 'particles.pvd').read_text()
    frames = re.findall(r'timestep="([^"]+)" part="(\d+)" file="([^"]+)"', text)
    assert [float(t) for t, part, _ in frames if part == '0'] == [0, 1e-4, 2e-4]
    assert len(frames) == 3 * ranks

    ids, points = [], []
    for t, _, name in frames:
        if float(t) == 2e-4:
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(str(case.path / 'VTK' / name))
            reader.Update()
            data = reader.GetOutput()
            if data.GetNumberOfPoints():
                ids.append(vtk_to_numpy(data.GetPointData().GetArray('id')))
                points.append(vtk_to_numpy(data.GetPoints().GetData()))
    ids, points = np.concatenate(ids), np.concatenate(points)
    order = np.argsort(ids)
    rows = case.table(2e-4)
    assert np.array_equal(ids[order], rows['id'])
    assert np.array_equal(points[order], np.stack([rows[k] for k in 'xyz'], 1))


def test_table_is_read_back_by_insertion(tmp_path):
    """A case that starts from the table of another holds the same particles."""
    first = packed(tmp_path / 'first', 1, 1)
    second = Case(tmp_path / 'second', upper=(4e-3,)*3, gravity=(0, 0, 0), deltaT=1e-9, endTime=1e-9, writeInterval=1,
                  timePrecision=12)
    second.properties = {**first.properties, 'output': ('csv',), 'timeStep': {'deltaT': 1e-9},
                         'insertion': {'bed': {'type': 'file', 'file': '"constant/particles.csv"'}}}
    second.mesh()
    second.write_file('constant/particles.csv', (first.path / first.times()[-1] / 'particles.csv').read_text())
    done = second.run('demFoam')
    assert done.code == 0, done.output
    # Numbers are given anew: compare in the order of x
    a, b = (np.sort(table, order='x') for table in (first.table(2e-4), second.table(1e-9)))
    for k in ('vx', 'vy', 'vz', 'd'):
        assert np.allclose(a[k], b[k], rtol=1e-14, atol=1e-12)
    assert np.abs(a['x'] - b['x']).max() < 1e-9
