"""Colloids in the engine: Brownian motion, the surface of a liquid, dynamics without inertia.

Expected values are closed forms, written beside each test. testEngine (folder engine) advances an engine under given
bulk forces and writes what each particle received.
"""
import re

import numpy as np
import pytest

from dewCase import SIDES, Case, changed, foam_dict, quoted
from fluidCase import FluidCase

R, RHO, MU, KT = 5e-7, 1055.0, 1e-3, 1.380649e-23 * 298.15
D = 2 * R
MASS = RHO * 4 / 3 * np.pi * R**3
SP = 6 * np.pi * MU * R
TAU = MASS / SP
OVERDAMPED = {'type': 'overdamped', 'viscosity': MU}
BOTH = pytest.mark.parametrize('dynamics', [{}, OVERDAMPED], ids=['inertial', 'overdamped'])


def colloids(path, positions, dt, n_sub, n_steps, dynamics, modulus=1e3, box=200*D, columns=None, walls=False,
             **control):
    """Particles in a box without gravity, sub-step dt, n_steps intervals of n_sub sub-steps."""
    case = Case(path, upper=(box,) * 3, cells=(2, 2, 2), deltaT=dt * n_sub, endTime=dt * n_sub * n_steps,
                **{'gravity': (0, 0, 0), 'writeInterval': 1000000, 'timePrecision': 12, **control})
    case.properties = {
        'engine': 'liggghts', 'timeStep': {'deltaT': dt}, 'output': ('csv',), 'overlapTolerance': 0.2,
        'materials': {'soft': {'youngsModulus': modulus, 'poissonsRatio': 0.3, 'density': RHO}},
        'contacts': {'default': {'restitution': 0.5, 'friction': 0.4}},
        'insertion': {'some': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'soft'}},
        **({'dynamics': dynamics} if dynamics else {}),
        **({'walls': {'box': {'type': 'patch', 'patches': tuple(SIDES), 'material': 'soft'}}} if walls else {})}
    x = np.atleast_2d(positions)
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': D, **(columns or {})})
    case.mesh()
    return case


def start(case, forces, ranks=1, timeout=120):
    case.write_file('constant/testProperties', foam_dict(forces) + '\n')
    return case.run('testEngine', ranks=ranks, timeout=timeout)


def run(case, forces, ranks=1, timeout=120):
    done = start(case, forces, ranks, timeout)
    assert done.code == 0, done.output
    return done


def state(case, time):
    name = next(n for n in case.times() if np.isclose(float(n), time, rtol=1e-6, atol=0))
    rows = np.genfromtxt(case.path / name / 'engine.csv', delimiter=',', names=True)
    return np.sort(np.atleast_1d(rows), order='id')


def vectors(rows, names='x y z'):
    return np.stack([rows[n] for n in names.split()], axis=1)


def lattice(n, spacing, origin=0):
    return origin + spacing * (np.array(list(np.ndindex(n, n, n))) + 0.5)


# --- Brownian motion

@pytest.mark.parametrize('h, n_sub, added', [(0.05, 200, 0), (5, 4, 0), (50, 1, 0), (0.05, 200, 1.0)])
def test_diffusion_and_thermal_velocity(tmp_path, h, n_sub, added):
    """Stationary Ornstein-Uhlenbeck: <v^2> = 3 kT/M, <dx^2> = 2 D (t - tau (1 - exp(-t/tau))) for each axis, with
    D = kT/(6 pi mu R), tau = M/(6 pi mu R) and M the mass with the added one; 3e4 samples have a standard error of
    0.8 %, bound 3 %. What was received is m dv."""
    steps, moved = 12, MASS * (1 + added)
    tau = moved / SP
    case = colloids(tmp_path, lattice(10, 19 * D), h * tau, n_sub, steps, {'type': 'inertial', 'seed': 3}, modulus=1)
    run(case, {'Sp': SP, 'U': (0, 0, 0), 'kT': KT, **({'addedMass': moved - MASS} if added else {})})
    t = h * tau * n_sub
    rows = [state(case, k * t) for k in range(1, steps + 1)]
    v = np.array([vectors(r, 'vx vy vz') for r in rows[1:]])
    dx = np.diff([vectors(r) for r in rows[1:]], axis=0)
    J = np.array([vectors(r, 'jx jy jz') for r in rows[2:]])
    assert abs((v**2).sum(axis=2).mean() / (3 * KT / moved) - 1) < 0.03
    expected = 2 * KT / SP * (t + tau * np.expm1(-t / tau))
    assert abs((dx**2).mean() / expected - 1) < 0.03
    assert np.abs((dx**2).mean(axis=(0, 1)) / expected - 1).max() < 0.06
    assert abs(dx.mean()) < 4 * np.sqrt(expected / dx.size)
    assert np.abs(J - MASS * np.diff(v, axis=0)).max() < 1e-9 * MASS * np.abs(v).max()


@pytest.mark.parametrize('n_sub', [1, 10])
def test_diffusion_without_inertia(tmp_path, n_sub):
    """<dx^2> = 2 D t for each axis, 3 %, in a fluid that flows; the velocity and what was received have no noise."""
    steps, dt = 12, 1e-6
    case = colloids(tmp_path, lattice(10, 19 * D), dt, n_sub, steps, OVERDAMPED)
    U = np.array([1e-3, -2e-3, 0])
    run(case, {'Sp': SP, 'U': tuple(U), 'kT': KT})
    t = dt * n_sub
    rows = [state(case, k * t) for k in range(1, steps + 1)]
    dx = np.diff([vectors(r) for r in rows], axis=0) - U * t
    assert abs((dx**2).mean() / (2 * KT / SP * t) - 1) < 0.03
    assert abs(dx.mean()) < 4 * np.sqrt(2 * KT / SP * t / dx.size)
    assert np.abs(vectors(rows[-1], 'vx vy vz') - U).max() < 1e-12 * np.abs(U).max()
    assert np.abs(vectors(rows[-1], 'jx jy jz')).max() < 1e-12 * SP * np.abs(U).max() * t
    assert np.abs(rows[-1]['jsp']).max() == 0


@pytest.mark.parametrize('q', [0.1, 10])
def test_boltzmann_distribution_in_a_trap(tmp_path, q):
    """A particle that a force holds out of the surface fluctuates along the normal with the variance kT/k, at any
    k dt/Sp; 3 % of the width are 7 standard errors of 3e4 samples."""
    steps, dt = 40, 1e-6
    k = q * SP / dt
    wide = np.sqrt(KT / k)
    U = 0.5 * R * k / SP
    assert wide < 0.1 * R
    x = np.insert(6*D * (np.array(list(np.ndindex(30, 30))) + 1), 0, 100*D + 0.5*R, axis=1)
    case = colloids(tmp_path, x, dt, max(1, int(6 / q)), steps, OVERDAMPED, modulus=1)
    run(case, {'Sp': SP, 'U': (0, 0, 0), 'Su': (SP * U, 0, 0), 'kT': KT, 'surfaceX': (100*D, 0, 0), 'surfaceN': (1, 0, 0),
               'surfaceSpeed': 0, 'surfaceCurvature': 0, 'surfaceK': k})
    out = np.array([state(case, n * dt * max(1, int(6 / q)))['x'] for n in range(4, steps + 1)]) - 100*D - 0.5*R
    assert abs(out.std() / wide - 1) < 0.03


# --- The surface of a liquid

def surface(k, X=(100*D, 0, 0), n=(1, 0, 0), speed=0.0, curvature=0.0):
    return {'surfaceX': tuple(X), 'surfaceN': tuple(n), 'surfaceSpeed': speed, 'surfaceCurvature': curvature,
            'surfaceK': k}


@pytest.mark.parametrize('q', [1e-3, 1, 1e3])
@pytest.mark.parametrize('dynamics, h', [({}, 0.02), ({}, 20), (OVERDAMPED, 20)],
                         ids=['inertial', 'inertial-long', 'overdamped'])
def test_flow_against_a_surface(tmp_path, dynamics, h, q):
    """k delta = Sp U at rest, to 1e-6, for k dt/Sp = q; the drag is received, the spring is not. Without inertia the share
    1 - delta/R of U carries the particle: k delta (1 + Sp U/(k R)) = Sp U."""
    dt = h * TAU
    k = q * SP / dt
    U = 0.3 * R * k / SP
    # 25 of the slower of spring and drag
    n = int(max(25 / q, 60 / h, 30)) + 1
    case = colloids(tmp_path, (100*D + 0.01*R, 100*D, 100*D), dt, n, 2, dynamics)
    run(case, {'Sp': SP, 'U': (U, 0, 0), **surface(k)})
    row = state(case, 2 * n * dt)
    share = 1 / 1.3 if dynamics else 1
    assert abs((row['x'][0] - 100*D) / (0.3 * R * share) - 1) < 1e-6
    assert abs(row['vx'][0]) < 1e-6 * U
    assert abs(row['jx'][0] / (SP * U * share * n * dt) - 1) < 1e-6
    assert abs(row['jsp'][0] / (SP * n * dt) - 1) < 1e-6


@pytest.mark.parametrize('added', [0, 2.0])
def test_skin_and_added_mass(tmp_path, added):
    """(m + ma) s'' = -Sp s' - k s beyond a skin, with k (m + ma)/Sp^2 = 0.2: the slow and the fast decay, 1e-6 of the
    start; what was received is m dv less the impulse of the skin."""
    moved = MASS * (1 + added)
    tau = moved / SP
    k, n, dt = 0.2 * SP / tau, 8, 0.4 * tau
    start_at = 0.3 * R
    case = colloids(tmp_path, (100*D + start_at, 100*D, 100*D), dt, n, 1, {})
    run(case, {'Sp': SP, 'U': (0, 0, 0), **surface(k), **({'addedMass': moved - MASS} if added else {})})
    row = state(case, n * dt)
    rates = (1 + np.array([1, -1]) * np.sqrt(1 - 0.8)) / (2 * tau)
    share = np.array([-rates[1], rates[0]]) / (rates[0] - rates[1]) * start_at
    gone = np.exp(-rates * n * dt)
    s, v = share @ gone, -(share * rates) @ gone
    assert abs(row['x'][0] - 100*D - s) < 1e-6 * start_at
    assert abs(row['vx'][0] - v) < 1e-6 * start_at / tau
    held = -k * (share / rates) @ (1 - gone)
    assert abs(row['jx'][0] - (MASS * v - held)) < 1e-6 * abs(held)


@pytest.mark.parametrize('q', [1e-2, 1e2])
@BOTH
def test_moving_surface_pushes_a_particle(tmp_path, dynamics, q):
    """A surface that recedes at W takes a particle with it: v = -W n, k delta = Sp W."""
    dt = 2 * TAU
    k = q * SP / dt
    share = 0.2 / max(q, 1)
    W = share * R * k / SP
    n = int(30 / min(q, 1)) + 1
    far = W * dt * n * 3
    normal = np.array([0.6, 0, 0.8])
    start_at = np.array([100*D, 100*D, 100*D]) + 0.5 * share * R * normal
    case = colloids(tmp_path, start_at, dt, n, 3, dynamics, box=200*D + 4*far)
    run(case, {'Sp': SP, 'U': (0, 0, 0), **surface(k, (100*D,) * 3, normal, -W)})
    row = state(case, 3 * n * dt)
    v = vectors(row, 'vx vy vz')[0]
    assert np.abs(v + W * normal).max() < 1e-6 * W
    foot = np.array([100*D] * 3) - far * normal
    assert np.abs(vectors(row)[0] - foot - share * R * normal).max() < 1e-6 * R
    assert np.abs(vectors(row, 'jx jy jz')[0] - SP * W * n * dt * normal).max() < 1e-6 * SP * W * n * dt


@pytest.mark.parametrize('side', [1, -1], ids=['drop', 'bubble'])
@BOTH
def test_spherical_surface(tmp_path, dynamics, side):
    """A flow along a radius, 30 degrees from the foot point given: k delta = Sp U on that radius."""
    dt, q = 2 * TAU, 0.5
    k = q * SP / dt
    U, big = 0.25 * R * k / SP, 30 * D
    centre = np.array([100*D, 100*D, 100*D])
    e, foot = np.array([0, 0, 1.0]), np.array([0.5, 0, np.sqrt(0.75)])
    case = colloids(tmp_path, centre + (big + side*0.1*R) * e, dt, 100, 2, dynamics)
    run(case, {'Sp': SP, 'U': tuple(side * U * e), **surface(k, centre + big*foot, side*foot, 0, side/big)})
    row = state(case, 200 * dt)
    # k delta = Sp U, without inertia Sp U (1 - delta/R): see above
    delta = 0.2 if dynamics else 0.25
    assert np.abs(vectors(row)[0] - centre - (big + side*delta*R) * e).max() < 1e-6 * R


@BOTH
def test_liquid_lets_go(tmp_path, dynamics):
    """Nothing inside, and nothing from a hemisphere out on; in between a slow flow comes to rest. Without inertia the flow
    does not carry what is out."""
    dt, q = 2 * TAU, 0.05
    k = q * SP / dt
    out = np.array([-1.0, 0.99, 1.01])
    U = 1e-3 * R * k / SP
    x = np.array([[100*D + o*R, (50 + 40*j)*D, 100*D] for j, o in enumerate(out)])
    case = colloids(tmp_path, x, dt, 600, 1, dynamics)
    run(case, {'Sp': SP, 'U': (U, 0, 0), **surface(k)})
    row = state(case, 600 * dt)
    free = U * (600 * dt + (0 if dynamics else TAU * np.expm1(-600 * dt / TAU)))
    moved = row['x'] - x[:, 0]
    assert abs(moved[0] / free - 1) < 1e-6
    assert abs(moved[2] / free - (0 if dynamics else 1)) < 1e-6
    assert abs((row['x'][1] - 100*D) / (1e-3 * R) * (1.001 if dynamics else 1) - 1) < 1e-5


# --- Without inertia

def test_terminal_velocity_is_exact(tmp_path):
    """v = U + (m g + Su + Sn)/Sp from the first step; received: drag and Su, not Sn; no sensitivity."""
    dt, n = 1e-6, 7
    g = np.array([0, 0, -9.81])
    U, Su, Sn = np.array([1e-3, 0, 0]), np.array([0, 2e-12, 0]), np.array([1e-12, 0, 3e-13])
    case = colloids(tmp_path, (100*D,) * 3, dt, n, 1, OVERDAMPED, gravity=tuple(g))
    run(case, {'Sp': SP, 'U': tuple(U), 'Su': tuple(Su), 'Sn': tuple(Sn)})
    row = state(case, n * dt)
    v = U + (MASS * g + Su + Sn) / SP
    assert np.abs(vectors(row, 'vx vy vz')[0] - v).max() < 1e-12 * np.linalg.norm(v)
    assert np.abs(vectors(row)[0] - 100*D - v * n * dt).max() < 1e-12 * 100*D
    J = -(MASS * g + Sn) * n * dt
    assert np.abs(vectors(row, 'jx jy jz')[0] - J).max() < 1e-9 * np.linalg.norm(J)
    assert row['jsp'][0] == 0


def test_rotation_without_inertia(tmp_path):
    """omega = Omega + Tu/Tp; without Tp that of creeping flow, Tu/(8 pi mu R^3)."""
    Tu = np.array([0, 3e-20, 0])
    for Tp, Omega in ((4e-21, 5.0), (None, 0.0)):
        case = colloids(tmp_path / str(Tp), (100*D,) * 3, 1e-6, 3, 1, OVERDAMPED)
        run(case, {'Sp': SP, 'U': (0, 0, 0), 'Tu': tuple(Tu),
                   **({'Tp': Tp, 'Omega': (0, Omega, 0)} if Tp else {})})
        row = state(case, 3e-6)
        friction = Tp or 8 * np.pi * MU * R**3
        assert abs(row['wy'][0] / (Omega + Tu[1] / friction) - 1) < 1e-12


def test_both_dynamics_agree_at_a_soft_wall(tmp_path):
    """A flow drives a particle onto a soft wall: 4/3 E* sqrt(R) delta^1.5 = Sp U at rest, 1e-4. On the way, at 1 % of
    the overlap, the two dynamics differ by tau over the time of the approach."""
    E = 1e3
    effective = E / (2 * (1 - 0.3**2))
    overlap = 0.01 * R
    U = 4 / 3 * effective * np.sqrt(R) * overlap**1.5 / SP
    rate = 2 * effective * np.sqrt(R * overlap) / SP
    ways = []
    for name, dynamics in (('inertial', {}), ('overdamped', OVERDAMPED)):
        dt = 0.01 / rate
        case = colloids(tmp_path / name, (R + 0.002*R, 100*D, 100*D), dt, 100, 30, dynamics, modulus=E, walls=True)
        run(case, {'Sp': SP, 'U': (-U, 0, 0)})
        x = np.array([state(case, k * 100 * dt)['x'][0] for k in range(1, 31)])
        assert abs((R - x[-1]) / overlap - 1) < 1e-4
        row = state(case, 30 * 100 * dt)
        assert abs(row['jsp'][0] / (SP * 100 * dt) - 1) < 1e-6
        ways.append(x)
    assert np.abs(ways[0] - ways[1]).max() < overlap * max(rate * TAU, 0.01)


def test_dense_packing_relaxes(tmp_path):
    """A close packing with overlaps of 1 % of the radius comes to rest with the sub-step that is chosen."""
    a = 1.99 * R * np.sqrt(2)
    base = a * np.array(list(np.ndindex(4, 4, 4)))
    x = 100*D + np.concatenate([base + 0.5 * a * np.array(s) for s in ((0, 0, 0), (1, 1, 0), (1, 0, 1), (0, 1, 1))])
    case = colloids(tmp_path, x, 1e-7, 1, 1, OVERDAMPED)
    del case.properties['timeStep']
    # 6 pi mu/(2 E* sqrt(0.005)), a fifth of it
    chosen = 0.2 * 6 * np.pi * MU / (2 * 1e3 / (2 * 0.91) * np.sqrt(0.005))
    case.control.update(deltaT=chosen * 1.001 * 20, endTime=chosen * 1.001 * 20 * 20)
    case.write()
    done = run(case, {'Sp': SP, 'U': (0, 0, 0)})
    assert re.search(r'sub-steps 21 ', done.output)
    speeds = [np.linalg.norm(vectors(state(case, k * case.control['deltaT']), 'vx vy vz'), axis=1).max()
              for k in (1, 5, 20)]
    assert speeds[0] > 4 * speeds[1] > 16 * speeds[2]


# --- Ranks and restarts

def crowd(path, dynamics, **control):
    """Colloids that hit each other, walls and a surface, with noise; some cross the cut between ranks."""
    rng = np.random.default_rng(5)
    x = 3*D + lattice(5, 1.3 * D) + rng.uniform(-0.1, 0.1, (125, 3)) * D
    # Steps of a round number: the names of times do not round it
    return colloids(path, x - 2.5*D, 2e-6 if dynamics else 2e-7, 10, 40, dynamics, box=8*D, walls=True, **control)


FORCES = {'Sp': SP, 'U': (2e-3, 5e-4, 0), 'kT': 50 * KT, 'Su': (0, 0, -1e-13),
          **surface(1e-5, (6*D, 0, 0), (1, 0, 0), -1e-3)}


@BOTH
def test_noise_does_not_depend_on_ranks(tmp_path, dynamics):
    """1, 2 and 3 ranks: the same to 1e-9 diameters after a few collisions (round-off grows at each of them)."""
    answers = []
    for ranks in (1, 2, 3):
        case = crowd(tmp_path / str(ranks), dynamics)
        if ranks > 1:
            case.decompose(ranks)
        run(case, FORCES, ranks)
        answers.append(state(case, case.control['endTime']))
    for other in answers[1:]:
        assert (other['id'] == answers[0]['id']).all() and len(other) == 125
        assert np.abs(vectors(other) - vectors(answers[0])).max() < 1e-9 * D


@pytest.mark.parametrize('before, after', [(1, 1), (1, 2), (2, 1)])
@BOTH
def test_restart_equals_uninterrupted(tmp_path, dynamics, before, after):
    """To 1e-9 diameters."""
    whole = crowd(tmp_path / 'whole', dynamics)
    run(whole, FORCES)
    case = crowd(tmp_path / 'cut', dynamics, writeInterval=20)
    end = case.control['endTime']
    case.control['endTime'] = end / 2
    case.write()
    if before > 1:
        case.decompose(before)
    run(case, FORCES, before)
    case.control['endTime'] = end
    case.write()
    if after > 1:
        case.decompose(after)
        for rank in range(after):
            source = case.path / case.times()[-1]
            target = case.path / f'processor{rank}' / source.name / 'uniform'
            if not target.exists():
                target.parent.mkdir(parents=True, exist_ok=True)
                target.symlink_to(source / 'uniform')
    elif before > 1:
        source = case.path / 'processor0' / case.times('processor0')[-1]
        target = case.path / source.name / 'uniform'
        if not target.exists():
            target.symlink_to(source / 'uniform')
    run(case, FORCES, after)
    assert np.abs(vectors(state(case, end)) - vectors(state(whole, end))).max() < 1e-9 * D


# --- What cannot be meant

REFUSED = {
    'no drag': ({}, {'U': None, 'Sp': None, 'Su': (0, 0, 0)}, ('particle 1 ', 'no drag', 'drag law')),
    'too little drag': ({}, {'Sp': 0.4 * SP}, ('particle 1 ', 'drag coefficient', 'viscosity')),
    'kick': ({}, {'kick': (1e-20, 0, 0)}, ('particle 1 ', 'momentum at once', 'momentum explicit')),
    'viscosity missing': ({'dynamics': {'type': 'overdamped'}}, {}, ('dynamics', 'viscosity')),
    'viscosity negative': ({'dynamics/viscosity': -1}, {}, ('viscosity', '-1', 'greater than zero')),
    'viscosity of no use': ({'dynamics/type': 'inertial'}, {}, ('viscosity', 'inertial', 'Remove')),
    'type unknown': ({'dynamics/type': 'brownian'}, {}, ('brownian', 'inertial', 'overdamped')),
    'entry unknown': ({'dynamics/mu': 1}, {}, ("'mu'", 'viscosity', 'seed')),
    'seed negative': ({'dynamics/seed': -1}, {}, ("'seed'", '-1')),
    'sub-step too long': ({'timeStep/deltaT': 1.0, 'dynamics/viscosity': 1e-9}, {}, ('sub-step', 'stability limit')),
    'dashpot only': ({'contacts/tangential': 'noHistory'}, {}, ('noHistory', 'dashpot', 'history')),
    'rolling dashpot': ({'contacts/rolling': 'cdt'}, {}, ('cdt', 'dashpot', 'epsd2')),
}


@pytest.mark.parametrize('what', REFUSED)
def test_refused(tmp_path, what):
    entries, forces, words = REFUSED[what]
    case = colloids(tmp_path, (100*D,) * 3, 1e-6, 1, 1, OVERDAMPED)
    case.properties = changed(case.properties, entries)
    case.write()
    all_forces = {'Sp': SP, 'U': (0, 0, 0), **forces}
    done = start(case, {key: value for key, value in all_forces.items() if value is not None})
    assert done.code != 0 and done.output.count('FATAL') == 1, done.output
    for word in words:
        assert word in ' '.join(done.output.split()), done.output


# --- The laws, in a case

def fluid(path, laws, dynamics=OVERDAMPED, momentum='none', n=10, spacing=4*D, **control):
    case = FluidCase(path, rho=1000, nu=MU / 1000, tolerance=1e-14, upper=(n * spacing,) * 3, cells=(4, 4, 4),
                     cyclic='xyz',
                     **{'gravity': (0, 0, 0), 'deltaT': 1e-5, 'endTime': 1e-4, 'writeInterval': 1, **control})
    x = lattice(n, spacing)
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': D})
    case.properties = {
        'engine': 'liggghts', 'output': ('csv',), 'dynamics': dynamics,
        'materials': {'soft': {'youngsModulus': 1e3, 'poissonsRatio': 0.3, 'density': RHO}},
        'contacts': {'default': {'friction': 0.4}},
        'insertion': {'some': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'soft'}},
        'coupling': FluidCase.coupling('Stokes', momentum=momentum)}
    case.properties['coupling']['forces'].update(laws)
    return case


@pytest.mark.parametrize('T', ['law', 'fluid'])
def test_brownian_law(tmp_path, T):
    """In a fluid at rest, with T of the law or the fluid: <dx^2> = 2 kB T/(6 pi mu R) t, 3 % (3e4 samples)."""
    case = fluid(tmp_path, {'random': {'type': 'Brownian', **({'T': 298.15} if T == 'law' else {})}})
    if T == 'fluid':
        case.fields['T'] = '298.15'
        case.transport.update(Cp=4180, kappa=0.6)
    case.mesh()
    done = case.run('cfdDemFoam', timeout=120)
    assert done.code == 0, done.output
    x = np.array([vectors(case.table(k * 1e-5)) for k in range(1, 11)])
    box = 40 * D
    dx = np.diff(x, axis=0)
    dx -= box * np.round(dx / box)
    assert abs((dx**2).mean() / (2 * KT / SP * 1e-5) - 1) < 0.03


def test_weight_goes_to_the_fluid(tmp_path):
    """Explicit two-way coupling without inertia: in every step the fluid gets the submerged weight, to 1e-6."""
    case = fluid(tmp_path, {}, momentum='explicit', n=2, spacing=20*D, gravity=(0, 0, -9.81))
    case.mesh()
    done = case.run('cfdDemFoam', timeout=120)
    assert done.code == 0, done.output
    weight = 8 * MASS * (1 - 1000 / RHO) * -9.81
    ledger = case.ledger()
    assert np.abs(ledger['rz'] / (-weight * 1e-5) - 1).max() < 0.02
    assert np.abs(ledger['rz'] - ledger['lz']).max() < 1e-9 * abs(weight * 1e-5)


@pytest.mark.parametrize('ranks', [1, 2])
def test_surface_of_a_solver(tmp_path, ranks):
    """A drop that moves takes the particles out of its surface with it, from the fields of the solver: at rest with
    respect to it k delta = Sp V.n for V the velocity of the drop less that of the fluid, on the drop's far side. Foot
    points are those of the cells: exact for a sphere."""
    big, speed = 20 * D, np.array([2e-4, 0, 0])
    k = 1e-5
    delta = SP * speed[0] / k
    case = fluid(tmp_path, {'surface': {'type': 'elasticSurface', 'stiffness': k}, 'random': {'type': 'Brownian'}},
                 n=2, spacing=30*D, deltaT=2e-5, endTime=1e-2, writeInterval=100000)
    centre = np.array([25*D, 30*D, 30*D])
    x = centre + np.array([[-big - 0.1*R, 0, 0], [big + 0.1*R, 1e-3*D, 0]])
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': D})
    case.write_file('constant/testProperties', foam_dict(
        {'U': (0, 0, 0), 'rho': 1000, 'mu': MU, 'T': 1e-6, 'centre': tuple(centre), 'radius': big,
         'speed': tuple(speed)}) + '\n')
    case.mesh()
    if ranks > 1:
        case.decompose(ranks)
    done = case.run('testColloidSurface', ranks=ranks, timeout=120)
    assert done.code == 0, done.output
    found = {int(i): np.array(p.split(), float) for i, p in re.findall(r'particle (\d+) \((.*?)\)', done.output)}
    end = centre + speed * 1e-2
    # Behind, the surface drives the particle before it; ahead it draws away from the one that it leaves inside
    assert abs(np.linalg.norm(found[1] - end) - big - delta) < 2e-3 * R
    assert np.linalg.norm(found[2] - end) < big


def test_film_of_a_solver(tmp_path):
    """The drop of the last test pushes a particle through a film that repels it (H < 0) and is drained: at rest with
    respect to it |H| Rb/6 (1/h^2 - 1/r^2) = Sp V, 1/Rb = 1/R - 1/radius, to 0.5 % of h. On a line of cell
    centres: the surface's velocity is that at the foot point of the cell."""
    big, speed = 20 * D, np.array([2e-4, 0, 0])
    H, r = -1e-18, 1e-6
    case = fluid(tmp_path, {'film': {'type': 'filmForce', 'minThickness': 1e-9, 'drainage': {'surface': 'mobile', 'range': r},
                                     'vanDerWaals': {'HamakerConstant': H, 'range': r}},
                            'surface': {'type': 'elasticSurface', 'stiffness': 1e-5}},
                 n=2, spacing=30*D, deltaT=2e-5, endTime=2e-2, writeInterval=100000)
    centre = np.array([25*D, 22.5*D, 22.5*D])
    x = centre + np.array([[-big + 1.6*R, 0, 0]])
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': D})
    case.write_file('constant/testProperties', foam_dict(
        {'U': (0, 0, 0), 'rho': 1000, 'mu': MU, 'T': 1e-6, 'centre': tuple(centre), 'radius': big,
         'speed': tuple(speed)}) + '\n')
    case.mesh()
    done = case.run('testColloidSurface', timeout=120)
    assert done.code == 0, done.output
    found = np.array(re.findall(r'particle 1 \((.*?)\)', done.output)[-1].split(), float)
    h = big - R - np.linalg.norm(found - centre - speed * 2e-2)
    expected = (6 * SP * speed[0] * (1/R - 1/big) / -H + r**-2)**-0.5
    assert abs(h / expected - 1) < 5e-3, (h, expected)


LAWS_REFUSED = {
    'film without a surface': ({'a': {'type': 'filmForce', 'minThickness': 1e-9,
                                      'hydrophobic': {'strength': 1e-20, 'range': 1e-8}}}, {},
                               ('filmForce', 'needs a solver with a liquid surface')),
    'semiImplicit': ({}, {'coupling/momentum': 'semiImplicit'}, ('semiImplicit', 'overdamped', 'explicit', 'none')),
    'no temperature': ({'a': {'type': 'Brownian'}}, {}, ('Brownian', 'temperature', "'T'")),
    'T negative': ({'a': {'type': 'Brownian', 'T': -3}}, {}, ("'T'", '-3', 'greater than zero')),
    'twice': ({'a': {'type': 'Brownian', 'T': 300}, 'b': {'type': 'Brownian', 'T': 300}}, {},
              ('second', 'Brownian', 'Remove')),
    'no surface': ({'a': {'type': 'elasticSurface', 'stiffness': 1e-3}}, {},
                   ('elasticSurface', 'needs a solver with a liquid surface')),
    'stiffness zero': ({'a': {'type': 'elasticSurface', 'stiffness': 0}}, {}, ("'stiffness'", 'is 0')),
    'misspelt': ({'a': {'type': 'elasticSurface', 'stifness': 1}}, {}, ('stiffness',)),
}


@pytest.mark.parametrize('what', LAWS_REFUSED)
def test_law_refused(tmp_path, what):
    laws, entries, words = LAWS_REFUSED[what]
    case = fluid(tmp_path, laws, n=2, spacing=20*D)
    case.properties = changed(case.properties, entries)
    case.mesh()
    done = case.run('cfdDemFoam')
    assert done.code != 0 and done.output.count('FATAL') == 1, done.output
    for word in words:
        assert word in ' '.join(done.output.split()), done.output


# --- The contact line of two fluids

@pytest.mark.parametrize('theta, z', [(60, -0.2), (60, -0.8), (120, 0.1), (90, 0.5)])
@pytest.mark.parametrize('dynamics, h', [({}, 0.5), ({}, 20), (OVERDAMPED, 20)],
                         ids=['inertial', 'inertial-long', 'overdamped'])
def test_tension_holds_a_sphere(tmp_path, dynamics, h, theta, z):
    """A force Su along the normal is held where 2 pi R sigma [z sin(theta) sqrt(1 - z^2) + cos(theta) (1 - z^2)] = Su (the
    tension at the contact line), z = delta/R, for 2 pi sigma dt/Sp = 1, 20 and others: to 1e-6 R. It is not received."""
    dt, angle = h * TAU, np.deg2rad(theta)
    sigma = SP / dt / (2*np.pi)
    F = 2*np.pi*R*sigma*(z*np.sin(angle)*np.sqrt(1 - z*z) + np.cos(angle)*(1 - z*z))
    case = colloids(tmp_path, (100*D + (z + 0.03)*R, 100*D, 100*D), dt, 400, 2, dynamics, modulus=1)
    run(case, {'Sp': SP, 'U': (0, 0, 0), 'Su': (F, 0, 0), **surface(0.0), 'surfaceTension': sigma, 'contactAngle': angle})
    row = state(case, 800 * dt)
    assert abs((row['x'][0] - 100*D)/R - z) < 1e-6
    assert abs(row['jx'][0] / (F*400*dt) - 1) < 1e-5
