"""particleAverages: fields of the particles as a phase.

Expected values are closed forms of the particles put in, written beside each test; particles are read back from
particles.csv where they have moved. Tolerances: sums of N numbers are good to N ulp; forces to 1e-6, as the engine's
units and the step between two evaluations allow; a settled column to 2 %, of which the overlap of grains is 0.2 %.
"""
import numpy as np
import pytest

from averagesCase import GLASS, HEAVY, build, cells, hertz, run, sphere
from dewCase import quoted

L = 4e-3
ALL = ('alpha.particles', 'bulkDensity.particles', 'numberDensity.particles', 'U.particles', 'granularTemperature',
       'kineticStress', 'collisionalStress', 'contactNumber')
STEP = {'deltaT': 1e-6, 'endTime': 1e-6, 'writeInterval': 1}


def columns(x, **others):
    return {'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], **others}


def vectors(rows, names='vx vy vz'):
    return np.stack([rows[n] for n in names.split()], axis=1)


# --- Mass, velocity, temperature

def populations(path, offset, ranks=1, **changes):
    """Cells of 2 mm. The first has two glass and one heavy grain, the fourth one grain, the others none."""
    x = np.array([[0.5, 0.5, 0.5], [1.5, 1.5, 0.5], [0.5, 1.5, 1.5], [3.0, 3.0, 1.0]]) * 1e-3
    u = np.array([[2e-3, 0, 0], [-1e-3, 1e-3, 0], [0, -4e-3, 5e-3], [1, 2, 3]])
    v = u + offset
    data = columns(x, d=(3e-4, 4e-4, 2e-4, 5e-4), vx=v[:, 0], vy=v[:, 1], vz=v[:, 2], T=(300, 350, 400, 310),
                   material=('glass', 'glass', 'heavy', 'glass'))
    case = build(path, data, ALL + ('T.particles',), cells=(2, 2, 2), heat=True, ranks=ranks, **{**STEP, **changes})
    m = sphere(data['d']) * np.array([GLASS['density']] * 2 + [HEAVY['density'], GLASS['density']])
    return case, m, u, np.array(data['T']), sphere(data['d'])


@pytest.mark.parametrize('offset', [0, 100], ids=['slow', 'fast'])
@pytest.mark.parametrize('ranks', [1, 2])
def test_sums_by_hand(tmp_path, offset, ranks):
    """Velocities of some mm/s on top of 100 m/s too, where 1e-14 of the latter is left of the former: 1e-11 in the
    differences; the mean of the squares less the square of the mean would be wrong by 1e-6."""
    case, m, u, T, V = populations(tmp_path, offset * np.array([1, -1, 1]), ranks)
    run(case, ranks)
    get = {name: cells(case, name, ranks=ranks) for name in ALL + ('T.particles',)}
    volume = (L / 2)**3
    a = slice(0, 3)
    U = m[a] @ u[a] / m[a].sum()
    du = u[a] - U
    stress = np.einsum('i,ij,ik->jk', m[a], du, du)

    assert np.allclose(get['alpha.particles'][[0, 3]], [V[a].sum() / volume, V[3] / volume], rtol=1e-13)
    assert np.allclose(get['bulkDensity.particles'][[0, 3]], [m[a].sum() / volume, m[3] / volume], rtol=1e-12)
    assert np.allclose(get['numberDensity.particles'][[0, 3]], [3 / volume, 1 / volume], rtol=1e-13)
    assert np.allclose(get['U.particles'][0], U + offset * np.array([1, -1, 1]), rtol=1e-13, atol=1e-15)
    assert np.allclose(get['U.particles'][3], u[3] + offset * np.array([1, -1, 1]), rtol=1e-13)
    assert np.allclose(get['T.particles'][[0, 3]], [m[a] @ T[a] / m[a].sum(), 310], rtol=1e-9)
    theta = np.trace(stress) / (3 * m[a].sum())
    tolerance = 1e-12 if offset == 0 else 1e-10
    assert np.isclose(get['granularTemperature'][0], theta, rtol=tolerance)
    assert get['granularTemperature'][3] < 1e-20
    assert np.allclose(get['kineticStress'][0], stress[np.triu_indices(3)] / volume,
                       rtol=0, atol=tolerance * np.trace(stress) / volume)
    for name, values in get.items():
        assert np.all(np.isfinite(values)), name
        assert np.all(values[[1, 2, 4, 5, 6, 7]] == 0), name
    assert np.all(get['contactNumber'] == 0) and np.all(get['collisionalStress'] == 0)


def test_two_streams(tmp_path):
    """Two populations of opposite velocity: Theta is v0^2/3, the kinetic stress alpha rho v0 v0."""
    grid = (np.array(list(np.ndindex(4, 4, 4))) + 0.5) * 1e-3
    v0 = np.array([0.2, -0.1, 0.3])
    v = np.where(grid[:, :1] % 2e-3 < 1e-3, 1, -1) * v0
    case = build(tmp_path, columns(grid, d=5e-4, vx=v[:, 0], vy=v[:, 1], vz=v[:, 2]), ALL, cells=(2, 2, 2), **STEP)
    run(case)
    alpha = 8 * sphere(5e-4) / (L / 2)**3
    assert np.allclose(cells(case, 'granularTemperature'), v0 @ v0 / 3, rtol=1e-12)
    assert np.allclose(cells(case, 'kineticStress'), alpha * GLASS['density'] * np.outer(v0, v0)[np.triu_indices(3)],
                       rtol=1e-12)
    assert np.abs(cells(case, 'U.particles')).max() < 1e-15


def cloud(path, ranks=1, n_steps=1, average=None, fields=ALL, seed=3, **control):
    """A dense random bed between plates, in contact and moving; weights over several cells."""
    rng = np.random.default_rng(seed)
    x = (np.array(list(np.ndindex(8, 8, 8))) + 0.5) * 5e-4 + rng.uniform(-4e-6, 4e-6, (512, 3))
    v = rng.uniform(-0.1, 0.1, x.shape)
    write_floor(path, L)
    return build(path, columns(x, d=rng.uniform(4.95e-4, 5.02e-4, len(x)), vx=v[:, 0], vy=v[:, 1], vz=v[:, 2],
                                  T=300), fields,
                 'divided', cyclic='xy', cells=(4, 4, 4), average=average, ranks=ranks, gravity=(0, 0, -9.81),
                 walls={'floor': {'type': 'STL', 'file': quoted('constant/floor.stl'), 'material': 'glass'},
                        'lid': {'type': 'patch', 'patches': '(zMax)', 'material': 'glass'}},
                 **{'deltaT': 1e-5, 'endTime': n_steps * 1e-5, 'writeInterval': 1, **control})


def test_conservative_and_equal_on_ranks(tmp_path):
    """With shares over several cells: sums over cells are those over particles; two ranks give the same to 1e-10."""
    one, two = cloud(tmp_path / '1'), cloud(tmp_path / '2', 2)
    run(one)
    run(two, 2)
    rows = one.table(1e-5)
    V, volume = sphere(rows['d']), 1e-9
    momentum = GLASS['density'] * V @ vectors(rows)
    scale = GLASS['density'] * V @ np.abs(vectors(rows))
    assert np.isclose(cells(one, 'alpha.particles').sum() * volume, V.sum(), rtol=1e-11)
    assert np.isclose(cells(one, 'numberDensity.particles').sum() * volume, len(V), rtol=1e-12)
    found = cells(one, 'bulkDensity.particles') @ cells(one, 'U.particles') * volume
    assert np.abs(found - momentum).max() < 1e-10 * scale.max()

    contacts = cells(one, 'contactNumber') @ cells(one, 'numberDensity.particles') * volume
    assert np.isclose(contacts, 2 * pairs(rows), rtol=1e-12)
    for name in ALL:
        a, b = cells(one, name), cells(two, name, ranks=2)
        assert np.abs(a).max() > 0, name
        assert np.abs(a - b).max() < 1e-10 * np.abs(a).max(), name


def pairs(rows):
    """Number of touching pairs, cyclic in x and y."""
    dx = vectors(rows, 'x y z')[:, None] - vectors(rows, 'x y z')
    dx[..., :2] -= L * np.round(dx[..., :2] / L)
    close = np.linalg.norm(dx, axis=2) < 0.5 * (rows['d'][:, None] + rows['d'])
    return (close.sum() - len(rows)) // 2


@pytest.mark.parametrize('more', [{}, {'lubrication': {'viscosity': 1e-3, 'minGap': 1e-8, 'maxGap': 2e-5}}],
                         ids=['contacts', 'lubrication'])
def test_looking_changes_nothing(tmp_path, more):
    """A run that asks for contacts at every sub-step ends with the same bytes of restart as one that does not, also
    with friction, walls of both kinds, heat, and laws of our own that look at contacts."""
    digests = []
    for name, fields in (('without', ('alpha.particles',)), ('with', ALL)):
        case = cloud(tmp_path / name, n_steps=30, fields=fields, writeInterval=30, heat=True)
        case.properties.update(more)
        case.properties['walls']['floor']['T'] = 350
        case.write_dict('constant/particleProperties', case.properties)
        run(case)
        digests.append({k: v for k, v in case.digests().items() if 'uniform/particles/liggghts' in k or 'csv' in k})
    assert len(digests[0]) >= 2 and digests[0] == digests[1]


# --- Contacts

def test_two_spheres_pressed_together(tmp_path):
    """Hertz without damping; the branch is split in the ratio of the radii: 0.3 to 0.2, at whatever angle."""
    n = np.array([2, -1, 2]) / 3
    d, distance = np.array([6e-4, 4e-4]), 4.98e-4
    x = np.array([2e-3, 2e-3, 1e-3]) + np.outer([-0.6, 0.4], n) * distance
    case = build(tmp_path, columns(x, d=d), ('collisionalStress', 'contactNumber', 'alpha.particles'), cells=(2, 1, 1),
                 restitution=1.0, **STEP)
    run(case)
    rows = case.table(1e-6)
    x = vectors(rows, 'x y z')
    r = x[1] - x[0]
    moment = hertz(*d, np.linalg.norm(r)) * np.outer(r, r) / np.linalg.norm(r)
    expected = np.outer([0.6, 0.4], moment[np.triu_indices(3)]) / (L**3 / 2)
    assert x[0, 0] < 2e-3 < x[1, 0]
    assert np.allclose(cells(case, 'collisionalStress'), expected, rtol=1e-6)
    assert np.all(cells(case, 'contactNumber') == 1)


def test_simple_cubic_packing(tmp_path):
    """Six neighbours each; a force F on every face of a cube with the spacing s as its edge: F/s^2."""
    s = 5e-4
    x = (np.array(list(np.ndindex(8, 8, 8))) + 0.5) * s
    case = build(tmp_path, columns(x, d=1.002 * s), ('collisionalStress', 'contactNumber'), 'divided', cells=(2, 2, 2),
                 **STEP)
    run(case)
    pressure = hertz(1.002 * s, 1.002 * s, s) / s**2
    assert np.allclose(cells(case, 'contactNumber'), 6, rtol=1e-13)
    expected = pressure * np.array([1, 0, 0, 1, 0, 1])
    assert np.allclose(cells(case, 'collisionalStress'), expected, rtol=1e-6, atol=1e-6 * pressure)


def write_floor(path, size):
    """Two triangles that reach beyond a square."""
    a, b = -0.2 * size, 1.3 * size
    triangles = [((a, a), (b, a), (b, b)), ((a, a), (b, b), (a, b))]
    text = ''.join('facet normal 0 0 1\n outer loop\n' + ''.join(f'  vertex {x} {y} 0\n' for x, y in triangle)
                   + ' endloop\nendfacet\n' for triangle in triangles)
    (path / 'constant').mkdir(parents=True)
    (path / 'constant/floor.stl').write_text(f'solid floor\n{text}endsolid floor\n')


@pytest.mark.parametrize('floor', ['plane', 'triangles'])
def test_column_at_rest(tmp_path, floor):
    """Six grains on each other, two in a cell: stress times area is the weight above the middle of each cell, with the
    contact with the floor, a primitive wall of the engine or one of triangles."""
    d, n = 1e-3, 6
    wall = {'plane': {'type': 'plane', 'point': (0, 0, 0), 'normal': (0, 0, 1)},
            'triangles': {'type': 'STL', 'file': quoted('constant/floor.stl')}}[floor]
    x = np.array([[0.7e-3, 1.1e-3, (k + 0.5) * d] for k in range(n)])
    write_floor(tmp_path, 2e-3)
    case = build(tmp_path, columns(x, d=d), ('collisionalStress', 'contactNumber'), cyclic='xy', cells=(1, 1, 4),
                 upper=(2e-3, 2e-3, 8e-3), gravity=(0, 0, -9.81), walls={'floor': {**wall, 'material': 'glass'}},
                 restitution=0.3, deltaT=1e-3, endTime=0.1, writeInterval=100)
    run(case)
    weight = sphere(d) * GLASS['density'] * 9.81
    stress = cells(case, 'collisionalStress')
    assert np.allclose(stress[:3, 5] * 4e-6, weight * np.array([5, 3, 1]), rtol=0.02)
    assert np.abs(stress[:, :5]).max() < 1e-6 * stress.max() and np.all(stress[3] == 0)
    assert np.allclose(cells(case, 'contactNumber'), [1.5, 2, 1.5, 0])


# --- Means over time

def test_mean_of_a_ramp(tmp_path):
    """Free fall: v = g t at every step, whose mean over steps k+1 ... N is g dt (k + N + 1)/2."""
    average = {'timeAverage': True, 'averageStart': 4e-4}
    case = build(tmp_path, columns(np.array([[1e-3, 1e-3, 2e-3]]), d=5e-4),
                 ('U.particles', 'alpha.particles', 'granularTemperature'), cells=(2, 2, 1), average=average,
                 gravity=(1, 0, -9.81), deltaT=1e-4, endTime=1e-3, writeInterval=10)
    run(case)
    expected = np.array([1, 0, -9.81]) * 1e-4 * (4 + 10 + 1) / 2
    assert np.allclose(cells(case, 'U.particles')[0], np.array([1, 0, -9.81]) * 1e-3, rtol=1e-9)
    assert np.allclose(cells(case, 'U.particlesMean')[0], expected, rtol=1e-9)
    assert np.allclose(cells(case, 'alpha.particlesMean'), cells(case, 'alpha.particles'), rtol=1e-12)
    assert np.all(cells(case, 'U.particlesMean')[1:] == 0)


def crossing(path, **control):
    """One grain stays in the first cell, a fast one leaves it after the fifth of ten steps."""
    x = np.array([[1e-3, 1e-3, 1e-3], [1.45e-3, 3e-3, 1e-3]])
    return build(path, columns(x, d=(3e-4, 4e-4), vx=(0.1, 1.0), T=(300, 400)),
                 ('U.particles', 'T.particles', 'alpha.particles', 'contactNumber', 'kineticStress'), heat=True,
                 average={'timeAverage': True},
                 cells=(2, 1, 1), **{'deltaT': 1e-4, 'endTime': 1e-3, 'writeInterval': 5, **control})


def test_mean_by_mass_and_restart(tmp_path):
    """Velocity and temperature by mass over time; a run stopped after step 5 and continued gives the same."""
    case = crossing(tmp_path / 'whole')
    run(case)
    m = sphere([3e-4, 4e-4])
    n = np.array([[10, 5], [0, 5]]) / 10
    for name, value in (('U.particlesMean', np.array([0.1, 1.0])), ('T.particlesMean', np.array([300, 400]))):
        found = cells(case, name)
        found = found[:, 0] if found.ndim == 2 else found
        assert np.allclose(found, n @ (m * value) / (n @ m), rtol=1e-9), name
    assert np.allclose(cells(case, 'alpha.particlesMean'), n @ m / (L**3 / 2), rtol=1e-12)

    part = crossing(tmp_path / 'parts', endTime=5e-4)
    run(part)
    part.control['endTime'] = 1e-3
    part.write_dict('system/controlDict', part.control)
    assert 'start anew' not in run(part)
    for name in ('U', 'T', 'alpha', 'bulkDensity', 'numberDensity'):
        a, b = (cells(c, f'{name}.particlesMean') for c in (case, part))
        assert np.abs(a - b).max() < 1e-12 * np.abs(a).max(), name
    a, b = (cells(c, 'kineticStressMean') for c in (case, part))
    assert np.abs(a).max() > 0 and np.abs(a - b).max() < 1e-10 * np.abs(a).max()


def test_means_start_anew_where_they_were_not_written(tmp_path):
    case = crossing(tmp_path, endTime=5e-4)
    case.control['functions']['phase']['timeAverage'] = False
    case.write_dict('system/controlDict', case.control)
    run(case)
    case.control['endTime'] = 1e-3
    case.control['functions']['phase']['timeAverage'] = True
    case.write_dict('system/controlDict', case.control)
    assert 'phase: the means start anew at time 0.0005' in run(case)
    assert np.allclose(cells(case, 'U.particlesMean')[:, 0], [0.1, 1.0], rtol=1e-9)


# --- Mistakes

@pytest.mark.parametrize('changes, words', [
    ({'fields': ('U.particle',)}, ("'U.particle'", 'granularTemperature', 'collisionalStress', 'controlDict')),
    ({'fields': ('T.particles',)}, ("'T.particles'", 'heat on')),
    ({'averageFrom': 1}, ("'averageFrom'", 'averageStart')),
    ({'engine': 'prescribed'}, ('contactNumber', 'engine liggghts'))],
    ids=['field', 'heat', 'unknown', 'engine'])
def test_refused(tmp_path, changes, words):
    entries = {k: v for k, v in changes.items() if k != 'engine'}
    case = build(tmp_path, columns(np.array([[1e-3, 1e-3, 2e-3]]), d=5e-4), ('contactNumber',), cells=(2, 2, 1),
                 average=entries, **STEP)
    if 'engine' in changes:
        case.properties['engine'] = changes['engine']
        for name in ('contacts', 'walls'):
            case.properties.pop(name)
        case.write_dict('constant/particleProperties', case.properties)
    done = case.run('cfdDemFoam')
    assert done.code != 0 and done.output.count('ERROR') == 1, done.output
    for word in words:
        assert word in done.output, done.output


def test_refused_without_fluid(tmp_path):
    case = build(tmp_path, columns(np.array([[1e-3, 1e-3, 2e-3]]), d=5e-4), ('U.particles',), cells=(2, 2, 1), **STEP)
    done = case.run('demFoam')
    assert done.code != 0 and 'cfdDemFoam' in done.output, done.output


def test_two_objects_of_the_same_name(tmp_path):
    case = build(tmp_path, columns(np.array([[1e-3, 1e-3, 2e-3]]), d=5e-4), ('U.particles',), cells=(2, 2, 1), **STEP)
    case.control['functions']['other'] = case.control['functions']['phase']
    case.write_dict('system/controlDict', case.control)
    done = case.run('cfdDemFoam')
    assert done.code != 0 and "already a field 'U.particles'" in done.output, done.output
