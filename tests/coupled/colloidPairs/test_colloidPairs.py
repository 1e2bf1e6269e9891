"""Forces of colloids in the engine against an independent calculation: the velocity that one very short sub-step gives to
particles at rest, F dt/m. Formulas are written out below (Hamaker 1937, Hogg et al. 1966, Gregory 1975), differentiated with
mpmath where the force itself is lengthy."""
import re

import mpmath
import numpy as np
import pytest

import colloidTheory
from dewCase import Case, changed, foam_dict, quoted

K, E, NA, EPS0 = 1.380649e-23, 1.602176634e-19, 6.02214076e23, 8.8541878128e-12
T, EPSR, RHO, A, PSI = 298.15, 78.5, 2650.0, 1e-20, 25e-3
EPS = EPSR * EPS0
KAPPA = float(np.sqrt(2 * E**2 * NA * 1.0 / (EPS * K * T)))
MIN_GAP, CUT_OFF = 2e-10, 60e-9
DT = 1e-14
HAMAKER = {'type': 'Hamaker', 'hamaker': A}
CHARGED = {'type': 'constantPotential', 'zeta': PSI}
SOFT = {'youngsModulus': 1e6, 'poissonsRatio': 0.3, 'density': RHO}
STL = ('solid floor\n' + ''.join(
    'facet normal 0 0 1\n outer loop\n' + ''.join(f'  vertex {x} {y} {{z}}\n' for x, y in corners)
    + ' endloop\nendfacet\n' for corners in (((-9e-4, -9e-4), (9e-4, -9e-4), (9e-4, 9e-4)),
                                              ((-9e-4, -9e-4), (9e-4, 9e-4), (-9e-4, 9e-4))))
       + 'endsolid floor\n')


# --- The formulas

def hamaker_U(h, a, b=None):
    """Two spheres, or a sphere and a plate, Hamaker's expression at 60 digits."""
    h, a = mpmath.mpf(h), mpmath.mpf(a)
    if b is None:
        return -A / mpmath.mpf(6) * (a / h + a / (h + 2*a) + mpmath.log(h / (h + 2*a)))
    b = mpmath.mpf(b)
    r = h + a + b
    p, q = r**2 - (a + b)**2, r**2 - (a - b)**2
    return -A / mpmath.mpf(6) * (2*a*b/p + 2*a*b/q + mpmath.log(p / q))


def force(U, h, *radii):
    with mpmath.workdps(60):
        return -float(mpmath.diff(lambda x: U(x, *radii), mpmath.mpf(h)))


def derjaguin(a, b=None):
    return a if b is None else a * b / (a + b)


def constant_potential(h, a, b=None, psi1=PSI, psi2=PSI, sign=1):
    x = np.exp(-KAPPA * h)
    return (2 * np.pi * EPS * derjaguin(a, b) * KAPPA * x * (2 * psi1 * psi2 - sign * (psi1**2 + psi2**2) * x)
            / (1 - x**2))


def superposition(h, a, b=None):
    phi = K * T / E
    return 64 * np.pi * EPS * derjaguin(a, b) * KAPPA * phi**2 * np.tanh(PSI / (4 * phi))**2 * np.exp(-KAPPA * h)


def total(h, a, b=None):
    return force(hamaker_U, h, *([a] if b is None else [a, b])) + constant_potential(h, a, b)


# --- Cases

def case_of(path, forces, x, d, dt=DT, n_sub=1, n_out=1, code=0, ranks=1, walls=None, files=None, changes=None,
            v=None, width=None, cyclic='', run=True, **more):
    x, d = np.atleast_2d(x), np.broadcast_to(d, np.atleast_2d(x).shape[0])
    width = width or 40 * max(d)
    case = Case(path, lower=(-width / 2,) * 3, upper=(width / 2,) * 3, cells=(2, 2, 2), gravity=(0, 0, 0),
                deltaT=dt * n_sub, endTime=dt * n_sub * n_out, writeInterval=1000000, timePrecision=15, cyclic=cyclic,
                **more)
    case.properties = {
        'engine': 'liggghts', 'materials': {'silica': SOFT},
        'contacts': {'tangential': 'none', 'default': {'restitution': 1}},
        'insertion': {'some': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'silica'}},
        'timeStep': {'deltaT': dt}, 'overlapTolerance': 0.2, 'output': ('csv',),
        'colloids': {'temperature': T, 'permittivity': EPSR, 'ionicStrength': 1, 'minGap': MIN_GAP, 'cutOff': CUT_OFF,
                     'forces': forces}, **({'walls': walls} if walls else {}),
        **({'processors': (ranks, 1, 1)} if ranks > 1 else {})}
    case.properties = changed(case.properties, changes or {})
    columns = {'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': d}
    if v is not None:
        columns.update({'v' + 'xyz'[k]: np.atleast_2d(v)[:, k] for k in range(3)})
    case.particles(columns)
    for name, text in (files or {}).items():
        case.write_file(name, text)
    case.mesh()
    case.write_file('constant/testProperties', '')
    if not run:
        return case
    if ranks > 1:
        case.decompose(ranks)
    done = case.run('testEngine', ranks=ranks, timeout=200)
    assert (done.code == 0) == (code == 0), done.output
    return case, done.output


def rows_of(case, k=-1):
    rows = np.genfromtxt(case.path / case.times()[k] / 'engine.csv', delimiter=',', names=True)
    return np.sort(np.atleast_1d(rows), order='id')


def vectors(rows, names):
    return np.stack([rows[n] for n in names.split()], axis=1)


def forces_on(case, dt=DT):
    rows = rows_of(case)
    return vectors(rows, 'vx vy vz') * (RHO * np.pi / 6 * rows['d']**3 / dt)[:, None]


def two(h, d, axis=(2/7, 3/7, 6/7)):
    """Places of two spheres, and the gap that these round-off to."""
    n = np.array(axis)
    x = np.array([-n * (d[0] + h) / 2, n * (d[1] + h) / 2])
    return x, np.linalg.norm(x[1] - x[0]) - sum(d) / 2


# --- Pairs

LAWS = {
    'Hamaker': (HAMAKER, lambda h, a, b: force(hamaker_U, h, a, b)),
    'constantPotential': (CHARGED, constant_potential),
    'constantCharge': ({**CHARGED, 'type': 'constantCharge'},
                       lambda h, a, b: constant_potential(h, a, b, sign=-1)),
    'linearSuperposition': ({**CHARGED, 'type': 'linearSuperposition'}, superposition),
    'Yukawa': ({**CHARGED, 'type': 'Yukawa'}, superposition),
    'Born': ({'type': 'Born', 'hamaker': A, 'sigma': 4e-10},
             lambda h, a, b: A * (4e-10)**6 * derjaguin(a, b) / (180 * h**8)),
    'hydration': ({'type': 'hydration', 'energy': 5e-3, 'length': 6e-10},
                  lambda h, a, b: 2 * np.pi * derjaguin(a, b) * 5e-3 * np.exp(-h / 6e-10)),
    'steric': ({'type': 'steric', 'spacing': 4e-9, 'thickness': 8e-9},
               lambda h, a, b: 2 * np.pi * derjaguin(a, b) * float(mpmath.quad(
                   lambda g: K * T / (4e-9)**3 * ((1.6e-8 / g)**2.25 - (g / 1.6e-8)**0.75), [h, 1.6e-8]))
               if h < 1.6e-8 else 0.0)}


@pytest.mark.parametrize('d', [(5e-8, 5e-8), (1e-6, 1e-6), (1e-5, 1e-5), (2e-7, 1e-6)])
@pytest.mark.parametrize('law', LAWS)
def test_force_of_a_law(tmp_path, law, d):
    """F dt/m to 1e-6, and the sum of both to round-off (1e-12); gaps from 0.3 to 30 nm, together with another pair."""
    entries, expected = LAWS[law]
    gaps = [3e-10, 1e-9, 5e-9, 3e-8]
    pairs = [two(h, d) for h in gaps]
    places = [x + np.array([0, 4 * max(d) * (k - 1.5), 0]) for k, (x, _) in enumerate(pairs)]
    case, _ = case_of(tmp_path, {'one': entries}, np.vstack(places), d * len(gaps))
    rows, F = rows_of(case), forces_on(case)
    for k, x in enumerate(places):
        r = x[1] - x[0]
        h = np.linalg.norm(r) - sum(d) / 2
        F_expected = expected(h, d[0] / 2, d[1] / 2)
        if abs(F_expected) < 1e-25:
            assert np.abs(F[2*k:2*k + 2]).max() < 1e-25
            continue
        assert abs(F[2*k + 1] @ r / np.linalg.norm(r) / F_expected - 1) < 1e-6
        assert np.abs(F[2*k] + F[2*k + 1]).max() < 1e-12 * abs(F_expected)
    assert len(rows) == 2 * len(gaps)


@pytest.mark.parametrize('forces, h, expected', [
    ('Hamaker', 1e-9, 4.167e-10), ('Hamaker', 5e-9, 1.667e-11), ('Hamaker', 1e-8, 4.17e-12),
    ('constantPotential', 1e-9, 6.72e-11), ('constantPotential', 1e-8, 3.71e-11),
    ('linearSuperposition', 1e-9, 1.230e-10), ('linearSuperposition', 1e-8, 4.825e-11)])
def test_published_size(tmp_path, forces, h, expected):
    """Radius 0.5 um, 1 mM, 25 mV: Derjaguin's A R/(12 h^2), and double layers, to the three digits and to h/R."""
    x, _ = two(h, (1e-6, 1e-6))
    case, _ = case_of(tmp_path, {'one': LAWS[forces][0]}, x, 1e-6)
    F = np.linalg.norm(forces_on(case)[0])
    assert abs(F / expected - 1) < (4.2 * h / 1e-6 + 1e-3 if forces == 'Hamaker' else 1.4e-3)


def test_three_of_unequal_size(tmp_path):
    """Sums over pairs, and their total is zero to round-off."""
    d = np.array([1e-6, 4e-7, 7e-7])
    x = np.array([[0, 0, 0], [7.02e-7, 0, 0], [0, 8.7e-7, 0]])
    x[2, 0] = 0.1e-6
    case, output = case_of(tmp_path, {'v': HAMAKER, 'e': CHARGED}, x, d)
    F, expected, energy = forces_on(case), np.zeros((3, 3)), 0.0
    for i in range(3):
        for j in range(3):
            r = x[i] - x[j]
            h = np.linalg.norm(r) - (d[i] + d[j]) / 2
            if i != j and h < CUT_OFF:
                expected[i] += total(h, d[i] / 2, d[j] / 2) * r / np.linalg.norm(r)
    assert np.count_nonzero(np.abs(expected).sum(axis=1)) == 3
    assert np.abs(F - expected).max() < 1e-6 * np.abs(expected).max()
    assert np.abs(F.sum(axis=0)).max() < 1e-12 * np.abs(F).max()


@pytest.mark.parametrize('h, shift', [(1e-9, 0), (5.5e-8, 4.9e-7)], ids=['near', 'far'])
@pytest.mark.parametrize('ranks, cyclic', [(2, ''), (1, 'x'), (2, 'x')])
def test_pair_across_a_boundary(tmp_path, ranks, cyclic, h, shift):
    """Between ranks and across a cyclic side as within one, also with one of them on the boundary and the other as far away
    as the forces reach: 1e-9 for round-off of positions over the gap."""
    x, _ = two(h, (1e-6, 1e-6), (1, 0, 0))
    x[:, 0] += shift
    if cyclic:
        x += np.array([2e-5, 0, 0])
        x[1, 0] -= 4e-5
    case, output = case_of(tmp_path, {'v': HAMAKER, 'e': CHARGED}, x, 1e-6, ranks=ranks, cyclic=cyclic)
    gap = (x[1, 0] - x[0, 0]) % 4e-5 - 1e-6
    F, expected = forces_on(case), total(gap, 5e-7, 5e-7)
    assert np.abs(F[:, 0] / expected - [-1, 1]).max() < 1e-6
    assert np.abs(F.sum(axis=0)).max() < 1e-9 * abs(expected)
    energy = float(re.search(r'energies \S+ (\S+)', output).group(1))
    phi = KAPPA * gap
    U = float(hamaker_U(gap, 5e-7, 5e-7)) + 2 * np.pi * EPS * 2.5e-7 * PSI**2 * 2 * np.log1p(np.exp(-phi))
    assert abs(energy / U - 1) < 1e-6


def test_energy_in_the_log(tmp_path):
    """demFoam tells of the energy after each step, here 1e-14 s from the start: to the digits it prints."""
    x, _ = two(2e-9, (1e-6, 1e-6))
    case = case_of(tmp_path, {'v': HAMAKER}, x, 1e-6, run=False)
    done = case.run('demFoam')
    assert done.code == 0, done.output
    found = float(re.search(r'colloidal energy (\S+) J', done.output).group(1))
    assert abs(found / float(hamaker_U(2e-9, 5e-7, 5e-7)) - 1) < 1e-3


def test_held_below_the_least_gap(tmp_path):
    """F(minGap) below it, nothing beyond the cut-off."""
    for name, h, at in (('below', 1e-10, MIN_GAP), ('beyond', 6.001e-8, None)):
        x, _ = two(h, (1e-6, 1e-6))
        case, _ = case_of(tmp_path / name, {'v': HAMAKER}, x, 1e-6)
        F = np.linalg.norm(forces_on(case)[0])
        assert F == 0 if at is None else abs(F / -force(hamaker_U, at, 5e-7, 5e-7) - 1) < 1e-6


@pytest.mark.parametrize('wall', [{'type': 'plane', 'point': (0, 0, -2**-20), 'normal': (0, 0, 1)},
                                  {'type': 'STL', 'file': quoted('constant/floor.stl')}], ids=['plane', 'STL'])
@pytest.mark.parametrize('d', [1e-7, 1e-6])
def test_wall(tmp_path, wall, d):
    """A sphere at a plate, on planes and triangles, 1e-6. The place is exact in the single precision of STL files."""
    gaps = [1e-9, 5e-9, 3e-8]
    x = np.array([[4 * d * (k - 1), 0.3 * d * k, d / 2 + h - 2**-20] for k, h in enumerate(gaps)])
    case, _ = case_of(tmp_path, {'v': HAMAKER, 'e': CHARGED}, x, d, walls={'floor': {**wall, 'material': 'silica'}},
                      files={'constant/floor.stl': STL.format(z=-2**-20).replace('9e-4', '9e-6')}, width=2e-5)
    F = forces_on(case)
    for k, z in enumerate(x[:, 2]):
        expected = total(z + 2**-20 - d / 2, d / 2)
        assert abs(F[k, 2] / expected - 1) < 1e-6
        assert np.abs(F[k, :2]).max() < 1e-9 * abs(expected)


@pytest.mark.parametrize('other', ['plane', 'STL', 'sphere'])
@pytest.mark.parametrize('h0', [6.5e-8, 1.1e-7, 2.3e-7])
def test_coming_from_afar(tmp_path, other, h0):
    """Lists are built in time: a sphere that comes at 1 m/s from beyond the cut-off has at 40 nm the speed that the energy
    between cut-off and there leaves it (1e-3 of the change: first order of the sub-step at the cut-off)."""
    d, v, h = 1e-7, 1.0, 4e-8
    steps = int(round((h0 - h) / v / 1e-11))
    shape = {'plane': {'type': 'plane', 'point': (0, 0, -2**-20), 'normal': (0, 0, 1)},
             'STL': {'type': 'STL', 'file': quoted('constant/floor.stl')}}.get(other)
    x = np.array([[0, 0, d / 2 + h0 - 2**-20]])
    R, share = (d / 2,), 1.0
    if other == 'sphere':
        # A thousand times the mass: it stays
        x = np.vstack([x, [0, 0, -5 * d - 2**-20]])
        R, share = (d / 2, 5 * d), 1 / (1 + 1e-3)
    case, _ = case_of(tmp_path, {'v': HAMAKER, 'e': CHARGED}, x, [d, 10 * d][:len(x)], dt=1e-11, n_sub=steps, n_out=1,
                      walls={'floor': {**shape, 'material': 'silica'}} if shape else None, width=2e-5,
                      v=[[0, 0, -v], [0, 0, 0]][:len(x)], files={
                          'constant/floor.stl': STL.format(z=-2**-20).replace('9e-4', '9e-6')})
    rows = rows_of(case)
    gap = rows['z'][0] + 2**-20 - d / 2 - (rows['z'][1] + 5 * d + 2**-20 if len(rows) > 1 else 0)
    assert abs(gap - h) < 1e-9
    lost = float(mpmath.quad(lambda s: total(float(s), *R), [gap, CUT_OFF]))
    m = RHO * np.pi / 6 * d**3 * share
    speed = rows['vz'][0] - (rows['vz'][1] if len(rows) > 1 else 0)
    assert abs((v**2 - speed**2) / (2 * lost / m) - 1) < 2e-3


def test_coming_to_another_rank(tmp_path):
    """The same of a large sphere that comes to a small one just behind the boundary of two ranks, from beyond the cut-off
    when the lists were built."""
    d, D, v, h0, h = 1e-7, 1e-6, 1.0, 1.12e-7, 4e-8
    x = np.array([[1e-9, 0, 0], [1e-9 - (d + D) / 2 - h0, 0, 0]])
    case, _ = case_of(tmp_path, {'v': HAMAKER, 'e': CHARGED}, x, [d, D], dt=1e-11, n_sub=int(round((h0 - h) / v / 1e-11)),
                      n_out=1, width=2e-5, v=[[0, 0, 0], [v, 0, 0]], ranks=2)
    rows = rows_of(case)
    gap = rows['x'][0] - rows['x'][1] - (d + D) / 2
    lost = float(mpmath.quad(lambda s: total(float(s), d / 2, D / 2), [gap, CUT_OFF]))
    m = RHO * np.pi / 6 * d**3 / (1 + (d / D)**3)
    assert abs((v**2 - (rows['vx'][0] - rows['vx'][1])**2) / (2 * lost / m) - 1) < 2e-3
    # Both felt it
    assert abs(rows['vx'][0] * (d / D)**3 / (v - rows['vx'][1]) - 1) < 1e-3


def atoms_at_wall(z, R, sigma, attraction=True):
    """A sphere of Lennard-Jones atoms with its centre at z over a half-space of them: the 9-3 potential of one atom (R.
    Everaers, M.R. Ejtehadi, Phys. Rev. E 67 (2003) 041710 start from the same pairs), summed over the sphere's slices;
    A = 4 pi^2 epsilon rho1 rho2 sigma^6."""
    with mpmath.workdps(40):
        z, R, s = (mpmath.mpf(float(v)) for v in (z, R, sigma))
        h = z - R
        # A slice has an area of pi (R^2 - (y - z)^2): its derivative by z remains
        edges = [h * 2**k for k in range(60) if h * 2**k < h + 2*R] + [h + 2*R]
        return float(-A / (6 * s**3) * mpmath.quad(
            lambda y: (2 * (s/y)**9 / 15 - (s/y)**3 * attraction) * 2 * (y - z), edges))


@pytest.mark.parametrize('attraction', [True, False])
@pytest.mark.parametrize('d', [5e-8, 1e-6])
def test_wall_of_atoms(tmp_path, d, attraction):
    """1e-6; no force between particles."""
    gaps = [2.5e-10, 5e-10, 3e-9]
    x = np.array([[(d + 2e-9) * (k - 1), 0, d / 2 + h - 2**-20] for k, h in enumerate(gaps)])
    law = {'type': 'LennardJonesWall', 'hamaker': A, 'sigma': 4e-10, 'vanDerWaals': attraction}
    case, _ = case_of(tmp_path, {'w': law}, x, d, width=2e-5, walls={
        'floor': {'type': 'plane', 'point': (0, 0, -2**-20), 'normal': (0, 0, 1), 'material': 'silica'}})
    F = forces_on(case)
    for k, z in enumerate(x[:, 2] + 2**-20):
        assert abs(F[k, 2] / atoms_at_wall(z, d / 2, 4e-10, attraction) - 1) < 1e-6
    assert np.abs(F[:, :2]).max() == 0


def test_materials(tmp_path):
    """Entries of a pair, and of one material, replace those for all."""
    x, _ = two(2e-9, (1e-6, 1e-6))
    case = case_of(tmp_path, {'v': {**HAMAKER, 'silica.other': {'hamaker': 3 * A}},
                              'e': {**CHARGED, 'other': {'zeta': 10e-3}}}, x, 1e-6, run=False,
                   changes={'materials/other': SOFT})
    del case.properties['insertion']['some']['material']
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': 1e-6, 'material': ['silica', 'other']})
    case.write()
    done = case.run('testEngine')
    assert done.code == 0, done.output
    expected = (3 * force(hamaker_U, 2e-9, 5e-7, 5e-7)
                + constant_potential(2e-9, 5e-7, 5e-7, PSI, 10e-3))
    F = forces_on(case)[1] @ [2/7, 3/7, 6/7]
    assert abs(F / expected - 1) < 1e-6


def test_bound_pair_keeps_its_energy(tmp_path):
    """Vibration in the primary minimum of Born and van der Waals forces (1e5 sub-steps of a sixtieth of a period): the
    energy stays within 1e-4 of the depth of the well, kinetic energy and the engine's own sum."""
    s, R = 4e-10, 5e-7
    h0 = 30**(-1/6) * s
    x, _ = two(1.05 * h0, (1e-6, 1e-6))
    depth = A * R / 2 / h0 * (1/6 - 1/1260 * 30)
    k = A * R / 2 * (56 * s**6 / (1260 * h0**9) - 2 / (6 * h0**3))
    dt = 0.1 * np.sqrt(RHO * 4 / 3 * np.pi * R**3 / 2 / k)
    dt = float(f'{dt:.3g}')
    _, output = case_of(tmp_path, {'v': HAMAKER, 'b': LAWS['Born'][0]}, x, 1e-6, dt=dt, n_sub=2000, n_out=50,
                        changes={'colloids/minGap': 2.1e-10})
    found = np.array([[float(e) for e in m] for m in re.findall(r'energies (\S+) (\S+)', output)])
    assert len(found) == 50 and found[:, 0].max() > 1e-4 * depth
    assert abs(-found[:, 1].min() / depth - 1) < 0.01
    total_energy = found.sum(axis=1)
    assert np.abs(total_energy - total_energy[0]).max() < 1e-4 * depth


def test_restart_goes_on_exactly(tmp_path):
    """Half of the way in one run and half after a restart: the same numbers, bit by bit."""
    x, _ = two(3e-9, (1e-6, 8e-7))
    laws = {'v': HAMAKER, 'e': CHARGED, 'b': LAWS['Born'][0]}
    dt = 1e-9
    whole, _ = case_of(tmp_path / 'whole', laws, x, (1e-6, 8e-7), dt=dt, n_sub=20, n_out=10,
                       changes={'colloids/minGap': 3e-10})
    half = case_of(tmp_path / 'half', laws, x, (1e-6, 8e-7), dt=dt, n_sub=20, n_out=10,
                   changes={'colloids/minGap': 3e-10}, run=False)
    half.control.update(endTime=5 * 20 * dt, writeInterval=5)
    half.write()
    assert half.run('testEngine').code == 0
    half.control.update(endTime=10 * 20 * dt)
    half.write()
    done = half.run('testEngine')
    assert done.code == 0 and 'continued' in done.output, done.output
    names = 'x y z vx vy vz'
    assert np.abs(vectors(rows_of(whole), 'vx vy vz')).max() > 0
    assert np.array_equal(vectors(rows_of(whole), names), vectors(rows_of(half), names))


# --- Ranks

def suspension(path, d, dynamics, ranks=1, **control):
    """216 Brownian colloids with gaps of 14 nm on over a wall, 100 sub-steps in 10 intervals."""
    rng = np.random.default_rng(3)
    spacing = d + 3e-8
    x = spacing * (np.array(list(np.ndindex(6, 6, 6))) - 2.5) + rng.uniform(-8e-9, 8e-9, (216, 3))
    case = case_of(path, {'v': HAMAKER, 'e': CHARGED}, x, d, dt=2e-10 if d < 1e-7 else 5e-8, n_sub=10, n_out=10, run=False,
                   width=8 * spacing, changes={'colloids/minGap': 1e-9, 'dynamics': dynamics}, walls={'floor': {
                       'type': 'plane', 'point': (0, 0, float(x[:, 2].min() - d/2 - 1e-8)), 'normal': (0, 0, 1),
                       'material': 'silica'}})
    case.cells = (4, 2, 2)
    case.control.update(control)
    case.mesh()
    case.write_file('constant/testProperties', foam_dict(
        {'Sp': 3 * np.pi * 1e-3 * d, 'U': (0, 0, 0), 'kT': K * T}) + '\n')
    if ranks > 1:
        case.decompose(ranks)
    return case


def at_end(case, ranks=1):
    done = case.run('testEngine', ranks=ranks, timeout=120)
    assert done.code == 0, done.output
    return vectors(rows_of(case), 'x y z')


CROWDS = pytest.mark.parametrize('dynamics', [{'seed': 7}, {'type': 'overdamped', 'viscosity': 1e-3, 'seed': 7}],
                                 ids=['inertial', 'overdamped'])


@CROWDS
@pytest.mark.parametrize('d', [5e-8, 1e-5])
def test_suspension_on_ranks_and_after_a_restart(tmp_path, d, dynamics):
    """1, 2 and 4 ranks: the same to 1e-9 radii, so the same noise; a restart half-way bit by bit, and on two ranks to
    1e-9 radii. Forces and noise move all by more than 1e-6 radii."""
    case = suspension(tmp_path / '1', d, dynamics)
    whole = at_end(case)
    start = np.genfromtxt(case.path / 'constant/particles.csv', delimiter=',', names=True)
    assert np.median(np.abs(whole - vectors(start, 'x y z'))) > 1e-6 * d / 2
    for ranks in (2, 4):
        assert np.abs(at_end(suspension(tmp_path / str(ranks), d, dynamics, ranks), ranks) - whole).max() < 1e-9 * d / 2

    half = suspension(tmp_path / 'half', d, dynamics, writeInterval=5)
    end = half.control['endTime']
    half.control['endTime'] = end / 2
    half.write()
    at_end(half)
    half.control['endTime'] = end
    half.write()
    other = half.copy(tmp_path / 'other')
    assert np.array_equal(at_end(half), whole)
    other.decompose(2)
    for rank in range(2):
        source = other.path / other.times()[-1]
        target = other.path / f'processor{rank}' / source.name / 'uniform'
        if not target.exists():
            target.parent.mkdir(parents=True, exist_ok=True)
            target.symlink_to(source / 'uniform')
    assert np.abs(at_end(other, 2) - whole).max() < 1e-9 * d / 2


# --- Rough surfaces

def dlvo(a, b=None):
    """F and U of van der Waals and double layer over a gap."""
    return lambda h: tuple(v + e for v, e in zip(
        colloidTheory.hamaker(h, A, a, b), colloidTheory.constant_potential(h, EPS, KAPPA, PSI, a, b)))


@pytest.mark.parametrize('d', [(5e-8, 5e-8), (1e-6, 1e-6), (2e-7, 1e-6)])
def test_rough_surfaces(tmp_path, d):
    """F of pairs and at a wall averaged over heights of s^2 = s1^2 + s2^2, of one size and of two, and below the least gap
    that of the least gap; all of the energy; 1e-4, for the table of sizes."""
    s1, s2 = 6e-10, 8e-10
    gaps = [1.5e-10, 1e-9, 4e-9, 3e-8]
    pairs = [two(h, d) for h in gaps]
    # Apart from each other and from the wall, and two at the wall
    places = [x + np.array([0, 4 * max(d) * (k - 1.5), 8 * max(d)]) for k, (x, _) in enumerate(pairs)]
    z = 2**-20
    at_wall = np.array([[0, (8 + 3*k) * max(d), d[k] / 2 + 3e-9 - z] for k in range(2)])
    case, output = case_of(
        tmp_path, {'v': HAMAKER, 'e': CHARGED}, np.vstack([*places, at_wall]), d * (len(gaps) + 1), width=4e-5,
        walls={'floor': {'type': 'plane', 'point': (0, 0, -z), 'normal': (0, 0, 1), 'material': 'glass'}},
        changes={'materials/glass': SOFT, 'colloids/roughness': {'silica': s1, 'glass': s2}})
    F, energy, terms = forces_on(case), 0, 0
    for k, x in enumerate(places):
        r = x[1] - x[0]
        gap = np.linalg.norm(r) - sum(d) / 2
        h = max(gap, MIN_GAP)
        f, U = colloidTheory.over_heights(dlvo(d[0] / 2, d[1] / 2), h, np.sqrt(2) * s1, MIN_GAP)
        assert abs(F[2*k + 1] @ r / np.linalg.norm(r) / f - 1) < 1e-4
        energy += U + f * (h - gap)
        terms += abs(U)
    for k in range(2):
        h = at_wall[k, 2] + z - d[k] / 2
        f, U = colloidTheory.over_heights(dlvo(d[k] / 2), h, np.hypot(s1, s2), MIN_GAP)
        assert abs(F[2*len(gaps) + k, 2] / f - 1) < 1e-4
        energy += U
        terms += abs(U)
    assert abs(float(re.search(r'energies \S+ (\S+)', output).group(1)) - energy) < 1e-4 * terms


# --- The sub-step

def slope_of_hamaker(h, *radii):
    with mpmath.workdps(60):
        return abs(float(mpmath.diff(lambda x: hamaker_U(x, *radii), mpmath.mpf(h), 2)))


DRAG = 6 * np.pi * 1e-3
STEEP = {
    'inertial': ({}, {'v': HAMAKER}, MIN_GAP,
                 lambda R: 2 * np.sqrt(RHO * 4 / 3 * np.pi * R**3 / 2 / slope_of_hamaker(MIN_GAP, R, R))),
    'attraction': ({'type': 'overdamped', 'viscosity': 1e-3}, {'v': HAMAKER}, MIN_GAP,
                   lambda R: DRAG * R * 0.01 * R / (2 * abs(force(hamaker_U, MIN_GAP, R, R)))),
    'weak': ({'type': 'overdamped', 'viscosity': 1e-3}, {'v': HAMAKER}, 2e-8,
             lambda R: DRAG * R / slope_of_hamaker(2e-8, R)),
    'repulsion': ({'type': 'overdamped', 'viscosity': 1e-3}, {'e': CHARGED}, MIN_GAP,
                  lambda R: DRAG * R / (2 * np.pi * EPS * R * KAPPA**2 * PSI**2 / 2))}


@pytest.mark.parametrize('case', STEEP)
def test_limit_of_the_sub_step(tmp_path, case):
    """2 sqrt(m*/k) of the steepest force, van der Waals at the least gap; without inertia an attraction may pull two by 1 %
    of R into each other, or has 6 pi mu R/k where that is longer, at a wall, where a force is twice as steep; and a repulsion
    has it, that of two equal potentials steepest at a wall at contact, 2 pi eps R kappa^2 psi^2/4 times 2 (MIN_GAP is near
    enough: kappa h = 0.02). The slope is sampled: 1 %."""
    R = 5e-7
    dynamics, forces, least, limit = STEEP[case]
    expected = limit(R)
    x, _ = two(1e-8, (1e-6, 1e-6))
    more = {'dynamics/' + key: value for key, value in dynamics.items()}
    case = case_of(tmp_path, forces, x, 1e-6, run=False, changes={
        **more, 'materials/silica/youngsModulus': 1e4 if least == MIN_GAP else 10.0, 'colloids/minGap': least})
    case.write_file('constant/testProperties', foam_dict({'Sp': 6 * np.pi * 1e-3 * R, 'U': (0, 0, 0)}) + '\n')
    done = case.run('testEngine')
    assert done.code == 0, done.output
    found = float(re.search(r'Stable sub-step (\S+)', done.output).group(1))
    assert abs(found / expected - 1) < 0.01
    share = int(re.search(r', sub-step \S+ s, (\d+) % of the stability limit', done.output).group(1))
    assert abs(share - 100 * 1e-14 / expected) <= 0.5
    case.properties['timeStep'] = {'deltaT': 0.4 * expected}
    case.control.update(deltaT=0.4 * expected, endTime=0.4 * expected)
    case.write()
    done = case.run('testEngine')
    assert done.code == 0 and ' s, 40 % of the stability limit' in done.output, done.output
    case.control.update(deltaT=2 * expected, endTime=2 * expected)
    case.properties['timeStep'] = {'deltaT': 2 * expected}
    case.write()
    done = case.run('testEngine')
    assert done.code and 'above the stability limit' in done.output and 'colloidal forces' in done.output, done.output


# --- Input

@pytest.mark.parametrize('changes, message', [
    ({'minGap': 0}, "'minGap' in .* is 0.*Hamaker"),
    ({'ionicStrength': 1e-3}, "Debye length .* beyond 'cutOff' .* kT"),
    ({'ionicStrength': None}, 'no ionic strength.*Add ionicStrength'),
    ({'permittivity': None}, "without 'permittivity'"),
    ({'debyeLength': 1e-8}, 'exclude each other'),
    ({'temperature': 0}, 'temperature'),
    ({'cutOff': 1e-10}, "'minGap' .* not below cutOff"),
    ({'forces/v/type': 'Lennard'}, 'Unknown colloid law.*Valid.*Hamaker'),
    ({'forces/v/hamaker': None}, "'hamaker'.*'media'"),
    ({'forces/v/hamaker': None, 'forces/v/media': '(silica brine silica)'}, "'media'.*brine.*polystyrene"),
    ({'forces/v/hamakr': 1}, 'hamakr'),
    ({'forces/v/glass.silica': {'hamaker': 1e-20}}, 'names no material'),
    ({'forces/e/charge': 0.01}, "'zeta'.*'charge'"),
    ({'forces/w': {'type': 'LennardJonesWall', 'hamaker': 1e-20, 'sigma': 4e-10}}, 'van der Waals force of walls'),
    ({'forces/w': {'type': 'LennardJonesWall', 'hamaker': 1e-20, 'sigma': 4e-10, 'vanDerWaals': False,
                   'silica.silica': {'vanDerWaals': True}}}, 'van der Waals force of walls'),
    ({'forces/w': {'type': 'LennardJonesWall', 'hamaker': 0, 'sigma': 4e-10}}, "Hamaker constant of .*w is 0 J.*above 0"),
    ({'forces/b': {'type': 'Born', 'hamaker': -1e-20, 'sigma': 4e-10}}, "Hamaker constant of .*b is -1e-20 J.*above 0"),
    ({'forces/v/silica': {'hamaker': 1e-20}}, "'silica' .* names a material, but.*material.material"),
    ({'forces/e/silica.silica': {'zeta': 0.01}}, "'silica.silica' .* names a pair, but.*Give one a material"),
    ({'materials/glass': SOFT, 'forces/v/silica.glass': {'hamaker': 1e-20}, 'forces/v/glass.silica': {'hamaker': 2e-20}},
     "'silica.glass' .* same pair as 'glass.silica'"),
    ({'roughness': -1e-9}, "'roughness'.*-1e-09"),
    ({'roughness': {'glass': 1e-9}}, 'glass.*Valid.*silica'),
    ({'roughness': 5e-12}, "'roughness' .*5e-12 m, below 5 % of minGap"),
    ({'roughness': 1e-9, 'minGap': 0, 'forces/v': {'type': 'hydration', 'energy': 5e-3, 'length': 6e-10},
      'forces/e/type': 'linearSuperposition'}, "'roughness' .* minGap > 0"),
    ({'debye': 1e-8}, "debye"),
])
def test_bad_input(tmp_path, changes, message):
    """One message each, with the remedy."""
    x, _ = two(1e-8, (1e-6, 1e-6))
    _, output = case_of(tmp_path, {'v': HAMAKER, 'e': CHARGED}, x, 1e-6, code=1,
                        changes={key if key.startswith('materials') else 'colloids/' + key: value
                                 for key, value in changes.items()})
    assert output.count('FOAM FATAL') == 1
    assert re.search(message, output.replace('\n', ' ')), output
