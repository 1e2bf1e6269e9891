"""Passive scalars that fluid and particles exchange.

Expected values are closed forms, written beside each test: of one body and of two that relax, and of a row of stirred
cells; or another run that must give the same.
"""
import re

import numpy as np
import pytest

from dewCase import changed, quoted
from fluidCase import FluidCase

GLASS = {'youngsModulus': 5e6, 'poissonsRatio': 0.3, 'density': 2500.0}
CONTACTS = {'normal': 'Hertz', 'tangential': 'history', 'default': {'restitution': 0.7, 'friction': 0.3}}
ASCII = {'writeFormat': 'ascii', 'writePrecision': 17, 'timePrecision': 12}
D = 1e-9


def scalar(**entries):
    return {'diffusivity': D, 'transfer': {'type': 'RanzMarshall'}, 'initial': 3.0, **entries}


def sphere(d):
    return np.pi / 6 * d**3


def lattice(n, spacing, jitter=0.0):
    n = np.broadcast_to(n, 3)
    x = np.array(list(np.ndindex(*n))) + 0.5
    return (x + np.random.default_rng(8).uniform(-jitter, jitter, x.shape)) * spacing


def run(case, ranks=1, end=None):
    if end:
        case.control['endTime'] = end
        case.write_dict('system/controlDict', case.control)
    done = case.run('cfdDemFoam', ranks=ranks, timeout=240)
    assert done.code == 0, done.output
    return done.output


def folder(case, time, ranks=1):
    names = case.times('.' if ranks == 1 else 'processor0')
    return next(n for n in names if np.isclose(float(n), time, rtol=1e-6))


# --- Grains that stay where they are

d, SHARE = 1e-4, 0.1
SPACING = d * (np.pi / 6 / SHARE)**(1 / 3)


def fixed(path, dt, n_steps, entries, c=1.0, U=0.0, cells=(2, 2, 2), per_cell=(2, 2, 2), **coupling):
    """Grains of 0.1 mm on a lattice in water, a tenth of the volume; periodic."""
    n = np.array(cells) * per_cell
    case = FluidCase(path, tolerance=1e-15, upper=tuple(float(v) for v in n * SPACING), cells=cells, cyclic='xyz',
                     deltaT=dt, endTime=n_steps * dt, writeInterval=1, **ASCII)
    x = lattice(n, SPACING)
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': d})
    case.fields.update(U=f'(0 0 {U!r})', salt=repr(c))
    case.properties = {
        'engine': 'prescribed', 'materials': {'glass': GLASS},
        'insertion': {'all': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'glass'}},
        'output': ('csv',),
        'coupling': {'voidFraction': {'type': 'divided'}, 'momentum': 'none', 'forces': {},
                     'scalars': {'salt': entries}, **coupling}}
    return case


@pytest.mark.parametrize('U', [0.0, 1e-2])
@pytest.mark.parametrize('step', [0.1, 10.0])
def test_particles_relax_exactly(tmp_path, step, U):
    """One way: cp = c/K + (cp0 - c/K) exp(-t/tau), tau = V/(K Sh D pi d), with Sh of Ranz and Marshall (1952) at
    Sc = nu/D = 1000; to round-off at any step. The fluid keeps its value."""
    K, c = 2.0, 1.0
    Sh = 2 + 0.6 * np.sqrt(U * d / 1e-6) * 1000**(1 / 3)
    tau = sphere(d) / (K * Sh * D * np.pi * d)
    case = fixed(tmp_path, step * tau, 3, scalar(partition=K, exchange='none'), c=c, U=U)
    case.mesh()
    run(case)
    for k in range(1, 4):
        expected = c / K + (3.0 - c / K) * np.exp(-k * step)
        assert np.abs(case.table(k * step * tau)['salt'] / expected - 1).max() < 1e-11, k
    assert np.abs(case.field('salt', folder(case, 3 * step * tau)) - c).max() < 1e-13


@pytest.mark.parametrize('smoothing', [False, True], ids=['', 'smoothed'])
def test_two_bodies_relax(tmp_path, smoothing):
    """Fluid and particles at rest: c - K cp = delta0 exp(-(1 + r) t/tau), r = V/(K Vf) with V and Vf the volumes of
    both, to 1e-3 of delta0 with steps of a tenth of tau (a fluid frozen over a step errs by r step/2 of it). Amount to
    1e-12 at every step."""
    K, c0, cp0 = 2.0, 1.0, 3.0
    tau = sphere(d) / (K * 2 * D * np.pi * d)
    r = SHARE / (K * (1 - SHARE))
    dt = 0.1 * tau
    extra = {'smoothing': {'type': 'diffusion', 'length': 2 * d}} if smoothing else {}
    case = fixed(tmp_path, dt, 20, scalar(partition=K), c=c0, **extra)
    case.mesh()
    run(case)
    ledger = case.ledger()
    Vp = 64 * sphere(d)
    Vf = Vp / SHARE * (1 - SHARE)
    whole = Vp * cp0 + Vf * c0
    for k in range(1, 21):
        difference = (c0 - K * cp0) * np.exp(-k * dt / tau * (1 + r))
        # From K cp + delta = c and the amount
        cp = (whole - Vf * difference) / (Vp + K * Vf)
        fluid = np.mean(case.field('salt', folder(case, k * dt)))
        grains = case.table(k * dt)['salt']
        assert np.abs(grains - cp).max() < 1e-3 * abs(c0 - K * cp0), k
        assert abs(fluid - (K * cp + difference)) < 1e-3 * abs(c0 - K * cp0), k
        assert abs(Vp * np.mean(grains) + Vf * fluid - whole) < 1e-12 * whole, k
    assert np.abs(ledger['salt.held'] - Vp * cp0 - np.cumsum(ledger['salt.received'])).max() < 1e-12 * whole
    assert np.all(np.abs(ledger['salt.received'] - ledger['salt.lost']) < 1e-12 * ledger['salt.scale'])


def test_equilibrium_in_one_step(tmp_path):
    """A step of 1000 tau leads to c = K cp, with cp = (V cp0 + Vf c0)/(V + K Vf)."""
    K, c0, cp0 = 0.5, 1.0, 3.0
    tau = sphere(d) / (K * 2 * D * np.pi * d)
    case = fixed(tmp_path, 1e3 * tau, 2, scalar(partition=K), c=c0)
    case.mesh()
    run(case)
    cp = (SHARE * cp0 + (1 - SHARE) * c0) / (SHARE + K * (1 - SHARE))
    for k in (1, 2):
        assert np.abs(case.table(1e3 * k * tau)['salt'] - cp).max() < 1e-12, k
        assert np.abs(case.field('salt', folder(case, 1e3 * k * tau)) - K * cp).max() < 1e-12, k


def test_bed_takes_what_flows_through(tmp_path):
    """Grains that hold nothing back (K = 0) in plug flow: a row of n stirred cells (upwind) has
    c_i = c0 (1 + NTU/n)^-i, NTU = N Sh D pi d/(u A), which goes to exp(-NTU). 2e-3 of it: axial diffusion gives
    NTU^2 D/(u L) = 3e-4 along the bed and 2 NTU/n D/(u dx) = 5e-4 at the inlet."""
    u, c0, n = 1e-3, 1.0, 16
    case = fixed(tmp_path, 0.5, 60, scalar(partition=0.0, initial=0.0), c=c0, cells=(1, 1, n),
                 per_cell=(2, 2, 2), interpolation='cell', voidFraction={'type': 'particleCentre'})
    case.cyclic = 'xy'
    case.convection = 'Gauss upwind'
    case.control['writeInterval'] = 60
    case.fields['U'] = f'(0 0 {u / (1 - SHARE)!r})'
    case.patches = {
        'U': {'zMin': {'type': 'fixedValue', 'value': f'uniform (0 0 {u!r})'}, 'zMax': {'type': 'zeroGradient'}},
        'p': {'zMax': {'type': 'fixedValue', 'value': 'uniform 0'}},
        'salt': {'zMin': {'type': 'fixedValue', 'value': f'uniform {c0!r}'}}}
    case.write()
    case.write_block_mesh()
    mesh = tmp_path / 'system/blockMeshDict'
    mesh.write_text(re.sub(r'(zM\w+\s*\{\s*type) wall', r'\1 patch', mesh.read_text()))
    assert case.run('blockMesh').code == 0
    run(case)
    Sh = 2 + 0.6 * np.sqrt(u / (1 - SHARE) * d / 1e-6) * 1000**(1 / 3)
    ntu = 8 * n * Sh * D * np.pi * d / (u * (2 * SPACING)**2)
    c = case.field('salt', folder(case, 30.0))
    assert 0.5 < ntu < 5
    assert np.abs(c / (1 + ntu / n)**-np.arange(1.0, n + 1) - 1).max() < 2e-3
    assert abs(np.log(c[-1] / c0) / ntu + 1) < 0.6 * ntu / n


# --- A cloud of grains that move

L = 4e-3


def cloud(path, n_steps=6, **coupling):
    """125 grains of 0.4 mm in (4 mm)^3 of a gas that swirls; moisture and a second scalar, not uniform."""
    dt = 1e-4
    case = FluidCase(path, rho=1.2, nu=1.5e-5, tolerance=1e-14, upper=(L,)*3, cells=(4, 4, 4), cyclic='xy',
                     outer=2, pressure_correctors=3, deltaT=dt, endTime=n_steps * dt, writeInterval=3, **ASCII)
    rng = np.random.default_rng(7)
    x = lattice(5, L / 5, 0.15)
    v = rng.uniform(-0.3, 0.3, x.shape)
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': 4e-4, 'vx': v[:, 0], 'vy': v[:, 1], 'vz': v[:, 2]})
    case.fields.update(U=rng.uniform(-1, 1, (64, 3)), moisture=rng.uniform(0, 1, 64), dye=rng.uniform(1, 2, 64))
    case.properties = {
        'engine': 'liggghts', 'materials': {'glass': GLASS}, 'contacts': CONTACTS,
        'walls': {'sides': {'type': 'patch', 'patches': ('zMin', 'zMax'), 'material': 'glass'}},
        'insertion': {'all': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'glass'}},
        'output': ('csv', 'vtk', 'cloud'),
        'coupling': case.coupling('DiFelice', scalars={
            'moisture': scalar(diffusivity=2.6e-5, partition=0.1),
            'dye': scalar(diffusivity=1e-4, transfer={'type': 'Gunn'})}, **coupling)}
    case.mesh()
    return case


def same(one, other, time, ranks=1, other_ranks=1, tolerance=1e-10):
    a, b = one.table(time), other.table(time)
    assert np.array_equal(a['id'], b['id'])
    for name in ('moisture', 'dye'):
        assert np.ptp(a[name]) > 1e-4
        assert np.abs(a[name] - b[name]).max() < tolerance, name
        f = one.joined_field(name, folder(one, time, ranks), ranks)
        g = other.joined_field(name, folder(other, time, other_ranks), other_ranks)
        assert np.abs(f - g).max() < tolerance, name


def test_amounts_close_in_a_cloud_and_restart_goes_on(tmp_path):
    """What the fluid has and the particles is constant to 1e-10 of the whole, at every write time; a run that stops
    half way gives the same as one that does not, to 1e-10 (the engine's round-off)."""
    case = cloud(tmp_path / 'one', smoothing={'type': 'diffusion', 'length': 1e-3})
    part = case.copy(tmp_path / 'part')
    run(case)
    ledger = case.ledger()
    V = (L / 4)**3
    for name in ('moisture', 'dye'):
        assert np.all(np.abs(ledger[name + '.received'] - ledger[name + '.lost']) < 1e-12 * ledger[name + '.scale'])
        whole = []
        for k in (3, 6):
            time = folder(case, k * 1e-4)
            fluid = V * np.sum(case.field('alphac', time) * case.field(name, time))
            grains = sphere(4e-4) * np.sum(case.table(k * 1e-4)[name])
            assert abs(grains / ledger[name + '.held'][k - 1] - 1) < 1e-12
            whole.append(fluid + grains)
        assert abs(ledger[name + '.received']).min() > 1e-6 * whole[0]
        assert abs(whole[1] - whole[0]) < 1e-10 * whole[0]
    run(part, end=3e-4)
    run(part, end=6e-4)
    same(case, part, 6e-4)


def test_ranks(tmp_path):
    """On two ranks as on one, to 1e-10 (solver tolerance)."""
    one = cloud(tmp_path / 'one', 3)
    two = one.copy(tmp_path / 'two')
    run(one)
    two.decompose(2)
    run(two, 2)
    same(one, two, 3e-4, 1, 2)
    # The form of the output: by the scalar's name
    name = folder(one, 3e-4)
    assert (one.path / name / 'lagrangian/particles/moisture').is_file()
    assert 'Name="dye"' in next((one.path / 'VTK/particles').glob('*.vtp')).read_text(errors='replace')


# --- Mistakes

MISTAKES = {
    'no field': ({'scalars/sugar': scalar()}, ("'sugar'", 'no field', '0/sugar')),
    'name taken': ({'scalars/U': scalar()}, ("'U'", 'name of another field')),
    'diffusivity': ({'scalars/salt/diffusivity': -1.0}, ('diffusivity', 'salt')),
    'no diffusivity': ({'scalars/salt/diffusivity': None}, ('diffusivity', 'salt')),
    'partition': ({'scalars/salt/partition': -1.0}, ('partition', 'salt')),
    'law': ({'scalars/salt/transfer/type': 'Ranz'}, ('Ranz', 'RanzMarshall', 'Gunn')),
    'unknown entry': ({'scalars/salt/inital': 1.0}, ('inital', 'initial')),
    'exchange': ({'scalars/salt/exchange': 'explicit'}, ('explicit', 'semiImplicit', 'none'))}


@pytest.mark.parametrize('name', MISTAKES)
def test_refused(tmp_path, name):
    changes, words = MISTAKES[name]
    case = fixed(tmp_path, 1e-3, 1, scalar())
    case.properties['coupling'] = changed(case.properties['coupling'], changes)
    case.mesh()
    done = case.run('cfdDemFoam', '-dry-run')
    assert done.code != 0 and done.output.count('ERROR') == 1, done.output
    assert all(word in done.output for word in words), done.output


def test_field_without_entry_is_told_of(tmp_path):
    case = fixed(tmp_path, 1e-3, 1, scalar())
    case.fields['sugar'] = '1'
    case.mesh()
    text = (tmp_path / 'system/fvSolution').read_text().replace('solvers\n{', 'solvers\n{\n    sugar { solver PBiCG; }')
    (tmp_path / 'system/fvSolution').write_text(text)
    done = case.run('cfdDemFoam', '-dry-run')
    assert done.code == 0 and 'the field sugar has a solver' in done.output, done.output
