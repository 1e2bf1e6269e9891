"""Capillary attraction of particles that stick out of a film (P. A. Kralchevsky, K. Nagayama, Adv. Colloid Interface Sci. 85
(2000) 145), in demFoam: force and energy with Bessel functions of scipy, the contact line by Brent's method; approach; what is
refused."""
import re

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.special import k0, k1

from colloidTheory import capillary_charge
from dewCase import Case, changed, quoted

R, RHO, MU, SIGMA = 5e-7, 1055.0, 1e-3, 1e-3
D = 2 * R
LENGTH, CUT = 5e-6, 1e-5
Q = 1 / LENGTH
BOX = 40 * D
TOP = 20 * D                        # of the liquid
OVERDAMPED = {'type': 'overdamped', 'viscosity': MU}
BOTH = pytest.mark.parametrize('dynamics', [{}, OVERDAMPED], ids=['inertial', 'overdamped'])


def charge(r, theta, film):
    return capillary_charge(r, theta, film, Q)


def attraction(q1, q2, L):
    return -2 * np.pi * SIGMA * q1 * q2 * Q * (k1(Q * L) - k1(Q * CUT)) if L < CUT else 0.0


def energy(q1, q2, L):
    return -2 * np.pi * SIGMA * q1 * q2 * (k0(Q * L) - k0(Q * CUT) - Q * k1(Q * CUT) * (CUT - L)) if L < CUT else 0.0


def case_of(path, x, d, theta=60, dt=1e-13, n_sub=1, n_steps=1, dynamics=OVERDAMPED, modulus=1e3, **control):
    x = np.atleast_2d(x)
    case = Case(path, upper=(BOX,) * 3, cells=(4, 2, 2), gravity=(0, 0, 0), deltaT=dt * n_sub,
                endTime=dt * n_sub * n_steps, **{'writeInterval': 1, 'timePrecision': 15, **control})
    case.properties = {
        'engine': 'liggghts', 'timeStep': {'deltaT': dt}, 'output': ('csv',), **({'dynamics': dynamics} if dynamics else {}),
        'materials': {'soft': {'youngsModulus': modulus, 'poissonsRatio': 0.3, 'density': RHO}},
        'contacts': {'tangential': 'none', 'default': {'restitution': 0.5}},
        'insertion': {'some': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'soft'}},
        'fluid': {'viscosity': MU, 'surface': {'type': 'plane', 'point': (0, 0, TOP), 'normal': (0, 0, 1),
                                               'surfaceTension': SIGMA, 'contactAngle': theta}},
        'immersion': {'capillaryLength': LENGTH, 'cutOff': CUT}}
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': d * np.ones(len(x))})
    case.mesh()
    return case


def run(case, ranks=1):
    if ranks > 1:
        case.decompose(ranks)
    done = case.run('demFoam', ranks=ranks, timeout=200)
    assert done.code == 0, done.output
    return done.output


def vectors(rows, names='x y z'):
    return np.stack([rows[n] for n in names.split()], axis=1)


@pytest.mark.parametrize('depths', [(-0.2, -0.2), (0.5, 0.5), (0.3, -0.9), (-0.7, -0.95)])
@pytest.mark.parametrize('sizes', [(D, D), (D, 0.6*D)], ids=['equal', 'unequal'])
@BOTH
def test_force_and_energy_of_a_pair(tmp_path, dynamics, sizes, depths):
    """From the velocities at the end of a sub-step so short that nothing moves, along the diagonal: 1e-6 of the force; the
    sum is zero to 3e-7, of the drag; no force beyond the cut-off. Like charges attract, unlike ones repel.
    The log tells the energy with four digits."""
    dt = 1e-14
    r = np.array(sizes) / 2
    e = np.array([0.6, 0.8])
    for L in (1.05*D, 2.5*D, 9.9*D, 10.1*D):
        x = np.array([[BOX/2, BOX/2, TOP + depths[0]*r[0]], [BOX/2 + L*e[0], BOX/2 + L*e[1], TOP + depths[1]*r[1]]])
        case = case_of(tmp_path / f'{L:.4g}', x, np.array(sizes), dt=dt, dynamics=dynamics)
        log = run(case)
        row = case.table(dt)
        z = row['z'] - TOP
        q = [charge(r[i], 60, r[i] - z[i]) for i in range(2)]
        F = attraction(*q, L)
        # With inertia half a sub-step has passed since the first force
        scale = 6*np.pi*MU*r if dynamics else RHO * 4/3*np.pi*r**3 / (0.5*dt)
        found = np.stack([row['vx'], row['vy']], axis=1) * scale[:, None]
        size = 2 * np.pi * SIGMA * abs(q[0]*q[1]) / L
        assert np.abs(found[1] - F * e).max() < 1e-6 * size, (L, found[1] / e, F)
        assert np.abs(found[0] + found[1]).max() < 3e-7 * size, (L, found, F, row)
        U = float((re.findall(r'colloidal energy (\S+) J', log) or ['0'])[-1])
        assert abs(U - energy(*q, L)) < 5.1e-4 * abs(energy(*q, L)) + 1e-9 * size * L, (L, U, energy(*q, L))
        if L < 3*D:
            assert (F < 0) == (q[0] * q[1] > 0)


def test_no_charge_at_rest(tmp_path):
    """Two that float at their contact angle do not attract: below 1e-6 of 2 pi sigma R^2/L."""
    L = 1.2*D
    x = np.array([[BOX/2, BOX/2, TOP - 0.5*R], [BOX/2 + L, BOX/2, TOP - 0.5*R]])
    case = case_of(tmp_path, x, D, dynamics={})
    run(case)
    row = case.table(1e-13)
    force = row['vx'] * RHO * 4/3*np.pi*R**3 / 0.5e-13
    assert np.abs(force).max() < 1e-6 * 2*np.pi*SIGMA * R**2 / L


def test_approach_on_a_substrate(tmp_path):
    """Two on a floor without friction in a film of 0.7 R: dL/dt = 2 F(L)/Sp from 2.2 to 2.05 diameters, 1e-3 of the way;
    the film of each is measured, for the floor is soft."""
    dt, n = 1e-8, 500
    floor = TOP - 0.7*R
    x = np.array([[BOX/2, BOX/2, floor + R], [BOX/2 + 2.2*D, BOX/2, floor + R]])
    case = case_of(tmp_path, x, D, dt=dt, n_sub=n, n_steps=5, modulus=1e6)
    case.properties['walls'] = {'floor': {'type': 'plane', 'point': (0, 0, floor), 'normal': (0, 0, 1), 'material': 'soft'}}
    case.write()
    run(case)
    first, last = case.table(n * dt), case.table(5 * n * dt)
    film = R - (last['z'][0] - TOP)
    assert np.abs(vectors(first, 'z') - last['z'][0]).max() < 1e-4 * R
    q = charge(R, 60, film)
    L0 = np.diff(first['x'])[0]
    path = solve_ivp(lambda t, L: [2 * attraction(q, q, L[0]) / (6*np.pi*MU*R)], (0, 4 * n * dt), [L0], rtol=1e-9, atol=1e-15)
    expected = path.y[0, -1]
    found = np.diff(last['x'])[0]
    assert L0 - expected > 0.1 * D
    assert abs((L0 - found) / (L0 - expected) - 1) < 1e-3, (L0, found, expected)


def raft(path, dynamics, ranks=1, **control):
    """25 particles of two sizes on a floor in a film"""
    rng = np.random.default_rng(2)
    x = BOX/2 + 1.3*D * (np.array(list(np.ndindex(5, 5))) - 2) + rng.uniform(-0.1, 0.1, (25, 2)) * D
    d = np.where(np.arange(25) % 2, D, 0.8*D)
    floor = TOP - 0.6*R
    case = case_of(path, np.column_stack([x, floor + d/2]), d, dt=2e-8 if dynamics else 5e-9, n_sub=50, n_steps=20,
                   dynamics=dynamics, modulus=1e5, **control)
    case.properties['walls'] = {'floor': {'type': 'plane', 'point': (0, 0, floor), 'normal': (0, 0, 1), 'material': 'soft'}}
    if ranks > 1:
        case.properties['processors'] = (ranks, 1, 1)
    case.write()
    return case


@BOTH
def test_ranks_and_restart(tmp_path, dynamics):
    """Two ranks, and a run cut in the middle, are as one that is not, to 1e-9 diameters."""
    whole = raft(tmp_path / 'whole', dynamics)
    run(whole)
    end = whole.control['endTime']
    expected = vectors(whole.table(end))
    start = np.genfromtxt(whole.path / 'constant/particles.csv', delimiter=',', names=True)
    assert np.abs(expected - vectors(start))[:, :2].max() > 1e-3 * D

    two = raft(tmp_path / 'two', dynamics, ranks=2)
    run(two, 2)
    assert np.abs(vectors(two.table(end)) - expected).max() < 1e-9 * D

    cut = raft(tmp_path / 'cut', dynamics)
    cut.control['endTime'] = end / 2
    cut.write()
    run(cut)
    cut.control['endTime'] = end
    cut.write()
    run(cut)
    assert np.abs(vectors(cut.table(end)) - expected).max() < 1e-9 * D


REFUSED = {
    'cut-off': ({'immersion/cutOff': 0.9*D}, ("'cutOff'", 'largest diameter', 'Raise')),
    'length': ({'immersion/capillaryLength': 0}, ("'capillaryLength'", 'greater than zero')),
    'missing': ({'immersion/cutOff': None}, ("'cutOff'",)),
    'misspelt': ({'immersion/sigma': 1}, ("'sigma'", 'capillaryLength')),
    'no surface': ({'fluid/surface': None}, ("'immersion'", 'surfaceTension', 'capillaryForce')),
    'skin': ({'fluid/surface': {'type': 'plane', 'point': (0, 0, TOP), 'normal': (0, 0, 1), 'stiffness': 1e-5}},
             ("'immersion'", 'surfaceTension')),
    'no fluid': ({'fluid': None, 'dynamics': None}, ("'immersion'", 'surfaceTension')),
}


@pytest.mark.parametrize('what', REFUSED)
def test_refused(tmp_path, what):
    changes, words = REFUSED[what]
    case = case_of(tmp_path, [[BOX/2, BOX/2, TOP - R/2]], D, dt=1e-9)
    case.properties = changed(case.properties, changes)
    case.write()
    case.refuses(words, 'demFoam')


def test_refused_in_a_small_periodic_box(tmp_path):
    case = case_of(tmp_path, [[BOX/2, BOX/2, TOP - R/2]], D, dt=1e-9, cyclic='x')
    case.properties['immersion']['cutOff'] = 0.6 * BOX
    case.write()
    case.refuses(('periodic box along x',), 'demFoam')
