"""Dissipative particles in the engine against an independent calculation: the equations of Espanol and Warren (1995) and of
Groot and Warren (1997) by velocity Verlet in Python, with Philox 4x32-10 as Salmon et al. (2011) define it."""
import re

import numpy as np
import pytest

from dewCase import Case, changed, quoted

# Beads of 1/3 of 1 um^3 of water, n rc^3 = 3
RC, T, K = 1e-6, 298.15, 1.380649e-23
KT = K * T
M = 1000 * RC**3 / 3
TAU = RC * np.sqrt(M / KT)
A, GAMMA = 25 * KT / RC, 4.5 * np.sqrt(M * KT) / RC
D = 0.4 * RC
RHO = 6 * M / (np.pi * D**3)
DT = float(f'{0.02 * TAU:.2e}')
SOFT = {'youngsModulus': 1e-9, 'poissonsRatio': 0.3, 'density': RHO}
# Of a box with 9^3 particles, and columns of the engine's table
WIDTH = 9 / 3**(1/3) * RC
NAMES = 'x y z vx vy vz'


# --- Independent calculation

def philox(key, counter):
    k, c = list(key), list(counter)
    for _ in range(10):
        p, q = 0xD2511F53 * c[0], 0xCD9E8D57 * c[2]
        c = [(q >> 32) ^ c[1] ^ k[0], q & 0xFFFFFFFF, (p >> 32) ^ c[3] ^ k[1], p & 0xFFFFFFFF]
        k = [(k[0] + 0x9E3779B9) & 0xFFFFFFFF, (k[1] + 0xBB67AE85) & 0xFFFFFFFF]
    return c


def test_philox():
    """Known answer of the authors' library Random123, for zeros."""
    assert philox((0, 0), (0, 0, 0, 0)) == [0x6627E8D5, 0xE169C58D, 0xBC57AC4C, 0x9B00DBD8]


def noise(i, j, step, seed):
    c = philox((seed, 0), (min(i, j), max(i, j), step, 0x44500000))
    return np.sqrt(-2 * np.log((c[0] + 0.5) / 2**32)) * np.cos(2 * np.pi * c[1] / 2**32)


def forces(x, v, step, width, a, gamma, s, seed, dt=DT):
    F = np.zeros_like(x)
    for i in range(len(x)):
        for j in range(i):
            d = x[i] - x[j]
            d -= width * np.round(d / width)
            r = np.linalg.norm(d)
            if r < RC:
                w = (1 - r / RC)**s
                f = (a[i, j] * (1 - r / RC) - gamma[i, j] * w**2 * (v[i] - v[j]) @ d / r
                     + np.sqrt(2 * gamma[i, j] * KT / dt) * w * noise(i + 1, j + 1, step, seed))
                F[i] += f * d / r
                F[j] -= f * d / r
    return F


def verlet(x, v, n, width, m, *more, dt=DT):
    x, v = x.copy(), v.copy()
    F = forces(x, v, 0, width, *more, dt=dt)
    for step in range(1, n + 1):
        v += F * dt / (2 * m)
        x += v * dt
        F = forces(x, v, step, width, *more, dt=dt)
        v += F * dt / (2 * m)
    return x, v


# --- Cases

def case_of(path, x, v=None, n_sub=1, n_out=1, code=0, ranks=1, changes=None, width=WIDTH, cyclic='xyz', run=True, dt=DT,
            d=D, material=None, application='testEngine', **more):
    x = np.atleast_2d(x)
    case = Case(path, lower=(-width / 2,) * 3, upper=(width / 2,) * 3, cells=(4, 2, 2), gravity=(0, 0, 0),
                deltaT=dt * n_sub, endTime=dt * n_sub * n_out, timePrecision=15, cyclic=cyclic,
                **{'writeInterval': 1000000, **more})
    case.properties = changed({
        'engine': 'liggghts', 'materials': {'water': SOFT},
        'contacts': {'tangential': 'none', 'default': {'restitution': 1}},
        'insertion': {'some': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'water'}},
        'timeStep': {'deltaT': dt}, 'overlapTolerance': 2, 'output': ('csv',),
        'dissipative': {'temperature': T, 'range': RC, 'conservative': A, 'friction': GAMMA},
        'dynamics': {'seed': 7}}, changes or {})
    columns = {'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': d}
    if material:
        columns['material'] = material
        del case.properties['insertion']['some']['material']
    if v is not None:
        columns.update({'v' + 'xyz'[k]: np.atleast_2d(v)[:, k] for k in range(3)})
    case.particles(columns)
    case.mesh()
    case.write_file('constant/testProperties', '')
    if not run:
        return case
    if ranks > 1:
        case.decompose(ranks)
    done = case.run(application, ranks=ranks, timeout=200)
    assert (done.code == 0) == (code == 0), done.output
    return case, done.output


def rows_of(case, k=-1, names=NAMES):
    rows = np.genfromtxt(case.path / case.times()[k] / 'engine.csv', delimiter=',', names=True)
    rows = np.sort(np.atleast_1d(rows), order='id')
    return np.stack([rows[n] for n in names.split()], axis=1)


def energies(output):
    return np.array([[float(e) for e in m] for m in re.findall(r'energies (\S+) (\S+)', output)])


def fluid(n=9, seed=1):
    """n^3 particles of a fluid on a shaken lattice in the box, with the velocities of the temperature and no momentum."""
    width = WIDTH
    rng = np.random.default_rng(seed)
    x = (np.stack(np.meshgrid(*[np.arange(n) + 0.5] * 3), axis=-1).reshape(-1, 3) / n - 0.5) * width
    x += rng.uniform(-0.02, 0.02, x.shape) * RC
    v = rng.normal(0, np.sqrt(KT / M), x.shape)
    return x, v - v.mean(axis=0)


# --- Pairs

@pytest.mark.parametrize('s', [1, 0.5])
def test_against_independent_integration(tmp_path, s):
    """Twelve particles of two materials and masses in a cyclic box, 20 sub-steps: positions and velocities to 1e-9, round-off of
    positions (12 digits of the written time step's scale) grown in 20 steps."""
    rng = np.random.default_rng(3)
    width = 2.1 * RC
    x, v = rng.uniform(-0.5, 0.5, (12, 3)) * width, rng.normal(0, np.sqrt(KT / M), (12, 3))
    oil = np.arange(12) % 3 == 0
    case, _ = case_of(tmp_path, x, v, n_sub=20, width=width, material=np.where(oil, 'oil', 'water').tolist(), changes={
        'materials/oil': {**SOFT, 'density': 2 * RHO}, 'dissipative/exponent': s,
        'dissipative/oil.water': {'conservative': 2 * A}, 'dissipative/oil.oil': {'friction': 3 * GAMMA}})
    both = np.add.outer(oil.astype(int), oil.astype(int))
    a, gamma = np.where(both == 1, 2 * A, A), np.where(both == 2, 3 * GAMMA, GAMMA)
    x_expected, v_expected = verlet(x, v, 20, width, np.where(oil, 2 * M, M)[:, None], a, gamma, s, 7)
    found = rows_of(case)
    apart = found[:, :3] - x_expected
    apart -= width * np.round(apart / width)
    assert np.abs(apart).max() < 1e-9 * D
    assert np.abs(found[:, 3:] - v_expected).max() < 1e-9 * np.sqrt(KT / M)
    assert np.abs(v_expected - v).max() > 0.1 * np.sqrt(KT / M)


def test_bounce_of_a_pair(tmp_path):
    """The conservative force alone is half a period of a spring around r = rc, r = rc - v/w sin(w t), w^2 = 2 a/(m rc). Verlet's
    error of the phase, (w dt)^2/24 = 1e-5 at a turn and 3e-5 in 50 steps; the energy's (w dt)^2/8 of what is exchanged."""
    w = np.sqrt(2 * A / (M * RC))
    dt = float(f'{np.pi / 200 / w:.3e}')
    speed = 0.5 * w * RC
    v = np.array([[speed / 2, 0, 0], [-speed / 2, 0, 0]])
    n = 60
    case, output = case_of(tmp_path, [[-RC / 2, 0, 0], [RC / 2, 0, 0]], v, n_out=n, dt=dt, writeInterval=1, changes={
        'dissipative/temperature': 0, 'dissipative/friction': 0})
    t = dt * np.arange(1, n + 1)
    r = np.array([np.diff(rows_of(case, k)[:, 0])[0] for k in range(n)])
    assert np.abs(r - (RC - speed / w * np.sin(w * t))).max() < 1e-4 * RC
    E = energies(output)
    assert np.abs(E.sum(axis=1) / (M * speed**2 / 4) - 1).max() < (w * dt)**2 / 4
    assert np.abs(E[:, 1] - A * (RC - r)**2 / (2 * RC)).max() < 1e-9 * E[:, 1].max()


@pytest.mark.parametrize('ranks', [1, 2])
def test_sum_of_forces(tmp_path, ranks):
    """Zero to round-off of the 729 velocities, after one sub-step and after 100."""
    x, v = fluid()
    for n in (1, 100):
        case, _ = case_of(tmp_path / str(n), x, v, n_sub=n, ranks=ranks)
        found = rows_of(case)[:, 3:]
        assert np.abs(found - v).max() > 0.01 * np.sqrt(KT / M)
        assert np.abs(found.sum(axis=0) - v.sum(axis=0)).max() < 1e-12 * np.abs(v).sum()


def test_same_on_any_ranks(tmp_path):
    """1, 2 and 4 ranks, 100 sub-steps: positions within 1e-9 of the radius."""
    x, v = fluid()
    found = [rows_of(case_of(tmp_path / str(ranks), x, v, n_sub=100, ranks=ranks)[0]) for ranks in (1, 2, 4)]
    for other in found[1:]:
        apart = other[:, :3] - found[0][:, :3]
        apart -= WIDTH * np.round(apart / (WIDTH))
        assert np.abs(apart).max() < 1e-9 * D / 2


def test_restart_goes_on_exactly(tmp_path):
    """Half of the way in one run and half after a restart, to round-off: the engine sorts its particles anew, and adds their
    forces in another order."""
    x, v = fluid()
    whole, _ = case_of(tmp_path / 'whole', x, v, n_sub=10, n_out=10)
    half = case_of(tmp_path / 'half', x, v, n_sub=10, n_out=10, run=False)
    half.control.update(endTime=5 * 10 * DT, writeInterval=5)
    half.write()
    assert half.run('testEngine').code == 0
    half.control.update(endTime=10 * 10 * DT)
    half.write()
    done = half.run('testEngine')
    assert done.code == 0 and 'continued' in done.output, done.output
    apart = rows_of(whole) - rows_of(half)
    apart[:, :3] -= WIDTH * np.round(apart[:, :3] / (WIDTH))
    assert np.abs(apart[:, :3]).max() < 1e-9 * D / 2 and np.abs(apart[:, 3:]).max() < 1e-9 * np.sqrt(KT / M)


def test_moving_with_the_observer(tmp_path):
    """A velocity added to all is there at the end and nothing else has changed: round-off of a speed 20 times the thermal one,
    1e-9 after 50 sub-steps."""
    x, v = fluid()
    U = 20 * np.sqrt(KT / M) * np.array([2/7, 3/7, 6/7])
    rest = rows_of(case_of(tmp_path / 'rest', x, v, n_sub=50)[0])
    moving = rows_of(case_of(tmp_path / 'moving', x, v + U, n_sub=50)[0])
    assert np.abs(moving[:, 3:] - U - rest[:, 3:]).max() < 1e-9 * np.sqrt(KT / M)
    apart = moving[:, :3] - rest[:, :3] - 50 * DT * U
    assert np.abs(apart - WIDTH * np.round(apart / (WIDTH))).max() < 1e-9 * D


@pytest.mark.parametrize('factor', [1, 3])
def test_temperature(tmp_path, factor):
    """Of 729 particles over 80 tau (for a friction three times as high 27 tau), a tenth of the limit a sub-step: 0.5 % by the
    sub-step and three standard errors of 0.35 %, energies being independent some 0.8 tau apart."""
    x, v = fluid()
    _, output = case_of(tmp_path, x, v, n_sub=20, n_out=400, dt=DT / 2 / factor,
                        changes={'dissipative/friction': GAMMA * factor})
    E = energies(output)[:, 0]
    assert abs(E[20:].mean() / (1.5 * (len(x) - 1) * KT) - 1) < 0.015


# --- The sub-step

@pytest.mark.parametrize('changes, expected, cause', [
    ({}, M / 2 / GAMMA, 'friction of dissipative pairs'),
    ({'friction': GAMMA / 10}, 2 * np.sqrt(M / 2 * RC / A), 'conservative force of dissipative pairs')])
def test_limit_of_the_sub_step(tmp_path, changes, expected, cause):
    """mu/gamma and 2 sqrt(mu rc/a), and a message above them; a tenth of it without an entry."""
    x, _ = fluid()
    changes = {'dissipative/' + key: value for key, value in changes.items()}
    case, output = case_of(tmp_path, x[:2], n_sub=200, changes={**changes, 'timeStep': {'fraction': 0.1}})
    assert abs(float(re.search(r'Stable sub-step (\S+)', output).group(1)) / expected - 1) < 1e-5
    sub = float(re.search(r', sub-step (\S+) s', output).group(1))
    assert 0.08 * expected < sub <= 0.1 * expected * 1.00001
    _, output = case_of(tmp_path / 'above', x[:2], code=1, dt=1.01 * expected, changes=changes)
    assert 'above the stability limit' in output and cause in output, output


# --- Input

@pytest.mark.parametrize('changes, message', [
    ({'temperature': 0}, "'temperature' in .* is 0.*friction.*Give both"),
    ({'friction': 0}, "'temperature' in .* is 298.15, the largest friction 0.*Give both"),
    ({'temperature': -1}, "'temperature'.*-1"),
    ({'friction': -1e-12}, "'friction'.*-1e-12"),
    ({'conservative': -1e-13}, "'conservative'.*-1e-13"),
    ({'range': 0}, "'range'.* 0"),
    ({'exponent': 0}, "'exponent'.* 0"),
    ({'range': 3.2e-6}, "'range' in .* 3.2e-06 m, more than half of the periodic box along x.*at least 6.4e-06"),
    ({'friction': None}, "friction"),
    ({'frction': 1}, "frction"),
    ({'water.glass': {'friction': 1e-12}}, 'water.glass'),
    ({'water.water': {'frition': 1e-12}}, 'frition'),
    ({'../dynamics': {'type': 'overdamped', 'viscosity': 1e-3}}, "'dissipative' and dynamics of type overdamped exclude"),
    ({'../input': quoted('in.particles')}, "'input' and 'dissipative' exclude"),
])
def test_bad_input(tmp_path, changes, message):
    """One message each, with the remedy."""
    x, v = fluid()
    changes = {('dissipative/' + key).replace('dissipative/../', ''): value for key, value in changes.items()}
    if 'input' in changes:
        changes.update({key: None for key in ('materials', 'contacts', 'insertion')})
    case = case_of(tmp_path, x[:9], v[:9], run=False)
    case.properties = changed(case.properties, changes)
    case.write()
    done = case.run('testEngine')
    assert done.code and done.output.count('FOAM FATAL') == 1, done.output
    assert re.search(message, done.output.replace('\n', ' ')), done.output


def test_same_pair_twice(tmp_path):
    x, v = fluid()
    _, output = case_of(tmp_path, x[:9], v[:9], code=1, changes={
        'materials/oil': SOFT, 'dissipative/oil.water': {'friction': GAMMA}, 'dissipative/water.oil': {'friction': GAMMA}})
    assert re.search("'water.oil' and 'oil.water'.*Remove one", output.replace('\n', ' ')), output


def test_second_thermostat(tmp_path):
    """Brownian motion in a given fluid beside the forces."""
    x, v = fluid()
    _, output = case_of(tmp_path, x[:9], v[:9], code=1, application='demFoam', changes={
        'fluid': {'viscosity': 1e-3, 'density': 1000, 'Brownian': 'on', 'temperature': T}})
    assert re.search('dissipative forces and Brownian motion exclude.*Remove', output.replace('\n', ' ')), output
