"""The film of liquid between a particle and the surface of the liquid: drainage, van der Waals and hydrophobic force,
and its thermal motion, in demFoam.

Expected values are closed forms, written beside each test; those of drainage follow D. Y. C. Chan, R. G. Horn,
J. Chem. Phys. 83 (1985) 5311. A table has 9 digits or more, of positions in 20 um.
"""
import numpy as np
import pytest
from scipy.integrate import quad

from dewCase import changed
from test_surroundingFluid import D, KT, MASS, MU, OVERDAMPED, R, RHO, SP, T, TAU, VOLUME, WATER, BOTH
from test_surroundingFluid import colloids, crowd, run, vectors

BOX, BOTTOM = 20*D, 5*D
DRAINED = {'surface': 'rigid', 'range': 5e-8}
K_FILM = 6 * np.pi * MU * R**2


def integral(h, r, least=0):
    """Of 1/h - 1/r, below the least thickness with that there"""
    s = max(h, least)
    return np.log(s / r) - s / r + (h - s) * (1 / s - 1 / r)


def film(path, h, dt, n_sub, n_steps, dynamics, laws, force=0.0, surface=None, density=RHO, n=1, modulus=1.0, v=None,
         least=1e-9, **control):
    """Particles at distances h before a surface below them, to which a force drives them."""
    h = np.atleast_1d(h)
    side = int(np.ceil(np.sqrt(len(h))))
    i = np.arange(len(h))
    box = max(BOX, 3*D * (side + 1))
    x = np.stack([3*D * (i % side + 1), 3*D * (i // side + 1), BOTTOM + R + h], axis=1)
    g = force / (VOLUME * (density - WATER))
    case = colloids(path, x, dt, n_sub, n_steps, dynamics, box=box, gravity=(0, 0, -g), **control)
    case.properties['fluid']['surface'] = {'type': 'plane', 'point': (0, 0, BOTTOM), 'normal': (0, 0, -1),
                                           'stiffness': 1e-9, 'film': {'minThickness': least, **laws}, **(surface or {})}
    case.properties['materials']['soft'].update(density=density, youngsModulus=modulus)
    columns = {'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': D}
    if v is not None:
        columns['vz'] = v
    case.particles(columns)
    case.mesh()
    return case


@pytest.mark.parametrize('n_sub', [4, 400])
@pytest.mark.parametrize('side, share', [('rigid', 1), ('mobile', 0.25)])
def test_drainage_by_a_constant_force(tmp_path, side, share, n_sub):
    """Sp (h0 - h) + k (G(h0) - G(h)) = F t at any sub-step, 1e-3 of h, from outside the range to below the least
    thickness, where the friction is that there."""
    t, least, h0, r = 3e-4, 2e-9, 6e-8, 5e-8
    h = 0.4 * least
    force = (SP * (h0 - h) + share * K_FILM * (integral(r, r) - integral(h, r, least))) / t
    case = film(tmp_path, h0, t / n_sub, n_sub, 1, OVERDAMPED, {'drainage': {**DRAINED, 'surface': side}}, force, least=least,
                modulus=1e-3)
    run(case)
    assert abs((case.table(t)['z'][0] - BOTTOM - R) / h - 1) < 1e-3


@pytest.mark.parametrize('density', [2000, 2e6])
def test_drainage_takes_momentum(tmp_path, density):
    """A particle that flies to the surface: m (v0 - v) = Sp (h0 - h) + k (G(h0) - G(h)) at any sub-step, here of a
    hundredth and ten times the film's relaxation, to 1e-4 of h."""
    mass = density * VOLUME
    h0, r = 4e-8, 5e-8
    v0 = 0.8 * K_FILM / mass
    for dt in (0.01 * mass / (K_FILM / h0), 10 * mass / (K_FILM / h0)):
        case = film(tmp_path / f'{dt:.3g}', h0, dt, 20, 1, {}, {'drainage': DRAINED}, v=-v0, density=density)
        case.gravity = (0, 0, 0)
        case.write()
        run(case)
        row = case.table(20 * dt)
        h, v = row['z'][0] - BOTTOM - R, -row['vz'][0]
        lost = SP * (h0 - h) + K_FILM * (integral(h0, r) - integral(h, r))
        assert h < 0.97 * h0
        assert abs(mass * (v0 - v) / lost - 1) < 1e-4


@pytest.mark.parametrize('shape', ['plane', 'sphere'])
@BOTH
def test_forces_through_the_film(tmp_path, dynamics, shape):
    """From the velocity after a short sub-step, 1e-3: van der Waals H Rb/6 (1/h^2 - 1/r^2) and hydrophobic
    K (1/h - 1/r), which stay below the least thickness and end with their ranges; 1/Rb = 1/R - kappa."""
    H, K, least, big = 1e-20, 3e-19, 1e-9, 8*D
    h = np.array([5e-10, 2e-9, 5e-9, 1.9e-8, 2.5e-8, 4e-8])
    laws = {'vanDerWaals': {'HamakerConstant': H, 'range': 2e-8}, 'hydrophobic': {'strength': K, 'range': 3e-8}}
    surface = {}
    if shape == 'sphere':
        surface = {'type': 'sphere', 'centre': (BOX/2, BOX/2, BOTTOM + big), 'radius': big, 'point': None, 'normal': None}
    dt = 1e-12
    found = []
    for one in h:
        case = film(tmp_path / f'{one}', one, dt, 1, 1, dynamics, laws, surface=surface, least=least)
        case.properties = changed(case.properties, {f'fluid/surface/{k}': v for k, v in surface.items()})
        if shape == 'sphere':
            case.particles({'x': [BOX/2], 'y': [BOX/2], 'z': [BOTTOM + R + one], 'd': D})
        case.gravity = (0, 0, 0)
        case.write()
        run(case)
        found.append(-case.table(dt)['vz'][0] * (SP if dynamics is OVERDAMPED else MASS / dt))
    Rb = R / (1 - (R / big if shape == 'sphere' else 0))
    s = np.maximum(h, least)
    expected = H * Rb / 6 * (s**-2 - 2e-8**-2) * (h < 2e-8) + K * (1/s - 1/3e-8) * (h < 3e-8)
    assert np.abs(found - expected).max() < 1e-3 * expected.max()
    inside = expected > 0
    assert np.abs(np.array(found)[inside] / expected[inside] - 1).max() < 1e-3, (found, expected)


@pytest.mark.parametrize('dt, n', [(2e-7, 20000), (1e-3, 40)], ids=['short', 'long'])
@BOTH
def test_rest_on_a_repelling_film(tmp_path, dynamics, dt, n):
    """H < 0 carries a force: |H| R/6 (1/h^2 - 1/r^2) = F, with drainage on the way, 1e-3 of h; also with sub-steps of
    twice the time in which the film relaxes."""
    H, r, force = -2e-20, 5e-8, 4e-12
    case = film(tmp_path, 3e-8, dt, n, 1, dynamics, {
        'vanDerWaals': {'HamakerConstant': H, 'range': r}, 'drainage': DRAINED}, force, modulus=1e-3)
    run(case)
    expected = (6 * force / (-H * R) + r**-2)**-0.5
    assert abs((case.table(n * dt)['z'][0] - BOTTOM - R) / expected - 1) < 1e-3


@BOTH
def test_attraction_brings_a_particle_to_its_contact_angle(tmp_path, dynamics):
    """A hydrophobic force takes a particle at rest to the surface; from touch on surface tension holds it, at rest with
    cos(theta) = -delta/R to 1e-3 R."""
    dt = 2 * TAU
    sigma = 0.05 * SP / dt
    case = film(tmp_path, 1.5e-8, dt, 40000, 1, dynamics, {
        'hydrophobic': {'strength': 3e-20, 'range': 4e-8}, 'drainage': {'surface': 'mobile', 'range': 4e-8}})
    surface = changed(case.properties['fluid']['surface'], {'stiffness': None})
    case.properties['fluid']['surface'] = {**surface, 'surfaceTension': sigma, 'contactAngle': 60}
    case.gravity = (0, 0, 0)
    case.write()
    run(case)
    assert abs(case.table(40000 * dt)['z'][0] - BOTTOM - 0.5*R) < 1e-3 * R


@pytest.mark.parametrize('dynamics, density, dt', [(OVERDAMPED, RHO, 5e-6), ({'seed': 7}, RHO, 5e-6), ({'seed': 7}, 2e5, 5e-6),
                                                   ({'seed': 7}, 5e6, 5e-6)],
                         ids=['overdamped', 'inertial-long', 'inertial', 'inertial-short'])
def test_boltzmann_distribution_in_the_film(tmp_path, dynamics, density, dt):
    """Particles that a force of kT over 10 nm drives to a surface that repels them, whose friction varies ten times
    where they are: <h> and <h^2> stay those of exp(-U/kT). Over five seeds 400 particles have a standard error of
    <h> of 2 %, <h^2> 3.5 %; 800: 1.4 and 2.5 %, bounds 4 and 7 %. Without the drift of the friction's gradient <h> falls.
    Sub-steps of .3 to 500 relaxation times of the velocity."""
    length, H, r, least = 1e-8, -1e-22, 1e-7, 1e-10
    force = KT / length

    def weight(h):
        return np.exp(-h / length + H * R / 6 / KT * (1/h + h/r**2 - 2/r))

    moments = [quad(lambda h, m=m: h**m * weight(h), least, r, limit=200)[0] for m in range(3)]
    h = np.linspace(least, r, 20001)
    share = np.cumsum(weight(h))
    start = np.interp((np.arange(800) + 0.5) / 800, share / share[-1], h)
    np.random.default_rng(1).shuffle(start)
    case = film(tmp_path, start, dt, 800, 10, dynamics, {
        'vanDerWaals': {'HamakerConstant': H, 'range': r}, 'drainage': {'surface': 'mobile', 'range': r}}, force,
        density=density, least=least, modulus=0.02)
    case.properties['fluid'].update(Brownian=True, temperature=T)
    case.write()
    run(case)
    found = np.array([case.table(800 * dt * k)['z'] for k in range(1, 11)]) - BOTTOM - R
    assert found.min() > 0
    assert abs(found.mean() / (moments[1] / moments[0]) - 1) < 0.04, found.mean()
    assert abs((found**2).mean() / (moments[2] / moments[0]) - 1) < 0.07, (found**2).mean()


@BOTH
def test_ranks_and_restart(tmp_path, dynamics):
    """Two ranks, and a run cut in the middle, are as one that is not, to 1e-9 diameters."""
    def case_of(name):
        case = crowd(tmp_path / name, dynamics)
        case.properties['fluid']['surface']['film'] = {
            'minThickness': 1e-9, 'drainage': {'surface': 'rigid', 'range': 2e-7},
            'vanDerWaals': {'HamakerConstant': 1e-20, 'range': 1e-7}}
        case.write()
        return case

    plain = crowd(tmp_path / 'plain', dynamics)
    run(plain)
    whole = case_of('whole')
    run(whole)
    end = whole.control['endTime']
    expected = vectors(whole.table(end))
    assert np.abs(vectors(plain.table(end)) - expected).max() > 1e-3 * D

    two = case_of('two')
    run(two, 2)
    assert np.abs(vectors(two.table(end)) - expected).max() < 1e-9 * D

    cut = case_of('cut')
    cut.control['endTime'] = end / 2
    cut.write()
    run(cut)
    cut.control['endTime'] = end
    cut.write()
    run(cut)
    assert np.abs(vectors(cut.table(end)) - expected).max() < 1e-9 * D


FILM = 'fluid/surface/film'
REFUSED = {
    'no law': ({FILM: {'minThickness': 1e-9}}, ('film', 'no law', 'drainage')),
    'no thickness': ({FILM + '/minThickness': 0}, ("'minThickness'", 'greater than zero')),
    'range': ({FILM + '/drainage/range': 1e-10}, ("'range'", 'minThickness', '1e-10')),
    'surface': ({FILM + '/drainage/surface': 'soft'}, ('soft', 'rigid', 'mobile')),
    'constant zero': ({FILM + '/vanDerWaals': {'HamakerConstant': 0, 'range': 1e-8}}, ("'HamakerConstant'", 'is 0')),
    'strength zero': ({FILM + '/hydrophobic': {'strength': 0, 'range': 1e-8}}, ("'strength'", 'is 0')),
    'misspelt': ({FILM + '/drain': {}}, ("'drain'", 'drainage')),
    'misspelt law': ({FILM + '/drainage/c': 1}, ("'c'", 'surface', 'range')),
    'large particle': (
        {'fluid/surface/type': 'sphere', 'fluid/surface/centre': (3*D, 3*D, BOTTOM + R), 'fluid/surface/radius': R,
         'fluid/surface/point': None, 'fluid/surface/normal': None}, ('particle 1', 'as large as', 'radius of curvature'))}


@pytest.mark.parametrize('what', REFUSED)
def test_refused(tmp_path, what):
    changes, words = REFUSED[what]
    case = film(tmp_path, 1e-8, 1e-7, 2, 1, {}, {'drainage': DRAINED})
    case.gravity = (0, 0, 0)
    case.properties = changed(case.properties, changes)
    case.write()
    case.refuses(words, 'demFoam')
