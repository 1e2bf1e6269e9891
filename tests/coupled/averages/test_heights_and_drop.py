"""bedHeight and pressureDrop: tables against closed forms, written beside each test. Twelve digits are in the files."""
import numpy as np
import pytest

from averagesCase import build
from dewCase import Case, changed, quoted
from fluidCase import FluidCase

MM = 1e-3
GLASS = {'youngsModulus': 5e6, 'poissonsRatio': 0.3, 'density': 2500.0}


def table(case, name, kind, start='0'):
    return np.loadtxt(case.path / 'postProcessing' / name / start / f'{kind}.dat', ndmin=2)


# --- Heights

BED = {'type': 'bedHeight', 'libs': '(dewFunctionObjects)', 'direction': (0, 0, 2), 'binHeight': 1 * MM}


def bed(path, x, d, entries, ranks=1, velocity='(0 0 0)'):
    case = Case(path, upper=(20 * MM,)*3, cells=(4, 4, 4), deltaT=1e-3, endTime=2e-3, functions={'bed': entries})
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': d})
    case.properties = {
        'engine': 'prescribed', 'materials': {'glass': GLASS}, 'velocity': f'constant {velocity}',
        'insertion': {'all': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'glass'}},
        'output': ()}
    case.mesh()
    if ranks > 1:
        case.decompose(ranks)
    done = case.run('demFoam', ranks=ranks)
    assert done.code == 0, done.output
    return table(case, 'bed', 'bedHeight')


def layers(n, d=MM, base=0.0):
    return np.array([[(i + 4.5) * d, (j + 4.5) * d, base + (k + 0.5) * d] for i in range(3) for j in range(3)
                     for k in range(n)])


@pytest.mark.parametrize('bins, top', [(1, 10), (0.5, 10), (0.25, 9.925)], ids=['d', 'd2', 'd4'])
@pytest.mark.parametrize('ranks', [1, 2])
def test_even_bed(tmp_path, bins, top, ranks):
    """Ten layers on each other: twice the mean is the height, nine tenths lie below nine layers. With bins of a quarter
    of a diameter a layer has 5, 11, 11, 5 of 32 parts: the last bin falls to a half, 4/5 of it, 0.2 beyond its middle.
    Where two layers touch, the volume below changes with the square of the height: 1e-5 of a diameter."""
    rows = bed(tmp_path, layers(10), MM, {**BED, 'binHeight': bins * MM, 'share': 0.9}, ranks)
    assert np.allclose(rows[:, 0], [1e-3, 2e-3]) and np.all(rows[:, 1] == 90)
    assert np.allclose(rows[:, 2], 10 * MM, rtol=1e-10)
    assert np.allclose(rows[:, 3], 9 * MM, rtol=0, atol=1e-5 * MM)
    assert np.allclose(rows[:, 4], top * MM, rtol=1e-9)


def test_other_direction_base_and_sizes(tmp_path):
    """Along -x from a base at 15 mm: a large sphere below, a small one above; half of the large one is 4/9 of all. Half
    of the volume lies where z^2 (3 - 2 z) = 9/16 (z in diameters)."""
    x = np.array([[13, 10, 10], [8, 10, 10]]) * MM
    d = np.array([2, 1]) * MM
    entries = {**BED, 'direction': (-1, 0, 0), 'base': (15 * MM, 0, 0), 'share': 4 / 9}
    rows = bed(tmp_path / 'a', x, d, entries)
    assert np.allclose(rows[0, 1:4], [2, 2 * (8 * 2 + 1 * 7) / 9 * MM, 2 * MM], rtol=1e-8)
    z = np.roots([-2, 3, 0, -9 / 16])
    z = float(next(r.real for r in z if abs(r.imag) < 1e-12 and 0 < r.real < 1))
    rows = bed(tmp_path / 'b', x, d, {**entries, 'share': 0.5})
    assert np.isclose(rows[0, 3], (1 + 2 * z) * MM, rtol=1e-8)


def test_a_single_particle_high_up(tmp_path):
    """It moves the share of all, not the profile. Then all rise with 1 m/s, a layer a step: of the n layers up to the
    mean one and two are empty, so that half of the bed's value is (n-1)/2n and (n-2)/2n of a layer's."""
    x = np.vstack([layers(10), [[10 * MM, 10 * MM, 16 * MM]]])
    rows = bed(tmp_path / 'rest', x, MM, {**BED, 'share': 1})
    assert np.allclose(rows[:, 3], 16.5 * MM, rtol=1e-7)
    assert np.allclose(rows[:, 4], 10 * MM, rtol=1e-9)
    rows = bed(tmp_path / 'rise', x, MM, {**BED, 'share': 1}, velocity='(0 0 1)')
    means = [(90 * 5 + 16) / 91 + k for k in (1, 2)]
    n = [round(m) for m in means]
    half = [0.5 * (n[0] - 1) / n[0], 0.5 * (n[1] - 2) / n[1]]
    assert np.allclose(rows[:, 2], [2 * m * MM for m in means], rtol=1e-9)
    assert np.allclose(rows[:, 3], [17.5 * MM, 18.5 * MM], rtol=1e-7)
    assert np.allclose(rows[:, 4], [(10.5 + 1 - half[0]) * MM, (11.5 + 1 - half[1]) * MM], rtol=1e-9)


@pytest.mark.parametrize('changes, words', [
    ({'binHeight': 0}, ("'binHeight'", 'greater than zero', 'controlDict')),
    ({'binHeight': None}, ("'binHeight'", 'Add')),
    ({'share': 95}, ("'share'", 'between 0')),
    ({'up': 1}, ("'up'", 'direction')),
    ({'binHeight': 1e-12}, ('bins', 'larger binHeight'))],
    ids=['bin', 'missing', 'share', 'unknown', 'many'])
def test_heights_refused(tmp_path, changes, words):
    with pytest.raises(AssertionError) as error:
        bed(tmp_path, layers(1), MM, changed(BED, changes))
    for word in words:
        assert word in str(error.value)


# --- Pressure

DROP = {'type': 'pressureDrop', 'libs': '(dewFunctionObjects)', 'from': {'patches': '(zMin)'},
        'to': {'patches': '("z.ax")'}, 'writeControl': 'writeTime'}


def duct(path, entries, ranks=1, **control):
    """Fluid of 1000 kg/m3 between slip walls, accelerated by p = 2 + 1000 t at one end and 0.5 at the other [m2/s2]:
    uniform, p linear in z."""
    case = FluidCase(path, rho=1000, tolerance=1e-13, upper=(4 * MM, 4 * MM, 8 * MM), cells=(4, 2, 8),
                     gravity=(0, 0, 0), functions={'drop': entries},
                     **{'deltaT': 1e-5, 'endTime': 1e-4, 'writeInterval': 5, 'writePrecision': 17, **control})
    free = {'type': 'zeroGradient'}
    case.patches['U'] = {name: {'type': 'slip'} for name in ('xMin', 'xMax', 'yMin', 'yMax')} | {'zMin': free,
                                                                                                 'zMax': free}
    case.patches['p'] = {name: free for name in ('xMin', 'xMax', 'yMin', 'yMax')} | {
        'zMin': {'type': 'uniformFixedValue', 'uniformValue': 'table ((0 2) (1 1002))', 'value': 'uniform 2'},
        'zMax': {'type': 'fixedValue', 'value': 'uniform 0.5'}}
    case.particles({'x': 2 * MM, 'y': 2 * MM, 'z': 4 * MM, 'd': 0.1 * MM})
    case.properties = {
        'engine': 'prescribed', 'materials': {'glass': GLASS},
        'insertion': {'all': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'glass'}},
        'output': (), 'coupling': {'voidFraction': {'type': 'particleCentre'}, 'momentum': 'none', 'forces': {}}}
    case.mesh()
    if ranks > 1:
        case.decompose(ranks)
    return case


def run(case, ranks=1):
    done = case.run('cfdDemFoam', ranks=ranks)
    assert done.code == 0, done.output
    return done.output


T = np.arange(1, 11) * 1e-5
DP = 1000 * (1.5 + 1000 * T)


@pytest.mark.parametrize('ranks', [1, 2])
def test_between_patches(tmp_path, ranks):
    """dp = rho (1.5 + 1000 t); the mean over steps from 4e-5 s on is that of their ends. The particle, 1e-3 of its
    cell, bends p by less than 1e-3 of it, and patches not at all."""
    case = duct(tmp_path, {**DROP, 'averageStart': 4e-5}, ranks)
    output = run(case, ranks)
    rows = table(case, 'drop', 'pressureDrop')
    assert np.allclose(rows[:, 0], T)
    assert np.allclose(rows[:, 1:4], np.stack([DP + 500, 500 + 0 * DP, DP], axis=1), rtol=1e-9)
    assert np.all(rows[:4, 4] == 0)
    assert np.allclose(rows[4:, 4], [DP[4:k].mean() for k in range(5, 11)], rtol=1e-9)
    assert output.count('drop: pressure drop') == 2
    assert 'drop: pressure drop 1600 Pa, mean 1575 Pa over 6e-05 s' in output


def test_plane_and_point(tmp_path):
    """p of the cells is linear: 5/16 of the way up for the plane through the third row and the point in it."""
    expected = 1000 * (0.5 + (1.5 + 1000 * T) * (1 - 5 / 16))
    for name, place in (('plane', {'plane': {'point': (0, 0, 2.3 * MM), 'normal': (0, 0, 1)}}),
                        ('point', {'point': (0.5 * MM, 3 * MM, 2.3 * MM)})):
        case = duct(tmp_path / name, {**DROP, 'from': place}, 2)
        run(case, 2)
        assert np.allclose(table(case, 'drop', 'pressureDrop')[:, 1], expected, rtol=2e-3), name


@pytest.mark.parametrize('z, normal, mean', [(4, (-1, 0, 1), 4), (4.1, (-1, 0, 1), 4.1), (3, (0, 0, 1), 3.5),
                                             (3, (0, 0, -1), 2.5)], ids=['edges', 'tilted', 'faces', 'below'])
def test_planes(tmp_path, z, normal, mean):
    """Tilted, a plane rises in x from 2 to 6 mm: through edges of the cells its mean is that of the middle; 0.1 higher
    it is for a tenth in those above. On faces it has the cells on the side of its normal."""
    place = {'plane': {'point': (2 * MM, 2 * MM, z * MM), 'normal': normal}}
    case = duct(tmp_path, {**DROP, 'from': place})
    run(case)
    expected = 1000 * (0.5 + (1.5 + 1000 * T) * (1 - mean / 8))
    assert np.allclose(table(case, 'drop', 'pressureDrop')[:, 1], expected, rtol=2e-4)


def test_mean_goes_on_after_a_restart(tmp_path):
    case = duct(tmp_path, DROP, endTime=5e-5)
    run(case)
    case.control['endTime'] = 1e-4
    case.write_dict('system/controlDict', case.control)
    run(case)
    rows = table(case, 'drop', 'pressureDrop', '5e-05')
    assert np.allclose(rows[:, 4], [DP[:k].mean() for k in range(6, 11)], rtol=1e-9)


@pytest.mark.parametrize('changes, words', [
    ({'from/patches': '(inlet)'}, ("'inlet'", 'zMin', 'controlDict')),
    ({'field': 'p_rgh'}, ("'p_rgh'", 'Fields are', 'alphac')),
    ({'field': 'alphac'}, ("'alphac'", 'm2/s2')),
    ({'from/point': (0, 0, 0)}, ("'from'", 'one of')),
    ({'from': {'point': (1, 1, 1)}}, ("'from'", 'no cell')),
    ({'from': {'line': 1}}, ("'line'", 'patches')),
    ({'to': None}, ("'to'",)),
    ({'start': 1}, ("'start'", 'averageStart'))],
    ids=['patch', 'field', 'dimensions', 'two', 'outside', 'place', 'missing', 'unknown'])
def test_drop_refused(tmp_path, changes, words):
    case = duct(tmp_path, changed(DROP, changes), endTime=1e-5)
    done = case.run('cfdDemFoam')
    assert done.code != 0 and done.output.count('ERROR') == 1, done.output
    for word in words:
        assert word in done.output, done.output


def test_drop_refused_without_fluid(tmp_path):
    case = build(tmp_path, {'x': 1 * MM, 'y': 1 * MM, 'z': 1 * MM, 'd': 0.1 * MM}, (), functions={'drop': DROP},
                 deltaT=1e-6, endTime=1e-6)
    done = case.run('demFoam')
    assert done.code != 0 and 'finds no fluid' in done.output, done.output
