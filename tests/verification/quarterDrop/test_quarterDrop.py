"""The drop with colloids of tutorials/interEvapDemFoam/sessileDroplet on a wedge with particles in space, and as a quarter
in space between planes of symmetry, on meshes of one cell size.

They differ in nothing but the mesh: the same volume at all times within 2 %, and the same share of the colloids at the rim
within the scatter of the number of colloids (three standard deviations of a binomial distribution of both).
"""
import re

import numpy as np
import pytest

from dewCase import run_command
from hotDroplet import A, CELLS, CORE, GROWN, OUTER, R, case, growth

def quarter_mesh(path):
    x = [0, CORE / CELLS * A, OUTER * A]
    n, g = (CORE, GROWN), (1, growth())

    def at(i, j, k):
        return i + 3 * (j + 3 * k)

    points = ' '.join(f'({x[i]!r} {x[j]!r} {x[k]!r})' for k in range(3) for j in range(3) for i in range(3))
    blocks = ' '.join(
        f'hex ({at(i, j, k)} {at(i+1, j, k)} {at(i+1, j+1, k)} {at(i, j+1, k)} {at(i, j, k+1)} {at(i+1, j, k+1)} '
        f'{at(i+1, j+1, k+1)} {at(i, j+1, k+1)}) ({n[i]} {n[j]} {n[k]}) simpleGrading ({g[i]} {g[j]} {g[k]})'
        for k in range(2) for j in range(2) for i in range(2))

    def plane(axis, value):
        faces = []
        for p in range(2):
            for q in range(2):
                corner = [(p, q), (p + 1, q), (p + 1, q + 1), (p, q + 1)]
                faces.append('(' + ' '.join(str(at(*(c[:axis] + (value,) + c[axis:]))) for c in corner) + ')')
        return ' '.join(faces)

    (path / 'system/blockMeshDict').write_text(
        'FoamFile { version 2.0; format ascii; class dictionary; object blockMeshDict; }\nscale 1;\n'
        f'vertices ({points});\nblocks ({blocks});\nboundary (\n'
        f'substrate {{ type wall; faces ({plane(2, 0)}); }}\n'
        f'outer {{ type patch; faces ({plane(0, 2)} {plane(1, 2)} {plane(2, 2)}); }}\n'
        f'front {{ type symmetryPlane; faces ({plane(0, 0)}); }}\nback {{ type symmetryPlane; faces ({plane(1, 0)}); }}\n);\n')
    for field in (path / '0').iterdir():
        field.write_text(re.sub(r'type(\s+)wedge;', r'type\1symmetryPlane;', field.read_text()))


def quarter_particles(path):
    """A quarter of the colloids at random in a quarter of the drop, and planes where the others would be."""
    random, x = np.random.default_rng(7), np.empty((0, 3))
    while len(x) < 78:
        p = random.uniform(R, A - R, 3)
        if p @ p < (A - R)**2 and (np.sum((x - p)**2, axis=1) > (2.1 * R)**2).all():
            x = np.vstack([x, p])
    (path / 'constant/particles.csv').write_text(
        'x,y,z,d\n' + ''.join(f'{p[0]!r},{p[1]!r},{p[2]!r},{2*R!r}\n' for p in x.tolist()))
    colloids = path / 'constant/colloids'
    text = re.sub(r'(?s)\n    colloids\n    \{.*?\n    \}\n\}',
                  '\n    colloids { type file; file "constant/particles.csv"; material latex; }\n}', colloids.read_text())
    assert 'type file' in text
    colloids.write_text(text)
    properties = path / 'constant/particleProperties'
    text = properties.read_text().replace('walls\n{', 'walls\n{\n' + ''.join(
        f'    {name} {{ type plane; point (0 0 0); normal {n}; material latex; }}\n'
        for name, n in (('front', '(1 0 0)'), ('back', '(0 1 0)'))))
    properties.write_text(text)


def dried(path):
    for command in (['blockMesh'], ['setSphericalCap'], ['setFields']):
        done = run_command(command, path, 120)
        assert done.code == 0, done.output[-2000:]
    done = run_command(['interEvapDemFoam'], path, 3000)
    assert done.code == 0 and 'has dried' in done.output, done.output[-3000:]
    ledger = np.loadtxt(path / 'postProcessing/evaporation/0/ledger.dat')
    deposit = np.loadtxt(path / 'postProcessing/deposit/0/deposit.dat')
    return ledger[:, 0], ledger[:, 7], deposit[-1]


@pytest.mark.slow
def test_wedge_and_quarter(tmp_path):
    wedge = case(tmp_path / 'wedge')
    quarter = case(tmp_path / 'quarter')
    quarter_mesh(quarter)
    quarter_particles(quarter)
    time, volume, deposit = dried(wedge)
    time3, volume3, deposit3 = dried(quarter)
    assert deposit[1] == 312 and deposit3[1] == 78

    common = np.linspace(0, min(time[-1], time3[-1]), 50)[1:-1]
    difference = np.interp(common, time3, volume3) - np.interp(common, time, volume)
    print('volume', np.abs(difference).max() / volume[0], 'life', time3[-1] / time[-1], 'rim', deposit[3], deposit3[3])
    assert np.abs(difference).max() < 0.02 * volume[0]
    assert abs(time3[-1] / time[-1] - 1) < 0.02
    share = 0.5 * (deposit[3] + deposit3[3])
    assert abs(deposit[3] - deposit3[3]) < 3 * np.sqrt(share * (1 - share) * (1 / 312 + 1 / 78))
