"""Surface tension that varies: the pull along a flat surface and around a drop; ranks, mirrors and wrong input.

Two layers, each between a wall and the surface, with sigma = s0 + s1 cos(k x): without inertia the stream functions

    psi_j = f_j(eta) sin(k x),  f_j = c1 sinh(k eta) + c2 eta cosh(k eta) + c3 eta sinh(k eta),  u = d(psi)/dy

(eta from the wall, so that f_j = 0 there; of the four solutions of the biharmonic equation cosh(k eta) drops out by
this) with no slip at the wall, no flow through the surface, one velocity along it, and the jump of the shear stress,

    mu1 u1' - mu2 u2' = d(sigma)/dx,

give u. Surface tension is strong and s1 small: the surface stays flat, and inertia is small.
"""
import re

import numpy as np
import pytest

from twoFluidCase import TwoFluidCase

WIDTH, HEIGHT, LEVEL = 2.0, 1.0, 0.45
K = 2*np.pi/WIDTH
S0, S1 = 100.0, 0.1
BOUNDS = re.compile(r'^Surface tension: from (\S+) to (\S+) N/m', re.M)


def layer(h):
    """u = d(psi)/d(eta) as a function of eta with u(h) = 1, and its slope there."""
    # f(h) = 0, f'(0) = 0, f'(h) = 1
    s, c = np.sinh(K*h), np.cosh(K*h)
    rows = [[s, h*c, h*s], [K, 1, 0], [K*c, c + K*h*s, s + K*h*c]]
    a = np.linalg.solve(rows, [0, 0, 1])

    def u(y):
        s, c = np.sinh(K*y), np.cosh(K*y)
        return a[0]*K*c + a[1]*(c + K*y*s) + a[2]*(s + K*y*c)
    return u, a[0]*K**2*s + a[1]*(2*K*s + K**2*h*c) + a[2]*(2*K*c + K**2*h*s)


def exact(x, y, mu):
    """u of both layers, and the most of it on the surface."""
    below, slope1 = layer(LEVEL)
    above, slope2 = layer(HEIGHT - LEVEL)
    # Both slopes are away from a wall; sigma' = -k s1 sin(k x) = U (mu1 slope1 + mu2 slope2) sin(k x)
    U = -K*S1/(mu[0]*slope1 + mu[1]*slope2)
    profile = np.where(y < LEVEL, below(np.minimum(y, LEVEL)), above(np.minimum(HEIGHT - y, HEIGHT - LEVEL)))
    return U*np.sin(K*x)*profile, abs(U)


def centres(n):
    return [v.ravel() for v in np.meshgrid((np.arange(2*n) + 0.5)/n, (np.arange(n) + 0.5)/n)]


class Alone(TwoFluidCase):
    """Without particles; a predictor for the viscous flow; shapes, if any, filled by setLiquid."""

    shapes = None

    def write(self):
        super().write()
        (self.path/'constant/particleProperties').unlink()
        if self.shapes:
            self.write_dict('system/setLiquidDict', {'liquid': 'water', 'shapes': self.shapes})

    def mesh(self):
        super().mesh()
        if self.shapes:
            assert self.run('setLiquid').code == 0


def layers(path, n=16, mu=(1.0, 1.0), steps=None, **keywords):
    """Two layers in the x-z plane, 2n x n cells."""
    dt = 4e-3*16/n
    end = steps*dt if steps else 0.5
    case = Alone(path, **{
        'level': LEVEL, 'upper': (WIDTH, 0.1, HEIGHT), 'cells': (2*n, 1, n), 'cyclic': 'xy', 'rho': (1.0, 1.0),
        'mu': mu, 'gravity': (0, 0, 0), 'endTime': end, 'deltaT': dt, 'writeFormat': 'ascii', 'writePrecision': 16,
        'tolerance': 1e-9, 'writeControl': 'runTime', 'writeInterval': end, **keywords})
    case.fields['T'] = np.cos(K*centres(n)[0])
    case.patches['U'] = {side: {'type': 'noSlip'} for side in ('zMin', 'zMax')}
    case.surface['surfaceTension'] = {
        'semiImplicit': True, 'sigma': {'type': 'linear', 'field': 'T', 'sigma0': S0, 'slope': S1}}
    return case


def solve(case, ranks=1):
    result = case.run('interDemFoam', ranks=ranks, timeout=400)
    assert result.code == 0, result.output[-3000:]
    return result.output


def bounds(output):
    """Least and largest surface tension of each step."""
    return np.array(BOUNDS.findall(output), dtype=float)


# --- A flat surface

def error(path, n, mu):
    """Of the velocity along the layers, root mean square over that of the surface."""
    case = layers(path, n, mu)
    case.mesh()
    solve(case)
    u, U = exact(*centres(n), mu)
    return np.sqrt(np.mean((case.field('U', 0.5)[:, 0] - u)**2))/U


@pytest.mark.parametrize('mu, order, scale', [((1.0, 1.0), 2, 0.5), ((1.0, 0.25), 1, 0.4)], ids=['even', 'uneven'])
def test_layers_driven_by_their_surface(tmp_path, mu, order, scale):
    """Second order with one viscosity: (h/level)^2 times a number of order 1, 0.34 and 0.36 measured. Viscosities that
    differ are mixed in the cells of the surface, which is of first order: 0.35 and 0.36 measured of h/level."""
    errors = [error(tmp_path/str(n), n, mu) for n in (16, 32)]
    print(errors)
    for n, e in zip((16, 32), errors):
        assert e < scale*(HEIGHT/n/LEVEL)**order
    assert errors[1] < 1.15*errors[0]/2**order


def test_surface_follows_a_field_that_is_solved(tmp_path):
    """T diffuses, by OpenFOAM's scalarTransport: cos(k x) falls as exp(-D k^2 t), and with it sigma - s0. Euler's steps
    say (1 + D k^2 dt)^-n, and the lines are of T before the last of them; k of differences is 2/h sin(k h/2)."""
    D, steps = 1.0, 20
    case = layers(tmp_path, steps=steps)
    case.control['functions'] = {'heat': {'type': 'scalarTransport', 'libs': '(solverFunctionObjects)', 'field': 'T',
                                          'D': D, 'schemesField': 'T', 'resetOnStartUp': False}}
    case.mesh()
    found = bounds(solve(case))
    assert len(found) == steps
    h, dt = HEIGHT/16, 4e-3
    fall = (1 + D*(2/h*np.sin(K*h/2))**2*dt)**-np.arange(steps)
    assert np.abs((found[:, 1] - S0)/(found[0, 1] - S0) - fall).max() < 1e-3
    assert np.abs((found[:, 0] - S0)/(found[0, 0] - S0) - fall).max() < 1e-3


# --- A drop

RADIUS, SIDE, SLOPE, GRADIENT = 1e-3, 4e-3, -1e-4, 1e4


def drop(path, cells, T, shapes=None, steps=1, **keywords):
    """A drop in a box, one cell thick or not, with a temperature by its cells."""
    thick = SIDE if cells[1] > 1 else SIDE/cells[0]
    case = Alone(path, **{
        'level': 0, 'upper': (SIDE, thick, SIDE), 'cells': cells, 'rho': (1000.0, 1000.0), 'mu': (0.1, 0.1),
        'gravity': (0, 0, 0), 'deltaT': 1e-4, 'endTime': steps*1e-4, 'writeInterval': steps, 'writeFormat': 'ascii',
        'writePrecision': 16, 'tolerance': 1e-10, **keywords})
    case.shapes = shapes or {'drop': {'type': 'sphere', 'centre': (SIDE/2,)*3, 'radius': RADIUS}}
    case.fields['T'] = T
    case.surface['surfaceTension'] = {'sigma': {'type': 'linear', 'sigma0': 0.02, 'slope': SLOPE, 'value0': 300}}
    return case


def test_sum_of_the_pull_around_a_sphere(tmp_path):
    """d(sigma)/dT G times the integral of 1 - cos^2 over the sphere, 8 pi R^2/3, along the gradient of T, nothing across.
    The planes are inside of the sphere and the steps between them are missing: some (h/R)^2/8 of the area."""
    n = 20
    z = (np.repeat(np.arange(n), n*n) + 0.5)/n*SIDE
    case = drop(tmp_path, (n, n, n), 300 + GRADIENT*(z - SIDE/2))
    case.patches['T'] = {'zMin': {'type': 'fixedValue', 'value': f'uniform {300 - GRADIENT*SIDE/2}'},
                         'zMax': {'type': 'fixedValue', 'value': f'uniform {300 + GRADIENT*SIDE/2}'}}
    case.control['functions'] = {'pull': {'type': 'writeObjects', 'libs': '(utilityFunctionObjects)',
                                          'objects': '(surfaceTensionPull)', 'writeOption': 'anyWrite'}}
    case.mesh()
    solve(case)
    total = case.field('surfaceTensionPull', '0.0001').sum(axis=0)*(SIDE/n)**3
    expected = SLOPE*GRADIENT*8/3*np.pi*RADIUS**2
    assert abs(total[2]/expected - 1) < (SIDE/n/RADIUS)**2/8
    assert np.abs(total[:2]).max() < 1e-3*abs(expected)


def plane_drop(path, mirrored=False, **keywords):
    """A disc in a periodic box, its surface aslant where ranks meet, with a temperature that is not even."""
    n = 20
    x, z = [v.ravel()/n for v in np.meshgrid(np.arange(n) + 0.5, np.arange(n) + 0.5)]
    x, at = (1 - x, SIDE - 1.33e-3) if mirrored else (x, 1.33e-3)
    T = 300 + 20*np.cos(2*np.pi*x) + 7*np.sin(4*np.pi*x) + 5*np.cos(2*np.pi*z)*np.sin(2*np.pi*x)
    return drop(path, (n, 1, n), T, steps=20, cyclic='xyz', shapes={'drop': {
        'type': 'cylinder', 'centre': (at, 0, 1.9e-3), 'axis': (0, 1, 0), 'radius': RADIUS}}, **keywords)


@pytest.fixture(scope='module')
def whole(tmp_path_factory):
    case = plane_drop(tmp_path_factory.mktemp('whole'))
    case.mesh()
    solve(case)
    return case


def test_two_ranks_do_as_one(whole, tmp_path):
    """To 1e-6 of the fastest flow: solvers end at 1e-10 of their residuals, 20 steps of them."""
    case = plane_drop(tmp_path)
    case.mesh()
    case.decompose(2)
    solve(case, ranks=2)
    U = whole.field('U', '0.002')
    fastest = np.abs(U).max()
    assert fastest > 1e-5
    assert np.abs(case.joined_field('U', '0.002', 2) - U).max() < 1e-6*fastest
    sigma = whole.field('sigma', '0.002')
    assert np.abs(case.joined_field('sigma', '0.002', 2) - sigma).max() < 1e-8*sigma.max()


def test_restart_goes_on(whole, tmp_path):
    """Ten steps, a restart, ten more; to 1e-6 as with two ranks."""
    case = plane_drop(tmp_path)
    case.control.update(endTime=1e-3, writeInterval=10)
    case.mesh()
    solve(case)
    case.control['endTime'] = 2e-3
    case.write_dict('system/controlDict', case.control)
    solve(case)
    U = whole.field('U', '0.002')
    assert np.abs(case.field('U', '0.002') - U).max() < 1e-6*np.abs(U).max()


def test_mirrored_drop_flows_mirrored(whole, tmp_path):
    """The same to what solvers leave: sums go the other way."""
    case = plane_drop(tmp_path, mirrored=True)
    case.mesh()
    solve(case)
    U, W = (c.field('U', '0.002').reshape(20, 20, 3) for c in (whole, case))
    assert np.abs(W[:, ::-1]*(-1, 1, 1) - U).max() < 1e-6*np.abs(U).max()


# --- Laws

LAWS = {
    'linear': (305.0, {'sigma0': 0.0728, 'value0': 293, 'slope': -1.5e-4}, 0.0728 - 1.5e-4*12),
    'function': (310.0, {'sigma': 'table ((273.15 0.0756) (323.15 0.0679))'}, 0.0756 - 0.0077*36.85/50),
    'polynomial': (310.0, {'type': 'function', 'sigma': 'polynomial ((0.1 0) (-1e-7 2))'}, 0.1 - 1e-7*310**2),
    'Szyszkowski': (12.0, {'field': 'T', 'sigma0': 0.0728, 'T': 293, 'Gamma': 3e-6, 'K': 0.5},
                    0.0728 - 8.314462618*293*3e-6*np.log(7.0))}


@pytest.mark.parametrize('law', LAWS)
def test_values_of_laws(tmp_path, law):
    """By the formulas written here; the lines have 12 digits."""
    value, entries, expected = LAWS[law]
    case = layers(tmp_path, steps=1)
    case.fields['T'] = repr(value)
    case.surface['surfaceTension'] = {'sigma': {'type': law, **entries}}
    case.mesh()
    assert np.abs(bounds(solve(case))/expected - 1).max() < 1e-10


def test_a_constant_is_the_number(tmp_path):
    """As a number, or of the type constant: the same to the last bit."""
    found = []
    for k, sigma in enumerate((0.02, {'type': 'constant', 'sigma': 0.02})):
        case = plane_drop(tmp_path/str(k))
        case.surface['surfaceTension'] = {'sigma': sigma}
        case.mesh()
        assert not len(bounds(solve(case)))
        found.append(case.field('U', '0.002'))
    assert np.array_equal(*found) and np.abs(found[0]).max() > 0


def test_particles_and_contact_angles_see_the_local_tension(tmp_path):
    """With T the same everywhere a law is a number: a sphere held by the surface, and an angle that depends on Ca, do as with
    this number, but for round-off over 20 steps."""
    found = []
    for k, sigma in enumerate((0.06, {'type': 'linear', 'sigma0': 0.072, 'value0': 300, 'slope': -1.2e-3})):
        case = TwoFluidCase(tmp_path/str(k), **{
            'level': 5e-3, 'upper': (8e-3, 8e-3, 9e-3), 'cells': (4, 4, 6), 'deltaT': 2e-4, 'endTime': 4e-3,
            'writeInterval': 20, 'writeFormat': 'ascii', 'writePrecision': 16, 'tolerance': 1e-12})
        case.properties = {
            'engine': 'liggghts', 'timeStep': {'deltaT': 5e-5}, 'output': ('csv',),
            'materials': {'glass': {'youngsModulus': 1e6, 'poissonsRatio': 0.3, 'density': 2500}},
            'contacts': {'default': {'restitution': 0.8, 'friction': 0.4}},
            'insertion': {'spheres': {'type': 'file', 'file': '"constant/particles.csv"', 'material': 'glass'}},
            'coupling': case.coupling('DiFelice')}
        case.properties['coupling']['forces']['capillarity'] = {'type': 'capillaryForce', 'contactAngle': 80}
        case.particles({'x': [3.1e-3], 'y': 4.9e-3, 'z': 5.1e-3, 'd': 1e-3})
        case.fields['T'] = '310'
        case.surface['surfaceTension'] = {'sigma': sigma}
        case.surface['contactAngles'] = {'xMin': {'type': 'Kistler', 'thetaA': 80, 'thetaR': 60}}
        case.mesh()
        solve(case)
        found.append((case.table(4e-3)['vz'][0], case.field('U', '0.004')))
    (one, U), (other, W) = found
    assert abs(one) > 1e-4 and abs(other/one - 1) < 1e-6
    assert np.abs(U - W).max() < 1e-6*np.abs(U).max()


LINEAR = {'type': 'linear', 'sigma0': S0, 'slope': S1}
TABLE = {'type': 'function', 'sigma': 'table ((-0.5 0.07) (0.5 0.06))'}
WRONG = {
    'no field': ({**LINEAR, 'field': 'c'}, ['the field c', "by 'field'"]),
    'not positive': ({**LINEAR, 'sigma0': 0.05}, ['Surface tension -', 'where T is -', 'greater than zero']),
    'out of the table': (TABLE, ['T on the surface is ', 'from -0.5 to 0.5', 'Extend sigma']),
    'no such law': ({**LINEAR, 'type': 'quadratic'}, ['surface tension law', 'quadratic', 'Szyszkowski']),
    'unknown entry': ({**LINEAR, 'T0': 293}, ['T0']),
    'dimensions': ({**LINEAR, 'slope': '[1 0 -2 0 0 0 0] -1e-4'}, ['slope', '[1 0 -2 -1 0 0 0]']),
    'negative': (-0.07, ['sigma', 'zero or greater'])}


@pytest.mark.parametrize('mistake', WRONG)
def test_wrong_input_is_told(tmp_path, mistake):
    sigma, words = WRONG[mistake]
    case = layers(tmp_path, steps=1)
    case.surface['surfaceTension'] = {'sigma': sigma}
    case.mesh()
    result = case.run('interDemFoam', timeout=100)
    assert result.code != 0
    for word in words:
        assert word in result.output, result.output[-2000:]
