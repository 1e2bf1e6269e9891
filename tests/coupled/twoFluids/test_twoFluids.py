"""Particles in two fluids: void fraction, forces and ledgers while particles cross the surface of the water.

Balances are identities of the equations: tolerances are round-off of sums, times the steps.
"""
import numpy as np
import pytest

from dewCase import SIDES, changed, quoted
from fluidCase import FluidCase
from twoFluidCase import TwoFluidCase, beyond_bounds, liquid_volumes, unbalanced

WIDTH, HEIGHT, CELL, LEVEL, D = 0.012, 0.024, 2e-3, 0.0113, 1e-3
RHO = (1000, 1.2)


def box(path, positions, vz=0.0, density=2500, forces=None, model='A', coupling=None, d=D, engine='liggghts', modulus=1e6, sub=5e-5,
        **keywords):
    """Spheres in a closed box, half full of water."""
    case = TwoFluidCase(path, **{'level': LEVEL, 'upper': (WIDTH, WIDTH, HEIGHT), 'cells': (6, 6, 12), 'deltaT': 5e-4,
                                 'endTime': 0.02, 'writeInterval': 40, 'writeFormat': 'ascii', 'writePrecision': 17,
                                 'rho': RHO, 'tolerance': 1e-12, **keywords})
    case.properties = {
        'engine': engine, 'timeStep': {'deltaT': sub}, 'output': ('csv',),
        'materials': {'glass': {'youngsModulus': modulus, 'poissonsRatio': 0.3, 'density': density}},
        'contacts': {'default': {'restitution': 0.8, 'friction': 0.4}},
        'insertion': {'spheres': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'glass'}},
        'walls': {'box': {'type': 'patch', 'patches': tuple(s for s in SIDES if s[0] not in case.cyclic),
                          'material': 'glass'}},
        'coupling': {'model': model, 'voidFraction': {'type': 'divided'},
                     'forces': forces or {'drag': {'type': 'DiFelice'}, 'pressure': {'type': 'pressureGradientForce'}},
                     **(coupling or {})}}
    x = np.atleast_2d(positions)
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': d, 'vz': vz})
    return case


def falling(path, **keywords):
    """27 spheres just above the surface and in it, at 0.4 m/s."""
    k = np.arange(27)
    shift = np.random.default_rng(3).uniform(-4e-4, 4e-4, (27, 3))
    x = (np.stack([k % 3, k//3 % 3, k//9], axis=1) + 0.5)*np.array([4, 4, 1.9])*1e-3 + (0, 0, LEVEL - 5e-4) + shift
    return box(path, x, vz=-0.4, **keywords)


def solve(case, ranks=1):
    done = case.run('interDemFoam', ranks=ranks)
    assert done.code == 0, done.output
    return done.output


@pytest.mark.parametrize('motion, model, sigma', [
    ('isoAdvector', 'A', 0.0), ('isoAdvector', 'B', 0.0), ('MULES', 'A', 0.0), ('isoAdvector', 'A', 0.072)])
def test_balances_while_spheres_cross_the_surface(tmp_path, motion, model, sigma):
    """Liquid as it was, to 1e-12; alpha beyond its bounds by 1e-9 at most (numbers of the project's aims); momentum."""
    case = falling(tmp_path, motion=motion, model=model, sigma=sigma, deltaT=2e-4, endTime=0.016)
    case.mesh()
    output = solve(case)
    volumes = liquid_volumes(output)
    assert len(volumes) == 80
    z = case.table(0.016)['z'] if case.times() else None
    assert z is not None and z.max() < LEVEL
    assert np.abs(volumes/volumes[0] - 1).max() < 1e-12
    assert beyond_bounds(output) < 1e-9
    assert unbalanced(output) < 1e-12
    ledger = case.ledger()
    assert np.abs(ledger.represented/(27*np.pi/6*D**3) - 1).max() < 1e-12


# --- Ranks and restarts

def same(one, other, time, ranks, tolerance):
    """Velocities of the fluids and of the spheres, over the fastest; shares of liquid."""
    a, b = one.table(float(time)), other.table(float(time))
    U, W = one.field('U', time), other.joined_field('U', time, ranks)
    assert np.abs(U - W).max() < tolerance*np.abs(U).max()
    alpha = one.field('alpha.water', time)
    assert np.abs(alpha - other.joined_field('alpha.water', time, ranks)).max() < tolerance
    for name in ('vx', 'vy', 'vz'):
        assert np.abs(a[name] - b[name]).max() < tolerance*np.abs(a['vz']).max()


ALL = {'drag': {'type': 'DiFelice'}, 'pressure': {'type': 'pressureGradientForce'}, 'mass': {'type': 'virtualMass'},
       'stress': {'type': 'viscousStressForce'}, 'lift': {'type': 'SaffmanMei'},
       'capillarity': {'type': 'capillaryForce', 'contactAngle': 80}}


def crossing(path, **keywords):
    """Spheres that cross the surface with all kinds of laws."""
    return falling(path, sigma=0.072, deltaT=2.5e-4, tolerance=1e-14, forces=ALL, **keywords)


@pytest.fixture(scope='module')
def whole(tmp_path_factory):
    """32 steps on one rank, the spheres in the surface at half of them."""
    case = crossing(tmp_path_factory.mktemp('whole'), endTime=8e-3, writeInterval=32)
    case.mesh()
    assert unbalanced(solve(case)) < 1e-12
    return case


def test_two_ranks_do_as_one(whole, tmp_path):
    """To 1e-8: solvers end at 1e-14 of residuals, 32 steps of them."""
    case = whole.copy(tmp_path/'two')
    case.decompose(2)
    solve(case, ranks=2)
    same(whole, case, '0.008', 2, 1e-8)


@pytest.mark.parametrize('ranks', [1, 2])
def test_restart_goes_on(whole, tmp_path, ranks):
    """16 steps, a restart, 16 more; on two ranks also."""
    case = crossing(tmp_path/'parts', endTime=4e-3, writeInterval=16)
    case.mesh()
    solve(case)
    case.control['endTime'] = 8e-3
    case.write_dict('system/controlDict', case.control)
    if ranks > 1:
        case.decompose(ranks)
    solve(case, ranks=ranks)
    same(whole, case, '0.008', ranks, 1e-8)


# --- Forces at rest

@pytest.mark.parametrize('sigma', [0.0, 0.072])
def test_no_force_in_fluids_at_rest_but_buoyancy(tmp_path, sigma):
    """Spheres as dense as water below the surface, as dense as air above it and as half of both in its middle stay where
    they are: pressure without jumps, and the cut by the surface. To 1e-6 of the speed of a fall over the time,
    what the pressure solver leaves in air."""
    case = box(tmp_path, [(2.1e-3, 5.3e-3, 3e-3), (6.3e-3, 6.1e-3, LEVEL), (9.1e-3, 4.7e-3, LEVEL - 0.6e-3),
                          (3e-3, 9.3e-3, LEVEL + 0.6e-3)], sigma=sigma, endTime=5e-3, writeInterval=10,
               modulus=1e3, tolerance=1e-15, outer=4)
    materials = {'water': 1000.0, 'half': 500.6, 'air': 1.2}
    stone = case.properties['materials']['glass']
    case.properties['materials'] = {'glass': stone, **{m: {**stone, 'density': d} for m, d in materials.items()}}
    table = case.path/'constant/particles.csv'
    rows = table.read_text().split()
    table.write_text('\n'.join([rows[0] + ',material'] + [f'{row},{m}' for row, m in zip(
        rows[1:], ('water', 'half', 'water', 'air'))]) + '\n')
    case.properties['insertion']['spheres'].pop('material')
    case.properties['coupling']['voidFraction'] = {'type': 'none'}
    case.mesh()
    solve(case)
    rows = case.table(5e-3)
    assert np.abs([rows[k] for k in ('vx', 'vy', 'vz')]).max() < 1e-6*9.81*5e-3


def depth(density, d, sigma, angle):
    """Of the centre below the surface, over the radius, at rest: weight = buoyancy of the two parts + tension."""
    R = d/2

    def force(z):
        share = (1 - z)**2*(2 + z)/4
        beta = np.arccos(-z)
        return (np.pi/6*d**3*9.81*(RHO[1] + (RHO[0] - RHO[1])*share - density)
                + 2*np.pi*R*sigma*np.sin(beta)*np.sin(np.deg2rad(angle) - beta))
    z = np.linspace(-1, 1, 20001)
    falls = np.flatnonzero((force(z)[:-1] >= 0) & (force(z)[1:] < 0))
    assert len(falls) == 1
    low, high = z[falls[0]], z[falls[0] + 1]
    for _ in range(60):
        middle = (low + high)/2
        low, high = (middle, high) if force(middle) >= 0 else (low, middle)
    return -low


CAPILLARITY = {'drag': {'type': 'DiFelice'}, 'pressure': {'type': 'pressureGradientForce'}}


def floating(path, density, sigma=0.0, angle=None, z=0.0, d=2e-3, **keywords):
    """A sphere in the middle of the surface of something viscous, its centre z radii above."""
    forces = dict(CAPILLARITY)
    if angle is not None:
        forces['capillarity'] = {'type': 'capillaryForce', 'contactAngle': angle}
    return box(path, (0.0171, 0.0163, 0.0131 + z*d/2), density=density, forces=forces, d=d, sigma=sigma,
               **{'level': 0.0131, 'upper': (0.032, 0.032, 0.024), 'cells': (8, 8, 6), 'mu': (0.05, 1.8e-5), 'endTime': 0.3,
                  'deltaT': 1e-3, 'writeInterval': 300, 'tolerance': 1e-9, 'sub': 5e-5 if d > 5e-4 else 1e-5, **keywords})


@pytest.mark.parametrize('density, sigma, angle, d', [
    (500.6, 0.0, None, 2e-3), (300, 0.0, None, 2e-3), (500, 0.072, 60, 2e-3), (1500, 0.072, 110, 2e-3),
    (2500, 0.072, 110, 2e-4)])
def test_floating_depth(tmp_path, density, sigma, angle, d):
    """The depth at rest, from weight, Archimedes and the tension at the contact line. The level rises by what is immersed,
    1e-6 of the cross-section for 2 mm: 4e-3 of the radius, and in the sphere's cell by less than twice that."""
    case = floating(tmp_path, density, sigma, angle, d=d, z=0.2 if angle is None else -np.cos(np.deg2rad(angle)))
    case.mesh()
    solve(case)
    row = case.table(0.3)
    assert abs((0.0131 - row['z'][0])/(d/2) - depth(density, d, sigma, angle or 0)) < 0.015
    assert abs(row['vz'][0]) < 1e-3*d/2/0.01


@pytest.mark.parametrize('heavier, floats', [(0.97, True), (1.03, False)])
def test_detachment(tmp_path, heavier, floats):
    """Half pi d sigma (1 - cos(theta)) at beta = theta/2 is the most the surface holds, with the buoyancy of that depth: a
    sphere of 0.97 of that weight stays, one of 1.03 sinks."""
    d, sigma, angle = 1e-3, 0.072, 110.0
    z = -np.cos(np.deg2rad(angle)/2)
    share = (1 - z)**2*(2 + z)/4
    held = 0.5*np.pi*d*sigma*(1 - np.cos(np.deg2rad(angle)))
    density = held/(9.81*np.pi/6*d**3) + RHO[1] + (RHO[0] - RHO[1])*share
    case = floating(tmp_path, heavier*density, sigma, angle, z=z + 0.1*floats, d=d)
    case.mesh()
    solve(case)
    assert (case.table(0.3)['z'][0] > 0.0131 - d/2) == floats


@pytest.mark.parametrize('heavier, floats', [(0.95, True), (1.05, False)])
def test_detachment_of_a_plane(tmp_path, heavier, floats):
    """With pull plane pi d sigma (1 - cos(theta)), and the buoyancy of the whole sphere: one of 0.95 of that weight stays,
    one of 1.05 sinks. Begun where the first is at rest, for it has too little friction to come there."""
    d, sigma, angle = 1e-3, 0.072, 110.0
    held = np.pi*d*sigma*(1 - np.cos(np.deg2rad(angle)))
    density = held/(9.81*np.pi/6*d**3) + RHO[0]
    case = floating(tmp_path, heavier*density, sigma, angle, z=-1 + 0.05*(1 - np.cos(np.deg2rad(angle))), d=d)
    case.properties['coupling']['forces']['capillarity']['pull'] = 'plane'
    case.mesh()
    solve(case)
    assert (case.table(0.3)['z'][0] > 0.0131 - d/2) == floats


# --- Bad input

REFUSALS = {
    'angle': ({'coupling/forces/capillarity': {'type': 'capillaryForce', 'contactAngle': 190}},
              ('particleProperties', 'capillarity', 'contactAngle', '190', '180')),
    'no angle': ({'coupling/forces/capillarity': {'type': 'capillaryForce'}},
                 ('particleProperties', 'capillarity', 'contactAngle')),
    'pull': ({'coupling/forces/capillarity': {'type': 'capillaryForce', 'contactAngle': 60, 'pull': 'Pieranski'}},
             ('particleProperties', 'Pieranski', 'contactLine', 'plane')),
    'two surfaces': ({'coupling/forces/capillarity': {'type': 'capillaryForce', 'contactAngle': 60},
                      'coupling/forces/skin': {'type': 'elasticSurface', 'stiffness': 1e-3}},
                     ('particleProperties', 'elasticSurface', 'capillaryForce', 'Remove'))}


@pytest.mark.parametrize('subject', REFUSALS)
def test_refusals(tmp_path, subject):
    changes, words = REFUSALS[subject]
    case = floating(tmp_path, 500)
    case.properties = changed(case.properties, changes)
    case.mesh()
    done = case.run('interDemFoam')
    assert done.code != 0 and not case.times()
    for word in words:
        assert word in done.output, word


def test_unknown_entry_of_surface_tension(tmp_path):
    """Also one that would do nothing: the share of an implicit part that is off."""
    for entry in ({'semiImplict': 'yes'}, {'implicitShare': 0.5}):
        case = floating(tmp_path/next(iter(entry)), 500)
        case.surface['surfaceTension'].update(entry)
        case.mesh()
        done = case.run('interDemFoam')
        assert done.code != 0 and next(iter(entry)) in done.output and 'surfaceTension' in done.output


def test_particles_need_the_distance(tmp_path):
    case = floating(tmp_path, 500)
    case.surface['distance'] = {'type': 'none'}
    case.mesh()
    done = case.run('interDemFoam')
    assert done.code != 0 and not case.times()
    for word in ('surfaceProperties', 'distance', 'none', 'reconstructed', 'Particles'):
        assert word in done.output, word


def test_capillarity_needs_two_fluids(tmp_path):
    """In a solver of one fluid the law is refused, with the solver that has it."""
    case = FluidCase(tmp_path, endTime=1e-3)
    case.properties = changed(box(tmp_path, (2e-3,)*3).properties, {
        'coupling/forces/capillarity': {'type': 'capillaryForce', 'contactAngle': 60}})
    case.mesh()
    done = case.run('cfdDemFoam')
    assert done.code != 0
    for word in ('capillaryForce', 'surface', 'interDemFoam', 'forces'):
        assert word in done.output, word
