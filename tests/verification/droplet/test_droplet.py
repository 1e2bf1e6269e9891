"""The beginning of the tutorial sessileDroplet on a coarse mesh and two ranks, put together and read as ParaView reads it."""
import re
import shutil

import numpy as np
import pytest

from dewCase import ROOT, run_command

TUTORIAL = ROOT / 'tutorials' / 'interEvapDemFoam' / 'sessileDroplet'
A, R = 25e-6, 0.5e-6
END = 2e-5


def must(case, *command):
    done = run_command(command, case, 200)
    assert done.code == 0, done.output[-3000:]


@pytest.fixture(scope='module')
def dropped(tmp_path_factory):
    """12 cells a radius, 20 us."""
    case = tmp_path_factory.mktemp('droplet') / 'case'
    shutil.copytree(TUTORIAL / 'common', case)
    shutil.copytree(TUTORIAL / 'hot', case, dirs_exist_ok=True)
    path = case / 'system' / 'mesh'
    text = path.read_text()
    for key, value in {'coreRadial': 13, 'coreAxial': 13, 'outerRadial': 12, 'outerAxial': 12}.items():
        text, n = re.subn(rf'^{key} .*;', f'{key} {value};', text, flags=re.M)
        assert n == 1
    path.write_text(text)
    path = case / 'system' / 'times'
    text = re.sub(r'^endTime .*;', f'endTime {END};', path.read_text(), flags=re.M)
    path.write_text(re.sub(r'^writeInterval .*;', 'writeInterval 1e-5;', text, flags=re.M))
    shutil.copytree(case / '0.orig', case / '0')
    for command in ('blockMesh', 'setSphericalCap', 'setFields', 'decomposePar'):
        must(case, command)
    done = run_command(['mpirun', '-np', '2', 'interEvapDemFoam', '-parallel'], case, 400)
    assert done.code == 0, done.output[-3000:]
    (case / 'log').write_text(done.output)
    must(case, 'reconstructPar')
    return case


def blocks(data):
    """Leaves of a multi-block data set by name"""
    found = {}
    for i in range(data.GetNumberOfBlocks()):
        name = data.GetMetaData(i).Get(data.NAME())
        block = data.GetBlock(i)
        found.update(blocks(block) if hasattr(block, 'GetNumberOfBlocks') else {name: block})
    return found


def test_openfoam_reader_of_vtk(dropped):
    """Fields in all cells, alpha the volume of a hemisphere within its loss of 0.2 %; every particle, with the values of
    the table, at its place folded onto the wedge."""
    from vtkmodules.vtkIOGeometry import vtkOpenFOAMReader
    from vtkmodules.util.numpy_support import vtk_to_numpy

    (dropped / 'case.foam').touch()
    reader = vtkOpenFOAMReader()
    reader.SetFileName(str(dropped / 'case.foam'))
    reader.UpdateInformation()
    times = vtk_to_numpy(reader.GetTimeValues())
    assert abs(times[-1] / END - 1) < 0.01
    reader.UpdateTimeStep(times[-1])
    reader.EnableAllPatchArrays()
    reader.EnableAllCellArrays()
    reader.EnableAllLagrangianArrays()
    reader.CreateCellToPointOff()
    reader.Update()
    found = blocks(reader.GetOutput())

    cells = found['internalMesh'].GetCellData()
    field = {name: vtk_to_numpy(cells.GetArray(name)) for name in ('T', 'U', 'p', 'Y.water', 'alpha.water')}
    assert {len(values) for values in field.values()} == {25**2}
    assert 330 < field['T'].min() and field['T'].max() < 646.1
    assert field['alpha.water'].min() == 0 and field['alpha.water'].max() == 1
    assert 0.1 < field['Y.water'].max() < 1
    speed = np.linalg.norm(field['U'], axis=1)
    assert 5e-4 < speed.max() < 0.05

    cloud = found['particles']
    x = vtk_to_numpy(cloud.GetPoints().GetData())
    data = cloud.GetPointData()
    ids = vtk_to_numpy(data.GetArray('id')).astype(int)
    assert sorted(ids) == list(range(1, 313))
    assert np.allclose(vtk_to_numpy(data.GetArray('d')), 2*R, rtol=1e-6)

    last = max((p for p in dropped.iterdir() if (p / 'particles.csv').exists()), key=lambda p: float(p.name))
    table = np.genfromtxt(last / 'particles.csv', delimiter=',', names=True, dtype=None, encoding=None)
    table = table[np.argsort(table['id'])]
    x = x[np.argsort(ids)]
    r = np.hypot(table['x'], table['y'])
    # The middle plane has radius r at r cos(1 degree); the reader has single precision
    assert np.abs(x[:, 2] - table['z']).max() < 1e-5 * A
    assert np.abs(x[:, 0] / np.cos(np.radians(1)) - r).max() < 1e-4 * A
    true = vtk_to_numpy(data.GetArray('inSpace'))[np.argsort(ids)]
    assert np.abs(true - np.array([table['x'], table['y'], table['z']]).T).max() < 1e-5 * A


def test_pace(dropped):
    """The last number of the last line is the time simulated over the wall clock."""
    line = [line for line in (dropped / 'log').read_text().splitlines() if ' simulated per s' in line][-1]
    time, wall, pace = (float(re.search(pattern, line)[1]) for pattern in (
        r'^Time = (\S+)', r'wall (\S+) s', r', (\S+) s simulated per s$'))
    assert abs(pace / (time / wall) - 1) < 0.05
