"""The function object depositStatistics against numbers counted by hand, on one and on two ranks.

Eight prescribed particles of 1 um over a substrate at z = 1 um, axis at (20, 20) um, contact radius 10 um. By hand:

    r [um]        0    3    9.5  8    2    9.2  11   9.9
    gap [nm]      10   10   10   60   200  40   30   49.9

With gap 50 nm six are deposited, all but those with 60 and 200; beyond the rim at 9 um are 9.5, 9.2, 11 and 9.9, all of
them deposited. The mean radius is 52.6/8 um, that of those deposited 42.6/6 um. In four rings of 2.5 um, of area pi 6.25
(1, 3, 5, 7) um2, lie 2, 1, 0 and 4 (deposited 1, 1, 0, 3), and 1 beyond them.
"""
import numpy as np
import pytest

from dewCase import Case, changed, quoted

UM = 1e-6
R = np.array([0, 3, 9.5, 8, 2, 9.2, 11, 9.9])
GAP = np.array([10, 10, 10, 60, 200, 40, 30, 49.9])
AREA = np.pi * 6.25 * np.array([1, 3, 5, 7]) * UM**2
ROW = [8, 6 / 8, 4 / 8, 4 / 6, 52.6 / 8 * UM, 42.6 / 6 * UM]

ENTRIES = {'type': 'depositStatistics', 'libs': '(dewFunctionObjects)', 'centre': (20 * UM, 20 * UM, UM),
           'normal': (0, 0, 2), 'contactRadius': 10 * UM, 'rings': 4, 'writeControl': 'writeTime'}


def build(path, entries, azimuth=0.0, tilted=False, ranks=1):
    """Particles around the axis, the first at an azimuth; or all of it turned from z to x."""
    case = Case(path, upper=(40 * UM,)*3, cells=(4, 4, 4), deltaT=1e-6, endTime=4e-6, writeInterval=2,
                functions={'deposit': entries})
    azimuth = azimuth + 0.7 * np.arange(len(R))
    position = {'x': 20 * UM + R * UM * np.cos(azimuth), 'y': 20 * UM + R * UM * np.sin(azimuth),
                'z': UM + GAP * 1e-9 + 0.5 * UM}
    if tilted:
        position = {'x': position['z'], 'y': position['x'], 'z': position['y']}
    case.particles({**position, 'd': UM})
    case.properties = {
        'engine': 'prescribed', 'materials': {'latex': {'youngsModulus': 1e7, 'poissonsRatio': 0.3, 'density': 1000.0}},
        'insertion': {'all': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'latex'}},
        'output': ()}
    case.mesh()
    if ranks > 1:
        case.decompose(ranks)
    return case


def rows(case, name, start='0'):
    return np.loadtxt(case.path / 'postProcessing' / 'deposit' / start / name, ndmin=2)


@pytest.mark.parametrize('azimuth, tilted, ranks', [(0, False, 1), (2.2, False, 1), (0, True, 1), (0, False, 2)],
                         ids=['x', 'azimuth', 'tilted', 'ranks'])
def test_counted_by_hand(tmp_path, azimuth, tilted, ranks):
    entries = dict(ENTRIES)
    if tilted:
        entries.update(centre=(UM, 20 * UM, 20 * UM), normal=(1, 0, 0))
    case = build(tmp_path, entries, azimuth, tilted, ranks)
    done = case.run('demFoam', ranks=ranks)
    assert done.code == 0, done.output

    # A line each of four steps; 12 digits in the file
    table = rows(case, 'deposit.dat')
    assert np.allclose(table[:, 0], [1e-6, 2e-6, 3e-6, 4e-6], rtol=1e-9, atol=0)
    assert np.allclose(table[:, 1:], ROW, rtol=1e-10, atol=0)

    # A line at each of two write times
    density, deposited = rows(case, 'density.dat'), rows(case, 'depositedDensity.dat')
    assert np.allclose(density[:, 0], [2e-6, 4e-6], rtol=1e-9, atol=0)
    assert np.allclose(density[:, 1:5], [2, 1, 0, 4] / AREA, rtol=1e-10, atol=0)
    assert np.allclose(deposited[:, 1:5], [1, 1, 0, 3] / AREA, rtol=1e-10, atol=0)
    assert np.all(density[:, 5] == 1) and np.all(deposited[:, 5] == 1)


def test_gap_rim_and_no_particles_there(tmp_path):
    """Other gap and rim; the substrate far below them: none deposited, and no division by none."""
    case = build(tmp_path / 'gap', changed(ENTRIES, {'gap': 2e-8, 'rim': 0.94}))
    done = case.run('demFoam')
    assert done.code == 0, done.output
    assert np.allclose(rows(case, 'deposit.dat')[0, 1:5], [8, 3 / 8, 3 / 8, 1 / 3], rtol=1e-10, atol=0)

    case = build(tmp_path / 'far', changed(ENTRIES, {'centre': (20 * UM, 20 * UM, -UM)}))
    done = case.run('demFoam')
    assert done.code == 0, done.output
    assert np.allclose(rows(case, 'deposit.dat')[0, 1:], [8, 0, 0.5, 0, ROW[4], 0], rtol=1e-10, atol=0)


def test_a_restart_has_a_file_of_its_own(tmp_path):
    case = build(tmp_path, ENTRIES)
    assert case.run('demFoam').code == 0
    case.control['endTime'] = 6e-6
    case.write_dict('system/controlDict', case.control)
    done = case.run('demFoam')
    assert done.code == 0, done.output
    assert len(rows(case, 'deposit.dat')) == 4
    assert np.allclose(rows(case, 'deposit.dat', '4e-06')[:, 0], [5e-6, 6e-6], rtol=1e-9, atol=0)


@pytest.mark.parametrize('changes, words', [
    ({'contactRadius': 0}, ("'contactRadius'", 'greater than zero', 'controlDict')),
    ({'normal': (0, 0, 0)}, ("'normal'", 'length greater than zero')),
    ({'rim': 90}, ("'rim'", 'between 0')),
    ({'rings': 2.5}, ("'rings'", 'whole number')),
    ({'radius': 1}, ("'radius'", 'contactRadius')),
    ({'centre': None}, ("'centre'", 'Add'))],
    ids=['radius', 'normal', 'rim', 'rings', 'unknown', 'missing'])
def test_refused(tmp_path, changes, words):
    case = build(tmp_path, changed(ENTRIES, changes))
    done = case.run('demFoam')
    assert done.code != 0 and done.output.count('ERROR') == 1
    for word in words:
        assert word in done.output, done.output
    assert not case.times()
