"""The exchange between fluid and particles in cfdDemFoam: balances, ranks, restarts, symmetries and exact answers.

Expected values are closed forms, written beside each test, or another run that must give the same. particles.csv has
velocities and temperatures before the kicks that the fluid's step owes the particles; these are added from the
restart (pending).
"""
import re

import numpy as np
import pytest

from dewCase import quoted
from fluidCase import FluidCase

GLASS = {'youngsModulus': 5e6, 'poissonsRatio': 0.3, 'density': 2500.0, 'thermalConductivity': 1.0,
         'heatCapacity': 700.0}
CONTACTS = {'normal': 'Hertz', 'tangential': 'history', 'default': {'restitution': 0.7, 'friction': 0.3}}
ASCII = {'writeFormat': 'ascii', 'writePrecision': 17}


def of_file(material='glass'):
    return {'some': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': material}}


def vectors(rows, names='vx vy vz'):
    return np.stack([rows[n] for n in names.split()], axis=1)


def sphere(d):
    return np.pi / 6 * d**3


def run(case, ranks=1, timeout=120):
    done = case.run('cfdDemFoam', ranks=ranks, timeout=timeout)
    assert done.code == 0, done.output
    return done


def folder(case, time):
    """Name of a time directory."""
    return next(n for n in ['0', *case.times()] if np.isclose(float(n), time, rtol=1e-6, atol=1e-300))


def pending(case, time):
    """Kicks owed to the particles at a time, sorted by id: N s, and J. Layout: particleRecord.H."""
    raw = (case.path / folder(case, time) / 'uniform/particles/exchange').read_bytes()
    n, n_values = np.frombuffer(raw[16:32], dtype='<i8')
    rows = np.frombuffer(raw[32:-8], dtype=[('id', '<i8'), ('values', '<f8', n_values)])
    assert len(rows) == n
    return np.sort(rows, order='id')['values']


def lattice(n, spacing, jitter=0, seed=0):
    """n particles along each axis, from half a spacing on, moved at random by up to jitter spacings."""
    n = np.broadcast_to(n, 3)
    x = np.array(list(np.ndindex(*n))) + 0.5
    return (x + np.random.default_rng(seed).uniform(-jitter, jitter, x.shape)) * spacing


# --- A cloud of grains in a gas, with walls, contacts, heat and a flow that is nowhere uniform

L = 4e-3


def cloud(path, model='A', void='divided', cyclic='xy', gravity=(0, 0, -9.81), n_steps=5, turn=lambda x: x,
          vector_turn=lambda v: v, cell_turn=lambda c: c, **control):
    """216 grains of 0.4 mm in (4 mm)^3; turn and vector_turn map places and vectors to those of a turned case,
    cell_turn an array over cells [z, y, x, 3]."""
    dt = 1e-4
    case = FluidCase(path, rho=1.2, nu=1.5e-5, tolerance=1e-13, upper=(L,)*3, cells=(4, 4, 4), cyclic=cyclic,
                     gravity=tuple(vector_turn(np.array(gravity, float))), deltaT=dt, endTime=n_steps * dt,
                     **{'writeInterval': 5, **ASCII, **control})
    rng = np.random.default_rng(7)
    x = turn(lattice(6, L / 6, 0.15, 8))
    v = vector_turn(rng.uniform(-0.3, 0.3, x.shape))
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': 4e-4, 'vx': v[:, 0], 'vy': v[:, 1], 'vz': v[:, 2],
                    'T': rng.uniform(300, 400, len(x))})
    U = cell_turn(rng.uniform(-1, 1, (4, 4, 4, 3))).reshape(-1, 3)
    case.fields = {'U': vector_turn(U), 'p': '0', 'T': '300'}
    case.transport.update(Cp=1000, kappa=0.026)
    walls = [s for s in ('xMin', 'xMax', 'yMin', 'yMax', 'zMin', 'zMax') if s[0] not in cyclic]
    case.properties = {
        'engine': 'liggghts', 'heat': True, 'materials': {'glass': GLASS}, 'contacts': CONTACTS,
        'walls': {'sides': {'type': 'patch', 'patches': walls, 'material': 'glass'}}, 'insertion': of_file(),
        'output': ('csv',),
        'coupling': case.coupling('DiFelice', void, model=model, heatTransfer={'type': 'RanzMarshall'})}
    case.mesh()
    return case


@pytest.mark.parametrize('ranks', [1, 2])
@pytest.mark.parametrize('void', ['divided', 'particleCentre'])
@pytest.mark.parametrize('model', ['A', 'B'])
def test_what_the_fluid_loses_particles_receive(tmp_path, model, void, ranks):
    """Momentum and heat at every step to 1e-12 of the sum of magnitudes: 216 products, each good to 1e-16. The volume
    that alphac shows is that of the particles to 1e-13."""
    case = cloud(tmp_path, model, void)
    if ranks > 1:
        case.decompose(ranks)
    run(case, ranks)
    rows = case.ledger()
    assert len(rows) == 5
    received, lost = (vectors(rows, f'{k}x {k}y {k}z') for k in 'rl')
    assert rows['scale'].min() > 1e-9 and np.abs(rows['heatScale']).min() > 1e-6
    assert np.all(np.linalg.norm(received - lost, axis=1) < 1e-12 * rows['scale'])
    assert np.all(np.abs(rows['heatReceived'] - rows['heatLost']) < 1e-12 * rows['heatScale'])
    volume = 216 * sphere(4e-4)
    assert np.abs(rows['held'] / volume - 1).max() < 1e-13
    assert np.abs(rows['represented'] / volume - 1).max() < 1e-13


def same_state(one, other, time, tolerance, ranks=1, other_ranks=1):
    """Particles and fields of two runs, relative to the largest magnitudes."""
    a, b = one.table(time), other.table(time)
    assert np.array_equal(a['id'], b['id'])
    for names in ('x y z', 'vx vy vz'):
        scale = np.abs(vectors(a, names)).max()
        assert np.abs(vectors(a, names) - vectors(b, names)).max() < tolerance * scale, names
    assert np.abs(a['T'] - b['T']).max() < tolerance * 100, 'T of particles'
    for name, scale in (('alphac', 1), ('U', 1), ('T', 100), ('p', 1)):
        f = one.joined_field(name, folder_of(one, time, ranks), ranks)
        g = other.joined_field(name, folder_of(other, time, other_ranks), other_ranks)
        if name == 'p':
            # The reference cell is the first of the first rank
            f, g = f - f.mean(), g - g.mean()
        assert np.abs(f - g).max() < tolerance * scale, name


def folder_of(case, time, ranks):
    names = case.times('.' if ranks == 1 else 'processor0')
    return next(n for n in names if np.isclose(float(n), time, rtol=1e-6, atol=0))


@pytest.fixture(scope='module')
def serial(tmp_path_factory):
    """The cloud after 1 and after 10 steps, on one rank."""
    case = cloud(tmp_path_factory.mktemp('serial'), n_steps=10, writeInterval=1)
    run(case)
    return case


@pytest.mark.parametrize('ranks, method', [(2, 'simple'), (2, 'scotch'), (4, 'hierarchical'), (4, 'scotch')])
def test_ranks_give_the_same(serial, tmp_path, ranks, method):
    """After one step, whose forces are of the same state: alphac, velocities and temperatures of particles to 1e-10.
    After ten, with solvers converged to 1e-13 of the right side: 1e-8, the sum of their errors and of contacts."""
    case = cloud(tmp_path, n_steps=10, writeInterval=1)
    case.decompose(ranks, method)
    run(case, ranks)
    a, b = serial.table(1e-4), case.table(1e-4)
    assert np.abs(vectors(a) - vectors(b)).max() < 1e-10 * np.abs(vectors(a)).max()
    assert np.abs(a['T'] - b['T']).max() < 1e-10 * 100
    alphac = serial.field('alphac', folder_of(serial, 1e-4, 1))
    assert np.abs(alphac - case.joined_field('alphac', folder_of(case, 1e-4, ranks), ranks)).max() < 1e-10
    same_state(serial, case, 1e-3, 1e-8, 1, ranks)


# --- Restart

@pytest.mark.parametrize('before, after', [(1, 1), (2, 2), (1, 2), (2, 1)])
def test_restart_goes_on_as_if_nothing_had_happened(serial, tmp_path, before, after):
    """5 steps, a restart from binary files, 5 more: as 10 steps. To 1e-11 of the largest magnitudes on one rank: the
    round-off of 5 steps (the order of particles differs), 1e-16 times contacts and solvers; on others 1e-8, as
    test_ranks_give_the_same. The contents are compared in ascii, written at the end only."""
    case = cloud(tmp_path, n_steps=5, writeInterval=5)
    if before > 1:
        case.decompose(before)
    case.control['writeFormat'] = 'binary'
    case.write_dict('system/controlDict', case.control)
    run(case, before)
    if before > after:
        done = case.run('reconstructPar', '-latestTime')
        assert done.code == 0, done.output
    case.control.update(endTime=1e-3, writeFormat='ascii')
    case.write_dict('system/controlDict', case.control)
    if after > before:
        case.decompose(after)
    run(case, after)
    same_state(serial, case, 1e-3, 1e-11 if before == after == 1 else 1e-8, 1, after)


def test_restart_of_a_scheme_with_three_time_levels(tmp_path):
    """backward: 5 steps, a restart, 5 more, as 10 steps, to 1e-11; alphac of the step before is in the restart."""
    def case_of(name, n_steps):
        case = cloud(tmp_path / name, n_steps=n_steps, writeInterval=n_steps)
        path = case.path / 'system/fvSchemes'
        path.write_text(path.read_text().replace('default Euler', 'default backward'))
        return case

    whole, case = case_of('whole', 10), case_of('parts', 5)
    run(whole)
    run(case)
    case.control['endTime'] = 1e-3
    case.write_dict('system/controlDict', case.control)
    run(case)
    same_state(whole, case, 1e-3, 1e-11)


# --- Symmetries

def test_common_velocity_changes_nothing(tmp_path):
    """A lattice of grains in a periodic box, one a cell: all is uniform, so 5 steps with fluid and grains faster by V
    give the same velocities plus V. To 1e-8 of the slip: in a uniform field residuals are relative to noise, and solvers
    add theirs, 1e-9, to the round-off of V, which is 10 times the slip."""
    V = np.array([0.9, -0.6, 0.3])
    U0, v0 = np.array([0.1, 0, 0.05]), np.array([0, 0.02, 0])
    results = []
    for name, shift in (('rest', np.zeros(3)), ('moving', V)):
        case = FluidCase(tmp_path / name, rho=1.2, nu=1.5e-5, tolerance=1e-14, upper=(L,)*3, cells=(4, 4, 4),
                         cyclic='xyz', gravity=(0, 0, 0), deltaT=1e-3, endTime=5e-3, writeInterval=5, **ASCII)
        x = lattice(4, L / 4, 0) + [1.3e-4, -0.7e-4, 0.9e-4]
        v = v0 + shift
        case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': 6e-4, 'vx': v[0], 'vy': v[1], 'vz': v[2]})
        case.fields['U'] = '({} {} {})'.format(*map(repr, map(float, U0 + shift)))
        case.properties = {'engine': 'liggghts', 'materials': {'glass': GLASS}, 'contacts': CONTACTS,
                           'insertion': of_file(), 'output': ('csv',), 'coupling': case.coupling('DiFelice')}
        case.mesh()
        run(case)
        U = case.field('U', folder(case, 5e-3))
        rows = case.table(5e-3)
        results.append((np.broadcast_to(U, (64, 3)) - shift, vectors(rows) - shift))
    slip = np.linalg.norm(U0 - v0)
    for a, b in zip(*results):
        assert np.abs(a - b).max() < 1e-8 * slip
        assert np.abs(a - a[0]).max() < 1e-8 * slip
    # and something did happen
    assert np.linalg.norm(results[0][0][0] - U0) > 0.05 * slip


TURNS = {
    'mirror': (lambda x: np.array([L, 0, 0]) + x * [-1, 1, 1], lambda v: v * [-1, 1, 1], lambda c: c[:, :, ::-1]),
    # (x, y) -> (L - y, x): the new cell [z, x, L - y] has what was at [z, y, x]
    'quarter turn about z': (lambda x: np.stack([L - x[..., 1], x[..., 0], x[..., 2]], -1),
                             lambda v: np.stack([-v[..., 1], v[..., 0], v[..., 2]], -1),
                             lambda c: np.swapaxes(c, 1, 2)[:, :, ::-1]),
    # (x, y, z) -> (z, x, y)
    'axes exchanged': (lambda x: x[..., [2, 0, 1]], lambda v: v[..., [2, 0, 1]],
                       lambda c: np.transpose(c, (1, 2, 0, 3)))}


@pytest.mark.parametrize('kind', TURNS)
def test_turned_case_gives_the_turned_result(tmp_path, kind):
    """Walls all around, gravity along no axis; the mesh is the same. 5 steps to 1e-9 of the largest velocity: solvers
    converged to 1e-13, in another order of cells, and the stiffness of contacts."""
    turn, vector_turn, cell_turn = TURNS[kind]
    g = (3.0, -2.0, -9.0)
    one = cloud(tmp_path / 'one', cyclic='', gravity=g)
    other = cloud(tmp_path / 'other', cyclic='', gravity=g, turn=turn, vector_turn=vector_turn, cell_turn=cell_turn)
    run(one)
    run(other)
    a, b = one.table(5e-4), other.table(5e-4)
    scale = np.abs(vectors(a)).max()
    assert np.abs(vector_turn(vectors(a)) - vectors(b)).max() < 1e-9 * scale
    assert np.abs(turn(vectors(a, 'x y z')) - vectors(b, 'x y z')).max() < 1e-9 * L
    assert np.abs(a['T'] - b['T']).max() < 1e-9 * 100
    name = folder(one, 5e-4)
    U, W = (c.field('U', name).reshape(4, 4, 4, 3) for c in (one, other))
    assert np.abs(vector_turn(cell_turn(U)) - W).max() < 1e-9 * np.abs(U).max()
    a, b = (c.field('alphac', name).reshape(4, 4, 4, 1) for c in (one, other))
    assert np.abs(cell_turn(a) - b).max() < 1e-12


# --- Two bodies: a fluid and particles that exchange momentum or heat, nothing else

def two_bodies(path, d, rho_p, dt, n_steps, per_cell=2, cells=2, share=0.1, U0=0.0, fluid=None, thermal=False,
               momentum='semiImplicit', T=None, E=5e6, **properties):
    """A periodic box of cells^3 cells, per_cell^3 particles in each on a lattice, at rest, of the given volume share;
    liquid at U0 along x."""
    spacing = d * (np.pi / 6 / share)**(1 / 3)
    h = per_cell * spacing
    fluid = {'rho': 1000, 'nu': 1e-6, **(fluid or {})}
    case = FluidCase(path, tolerance=1e-14, upper=(cells * h,)*3, cells=(cells,)*3, cyclic='xyz', gravity=(0, 0, 0),
                     deltaT=dt, endTime=n_steps * dt, **{'writeInterval': 1, 'timePrecision': 12, **ASCII}, **fluid)
    x = lattice(per_cell * cells, spacing)
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': d, **({'T': T[1]} if thermal else {})})
    case.fields['U'] = f'({U0!r} 0 0)'
    coupling = case.coupling('Stokes', pressure=False, momentum=momentum)
    if thermal:
        case.fields['T'] = repr(T[0])
        case.transport.update(Cp=4180, kappa=0.6)
        coupling['heatTransfer'] = {'type': 'RanzMarshall'}
    case.properties = {'engine': 'liggghts', 'heat': thermal,
                       'materials': {'glass': {**GLASS, 'density': rho_p, 'youngsModulus': E}}, 'contacts': CONTACTS,
                       'insertion': of_file(), 'output': ('csv',), 'coupling': coupling, **properties}
    case.mesh()
    return case


@pytest.mark.parametrize('dt', [1e-7, 1e-6, 1e-5, 1e-4])
def test_colloids_in_water_relax_exactly(tmp_path, dt):
    """10 % of 0.5 um: relaxation time 15 ns. Slip U0 exp(-t/tau'), 1/tau' = (1 + m/M)/tau with m and M the masses of
    particles and fluid, momentum constant; 1e-3 of U0 at every step for the fluid, and for particles with their
    pending kicks."""
    d, rho_p, mu, share, U0 = 0.5e-6, 1050.0, 1e-3, 0.1, 1e-3
    case = two_bodies(tmp_path, d, rho_p, dt, 3, share=share, U0=U0, timeStep={'fraction': 0.5})
    run(case)
    tau = rho_p * d**2 / (18 * mu)
    ratio = share * rho_p / ((1 - share) * 1000)
    for k in range(1, 4):
        slip = U0 * np.exp(-k * dt / tau * (1 + ratio))
        fluid = (U0 + ratio * slip) / (1 + ratio)
        U = np.broadcast_to(case.field('U', folder(case, k * dt)), (8, 3))
        rows = case.table(k * dt)
        v = vectors(rows) + pending(case, k * dt)[:, :3] / (rho_p * sphere(d))
        assert np.abs(U - [fluid, 0, 0]).max() < 1e-3 * U0, k
        assert np.abs(v - [fluid - slip, 0, 0]).max() < 1e-3 * U0, k


def test_hot_particles_warm_a_fluid_at_rest(tmp_path):
    """Nu = 2: both temperatures go exponentially to the common one. Steps of a tenth of the relaxation time, liquid of
    20 times the heat capacity: 1e-3 of the difference at every step (a frozen fluid over a step errs by
    0.05 x 0.1/2 x 0.37). Energy to 1e-12 of that exchanged."""
    d, rho_p, share, T = 1e-4, 2500.0, 0.1, (300.0, 350.0)
    Cp, kappa = 4180.0, 0.6
    m = rho_p * sphere(d)
    tau = m * 700 / (2 * kappa * np.pi * d)
    ratio = share * rho_p * 700 / ((1 - share) * 1000 * Cp)
    dt = 0.1 * tau
    case = two_bodies(tmp_path, d, rho_p, dt, 20, share=share, thermal=True, T=T, E=1e3)
    run(case)
    ledger = case.ledger()
    V = 64 * sphere(d) / share
    fluid_heat = (1 - share) * 1000 * Cp * V
    for k in range(1, 21):
        difference = (T[1] - T[0]) * np.exp(-k * dt / tau * (1 + ratio))
        common = (T[0] + ratio * T[1]) / (1 + ratio)
        Tf = np.broadcast_to(case.field('T', folder(case, k * dt)), 8)
        rows = case.table(k * dt)
        heat = pending(case, k * dt)[:, 3]
        Tp = rows['T'] + heat / (m * 700)
        assert np.abs(Tf - (common - ratio / (1 + ratio) * difference)).max() < 1e-3 * (T[1] - T[0]), k
        assert np.abs(Tp - (common + difference / (1 + ratio))).max() < 1e-3 * (T[1] - T[0]), k
        exchanged = np.abs(np.cumsum(ledger['heatLost']))[k - 1]
        given = m * 700 * np.sum(Tp - T[1])
        taken = fluid_heat * np.mean(Tf - T[0])
        # Temperatures of 300 K are good to 5e-14 K
        roundoff = 1e-12 * exchanged + fluid_heat * 3e-13
        assert abs(given + taken) < roundoff, k
        assert abs(taken + np.sum(ledger['heatLost'][:k])) < roundoff, k


def test_explicit_goes_to_semi_implicit(tmp_path):
    """The two schemes after half a relaxation time: their difference halves with the step, within a tenth."""
    d, rho_p = 1e-4, 2500.0
    tau = rho_p * d**2 / (18 * 1e-3)
    differences = []
    for n in (4, 8, 16):
        U = []
        for scheme in ('explicit', 'semiImplicit'):
            case = two_bodies(tmp_path / f'{scheme}{n}', d, rho_p, 0.5 * tau / n, n, U0=0.01, E=1e3, share=0.2,
                              momentum=scheme)
            case.control['writeInterval'] = n
            case.write()
            run(case)
            U.append(np.broadcast_to(case.field('U', case.times()[-1]), (8, 3))[0, 0])
        differences.append(abs(U[0] - U[1]))
    assert differences[0] > 1e-5
    for coarse, fine in zip(differences, differences[1:]):
        assert 1.8 < coarse / fine < 2.2


# --- Gas and steps above the relaxation time

@pytest.mark.parametrize('held, start', [('velocity', 1.1), ('force', 1.0), ('force', 1.2)])
def test_grains_fall_at_their_terminal_slip(tmp_path, held, start):
    """Grains at rest in a periodic gas that moves up at start times the terminal slip g tau, steps of 10 tau, 50 of
    them; the gas has a hundredth of the grains' mass. Held at its mean velocity, the slip is g tau from the first step
    on; driven by the weight of the grains, all is free but the total momentum, which stays: the slip is g tau from the start,
    or from the second step on. To 1e-3 (exp(-10) = 5e-5), and nothing swings beyond where it began."""
    d, rho_p, rho, mu = 50e-6, 2000.0, 1.2, 1.8e-5
    tau = rho_p * d**2 / (18 * mu)
    terminal = 9.81 * tau
    h, dt = 2 * d, 10 * tau
    case = FluidCase(tmp_path, rho=rho, nu=mu / rho, tolerance=1e-13, upper=(2 * h,)*3, cells=(2, 2, 2), cyclic='xyz',
                     gravity=(0, 0, -9.81), deltaT=dt, endTime=50 * dt, writeInterval=1, timePrecision=12, **ASCII)
    x = lattice(2, h)
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': d})
    case.fields['U'] = f'(0 0 {start * terminal!r})'
    case.properties = {'engine': 'liggghts', 'materials': {'glass': {**GLASS, 'density': rho_p, 'youngsModulus': 1.0}},
                       'contacts': CONTACTS, 'insertion': of_file(), 'output': ('csv',),
                       'coupling': case.coupling('Stokes', pressure=False)}
    case.mesh()
    weight = sphere(d) / h**3 * rho_p * 9.81 / rho
    case.write_dict('constant/fvOptions', {
        'velocity': {'up': {'type': 'meanVelocityForce', 'selectionMode': 'all', 'fields': ('U',),
                            'Ubar': (0, 0, start * terminal)}},
        'force': {'up': {'type': 'vectorSemiImplicitSource', 'selectionMode': 'all', 'volumeMode': 'specific',
                         'injectionRateSuSp': {'U': ((0, 0, weight), 0)}}}}[held])
    run(case)
    for k in range(1, 51):
        U = np.broadcast_to(case.field('U', folder(case, k * dt)), (8, 3))
        slip = U - vectors(case.table(k * dt))
        settled = start == 1 or held == 'velocity' or k >= 2
        assert np.abs(slip - [0, 0, terminal]).max() < (1e-3 if settled else start - 1 + 1e-3) * terminal, k
        share = sphere(d) / h**3
        common = (start - 1) / (1 + share / (1 - share) * rho_p / rho) + 1
        if held == 'velocity' or k >= 2:
            assert np.abs(U / terminal - [0, 0, start if held == 'velocity' else common]).max() < 1e-3, k


def resting_bed(path, ratio, n_steps, d=10e-6, **coupling):
    """A lattice of grains on the floor, gas from below at half the velocity of incipient fluidisation; time step ratio
    times m/Sp of the bed. Also Ergun's pressure drop [Pa] and the superficial velocity."""
    rho_p, rho, mu = 2000.0, 1.2, 1.8e-5
    eps = 1 - np.pi / 6
    tau = rho_p * d**2 * eps / (150 * (1 - eps) * mu)
    velocity = 0.5 * eps**3 * d**2 * (rho_p - rho) * 9.81 / (150 * mu * (1 - eps))
    layers = 10
    drop = layers * d * (150 * (1 - eps)**2 * mu * velocity / (eps**3 * d**2)
                         + 1.75 * (1 - eps) * rho * velocity**2 / (eps**3 * d))
    case = FluidCase(path, rho=rho, nu=mu / rho, tolerance=1e-10, upper=(6 * d, 6 * d, 16 * d), cells=(3, 3, 8),
                     cyclic='xy', deltaT=ratio * tau, endTime=n_steps * ratio * tau, writeInterval=1, timePrecision=12,
                     **ASCII)
    x = lattice((6, 6, layers), d)
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': d})
    case.fields['U'] = f'(0 0 {velocity!r})'
    case.patches = {'U': {'zMin': {'type': 'fixedValue', 'value': f'uniform (0 0 {velocity!r})'},
                          'zMax': {'type': 'zeroGradient'}},
                    'p': {'zMax': {'type': 'fixedValue', 'value': 'uniform 0'}}}
    case.properties = {'engine': 'liggghts', 'materials': {'glass': {**GLASS, 'density': rho_p, 'youngsModulus': 1e5}},
                       'contacts': CONTACTS, 'insertion': of_file(), 'output': ('csv',),
                       'walls': {'floor': {'type': 'plane', 'point': (0, 0, 0), 'normal': (0, 0, 1),
                                           'material': 'glass'}},
                       'coupling': case.coupling('Gidaspow', **coupling)}
    case.write()
    case.write_block_mesh()
    mesh = case.path / 'system/blockMeshDict'
    mesh.write_text(re.sub(r'(zM\w+\s*\{\s*type) wall', r'\1 patch', mesh.read_text()))
    done = case.run('blockMesh')
    assert done.code == 0, done.output
    return case, drop, velocity


@pytest.mark.parametrize('ratio, n_steps', [(3, 40), (10, 20)])
def test_gas_through_a_resting_bed(tmp_path, ratio, n_steps):
    """Steps of 3 and 10 times the relaxation time of a free grain in the bed: grains rest, velocities of the gas in the
    bed are bounded by twice the interstitial one, and everywhere in the end, and the pressure gradient is Ergun's
    within 2 % (overlaps of 0.1 % of d change it by 0.6 %) between the lowest and the highest but one of the bed's
    cells. In the highest the fluid's velocity is smeared over the jump. After 0.02 s the lattice would buckle."""
    case, drop, velocity = resting_bed(tmp_path, ratio, n_steps)
    run(case)
    times = case.times()
    for name in times:
        # The gas above the bed takes some steps to come to rest after the jump at the start
        cells = slice(None) if name == times[-1] else case.field('alphac', name) < 0.9
        assert np.abs(case.field('U', name)[cells]).max() < 2 * velocity / (1 - np.pi / 6), name
    p = case.field('p', times[-1]).reshape(8, 9).mean(axis=1) * 1.2
    # 6 of 10 layers
    assert abs((p[0] - p[3]) / (0.6 * drop) - 1) < 0.02
    assert np.abs(vectors(case.table(float(times[-1])))).max() < 1e-2 * velocity


# --- Whole sub-steps

def test_adjusted_steps_are_whole_sub_steps(tmp_path):
    """Every step a whole number of sub-steps to 1e-9, the Courant number's limit kept, write times met within half a
    sub-step."""
    sub, interval = 3e-6, 4.1e-4
    case = FluidCase(tmp_path, rho=1.2, nu=1.5e-5, upper=(L,)*3, cells=(4, 4, 4), cyclic='xyz', gravity=(0, 0, 0),
                     deltaT=1e-5 * 1.2, endTime=2.05e-3, writeControl='adjustableRunTime', writeInterval=interval,
                     adjustTimeStep=True, maxCo=0.2, maxDeltaT=1e-3, **ASCII)
    x = lattice(4, L / 4)
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': 4e-4})
    case.fields['U'] = '(2 0 0)'
    case.properties = {'engine': 'liggghts', 'materials': {'glass': GLASS}, 'contacts': CONTACTS,
                       'insertion': of_file(), 'output': ('csv',), 'timeStep': {'deltaT': sub},
                       'coupling': case.coupling('Stokes')}
    case.mesh()
    done = run(case)
    dt = np.array([float(v) for v in re.findall(r'^deltaT = (\S+)', done.output, re.M)])
    assert len(dt) > 20 and dt.max() > 1.5 * dt.min()
    # The log has 6 digits
    assert np.abs(dt / sub - np.round(dt / sub)).max() < 1e-5 * dt.max() / sub
    assert dt.max() * 2 / 1e-3 < 0.2 * 1.01
    n = [int(v) for v in re.findall(r'  sub-steps (\d+)  ', done.output)]
    assert np.array_equal(n, np.round(dt / sub))
    times = np.array([float(n) for n in case.times()])
    assert len(times) >= 4
    assert np.abs(times - interval * np.arange(1, len(times) + 1)).max() <= 0.5 * sub * (1 + 1e-9)


# --- A control: particles that do not see the flow

@pytest.mark.parametrize('interpolation', ['linear', 'cell'])
def test_no_carrier_velocity(tmp_path, interpolation):
    """Off, a grain in a flow slows down as in a fluid at rest: v = v0 exp(-t Sp/m), Stokes; with the flow along the other
    axes it stays where it was. On, it goes along."""
    d, tau = 4e-5, 2500 * (4e-5)**2 / (18 * 1.8e-5)
    ends = {}
    for on in (True, False):
        case = FluidCase(tmp_path / str(on), rho=1.2, nu=1.5e-5, upper=(L,)*3, cells=(4, 4, 4), cyclic='xyz',
                         gravity=(0, 0, 0), deltaT=1e-3, endTime=5e-3, writeInterval=5, **ASCII)
        case.path.mkdir()
        case.fields['U'] = '(0.02 0.01 0.03)'
        case.particles({'x': 2.1e-3, 'y': 2.2e-3, 'z': 2.3e-3, 'd': d, 'vx': 0.01})
        case.properties = {
            'engine': 'liggghts', 'materials': {'glass': GLASS}, 'contacts': CONTACTS, 'insertion': of_file(),
            'output': ('csv',),
            'coupling': case.coupling('Stokes', 'none', pressure=False, model='B', momentum='none',
                                      interpolation=interpolation, carrierVelocity=on)}
        case.mesh()
        run(case)
        ends[on] = case.table(5e-3)
    gone = np.exp(-5e-3 / tau)
    v = vectors(ends[False])[0]
    assert abs(v[0] / (0.01 * gone) - 1) < 1e-9 and np.abs(v[1:]).max() < 1e-18
    assert np.abs(vectors(ends[True])[0] - (np.array([0.02, 0.01, 0.03]) * (1 - gone) + [0.01 * gone, 0, 0])).max() < 1e-8
