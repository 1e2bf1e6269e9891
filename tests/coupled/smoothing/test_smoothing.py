"""Smoothing of what particles put into cells, and the delayed void fraction, in cfdDemFoam.

Expected values: the diffusion matrix of the mesh, made here from its boxes and decomposed into eigenvectors by numpy;
the Gaussian; balances; the closed form of a delay. Another program found none of them.
"""
import re

import numpy as np
import pytest

from dewCase import quoted
from fluidCase import FluidCase
from test_axisymmetric import cloud as wedge_cloud
from test_coupling import check_refused
from test_exchange import cloud, folder, pending, run, same_state, vectors
from test_map import moving, squeeze

ASCII = {'writeFormat': 'ascii', 'writePrecision': 17}
GLASS = {'youngsModulus': 1e7, 'poissonsRatio': 0.3, 'density': 2500}
L, D = 0.04, 3e-3


def sphere(d):
    return np.pi / 6 * d**3


def prescribed(path, x, velocity=(0, 0, 0), cells=(8, 8, 8), grading=1, upper=(L,)*3, cyclic='x', d=D, void='particleCentre',
               coupling=None, **control):
    """Spheres that move at a given velocity through a fluid that feels no force, and the entries of coupling."""
    case = FluidCase(path, upper=upper, cells=cells, cyclic=cyclic, **{'deltaT': 1e-3, 'endTime': 1e-3,
                                                                       'writeInterval': 1, **ASCII, **control})
    case.properties = {
        'engine': 'prescribed', 'velocity': 'constant ({} {} {})'.format(*velocity), 'output': (),
        'materials': {'glass': GLASS},
        'insertion': {'spheres': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'glass'}},
        'coupling': {**case.coupling('WenYu', void, pressure=False, momentum='none'), **(coupling or {})}}
    x = np.atleast_2d(x)
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': d})
    graded_mesh(case, grading)
    return case


def graded_mesh(case, grading):
    """The box with cells that grow along z: the last is grading times the first."""
    case.write()
    case.write_block_mesh()
    mesh = case.path / 'system/blockMeshDict'
    mesh.write_text(mesh.read_text().replace('(1 1 1)', f'(1 1 {grading})'))
    assert case.run('blockMesh').code == 0


def widths(n, length, grading=1):
    w = grading**(np.arange(n) / max(n - 1, 1))
    return w / w.sum() * length


def smoother(w, cyclic):
    """Along one axis: eigenvalues and the projections on eigenvectors of minus the second difference, for densities.
    Symmetric with the widths as weights."""
    n = len(w)
    A = np.zeros((n, n))
    for a in range(n if cyclic else n - 1):
        b = (a + 1) % n
        g = 2 / (w[a] + w[b])
        A[[a, b], [a, b]] += g
        A[a, b] -= g
        A[b, a] -= g
    root = np.sqrt(w)
    values, vectors_ = np.linalg.eigh(A / np.outer(root, root))
    return values, vectors_ / root[:, None], vectors_.T * root


def smoothed(density, axes, decay):
    """decay(M) density [z, y, x] with M the sum over the axes (z, y, x)."""
    result, rate = density, 0
    for k, (values, _, forward) in enumerate(axes):
        result = np.moveaxis(np.tensordot(forward, result, (1, k)), 0, k)
        rate = rate + values.reshape([-1 if m == k else 1 for m in range(3)])
    result = result * decay(rate)
    for k, (_, back, _) in enumerate(axes):
        result = np.moveaxis(np.tensordot(back, result, (1, k)), 0, k)
    return result


@pytest.mark.parametrize('ranks', [1, 2])
@pytest.mark.parametrize('grading', [1, 6])
@pytest.mark.parametrize('steps', [None, 1, 3])
def test_smoothing_is_that_of_the_matrix(tmp_path, steps, grading, ranks):
    """Spheres at rest near a wall, a cyclic and in the middle: alphac of every cell to 1e-11 of the largest (the series
    is cut off at 1e-12, eigenvectors are good to 1e-14), on regular and graded meshes."""
    b = 0.012
    x = np.array([[1e-3, 1e-3, 1e-3], [0.021, 0.017, 0.03], [0.039, 0.0185, 0.0213]])
    case = prescribed(tmp_path, x, grading=grading, cells=(8, 6, 10),
                      coupling={'smoothing': {'type': 'diffusion', 'length': b, **({'steps': steps} if steps else {})}})
    if ranks > 1:
        case.decompose(ranks)
    run(case, ranks)
    w = [widths(10, L, grading), widths(6, L), widths(8, L)]
    V = np.einsum('i,j,k', *w)
    density = np.zeros((10, 6, 8))
    for p in x:
        cell = tuple(np.searchsorted(np.cumsum(w[k]), p[2 - k]) for k in range(3))
        density[cell] += sphere(D) / V[cell]
    axes = [smoother(w[0], False), smoother(w[1], False), smoother(w[2], True)]
    s = b**2 / 4
    expected = smoothed(density, axes, (lambda r: (1 + s * r / steps)**-steps) if steps else (lambda r: np.exp(-s * r)))
    assert abs((expected * V).sum() / (3 * sphere(D)) - 1) < 1e-13
    found = 1 - case.joined_field('alphac', folder_of(case, ranks), ranks).reshape(10, 6, 8)
    assert np.abs(found - expected).max() < 1e-11 * density.max()
    assert found.min() > -1e-11 * density.max()
    row = case.ledger()[-1]
    assert abs(row['held'] / (3 * sphere(D)) - 1) < 1e-13 and row['clipped'] == 0 and row['lagging'] == 0
    # 480 cells, each some 40 products of round-off
    assert abs(row['represented'] / row['held'] - 1) < 1e-13


def folder_of(case, ranks):
    return case.times('.' if ranks == 1 else 'processor0')[-1]


@pytest.mark.parametrize('entry', [{'length': 0.01}, {'diameters': 4}, {'length': 0.01, 'steps': 4}])
def test_width(tmp_path, entry):
    """Variance b^2/2 of a point in a fine row of cells, to 1e-9 (walls are 6 b away: exp(-36); exponential tails of 4
    steps, 6^2 24^3 exp(-24) = 2e-5 at most: 1e-6); without steps the Gaussian cell by cell, to the error of the second
    difference, (h/b)^2/2 of the peak at most. b = 4 d."""
    n, d = 241, 2.5e-3
    length = 0.12
    case = prescribed(tmp_path, [0.06, 0.012, 0.012], cells=(n, 1, 1), upper=(length, 0.024, 0.024), cyclic='', d=d,
                      coupling={'smoothing': {'type': 'diffusion', **entry}})
    run(case)
    h = length / n
    x = (np.arange(n) + 0.5) * h - 0.06
    volume = (1 - case.field('alphac', case.times()[-1])) * h * 0.024**2
    b = 0.01
    assert abs(volume.sum() / sphere(d) - 1) < 1e-12
    assert abs(np.sum(volume * x**2) / sphere(d) / (b**2 / 2) - 1) < (1e-6 if 'steps' in entry else 1e-9)
    gauss = sphere(d) * h * np.exp(-x**2 / b**2) / (b * np.sqrt(np.pi))
    if 'steps' in entry:
        # (1 - b^2/16 d^2/dx^2)^-4 of a point, at the point: Gamma(7/2)/(2 (b/4) sqrt(pi) Gamma(4)) = 5/(8 b)
        assert abs(volume.max() / (sphere(d) * h * 0.625 / b) - 1) < 2 * (h / b)**2
    else:
        assert np.abs(volume - gauss).max() < 0.5 * (h / b)**2 * gauss.max()


# --- Balances

SMOOTH = {'type': 'diffusion', 'length': 1.7e-3}


def smooth_cloud(path, entries=None, grading=1, **keywords):
    case = cloud(path, **keywords)
    case.properties['coupling'].update(entries or {'smoothing': SMOOTH})
    graded_mesh(case, grading)
    return case


@pytest.mark.parametrize('ranks', [1, 2])
@pytest.mark.parametrize('grading', [1, 4])
@pytest.mark.parametrize('model', ['A', 'B'])
def test_smoothed_momentum_and_heat_close(tmp_path, model, grading, ranks):
    """Grains in a gas with contacts: what the fluid loses particles receive, at every step to 1e-12 of the sum of
    magnitudes, as without smoothing, whatever the cut-off."""
    case = smooth_cloud(tmp_path, model=model, grading=grading)
    if ranks > 1:
        case.decompose(ranks)
    run(case, ranks)
    rows = case.ledger()
    assert len(rows) == 5
    received, lost = (vectors(rows, f'{k}x {k}y {k}z') for k in 'rl')
    assert rows['scale'].min() > 1e-9 and np.abs(rows['heatScale']).min() > 1e-6
    assert np.all(np.linalg.norm(received - lost, axis=1) < 1e-12 * rows['scale'])
    assert np.all(np.abs(rows['heatReceived'] - rows['heatLost']) < 1e-12 * rows['heatScale'])
    assert np.abs(rows['represented'] / (216 * sphere(4e-4)) - 1).max() < 1e-13
    if ranks == 1:
        # The kicks are of the same order as the rest
        assert np.abs(pending(case, 5e-4)[:, :3]).max() > 1e-3 * rows['scale'][-1] / 216


@pytest.mark.parametrize('ranks', [1, 2])
def test_smoothed_momentum_closes_on_a_wedge(tmp_path, ranks):
    """Radial, azimuthal and axial momentum of a cylinder to 1e-12 of the sum of magnitudes, and the volume."""
    case = wedge_cloud(tmp_path)
    case.properties['coupling']['smoothing'] = {'type': 'diffusion', 'length': 2e-3}
    case.write()
    if ranks > 1:
        case.decompose(ranks)
    run(case, ranks)
    rows = case.ledger()
    received, lost = (vectors(rows, f'{k}x {k}y {k}z') for k in 'rl')
    assert np.all(np.abs(received).max(axis=0) > 1e-4 * rows['scale'].max())
    assert np.all(np.linalg.norm(received - lost, axis=1) < 1e-12 * rows['scale'])
    assert np.abs(rows['represented'] / (150 * sphere(4e-4)) - 1).max() < 1e-12


def test_ranks_give_the_same_smoothed(tmp_path):
    """To 1e-10 after one step, of the same forces; two cuts, the second through cyclics."""
    entries = {'smoothing': SMOOTH, 'alphacTime': 2e-4}
    one = smooth_cloud(tmp_path / 'one', entries, n_steps=1, writeInterval=1)
    run(one)
    for ranks, method in ((2, 'simple'), (2, 'scotch')):
        case = smooth_cloud(tmp_path / method, entries, n_steps=1, writeInterval=1)
        case.decompose(ranks, method)
        run(case, ranks)
        same_state(one, case, 1e-4, 1e-9, 1, ranks)
        a = one.field('alphac', folder_of(one, 1))
        assert np.abs(a - case.joined_field('alphac', folder_of(case, ranks), ranks)).max() < 1e-12


def test_restart_of_a_delayed_and_smoothed_run(tmp_path):
    """5 steps, a restart, 5 more: as 10 steps, to 1e-11. The delay is 20 steps."""
    entries = {'smoothing': {'type': 'diffusion', 'diameters': 4}, 'alphacTime': 2e-3}
    whole = smooth_cloud(tmp_path / 'whole', entries, n_steps=10, writeInterval=10)
    run(whole)
    case = smooth_cloud(tmp_path / 'parts', entries, n_steps=5, writeInterval=5)
    case.control['writeFormat'] = 'binary'
    case.write_dict('system/controlDict', case.control)
    run(case)
    case.control.update(endTime=1e-3, writeFormat='ascii')
    case.write_dict('system/controlDict', case.control)
    run(case)
    same_state(whole, case, 1e-3, 1e-11)
    # The field is behind: without the delay it is another
    plain = smooth_cloud(tmp_path / 'plain', {'smoothing': entries['smoothing']}, n_steps=10, writeInterval=10)
    run(plain)
    a, b = (c.field('alphac', folder(c, 1e-3)) for c in (whole, plain))
    assert np.abs(a - b).max() > 1e-4


# --- Delay

def test_delay_of_the_void_fraction(tmp_path):
    """One sphere by its centre through cells of 10 mm at 0.3 m/s, t = 2 d/v: alphac of every cell and step is the
    recursion of the closed form to 1e-12; its steps are below P8's bound 2 V_p/V_c v dt/d; no volume is lost."""
    v, dt, n, cells = 0.3, 3e-3, 40, 4
    t = 2 * D / v
    share = sphere(D) / (L / cells)**3
    case = prescribed(tmp_path, [0.004, 0.005, 0.005], velocity=(v, 0, 0), cells=(cells,)*3, cyclic='xyz',
                      deltaT=dt, endTime=n * dt, coupling={'alphacTime': t})
    run(case)
    expected = np.zeros((n + 1, cells))
    expected[0, 0] = share
    for k in range(1, n + 1):
        there = np.zeros(cells)
        there[int((0.004 + v * k * dt) % L / (L / cells))] = share
        expected[k] = expected[k - 1] + (1 - np.exp(-dt / t)) * (there - expected[k - 1])
    found = np.array([1 - case.field('alphac', folder(case, k * dt)).reshape(cells, cells, cells)[0, 0]
                      for k in range(1, n + 1)])
    assert np.abs(found - expected[1:]).max() < 1e-12
    bound = 2 * share * v * dt / D
    assert np.abs(np.diff(found, axis=0)).max() < 0.5 * bound < 0.5 * share
    rows = case.ledger()
    assert np.abs(rows['represented'] / sphere(D) - 1).max() < 1e-12
    assert np.abs(rows['lagging']).max() < 1e-12 * sphere(D)


def test_lagging_volume_is_in_the_ledger(tmp_path):
    """A sphere that leaves through an open side stays in alphac for some t; the sum of the lagging volume is
    - V exp(-n dt/t), n steps after, and held - represented - clipped."""
    v, dt, t = 0.3, 3e-3, 1e-2
    case = prescribed(tmp_path, [0.0385, 0.005, 0.005], velocity=(v, 0, 0), cells=(4,)*3, cyclic='', deltaT=dt,
                      endTime=6 * dt, coupling={'alphacTime': t})
    case.patches = {'U': {'xMax': {'type': 'zeroGradient'}}, 'p': {'xMax': {'type': 'fixedValue', 'value': 'uniform 0'}}}
    case.write()
    case.write_block_mesh()
    done = case.run('blockMesh')
    assert done.code == 0
    done = run(case)
    rows = case.ledger()
    gone = np.arange(6) >= 1
    k = np.cumsum(gone)
    expected = np.where(gone, -np.exp(-k * dt / t), 0) * sphere(D)
    assert np.abs(rows['lagging'] - expected).max() < 1e-12 * sphere(D)
    inside = np.where(gone, 0, sphere(D))
    assert np.abs(inside - rows['represented'] - rows['clipped'] - rows['lagging']).max() < 1e-12 * sphere(D)
    assert re.search(r'lagging, not yet in alphac: -\S+ m3', done.output)


def test_delay_in_a_mesh_that_is_squeezed(tmp_path):
    """A side moves in, all cells become thinner: both time levels of alphac are of the volumes of their time, so no
    volume is lost to 1e-12 and continuity holds to the solver's tolerance, 1e-10."""
    case, x, d, upper, n = moving(tmp_path)
    squeeze(case)
    case.properties['coupling'].update(alphacTime=3 * case.control['deltaT'],
                                       smoothing={'type': 'diffusion', 'length': 0.4 * min(upper)})
    case.write_dict('constant/particleProperties', case.properties)
    done = run(case)
    rows = case.ledger()
    assert len(rows) > 3 and np.ptp(rows['held']) == 0
    assert np.abs(rows['represented'] / rows['held'] - 1).max() < 1e-12
    errors = re.findall(r'continuity errors : sum local = (\S+),', done.output)
    assert max(map(float, errors)) < 1e-8, errors


# --- Bad input

REFUSALS = {
    'length zero': ({'smoothing': {'type': 'diffusion', 'length': 0}}, ("'length'", 'smoothing', 'greater than zero')),
    'length negative': ({'smoothing': {'type': 'diffusion', 'length': -1e-3}}, ("'length'", '-0.001', 'greater than zero')),
    'diameters negative': ({'smoothing': {'type': 'diffusion', 'diameters': -2}}, ("'diameters'", 'greater than zero')),
    'both': ({'smoothing': {'type': 'diffusion', 'diameters': 2, 'length': 1e-3}},
             ("'length'", "'diameters'", 'contradict')),
    'neither': ({'smoothing': {'type': 'diffusion'}}, ("'length'", "'diameters'", 'missing')),
    'steps zero': ({'smoothing': {'type': 'diffusion', 'length': 1e-2, 'steps': 0}}, ("'steps'", '1')),
    'misspelt': ({'smoothing': {'type': 'diffusion', 'lenght': 1e-2}}, ("'lenght'", 'Valid entries', 'length')),
    'unknown': ({'smoothing': {'type': 'diffusoin', 'length': 1e-2}}, ('smoothing', 'diffusoin', 'diffusion', 'none')),
    'wider than the domain': ({'smoothing': {'type': 'diffusion', 'length': 0.021}},
                              ("'length'", '0.021', 'half of the smallest extent', '0.04', '0.02')),
    'diameters wider than the domain': ({'smoothing': {'type': 'diffusion', 'diameters': 8}},
                                        ("'diameters'", '0.024', 'half of the smallest extent', '6.66')),
    'alphacTime zero': ({'alphacTime': 0}, ("'alphacTime'", 'greater than zero')),
    'alphacTime without volume': ({'alphacTime': 1, 'voidFraction': {'type': 'none'}}, ("'alphacTime'", 'voidFraction')),
}


@pytest.mark.parametrize('subject', REFUSALS)
def test_smoothing_refused(tmp_path, subject):
    entries, words = REFUSALS[subject]
    case = prescribed(tmp_path, [0.02, 0.02, 0.02], coupling=entries)
    check_refused(case.run('cfdDemFoam'), ('particleProperties', *words))
    assert case.times() == []


@pytest.mark.parametrize('subject', ['wider than the domain', 'diameters wider than the domain', 'both'])
def test_smoothing_refused_2_ranks(tmp_path, subject):
    entries, words = REFUSALS[subject]
    case = prescribed(tmp_path, [0.02, 0.02, 0.02], coupling=entries)
    case.decompose(2)
    check_refused(case.run('cfdDemFoam', ranks=2), words, ranks=2)
