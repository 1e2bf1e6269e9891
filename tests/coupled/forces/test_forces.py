"""Forces of the fluid's motion on particles in cfdDemFoam: added mass, history, torque, eddies; their restart and ranks.

Expected values are closed forms, written beside each test, or another run that must give the same.
"""
import re

import numpy as np
import pytest

from dewCase import changed, quoted
from evaporationCase import EvaporationCase
from fluidCase import FluidCase

GLASS = {'youngsModulus': 5e6, 'poissonsRatio': 0.3}
ASCII = {'writeFormat': 'ascii', 'writePrecision': 17}
RHO, NU, G = 1000.0, 1e-4, 9.81
MU = RHO * NU
D = 1e-3
VOLUME = np.pi / 6 * D**3


def vectors(rows, names='vx vy vz'):
    return np.stack([rows[n] for n in names.split()], axis=1)


def run(case, ranks=1):
    done = case.run('cfdDemFoam', ranks=ranks, timeout=120)
    assert done.code == 0, done.output
    return done


def two_digits(x):
    """A step that a time directory's name shows exactly."""
    return float(f'{x:.2g}')


def still(path, density, dt, n_steps, forces, momentum='none', model='A', columns=None, mesh=True, **control):
    """A sphere of 1 mm in a still oil of 0.1 Pa s, in a periodic box of 4 mm with gravity."""
    case = FluidCase(path, rho=RHO, nu=NU, tolerance=1e-14, deltaT=dt, endTime=n_steps * dt,
                     **{'upper': (4e-3,)*3, 'cells': (2, 2, 2), 'cyclic': 'xyz', 'gravity': (0, 0, -G),
                        'writeInterval': n_steps, 'timePrecision': 12, **ASCII, **control})
    case.particles({'x': 1.1e-3, 'y': 1.2e-3, 'z': 1.3e-3, 'd': D, **(columns or {})})
    case.properties = {
        'engine': 'liggghts', 'materials': {'glass': {**GLASS, 'density': density}},
        'contacts': {'default': {'restitution': 0.7, 'friction': 0.3}}, 'output': ('csv',),
        'insertion': {'some': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'glass'}},
        'coupling': case.coupling('Stokes', 'none' if momentum == 'none' else 'divided', momentum=momentum, model=model)}
    case.properties['coupling']['forces'].update(forces)
    if mesh:
        case.mesh()
    return case


# --- Added mass

@pytest.mark.parametrize('ratio', [8, 1.05, 0.01])
def test_added_mass_in_a_still_fluid(tmp_path, ratio):
    """(m + mf/2) dv/dt = (m - mf) g - 3 pi mu d v: the closed form, which a step of any size gives, to 1e-9; the
    lightest by 50 times its own mass."""
    m, mf, Sp = ratio * RHO * VOLUME, RHO * VOLUME, 3 * np.pi * MU * D
    tau = (m + mf / 2) / Sp
    dt = two_digits(tau / 3)
    case = still(tmp_path, ratio * RHO, dt, 6, {'added': {'type': 'virtualMass'}}, writeInterval=1)
    run(case)
    terminal = -(m - mf) * G / Sp
    for k in (1, 2, 6):
        v = vectors(case.table(k * dt))[0]
        assert abs(v[2] / (-terminal * np.expm1(-k * dt / tau)) - 1) < 1e-9, k
        assert np.abs(v[:2]).max() == 0


def open_ends(case):
    """Make the mesh, with xMin and xMax open."""
    case.write()
    case.write_block_mesh()
    mesh = case.path / 'system/blockMeshDict'
    mesh.write_text(re.sub(r'(xM\w+\s*\{\s*type) wall', r'\1 patch', mesh.read_text()))
    done = case.run('blockMesh')
    assert done.code == 0, done.output


@pytest.mark.parametrize('ratio', [8, 1.05, 0.01])
def test_added_mass_in_an_accelerated_fluid(tmp_path, ratio):
    """Plug flow under a difference of pressure, U = a t: m dv/dt = mf a + mf/2 (a - dv/dt), so dv/dt = 3 a/(2 ratio + 1), to 1e-8 between two times: that
    the forces are of the start of a step shows in the first only. A light sphere outruns the fluid threefold."""
    a, dt, n = 2.0, 1e-3, 6
    case = still(tmp_path, ratio * RHO, dt, n, {'added': {'type': 'virtualMass'}}, mesh=False, writeInterval=1,
                 gravity=(0, 0, 0), cyclic='yz', upper=(8e-3, 4e-3, 4e-3), cells=(4, 2, 2), outer=6)
    del case.properties['coupling']['forces']['drag']
    case.patches = {'U': {side: {'type': 'zeroGradient'} for side in ('xMin', 'xMax')},
                    'p': {'xMin': {'type': 'fixedValue', 'value': f'uniform {a * 8e-3!r}'},
                          'xMax': {'type': 'fixedValue', 'value': 'uniform 0'}}}
    open_ends(case)
    run(case)
    assert np.abs(case.field('U', case.times()[-1]) - [a * n * dt, 0, 0]).max() < 1e-10
    v = [vectors(case.table(k * dt))[0] for k in (3, n)]
    gained = np.array([3 * a / (2 * ratio + 1) * (n - 3) * dt, 0, 0])
    assert np.abs(v[1] - v[0] - gained).max() < 1e-8 * gained[0]


@pytest.mark.parametrize('momentum, ratio', [('explicit', 8), ('semiImplicit', 1.05), ('semiImplicit', 0.01)])
def test_fluid_gets_what_the_sphere_lost(tmp_path, momentum, ratio):
    """Added mass and history two-way, model B with buoyancy alone: the ledger closes to 1e-8 at every step, and what the
    sphere received in all is m v with its pending kick, less the weight in the fluid, (m - mf) g t."""
    m, mf, n = ratio * RHO * VOLUME, RHO * VOLUME, 8
    dt = two_digits((m + mf / 2) / (3 * np.pi * MU * D) / 5)
    case = still(tmp_path, ratio * RHO, dt, n, {'added': {'type': 'virtualMass'}, 'history': {
        'type': 'history', 'kernel': 'Basset', 'window': 5 * dt, 'intervals': 10}}, momentum=momentum, model='B')
    run(case)
    rows = case.ledger()
    received, lost = (vectors(rows, f'{k}x {k}y {k}z') for k in 'rl')
    assert rows['scale'].min() > 0
    assert np.all(np.linalg.norm(received - lost, axis=1) < 1e-8 * rows['scale'])

    path = case.path / case.times()[-1] / 'uniform/particles/exchange'
    kick = np.frombuffer(path.read_bytes()[32:-8], dtype=[('id', '<i8'), ('values', '<f8', 4)])['values'][0, 2]
    held = m * vectors(case.table(n * dt))[0, 2] + kick
    weight = (m - mf) * G * n * dt
    assert abs(received[:, 2].sum() - (held + weight)) < 1e-8 * abs(weight)
    assert 0.05 < received[:, 2].sum() / weight < 1


# --- History

# Velocity over the terminal one of a sphere released in a viscous fluid, at t nu/R^2 = 1 (Boussinesq 1885, Basset
# 1888): v' + s v + s pi^-1/2 int_0^t v'(u) (t - u)^-1/2 du = s, s = 9/(2 ratio + 1); of the Laplace transform
# s/(p (p + s p^1/2 + s)), v = 1 - (b E(a) - a E(b))/(b - a), E(c) = exp(c^2) erfc(c), a + b = a b = s; with mpmath
SETTLING = {8: 0.3057382914, 1.05: 0.5144302395, 0.01: 0.5542749615}


@pytest.mark.parametrize('ratio', SETTLING)
def test_settling_with_history(tmp_path, ratio):
    """To 5e-5 of the terminal velocity with 20 steps up to R^2/nu, and at least as the first power of the step: of 40
    steps less than 1/1.8 of that."""
    errors = []
    for n in (20, 40):
        dt = D**2 / 4 / NU / n
        case = still(tmp_path / str(n), ratio * RHO, dt, n, {
            'added': {'type': 'virtualMass'},
            'history': {'type': 'history', 'kernel': 'Basset', 'window': 1.0, 'intervals': n + 1}})
        run(case)
        terminal = (1 - ratio) * G * D**2 / (18 * NU)
        errors.append(vectors(case.table(n * dt))[0, 2] / terminal - SETTLING[ratio])
    assert abs(errors[0]) < 5e-5
    assert abs(errors[0]) > 1.8 * abs(errors[1])


# --- Torque

def test_spin_in_a_still_fluid(tmp_path):
    """omega = omega0 exp(-t/tau), tau = rho d^2/(60 mu): to 1e-9, in steps of tau."""
    density = 2500.0
    dt = two_digits(density * D**2 / (60 * MU))
    omega = np.array([1.0, -2.0, 3.0])
    case = still(tmp_path, density, dt, 3, {'torque': {'type': 'rotationalTorque'}}, writeInterval=1,
                 columns={'wx': omega[0], 'wy': omega[1], 'wz': omega[2]})
    run(case)
    for k in (1, 3):
        exact = omega * np.exp(-k * dt * 60 * MU / (density * D**2))
        assert np.abs(vectors(case.table(k * dt), 'wx wy wz')[0] - exact).max() < 1e-9 * 3


@pytest.mark.parametrize('lag', [0, 0.1])
def test_shear_turns_and_lifts(tmp_path, lag):
    """Plane Couette flow U = s y: the sphere comes to turn with -s/2 about z, omega = -s/2 (1 - exp(-t/tau)); one that
    lags behind is lifted to the faster side, and one that goes with the fluid is not. 1e-8: the flow's solution."""
    shear, density = 20.0, 2500.0
    dt = two_digits(density * D**2 / (60 * MU))
    case = still(tmp_path, density, dt, 3, {'torque': {'type': 'rotationalTorque'}, 'lift': {'type': 'SaffmanMei'}},
                 mesh=False, writeInterval=1, gravity=(0, 0, 0), cyclic='xz', cells=(2, 4, 2),
                 columns={'vx': shear * 1.2e-3 - lag})
    rows = [[(shear * (j + 0.5) * 1e-3, 0.0, 0.0)] * 2 for j in range(4)]
    case.fields['U'] = np.array([rows, rows]).reshape(-1, 3)
    case.patches = {'U': {'yMin': {'type': 'fixedValue', 'value': 'uniform (0 0 0)'},
                          'yMax': {'type': 'fixedValue', 'value': f'uniform ({shear * 4e-3!r} 0 0)'}}}
    case.mesh()
    run(case)
    for k in (1, 3):
        row = case.table(k * dt)
        exact = shear / 2 * np.expm1(-k * dt * 60 * MU / (density * D**2))
        assert np.abs(vectors(row, 'wx wy wz')[0] - [0, 0, exact]).max() < 1e-8 * shear
    if lag:
        assert row['vy'][0] > 1e-6
    else:
        assert abs(row['vy'][0]) < 1e-9


# --- Restart and ranks

def turbulent(path, n_steps, kernel='Basset', **control):
    """24 grains that slip through a turbulent stream and each other's wake of eddies; they go from one half of the
    periodic box to the other in the ten steps."""
    dt = 2e-3
    case = FluidCase(path, rho=RHO, nu=1e-6, tolerance=1e-14, upper=(4e-3,)*3, cells=(4, 2, 2), cyclic='xyz',
                     gravity=(0, 0, -G), deltaT=dt, endTime=n_steps * dt,
                     **{'writeInterval': n_steps, 'timePrecision': 12, **ASCII, **control})
    rng = np.random.default_rng(5)
    x = (np.array(list(np.ndindex(4, 3, 2))) + 0.5) * [1e-3, 4e-3 / 3, 2e-3]
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': 2e-4, 'vx': rng.uniform(0, 0.2, 24)})
    case.fields['U'] = '(0.1 0.02 0)'
    forces = {'added': {'type': 'virtualMass'},
              'history': {'type': 'history', 'kernel': kernel, 'window': 5 * dt, 'intervals': 8}}
    case.properties = {
        'engine': 'liggghts', 'materials': {'glass': {**GLASS, 'density': 1500.0}},
        'contacts': {'default': {'restitution': 0.7, 'friction': 0.3}}, 'output': ('csv',),
        'insertion': {'some': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'glass'}},
        'coupling': case.coupling('SchillerNaumann', 'none', momentum='none',
                                  seenVelocity={'eddies': {'type': 'eddyInteraction', 'seed': 4}})}
    case.properties['coupling']['forces'].update(forces)
    case.mesh()
    case.write_dict('constant/turbulenceProperties', {
        'simulationType': 'RAS', 'RAS': {'RASModel': 'kEpsilon', 'turbulence': True, 'printCoeffs': False}})
    for name, dimensions, value in (('k', '[0 2 -2 0 0 0 0]', 1e-3), ('epsilon', '[0 2 -3 0 0 0 0]', 0.5),
                                    ('nut', '[0 2 -1 0 0 0 0]', 0)):
        case.write_dict(f'0/{name}', {'dimensions': dimensions, 'internalField': f'uniform {value}',
                                      'boundaryField': {'".*"': {'type': 'cyclic'}}}, 'volScalarField')
    return case


@pytest.fixture(scope='module')
def uninterrupted(tmp_path_factory):
    case = turbulent(tmp_path_factory.mktemp('uninterrupted'), 10)
    run(case)
    return case


def same_particles(one, other, time, tolerance):
    a, b = one.table(time), other.table(time)
    assert np.array_equal(a['id'], b['id']) and len(a) == 24
    for names, scale in (('vx vy vz', 0.1), ('x y z', 4e-3)):
        assert np.abs(vectors(a, names) - vectors(b, names)).max() < tolerance * scale, names


def test_two_ranks_as_one(uninterrupted, tmp_path):
    """Eddies and past go with a particle to the other rank: to 1e-9. All have crossed the middle or the ends."""
    case = turbulent(tmp_path, 10)
    case.properties['processors'] = (2, 1, 1)       # the engine, too, is cut across the way they go
    case.write_dict('constant/particleProperties', case.properties)
    case.decompose(2)
    run(case, 2)
    same_particles(uninterrupted, case, 0.02, 1e-9)
    before = (np.arange(24) // 6 + 0.5) * 1e-3 > 2e-3
    assert (before != (case.table(0.02)['x'] > 2e-3)).sum() > 5


@pytest.mark.parametrize('before, after', [(1, 1), (2, 2), (1, 2)])
def test_restart_keeps_past_and_eddies(uninterrupted, tmp_path, before, after):
    """5 steps, a restart from binary files, 5 more: as 10 steps, to 1e-9."""
    case = turbulent(tmp_path, 5, writeFormat='binary')
    if before > 1:
        case.decompose(before)
    run(case, before)
    case.control.update(endTime=0.02)
    case.write_dict('system/controlDict', case.control)
    if after > before:
        case.decompose(after)
    run(case, after)
    same_particles(uninterrupted, case, 0.02, 1e-9)


def test_past_goes_to_a_rank_without_particles(tmp_path):
    """One sphere shot from the middle of one rank into the other, which has seen none: two ranks as one, to 1e-9."""
    dt, n, tables = 5e-4, 10, []
    for ranks in (1, 2):
        case = still(tmp_path / str(ranks), 8 * RHO, dt, n, {
            'history': {'type': 'history', 'kernel': 'Basset', 'window': 5 * dt, 'intervals': 8}},
            columns={'x': 2e-3, 'vx': 1.5}, upper=(8e-3, 4e-3, 4e-3), cells=(4, 2, 2))
        if ranks > 1:
            case.decompose(ranks)
        run(case, ranks)
        tables.append(case.table(n * dt))
    assert tables[0]['x'][0] > 4.5e-3
    for names, scale in (('vx vy vz', 1.0), ('x y z', 8e-3)):
        assert np.abs(vectors(tables[0], names) - vectors(tables[1], names)).max() < 1e-9 * scale


@pytest.mark.parametrize('ranks', [1, 2])
def test_past_begins_with_a_particle_let_in(tmp_path, ranks):
    """A run without particles at first: of those let in at 100/s each keeps its own past, as a restart every step does,
    to 1e-9."""
    dt, n = 5e-3, 8
    ends = []
    for restarts in (False, True):
        case = still(tmp_path / str(restarts), 8 * RHO, dt, n, {
            'history': {'type': 'history', 'kernel': 'Basset', 'window': 5 * dt, 'intervals': 8}},
            cyclic='xy', upper=(8e-3, 4e-3, 4e-3), cells=(4, 2, 2), mesh=False)
        case.properties['insertion'] = {'rain': {
            'type': 'rate', 'material': 'glass', 'numberRate': 100, 'start': 1.5 * dt,
            'diameter': {'type': 'mono', 'value': 2e-4},
            'region': {'type': 'box', 'min': (1e-3, 1e-3, 1e-3), 'max': (7e-3, 3e-3, 3e-3)}}}
        case.mesh()
        if ranks > 1:
            case.decompose(ranks)
        for k in range(n // 2, n + 1, n // 2) if restarts else [n]:
            case.control.update(endTime=k * dt)
            case.write_dict('system/controlDict', case.control)
            run(case, ranks)
        ends.append(case.table(n * dt))
    assert len(ends[0]) > 2
    assert np.array_equal(ends[0]['id'], ends[1]['id'])
    for names, scale in (('vx vy vz', 0.1), ('x y z', 4e-3)):
        assert np.abs(vectors(ends[0], names) - vectors(ends[1], names)).max() < 1e-9 * scale


def test_past_and_eddies_matter(uninterrupted, tmp_path):
    """Without its past, or with other eddies, the same case ends elsewhere: what the tests above compare."""
    for name in ('past', 'eddies'):
        case = turbulent(tmp_path / name, 10)
        coupling = case.properties['coupling']
        if name == 'past':
            del coupling['forces']['history']
        else:
            coupling['seenVelocity']['eddies']['seed'] = 5
        case.write_dict('constant/particleProperties', case.properties)
        run(case)
        a, b = uninterrupted.table(0.02), case.table(0.02)
        assert np.abs(vectors(a) - vectors(b)).max() > 1e-3, name


# --- What cannot be meant

BASSET = {'type': 'history', 'kernel': 'Basset', 'window': 1.0}
EDDIES = {'coupling/seenVelocity': {'eddies': {'type': 'eddyInteraction', 'seed': 1}}}

REFUSED = {
    'steps in the window': (
        {'coupling/forces/past': {**BASSET, 'intervals': 3}}, ('more than 3 steps', '1 s', "'intervals'", "'window'")),
    'tail of MeiAdrian': (
        {'coupling/forces/past': {**BASSET, 'kernel': 'MeiAdrian', 'tail': True}},
        ('past', "'tail'", 'MeiAdrian', 'Remove')),
    'window missing': (
        {'coupling/forces/past': {'type': 'history', 'kernel': 'Basset'}}, ('particleProperties', 'past', "'window'")),
    'kernel unknown': (
        {'coupling/forces/past': {**BASSET, 'kernel': 'Bassett'}}, ('past', 'Bassett', 'Basset', 'MeiAdrian')),
    'intervals': (
        {'coupling/forces/past': {**BASSET, 'intervals': 500}}, ('past', "'intervals'", '500', '140')),
    'Brownian beside history': (
        {'coupling/forces/past': BASSET, 'coupling/forces/random': {'type': 'Brownian', 'T': 300}},
        ('Brownian and history', 'random', 'Remove one')),
    'no turbulence': (EDDIES, ('eddyInteraction', 'k and epsilon', 'eddies', 'RAS', 'turbulenceProperties')),
    'seed missing': (
        {'coupling/seenVelocity': {'eddies': {'type': 'eddyInteraction'}}}, ('eddies', "'seed'")),
    'model unknown': (
        {'coupling/seenVelocity': {'eddies': {'type': 'eddies'}}}, ('seenVelocity', 'eddies', 'eddyInteraction')),
    'coefficient negative': (
        {'coupling/forces/added/coefficient': -0.5}, ('added', "'coefficient'", '-0.5')),
    'without inertia': (
        {'dynamics': {'type': 'overdamped', 'viscosity': MU}}, ('added mass', 'overdamped', 'virtualMass', 'inertial')),
}


@pytest.mark.parametrize('what', REFUSED)
def test_refused(tmp_path, what):
    changes, words = REFUSED[what]
    case = still(tmp_path, 1200.0, 1e-3, 6, {'added': {'type': 'virtualMass'}}, mesh=False)
    case.properties = changed(case.properties, changes)
    case.mesh()
    done = case.run('cfdDemFoam')
    text = ' '.join(done.output[max(done.output.find('FATAL'), 0):].split())
    assert done.code > 0 and done.output.count('FATAL') == 1, done.output
    missing = [word for word in words if word not in text]
    assert not missing, f'no {missing} in:\n{text}'
    assert case.times() == []


@pytest.mark.parametrize('law', ['virtualMass', 'viscousStressForce'])
def test_refused_beside_a_drop(tmp_path, law):
    """interEvapDemFoam has no acceleration and no stress of the fluid to offer."""
    case = EvaporationCase(tmp_path, film=0.5e-3)
    case.properties['coupling']['forces'] = {'some': {'type': law}}
    case.prepare()
    done = case.run('interEvapDemFoam')
    text = ' '.join(done.output.split())
    assert done.code > 0 and done.output.count('FATAL') == 1, done.output
    assert law in text and 'does not offer' in text and 'cfdDemFoam' in text, text
