"""Lubrication and conduction between particles, and between particles and walls, in the engine: closed forms.

With lubrication the law F = -k (1/s - 1/sMax) ds/dt is a function of the gap s, so that m v + k G(s) changes by the
impulse of the other forces only, G = ln(s/sMax) - s/sMax + 1 (below sMin the slope is that at sMin).
"""
import re

import numpy as np
import pytest

from dewCase import Case, foam_dict, quoted

RHO, CP, K = 2500.0, 700.0, 1.0
MATERIAL = {'youngsModulus': 1e8, 'poissonsRatio': 0.3, 'density': RHO}
THERMAL = {**MATERIAL, 'thermalConductivity': K, 'heatCapacity': CP}
R = 5e-4
M = RHO * 4 / 3 * np.pi * R**3
MU, S_MIN, S_MAX = 1e-3, 1e-8, 5e-5
LUBRICATION = {'viscosity': MU, 'minGap': S_MIN, 'maxGap': S_MAX}
LIMIT = 0.1 * np.pi * R * (RHO / (1e8 / 2.6))**0.5 / (0.1631 * 0.3 + 0.8766)     # a tenth of the Rayleigh time


def G(s, s_min=S_MIN, s_max=S_MAX):
    """The integral of the law from sMax, for any gap."""
    t = np.clip(s, s_min, s_max)
    return (np.log(t / s_max) - t / s_max + 1
            + (np.minimum(np.maximum(s, 0), s_min) - s_min) * (1 / s_min - 1 / s_max))


def gap_of(value):
    """The gap at which G has a value."""
    low, high = 0.0, S_MAX
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if G(middle) < value else (low, middle)
    return low


def run(path, columns, end, dt, n_out=1, walls=None, forces=None, ranks=1, width=1e-2, gravity=(0, 0, 0), cyclic='',
        restitution=0.8, lubrication=LUBRICATION, files=None, code=0, materials=None, **more):
    """Run testEngine: sub-step near dt, n_out outputs up to end. Returns case and output."""
    n_sub = max(1, int(round(end / n_out / dt)))
    step = end / n_out
    case = Case(path, upper=(width,)*3, gravity=gravity, deltaT=step, endTime=end, writeInterval=100000,
                timePrecision=12, cyclic=cyclic)
    case.properties = {
        'engine': 'liggghts', 'materials': materials or {'glass': THERMAL if more.get('heat') else MATERIAL},
        'contacts': {'normal': 'Hertz', 'tangential': 'none', 'default': {'restitution': restitution}},
        'insertion': {'some': {'type': 'file', 'file': quoted('constant/particles.csv'),
                               **({} if 'material' in columns else {'material': 'glass'})}},
        'timeStep': {'deltaT': step / n_sub}, 'overlapTolerance': 0.3, 'output': ('csv',), **more}
    if lubrication:
        case.properties['lubrication'] = lubrication
    if walls:
        case.properties['walls'] = walls
    case.particles(columns)
    for name, text in (files or {}).items():
        case.write_file(name, text)
    case.mesh()
    case.write_file('constant/testProperties', foam_dict(forces or {}) + '\n')
    if ranks > 1:
        case.decompose(ranks)
    done = case.run('testEngine', ranks=ranks)
    assert (done.code == 0) == (code == 0), done.output
    return case, done.output


def rows_of(case, k=-1):
    rows = np.genfromtxt(case.path / case.times()[k] / 'engine.csv', delimiter=',', names=True)
    return np.sort(np.atleast_1d(rows), order='id')


def vectors(rows, names):
    return np.stack([rows[n] for n in names.split()], axis=1)


def pair(s, v, axis=(2/7, 3/7, 6/7), d=(2 * R, 2 * R), **more):
    """Two spheres at a gap s that approach at v along an axis."""
    n = np.array(axis)
    x = [np.full(3, 5e-3) - n * (d[0] + s) / 2, np.full(3, 5e-3) + n * (d[1] + s) / 2]
    u = [n * v / 2, -n * v / 2]
    return {**{'xyz'[k]: [x[0][k], x[1][k]] for k in range(3)},
            **{'v' + 'xyz'[k]: [u[0][k], u[1][k]] for k in range(3)}, 'd': list(d), **more}


def opening(rows):
    """Gap and its rate of two spheres."""
    d = vectors(rows, 'x y z')[1] - vectors(rows, 'x y z')[0]
    v = vectors(rows, 'vx vy vz')[1] - vectors(rows, 'vx vy vz')[0]
    r = np.linalg.norm(d)
    return r - rows['d'].sum() / 2, v @ d / r


# --- Lubrication

@pytest.mark.parametrize('dt', [LIMIT / 50, LIMIT, 5 * LIMIT])
def test_two_spheres_come_to_rest_in_the_gap(tmp_path, dt):
    """v = v0 + (k/m*) (G(s) - G(s0)): the place where they stop is exact for any sub-step (1e-5 of it: round-off of
    positions over the gap, and what is left of the way after 20 relaxation times), whatever the gap was before."""
    v0, s0 = 0.01, 6e-5
    k = 6 * np.pi * MU * (R / 2)**2
    expected = gap_of(-v0 * (M / 2) / k)
    assert 3 * S_MIN < expected < 1e-6
    tau = (M / 2) * expected / k
    case, _ = run(tmp_path, pair(s0, v0), s0 / v0 + 400 * tau, dt)
    s, v = opening(rows_of(case))
    assert abs(s / expected - 1) < 1e-5
    assert abs(v) < 1e-6 * v0


def test_velocity_in_the_gap(tmp_path):
    """The same velocity on the way in, at every time; v is half a sub-step from s, dt F/m* of v."""
    v0, s0 = 0.02, 6e-5
    k = 6 * np.pi * MU * (R / 2)**2
    case, _ = run(tmp_path, pair(s0, v0), 3e-3, LIMIT / 20, n_out=16)
    slowest = v0
    for n in range(16):
        s, v = opening(rows_of(case, n))
        assert s > 0
        expected = -v0 - k / (M / 2) * G(s)
        assert abs(v - expected) < 1e-3 * v0
        slowest = min(slowest, abs(v))
    assert slowest < 0.95 * v0


def test_wet_restitution(tmp_path):
    """Through the gap, contact with e, and out again: e_wet = e (1 - u) - u, u = (k/m*)/v0 times -G at touch. 1 % is
    that of contacts, which begin and end between two sub-steps."""
    v0, s0, e = 0.2, 6e-5, 0.8
    k = 6 * np.pi * 2 * MU * (R / 2)**2
    u = -k / (M / 2) * G(0.0) / v0
    assert 0.5 < e * (1 - u) - u < 0.7
    case, _ = run(tmp_path, pair(s0, v0), 5 * s0 / v0, LIMIT / 10,
                  lubrication={**LUBRICATION, 'viscosity': 2 * MU})
    s, v = opening(rows_of(case))
    assert s > S_MAX
    assert abs(v / v0 / (e * (1 - u) - u) - 1) < 0.01


def test_unequal_spheres_and_the_usual_gap(tmp_path):
    """r* of two sizes, and 0.1 r* for maxGap where it is not given: stop at the same place as a pair with it."""
    d = (1e-3, 5e-4)
    r = d[0] * d[1] / (d[0] + d[1]) / 2
    m = [RHO * np.pi / 6 * x**3 for x in d]
    m_star = m[0] * m[1] / sum(m)
    k, v0, s0 = 6 * np.pi * MU * r**2, 0.02, 3e-5
    usual = {'viscosity': MU, 'minGap': S_MIN}
    case, _ = run(tmp_path, pair(s0, v0, d=d), 1e-2, LIMIT / 10, lubrication=usual)
    s, v = opening(rows_of(case))
    assert S_MIN < s < 1e-6
    assert abs(G(s, S_MIN, 0.1 * r) + v0 * m_star / k) < 1e-5


STL = """solid floor
facet normal 0 0 1
 outer loop
  vertex 0 0 1e-3
  vertex 1e-2 0 1e-3
  vertex 1e-2 1e-2 1e-3
 endloop
endfacet
facet normal 0 0 1
 outer loop
  vertex 0 0 1e-3
  vertex 1e-2 1e-2 1e-3
  vertex 0 1e-2 1e-3
 endloop
endfacet
endsolid floor
"""
# Wall and its height; below (5.1 4 1e-3) a face, below (5 5) an edge between two coplanar triangles
FLOORS = {
    'plane': ({'type': 'plane', 'point': (0, 0, 1e-3), 'normal': (0, 0, 1)}, (5e-3, 5e-3)),
    'triangles': ({'type': 'STL', 'file': quoted('constant/floor.stl')}, (5.1e-3, 4e-3)),
    'edge': ({'type': 'STL', 'file': quoted('constant/floor.stl')}, (5e-3, 5e-3)),
    'near an edge': ({'type': 'STL', 'file': quoted('constant/floor.stl')}, (5.00003e-3, 5e-3)),
    'moving': ({'type': 'plane', 'point': (0, 0, 1e-3), 'normal': (0, 0, 1),
                'motion': {'type': 'linear', 'velocity': (0, 0, 0.005)}}, (5.1e-3, 4e-3)),
}


@pytest.mark.parametrize('floor', FLOORS)
def test_sphere_comes_to_rest_before_a_wall(tmp_path, floor):
    """r* = R; the wall's velocity counts; one contact where triangles meet."""
    wall, at = FLOORS[floor]
    v0, s0, end = 0.01, 1e-4, 0.03
    k = 6 * np.pi * MU * R**2
    U = 0.005 if floor == 'moving' else 0.0
    case, _ = run(tmp_path, {'x': at[0], 'y': at[1], 'z': 1e-3 + R + s0, 'd': 2 * R, 'vz': U - v0}, end, LIMIT,
                  walls={'floor': {**wall, 'material': 'glass'}}, files={'constant/floor.stl': STL})
    row = rows_of(case)[0]
    s = row['z'] - 1e-3 - U * end - R
    # The gap where G takes all the momentum, approached as exp(-t/(m s/k)), m s/k = 10 ms s/1e-7
    assert abs(G(s) + v0 * M / k) < 0.01 * v0 * M / k
    assert abs(row['vz'] - U) < 0.02 * v0


@pytest.mark.parametrize('mu', [1e-3, 1.0, 1e3])
def test_impulse_of_other_forces_at_any_stiffness(tmp_path, mu):
    """A sphere that is pressed to a wall by gravity and a flow with drag: m v + k G + Sp s grows by (Sp U - m g) t.
    Viscosity up to 1e3 Pa s makes k/(s m) dt as large as 1e6."""
    k, g, s0, v0, end = 6 * np.pi * mu * R**2, 9.81, 4e-5, 0.0, 2e-3
    Sp, U = M / 1e-3, -0.02
    case, _ = run(tmp_path, {'x': 5e-3, 'y': 5e-3, 'z': R + s0, 'd': 2 * R}, end, LIMIT, n_out=4, gravity=(0, 0, -g),
                  walls={'floor': {'type': 'patch', 'patches': ('zMin',), 'material': 'glass'}},
                  forces={'Sp': Sp, 'U': (0, 0, U)}, lubrication={**LUBRICATION, 'viscosity': mu})
    for n in range(4):
        row = rows_of(case, n)[0]
        t = end * (n + 1) / 4
        s = row['z'] - R
        assert 0 < s < s0
        gained = M * (row['vz'] - v0) + k * (G(s) - G(s0)) + Sp * (s - s0)
        # The gap hears of a new force when it has moved by it for a sub-step, a dt^2/2
        F = Sp * U - M * g
        late = k * (1 / s - 1 / S_MAX) * abs(F) / M * LIMIT**2
        assert abs(gained - F * t) < abs(F) * 2 * LIMIT + late
        if mu > 1:
            assert late > 0.01 * abs(F) * t


def cloud(n=200, seed=7):
    """Spheres at gaps below maxGap: a cubic lattice, with random velocities."""
    rng = np.random.default_rng(seed)
    a = 2 * R + 2e-5
    side = int(np.ceil(n**(1 / 3)))
    x = (np.stack(np.meshgrid(*(np.arange(side),) * 3), -1).reshape(-1, 3)[:n] - (side - 1) / 2) * a + 5e-3
    x += rng.uniform(-4e-6, 4e-6, x.shape)
    v = rng.uniform(-1, 1, x.shape) * 0.02
    return {**{'xyz'[k]: x[:, k] for k in range(3)}, **{'v' + 'xyz'[k]: v[:, k] for k in range(3)}, 'd': 2 * R}


@pytest.mark.parametrize('mu', [1e-2, 1e3])
def test_third_law_and_ranks(tmp_path, mu):
    """Momentum stays to 1e-14 of the sum of momenta a sub-step, on one rank and with pairs across the boundary of two;
    both give the same (1e-10 of the scale); energy only falls, however stiff and crowded."""
    states, n_sub, dt = [], 40, LIMIT / 2
    for ranks in (1, 2):
        columns = cloud()
        case, _ = run(tmp_path / f'{ranks}', columns, n_sub * dt, dt, n_out=n_sub, ranks=ranks,
                      lubrication={**LUBRICATION, 'viscosity': mu})
        p, energy = [], []
        for n in range(n_sub):
            v = vectors(rows_of(case, n), 'vx vy vz')
            p.append(M * v.sum(0))
            energy.append(0.5 * M * (v**2).sum())
        v0 = np.stack([columns['v' + c] for c in 'xyz'], 1)
        assert np.abs(p[0] - M * v0.sum(0)).max() < 1e-14 * M * np.abs(v0).sum()
        assert np.abs(np.diff(p, axis=0)).max() < 1e-14 * M * np.abs(v0).sum()
        assert np.all(np.diff(energy) < 1e-12 * energy[0])
        assert energy[-1] < 0.98 * energy[0]
        states.append(rows_of(case))
    for names in ('x y z', 'vx vy vz'):
        one, two = (vectors(s, names) for s in states)
        assert np.abs(one - two).max() < 1e-10 * np.abs(one).max()


def test_pair_across_a_periodic_side(tmp_path):
    """As in the middle, where the two come to rest."""
    v0, s0 = 0.01, 6e-5
    k = 6 * np.pi * MU * (R / 2)**2
    expected = gap_of(-v0 * (M / 2) / k)
    columns = {'x': [1e-2 - R - s0 / 4, R + 3 * s0 / 4], 'y': 5e-3, 'z': 5e-3, 'd': 2 * R, 'vx': [v0 / 2, -v0 / 2]}
    case, _ = run(tmp_path, columns, s0 / v0 + 400 * (M / 2) * expected / k, LIMIT, cyclic='x')
    rows = rows_of(case)
    s = 1e-2 - abs(rows['x'][1] - rows['x'][0]) - 2 * R
    assert abs(s / expected - 1) < 1e-5


REFUSED = {
    'maxGap above the radius': ({'lubrication': {**LUBRICATION, 'maxGap': 1e-3}}, ('maxGap', 'smallest radius')),
    'minGap above maxGap': ({'lubrication': {**LUBRICATION, 'minGap': 1e-4}}, ('minGap', 'Lower')),
    'no viscosity': ({'lubrication': {'minGap': 1e-8}}, ('viscosity', 'lubrication')),
    'misspelt': ({'lubrication': {**LUBRICATION, 'maxgap': 1e-5}}, ('maxgap',)),
    'overdamped': ({'dynamics': {'type': 'overdamped', 'viscosity': 1e-3}}, ('lubrication', 'overdamped')),
    'conduction without heat': ({'conduction': {'type': 'contact'}}, ('conduction', 'heat on')),
    'unknown conduction': ({'heat': True, 'conduction': {'type': 'convection'}}, ('convection', 'BatchelorOBrien')),
    'fluid conducts better': ({'heat': True, 'conduction': {'type': 'BatchelorOBrien', 'fluidConductivity': 0.6}},
                              ('glass', 'Kp/Kf', 'fluidConductivity')),
    'materials too different': ({'heat': True, 'conduction': {'type': 'impact'},
                                 'materials': {'glass': THERMAL, 'lead': {**THERMAL, 'density': 11340}}},
                                ('lead', 'glass', '0.6')),
}


@pytest.mark.parametrize('what', REFUSED)
def test_refused(tmp_path, what):
    """One message that names entry and remedy."""
    changes, words = REFUSED[what]
    _, output = run(tmp_path, pair(6e-5, 0.01), 1e-5, LIMIT, code=1, **changes)
    assert all(word in output for word in ('particleProperties', *words)), output


def test_brownian_motion_is_refused(tmp_path):
    """Its noise would miss that of the gaps."""
    _, output = run(tmp_path, pair(6e-5, 0.01), 1e-5, LIMIT, code=1, forces={'kT': 4e-21, 'Sp': 1e-9, 'U': (0, 0, 0)})
    assert 'lubrication and Brownian motion exclude' in output


# --- Conduction

def conductances(law, k, overlap, sizes, wall=False):
    """Of a touching pair, or a sphere and a wall, by the papers' formulas."""
    if law == 'contact':
        if wall:
            area = np.pi * (R**2 - (R - overlap)**2)
        else:
            r = sum(sizes) / 2 - overlap
            d = (r**2 + sizes[0]**2 / 4 - sizes[1]**2 / 4) / (2 * r)
            area = np.pi * (sizes[0]**2 / 4 - d**2)
        return 2 * k * np.sqrt(area)
    a = 2 * R if wall else 2 / (2 / sizes[0] + 2 / sizes[1])
    return np.pi * 0.1 * a * np.log((k / 2 / 0.1)**2)


LAWS = {'contact': {'type': 'contact'}, 'BatchelorOBrien': {'type': 'BatchelorOBrien', 'fluidConductivity': 0.1}}


@pytest.mark.parametrize('sizes', [(2 * R, 2 * R), (2 * R, R)])
@pytest.mark.parametrize('law', LAWS)
def test_relaxation_of_two_particles(tmp_path, law, sizes):
    """T1 - T2 decays with h (1/(m1 cp) + 1/(m2 cp)): 1e-3, of first order in 2000 sub-steps; the heat stays, to
    1e-13."""
    k, cp, overlap = 5000.0, 100.0, 0.01 * R
    m = [RHO * np.pi / 6 * d**3 for d in sizes]
    rate = conductances(law, k, overlap, sizes) * sum(1 / (x * cp) for x in m)
    end = 2000 * LIMIT
    k, end = (k, 0.5 / rate) if 0.5 / rate < end else (k, end)
    thermal = {**MATERIAL, 'thermalConductivity': k, 'heatCapacity': cp}
    case, output = run(tmp_path, pair(-overlap, 0, d=sizes, T=[400.0, 300.0]), end, end / 2000, heat=True,
                       lubrication=None, conduction=LAWS[law], materials={'glass': thermal},
                       forces={'Sp': 1e9 * m[0] / end, 'U': (0, 0, 0)})
    T = rows_of(case)['T']
    assert abs((T[0] - T[1]) / 100 - np.exp(-rate * end)) < 1e-3
    assert rate * end > 0.05
    assert abs(m[0] * (T[0] - 400) + m[1] * (T[1] - 300)) < 1e-13 * (m[0] * 400 + m[1] * 300)


@pytest.mark.parametrize('floor', ['plane', 'triangles', 'edge'])
@pytest.mark.parametrize('law', LAWS)
def test_sphere_on_a_hot_wall(tmp_path, law, floor):
    """m cp dT/dt = h (T_w - T); all of its heat is in the ledger. An unheated wall beside it gives none."""
    wall, at = FLOORS[floor]
    k, cp, overlap = 5000.0, 100.0, 0.01 * R
    rate = conductances(law, k, overlap, None, wall=True) / (M * cp)
    end = min(0.5 / rate, 2000 * LIMIT)
    thermal = {**MATERIAL, 'thermalConductivity': k, 'heatCapacity': cp}
    case, output = run(tmp_path, {'x': [at[0], 9e-3], 'y': [at[1], 1e-2 - R + overlap],
                                  'z': [1e-3 + R - overlap, 5e-3], 'd': 2 * R, 'T': 300.0}, end, end / 2000,
                       heat=True, lubrication=None, conduction=LAWS[law], materials={'glass': thermal},
                       walls={'floor': {**wall, 'material': 'glass', 'T': 350},
                              'side': {'type': 'patch', 'patches': ('yMax',), 'material': 'glass'}},
                       files={'constant/floor.stl': STL}, forces={'Sp': 1e9 * M / end, 'U': (0, 0, 0)})
    T = rows_of(case)['T']
    assert abs(T[0] - (350 - 50 * np.exp(-rate * end))) < 0.05
    assert T[0] > 302
    assert T[1] == 300
    heat = float(re.findall(r'walls (\S+)', output)[-1])
    assert abs(heat / (M * cp * (T[0] - 300)) - 1) < 1e-5       # six digits are printed


def test_impact_gives_its_heat_once(tmp_path):
    """One elastic collision, Q by Sun and Chen with the coefficient of Zhou et al., computed here anew; the speed of
    touch is that of the start, so that 1e-9 is round-off; nothing while they move apart."""
    v, dT = 0.3, 100.0
    x = 1.0
    e_star, m_star, r_star = 1e8 / (2 * (1 - 0.09)), M / 2, R / 2
    delta = (15 * m_star * v**2 / (16 * np.sqrt(r_star) * e_star))**0.4
    t = 2.94 * delta / v
    rc = RHO * CP
    fo = K * t / (rc * r_star * delta)
    c1, c2, c3 = -2.3*x**2 + 8.909*x - 4.235, 8.169*x**2 - 33.77*x + 24.885, -5.758*x**2 + 24.464*x - 20.511
    c = 0.435 * (np.sqrt(c2**2 - 4 * c1 * (c3 - fo)) - c2) / c1
    Q = c * dT * np.pi * r_star * delta * np.sqrt(t) * np.sqrt(rc * K) / 2
    case, _ = run(tmp_path, pair(1e-6, v, T=[300.0 + dT, 300.0]), 2 * t + 1e-5, LIMIT / 10, n_out=2, heat=True,
                  lubrication=None, conduction={'type': 'impact'}, restitution=1)
    s, rate = opening(rows_of(case))
    assert s > 0 and abs(rate / v - 1) < 0.01
    T = rows_of(case)['T']
    # A change of 1e-3 K in 400 K: round-off of T
    assert abs(M * CP * (T[1] - 300) / Q - 1) < 1e-9 + 1e-12 * 400 / (T[1] - 300)
    assert abs(T.sum() - 700) < 1e-12 * 700


def test_a_ball_that_bounces_on_a_hot_wall(tmp_path):
    """Near the wall without touching it passes no heat (contact); each impact gives its own, once (impact): their
    number is that of the ballistic flights 2 e^n v/g between contacts of Hertz' duration. All heat is in the ledger."""
    end, heats, e, g = 0.02, {}, 0.8, 9.81
    v, t, expected = np.sqrt(0.03**2 + 2 * g * 2e-6), 2e-6 / 0.03, 0
    while t < end:
        expected += 1
        t += 2.87 * (M**2 / (R * (1e8 / 1.82)**2 * v))**0.2 + 2 * e * v / g
        v *= e
    for law in ('contact', 'impact', 'none'):
        case, output = run(tmp_path / law, {'x': 5e-3, 'y': 5e-3, 'z': R + 2e-6, 'd': 2 * R, 'vz': -0.03, 'T': 300.0},
                           end, LIMIT, n_out=200, gravity=(0, 0, -g), heat=True, lubrication=None,
                           conduction={'type': law}, restitution=e,
                           walls={'floor': {'type': 'patch', 'patches': ('zMin',), 'material': 'glass', 'T': 350}})
        T = np.array([rows_of(case, n)['T'][0] for n in range(200)])
        z = np.array([rows_of(case, n)['z'][0] for n in range(200)]) - R
        assert np.all(np.isfinite(T))
        heats[law] = T[-1] - 300
        if law != 'none':
            away = (z[:-1] > 1e-6) & (z[1:] > 1e-6) & (np.diff(T) == 0)
            assert away.sum() > 100
            assert T[-1] > 300
            walls = np.array([float(q) for q in re.findall(r'walls (\S+)', output)])
            assert abs(walls.sum() / (M * CP * heats[law]) - 1) < 1e-4
        if law == 'impact':
            assert (np.diff(np.append(300, T)) > 0).sum() == expected == 7
    assert heats['none'] == 0


def test_heat_of_pairs_on_ranks(tmp_path):
    """A crowd of colliding spheres: heat of all stays to 1e-13, also across ranks, and two ranks give what one
    gives."""
    states = []
    for law in ({'type': 'contact'}, {'type': 'impact'}):
        for ranks in (1, 2):
            columns = cloud(100)
            columns['T'] = 300 + np.arange(100.0)
            columns.update({c: 20 * np.array(columns[c]) for c in ('vx', 'vy', 'vz')})
            case, _ = run(tmp_path / f'{law["type"]}{ranks}', columns, 200 * LIMIT, LIMIT, ranks=ranks, heat=True,
                          lubrication=None, conduction=law)
            T = rows_of(case)['T']
            assert abs(T.sum() - columns['T'].sum()) < 1e-13 * T.sum()
            assert np.abs(T - columns['T']).max() > 1e-6
            states.append(T)
    assert np.abs(states[0] - states[1]).max() < 1e-9
    assert np.abs(states[2] - states[3]).max() < 1e-9
