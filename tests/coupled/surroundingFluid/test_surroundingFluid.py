"""The given fluid of demFoam: terminal velocity, diffusion, a moving surface of the liquid, and what it refuses.

Expected values are closed forms, written beside each test.
"""
import numpy as np
import pytest

from dewCase import Case, changed, quoted

R, RHO, MU, WATER, T = 5e-7, 2000.0, 8.9e-4, 997.0, 298.15
D = 2 * R
KT = 1.380649e-23 * T
VOLUME = 4 / 3 * np.pi * R**3
MASS = RHO * VOLUME
SP = 6 * np.pi * MU * R
TAU = MASS / SP
OVERDAMPED = {'type': 'overdamped', 'viscosity': MU, 'seed': 7}
BOTH = pytest.mark.parametrize('dynamics', [{'seed': 7}, OVERDAMPED], ids=['inertial', 'overdamped'])
HOT = {'Brownian': True, 'temperature': T}


def colloids(path, positions, dt, n_sub, n_steps, dynamics, box=200*D, gravity=(0, 0, 0), fluid=None, **control):
    """Particles in water, sub-step dt, n_steps time steps of n_sub sub-steps."""
    case = Case(path, upper=(box,) * 3, cells=(2, 2, 2), gravity=gravity, deltaT=dt * n_sub,
                endTime=dt * n_sub * n_steps, **{'writeInterval': 1, 'timePrecision': 12, **control})
    case.properties = {
        'engine': 'liggghts', 'timeStep': {'deltaT': dt}, 'output': ('csv',), 'dynamics': dynamics,
        'materials': {'soft': {'youngsModulus': 1e3, 'poissonsRatio': 0.3, 'density': RHO}},
        'contacts': {'default': {'restitution': 0.5, 'friction': 0.4}},
        'insertion': {'some': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'soft'}},
        'fluid': {'viscosity': MU, 'density': WATER, **(fluid or {})}}
    x = np.atleast_2d(positions)
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': D})
    case.mesh()
    return case


def run(case, ranks=1):
    if ranks > 1:
        case.decompose(ranks)
    done = case.run('demFoam', ranks=ranks, timeout=120)
    assert done.code == 0, done.output


def vectors(rows, names='x y z'):
    return np.stack([rows[n] for n in names.split()], axis=1)


def lattice(n, spacing):
    return spacing * (np.array(list(np.ndindex(n, n, n))) + 0.5)


@BOTH
def test_terminal_velocity_of_a_settling_colloid(tmp_path, dynamics):
    """v = U + 2/9 (rho_p - rho) g R^2/mu, 1e-6, after 30 relaxation times; the table has 9 digits or more."""
    U = np.array([2e-6, 0, 0])
    case = colloids(tmp_path, (100*D,) * 3, 0.5 * TAU, 60, 2, dynamics, gravity=(0, 0, -9.81),
                    fluid={'velocity': tuple(U)})
    run(case)
    v = U + np.array([0, 0, -2 / 9 * (RHO - WATER) * 9.81 * R**2 / MU])
    found = vectors(case.table(60 * TAU), 'vx vy vz')[0]
    assert np.abs(found - v).max() < 1e-6 * np.linalg.norm(v)


@BOTH
def test_temperature_along_a_line(tmp_path, dynamics):
    """<dx^2> of 500 particles each at both ends, 3 axes, 10 steps: 2 kB T(x) t/Sp; 15000 samples have a standard error
    of 1.2 %, bound 4 %. Steps are long against the relaxation (2 %), which the formula has."""
    x = lattice(10, 19 * D)
    dt, steps = 50 * TAU, 10
    middle, slope = 100 * D, 100.0 / (200 * D)
    case = colloids(tmp_path, x, dt, 1, steps, dynamics, fluid={
        'Brownian': True, 'temperature': {'value': T, 'gradient': (slope, 0, 0), 'origin': (middle, 0, 0)}})
    # Soft: its sub-step may be that long
    case.properties['materials']['soft']['youngsModulus'] = 1.0
    case.write()
    run(case)
    rows = [vectors(case.table(k * dt)) for k in range(1, steps + 1)]
    dx = np.diff(rows, axis=0)
    late = TAU * np.expm1(-dt / TAU) if dynamics is not OVERDAMPED else 0
    for low, high in ((0, 500), (500, 1000)):
        mean = T + slope * (x[low:high, 0].mean() - middle)
        expected = 2 * 1.380649e-23 * mean / SP * (dt + late)
        assert abs((dx[:, low:high]**2).mean() / expected - 1) < 0.04


@pytest.mark.parametrize('shape', ['plane', 'sphere'])
@BOTH
def test_receding_surface_takes_particles_along(tmp_path, dynamics, shape):
    """A surface that recedes at W: k delta = Sp W at rest, to 1e-5 R (position of a table of 9 digits or more)."""
    dt, n = 2 * TAU, 200
    k = 0.2 * SP / dt
    W = 0.2 * R * k / SP
    middle, big = np.array([100*D] * 3), 40 * D
    normal = np.array([0.6, 0, 0.8])
    surface = {'type': shape, 'speed': -W, 'stiffness': k, **(
        {'point': tuple(middle + big * normal), 'normal': tuple(3 * normal)} if shape == 'plane'
        else {'centre': tuple(middle), 'radius': big})}
    case = colloids(tmp_path, middle + (big - 0.1*R) * normal, dt, n, 3, dynamics, fluid={'surface': surface})
    run(case)
    t = 3 * n * dt
    found = vectors(case.table(t))[0]
    assert np.abs(found - middle - (big - W*t + 0.2*R) * normal).max() < 1e-5 * R


@BOTH
def test_capillary_surface_holds_at_the_contact_angle(tmp_path, dynamics):
    """Without other forces at rest with cos(theta) = -delta/R, to 1e-4 R."""
    dt = 2 * TAU
    sigma = 0.05 * SP / dt
    case = colloids(tmp_path, (100*D, 100*D, 100*D - 0.9*R), dt, 1000, 1, dynamics, fluid={'surface': {
        'type': 'plane', 'point': (0, 0, 100*D), 'normal': (0, 0, 1), 'surfaceTension': sigma, 'contactAngle': 60}})
    run(case)
    assert abs(case.table(1000 * dt)['z'][0] - 100*D + 0.5*R) < 1e-4 * R


@pytest.mark.parametrize('shape', ['plane', 'sphere'])
@pytest.mark.parametrize('pull, share', [('plane', 1), ('contactLine', 2/3)])
@BOTH
def test_work_of_detachment(tmp_path, dynamics, pull, share, shape):
    """The force of the surface in the engine at 801 depths, from the velocity after a sub-step of 1e-3 of the time in which
    the surface relaxes a particle, and its work from rest into the liquid (theta <= 90) or out of it: pi R^2 sigma
    (1 - |cos(theta)|)^2, P. Pieranski, Phys. Rev. Lett. 45 (1980) 569; with the tension at the contact line 2/3 of it. The
    relaxation takes 1e-3 of the force, 801 depths leave 0.1 %."""
    sigma, n = 0.072, 801
    k = 2 * np.pi * sigma
    dt = 1e-3 * SP / k if dynamics is OVERDAMPED else 1e-3 * np.sqrt(MASS / k)
    z = (1 - 1e-6) * np.linspace(-1, 1, n) * R
    big, middle = 1e4 * D, 100*D
    x = np.stack([middle + 4*D * (np.arange(n) % 29 - 14), middle + 4*D * (np.arange(n) // 29 - 14), middle + z], axis=1)
    if shape == 'sphere':
        x[:, 2] += np.sqrt(big**2 - (x[:, 0] - middle)**2 - (x[:, 1] - middle)**2) - big
    for theta in (40, 90, 125):
        case = colloids(tmp_path / str(theta), x, dt, 1, 1, dynamics, fluid={'surface': {
            'type': shape, 'surfaceTension': sigma, 'contactAngle': theta, 'pull': pull,
            **({'point': (0, 0, middle), 'normal': (0, 0, 1)} if shape == 'plane'
               else {'centre': (middle, middle, middle - big), 'radius': big})}})
        run(case)
        v = case.table(dt)['vz']
        cosine = np.cos(np.deg2rad(theta))
        force = v * (SP if dynamics is OVERDAMPED else MASS / dt)
        way = z <= -R * cosine if theta <= 90 else z >= -R * cosine
        work = abs(np.sum(0.5 * (force[way][1:] + force[way][:-1]) * np.diff(z[way])))
        lost = 1 - abs(cosine)
        assert abs(work / (share * np.pi * R**2 * sigma * lost**2) - 1) < 0.02, (theta, work)


def crowd(path, dynamics, **control):
    rng = np.random.default_rng(5)
    x = 0.5*D + 1.3*D * (lattice(5, 1.0)) + rng.uniform(-0.1, 0.1, (125, 3)) * D
    dt = 2e-6 if dynamics is OVERDAMPED else 2e-7
    return colloids(path, x, dt, 10, 40, dynamics, box=8*D, gravity=(0, 0, -9.81), fluid={
        'velocity': (2e-4, 0, 0), **HOT, 'surface': {
            'type': 'sphere', 'centre': (4*D, 4*D, 4*D), 'radius': 5*D, 'speed': -1.3*D / (400*dt), 'stiffness': 1e-5}}, **control)


@BOTH
def test_ranks_and_restart(tmp_path, dynamics):
    """Two ranks, and a run cut in the middle, are as one that is not, to 1e-9 diameters (a few collisions)."""
    whole = crowd(tmp_path / 'whole', dynamics)
    run(whole)
    end = whole.control['endTime']
    expected = vectors(whole.table(end))
    assert len(expected) > 100

    two = crowd(tmp_path / 'two', dynamics)
    run(two, 2)
    assert np.abs(vectors(two.table(end)) - expected).max() < 1e-9 * D

    cut = crowd(tmp_path / 'cut', dynamics)
    cut.control['endTime'] = end / 2
    cut.write()
    run(cut)
    cut.control['endTime'] = end
    cut.write()
    run(cut)
    assert np.abs(vectors(cut.table(end)) - expected).max() < 1e-9 * D


PLANE = {'type': 'plane', 'point': (0, 0, 100*D), 'normal': (0, 0, 1), 'stiffness': 1e-5}
REFUSED = {
    'viscosity zero': ({'fluid/viscosity': 0}, ("'viscosity'", 'greater than zero')),
    'viscosity missing': ({'fluid/viscosity': None}, ("'viscosity'", 'fluid')),
    'density missing': ({'fluid/density': None}, ("'density'", 'fluid')),
    'temperature missing': ({'fluid/Brownian': True}, ("'temperature'", 'fluid')),
    'temperature zero': ({'fluid/Brownian': True, 'fluid/temperature': 0}, ("'temperature'", 'greater than zero')),
    'temperature negative there': (
        {'fluid/Brownian': True, 'fluid/temperature': {'value': 1.0, 'gradient': (0, 0, -1e6), 'origin': (0, 0, 0)}},
        ('Temperature', 'particle 1', 'gradient')),
    'outside the liquid': ({'fluid/surface': {**PLANE, 'point': (0, 0, 99*D)}}, ('Particle 1 ', 'outside the liquid')),
    'outside a floating surface': (
        {'fluid/surface': {'type': 'plane', 'point': (0, 0, 99*D), 'normal': (0, 0, 1), 'surfaceTension': 1e-5,
                           'contactAngle': 60}}, ('Particle 1 ', 'outside the liquid')),
    'no force of the surface': ({'fluid/surface': changed(PLANE, {'stiffness': None})}, ('surfaceTension', 'none')),
    'two forces of the surface': ({'fluid/surface': {**PLANE, 'surfaceTension': 0.07}}, ('stiffness', 'both')),
    'pull of a skin': ({'fluid/surface': {**PLANE, 'pull': 'plane'}}, ("'pull'", 'no use')),
    'pull unknown': (
        {'fluid/surface': {**changed(PLANE, {'stiffness': None}), 'surfaceTension': 0.07, 'contactAngle': 60,
                           'pull': 'Pieranski'}}, ('Pieranski', 'contactLine', 'plane')),
    'angle of a skin': ({'fluid/surface': {**PLANE, 'contactAngle': 60}}, ('contactAngle', 'no use')),
    'radius of a plane': ({'fluid/surface': {**PLANE, 'radius': 1}}, ("'radius'", 'normal')),
    'shape unknown': ({'fluid/surface': {**PLANE, 'type': 'cube'}}, ('cube', 'plane', 'sphere')),
    'sphere shrinks away': (
        {'fluid/surface': {'type': 'sphere', 'centre': (100*D,) * 3, 'radius': 2*D, 'speed': -1e9, 'stiffness': 1e-5}},
        ('shrunk to nothing', 'End the run before')),
    'entry unknown': ({'fluid/mu': 1}, ("'mu'", 'viscosity')),
    'shaken': ({'frameAcceleration': 'constant (0 0 1)'}, ('frameAcceleration', 'exclude')),
}


@pytest.mark.parametrize('what', REFUSED)
def test_refused(tmp_path, what):
    changes, words = REFUSED[what]
    case = colloids(tmp_path, (100*D,) * 3, TAU, 2, 3, {}, gravity=(0, 0, -9.81))
    case.properties = changed(case.properties, changes)
    case.write()
    case.refuses(words, 'demFoam')


# --- Beside a wall

def Brenner(gap):
    """Mobility along the normal relative to Stokes' (Brenner 1961, equation 2.19), gap over radius."""
    a = np.arccosh(1 + gap)
    n = np.arange(1, int(40 / a) + 5)
    x = 2 * n + 1
    terms = n * (n + 1) / ((2*n - 1) * (2*n + 3)) * (
        (2 * np.sinh(x * a) + x * np.sinh(2 * a)) / (4 * np.sinh(x * a / 2)**2 - (x * np.sinh(a))**2) - 1)
    return 1 / (4 / 3 * np.sinh(a) * terms.sum())


def beside(path, gap, dt, steps, n=40, spacing=6, dynamics=OVERDAMPED, **fluid):
    """n^2 particles over a floor, at a gap over R."""
    x = np.insert(spacing * D * (np.array(list(np.ndindex(n, n))) + 0.5), 2, R * (1 + gap), axis=1)
    case = colloids(path, x, dt, 1, steps, dynamics, box=n * spacing * D, fluid={
        'hindered': {'walls': ('floor',), 'minGap': 1e-10}, **fluid})
    case.properties['walls'] = {'floor': {'type': 'plane', 'point': (0, 0, 0), 'normal': (0, 0, 1), 'material': 'soft'}}
    case.properties['materials']['soft']['youngsModulus'] = 100.0
    case.write()
    return case


@pytest.mark.parametrize('gap', [0.2, 2.0])
@BOTH
def test_hindered_diffusion_against_brenner(tmp_path, dynamics, gap):
    """One step of many particles at one gap: <dz^2> = 2 D Mn t, within 3 %, three seeds of 6400 particles (a
    standard error of 1 %); along the wall 2 D Mp t, with Faxen's Mp at 2 R, 1 - 9/16 s + s^3/8 - 45/256 s^4 - s^5/16,
    s = R/(R + h), which is good to 1 % there. With inertia, from rest in a step of h relaxation times, the share
    1 - (3/2 - 2 exp(-h) + exp(-2h)/2)/h of it (G. E. Uhlenbeck, L. S. Ornstein, Phys. Rev. 36 (1930) 823)."""
    dt = 1e-6
    dz, dx = [], []
    for seed in (1, 2, 3):
        case = beside(tmp_path / str(seed), gap, dt, 1, n=80, spacing=2, **HOT)
        case.properties['dynamics'] = {**dynamics, 'seed': seed}
        case.write()
        run(case)
        start = np.genfromtxt(case.path / 'constant/particles.csv', delimiter=',', names=True)
        moved = vectors(case.table(dt)) - vectors(start)
        dz.append(moved[:, 2])
        dx.append(moved[:, :2])
    width = 2 * KT / SP * dt

    def share(mobility):
        h = dt / TAU / mobility
        return 1 if dynamics is OVERDAMPED else 1 - (1.5 - 2*np.exp(-h) + 0.5*np.exp(-2*h)) / h

    assert abs(np.var(dz) / (width * Brenner(gap) * share(Brenner(gap))) - 1) < 0.03
    if gap > 1:
        s = 1 / (1 + gap)
        expected = 1 - 9/16*s + s**3/8 - 45/256*s**4 - s**5/16
        assert abs(np.mean(np.square(dx)) / (width * expected * share(expected)) - 1) < 0.03


@BOTH
def test_settling_onto_a_wall(tmp_path, dynamics):
    """v = Mn F/Sp at gaps of 0.2 and 2 R, within 1 % of Brenner (the formula has 0.5 %); with inertia after ten
    relaxation times."""
    for gap in (0.2, 2.0):
        case = beside(tmp_path / str(gap), gap, 1e-7, 1, n=1, spacing=200, dynamics=dynamics)
        if dynamics is not OVERDAMPED:
            case.control.update(deltaT=12 * TAU, endTime=12 * TAU)
            case.properties['timeStep'] = {'deltaT': TAU}
        case.gravity = (0, 0, -9.81)
        case.write()
        run(case)
        v = -VOLUME * (RHO - WATER) * 9.81 / SP * Brenner(gap)
        assert abs(case.table(case.control['endTime'])['vz'][0] / v - 1) < 0.01


@pytest.mark.parametrize('what, changes, words', [
    ('flow', {'fluid/velocity': (1e-3, 0, 0)}, ('hindered', 'at rest')),
    ('patch', {'walls/floor': {'type': 'patch', 'patches': ('zMin',), 'material': 'soft'}}, ('floor', 'plane')),
    ('no wall', {'fluid/hindered/walls': '()'}, ("'walls'", 'empty')),
    ('gap', {'fluid/hindered/minGap': 0}, ("'minGap'", 'greater than zero'))])
def test_hindered_refused(tmp_path, what, changes, words):
    case = beside(tmp_path, 1.0, 1e-7, 1, n=1, spacing=200)
    case.properties = changed(case.properties, changes)
    case.write()
    case.refuses(words, 'demFoam')


@pytest.mark.parametrize('dynamics, density', [(OVERDAMPED, RHO), ({'seed': 7}, RHO), ({'seed': 7}, 2e5), ({'seed': 7}, 4e6)],
                         ids=['overdamped', 'inertial-long', 'inertial', 'inertial-short'])
def test_boltzmann_distribution_beside_a_wall(tmp_path, dynamics, density):
    """Weight kT over 0.2 R above a soft wall (Hertz, elastic): <h> and <h^2> stay those of exp(-U/kT), 1600 particles,
    10 times in 4 relaxation times: standard error of <h> 1 %, bound 4 %. Without the drift of the mobility's gradient
    they sink to the wall. Sub-steps of .5 to 500 relaxation times of the velocity."""
    length, n, dt, E = 0.2 * R, 40, 1e-5, 20.0
    stiff = 8 / 15 * E / (2 * (1 - 0.3**2)) * np.sqrt(R) / KT
    h = np.linspace(-0.2 * R, 20 * length, 200001)
    weight = np.exp(-h / length - stiff * np.maximum(-h, 0)**2.5)
    moments = [np.sum(weight * h**m) for m in range(3)]
    share = np.cumsum(weight) / moments[0]
    start = np.interp((np.arange(n * n) + 0.5) / n**2, share, h)
    np.random.default_rng(1).shuffle(start)
    case = beside(tmp_path, 1.0, dt, 1, n=n, spacing=6, dynamics=dynamics, **HOT)
    x = 6 * D * (np.array(list(np.ndindex(n, n))) + 0.5)
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': R + start, 'd': D})
    case.gravity = (0, 0, -KT / length / (VOLUME * (density - WATER)))
    case.control.update(deltaT=400 * dt, endTime=4000 * dt)
    case.properties['timeStep'] = {'deltaT': dt}
    case.properties['fluid']['hindered']['minGap'] = 1e-9
    case.properties['materials']['soft'].update(density=density, youngsModulus=E)
    case.properties['contacts'] = {'tangential': 'none', 'default': {'restitution': 1}}
    case.write()
    run(case)
    found = np.array([case.table(400 * dt * k)['z'] for k in range(1, 11)]) - R
    assert abs(found.mean() / (moments[1] / moments[0]) - 1) < 0.04, found.mean()
    assert abs((found**2).mean() / (moments[2] / moments[0]) - 1) < 0.08, (found**2).mean()


def test_slip_of_a_gas(tmp_path):
    """v = 2/9 rho g R^2 Cc/mu with Cc of Kn = 0.132 (C. N. Davies 1945)."""
    case = colloids(tmp_path, (100*D,) * 3, 0.5 * TAU, 60, 2, {}, gravity=(0, 0, -9.81), fluid={
        'meanFreePath': 6.6e-8, 'density': 0})
    run(case)
    Kn = 6.6e-8 / R
    Cc = 1 + Kn * (1.257 + 0.4 * np.exp(-1.1 / Kn))
    assert abs(case.table(60 * TAU)['vz'][0] / (-2 / 9 * RHO * 9.81 * R**2 * Cc / MU) - 1) < 1e-6
