"""A wedge of fluid with particles in all of space: shares, what particles see, balances, walls, ranks and output.

The mesh is blockMesh's of 5 degrees about z, its middle plane is y = 0: a vertex at radius r is at x = r cos(theta/2).
Expected values come from the formulas written here: a ring is found by the radius alone, a field in space by its
closed form. Tolerances: sums of N numbers are good to about N ulp.
"""
import re

import numpy as np
import pytest

from dewCase import foam_dict, foam_value, quoted
from fluidCase import DIMENSIONS, FluidCase

THETA = np.radians(5)
C, S = np.cos(THETA / 2), np.sin(THETA / 2)
RING = 2 * np.pi / np.sin(THETA)

R, H = 5e-3, 8e-3
GLASS = {'youngsModulus': 5e6, 'poissonsRatio': 0.3, 'density': 2500.0}
CONTACTS = {'normal': 'Hertz', 'tangential': 'history', 'default': {'restitution': 0.7, 'friction': 0.3}}
FILE = {'some': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'glass'}}


def sphere(d):
    return np.pi / 6 * d**3


def vectors(rows, names='vx vy vz'):
    return np.stack([rows[n] for n in names.split()], axis=1)


def turned(x, phi):
    """x rotated by phi about z."""
    c, s = np.cos(phi), np.sin(phi)
    return np.stack([c * x[..., 0] - s * x[..., 1], s * x[..., 0] + c * x[..., 1], x[..., 2] + 0 * c], axis=-1)


class WedgeCase(FluidCase):
    """A cylinder (or the ring outside a hole, or a frustum) as a wedge: patches bottom, top, side, hole, front, back."""

    def __init__(self, path, cells=(5, 8), radii=(R, R), hole=0, open_ends=(), **keywords):
        super().__init__(path, **{'writeFormat': 'ascii', 'writePrecision': 17, **keywords})
        self.cells, self.radii, self.hole = cells, radii, hole
        self.patch_types = {'front': 'wedge', 'back': 'wedge', 'side': 'wall',
                            **{end: 'patch' if end in open_ends else 'wall' for end in ('bottom', 'top')}}
        self.patch_types.update({'hole': 'wall'} if hole else {'axis': 'empty'})

    def write_block_mesh(self):
        vertices, index = [], {}
        for z, radius in ((0, self.radii[0]), (H, self.radii[1])):
            for r in (self.hole, radius):
                for side in (-1, 1):
                    vertex = (r * C, side * r * S, z)
                    if vertex not in vertices:
                        vertices.append(vertex)
                    index[z > 0, r > self.hole, side] = vertices.index(vertex)
        bits = [(0, -1), (1, -1), (1, 1), (0, 1)]
        ends = [[index[top, bool(r), side] for r, side in bits] for top in (False, True)]
        a, b = ends
        faces = {'back': [a[0], a[1], b[1], b[0]], 'front': [a[3], b[3], b[2], a[2]], 'side': [a[1], a[2], b[2], b[1]],
                 'bottom': [a[0], a[3], a[2], a[1]], 'top': b}
        faces['hole' if self.hole else 'axis'] = [a[0], b[0], b[3], a[3]]
        self.write_dict('system/blockMeshDict', {
            'scale': 1, 'vertices': vertices,
            'blocks': f'(hex {foam_value(a + b)} {foam_value((self.cells[0], 1, self.cells[1]))} simpleGrading (1 1 1))',
            'boundary': '(' + foam_dict({name: {'type': kind, 'faces': f'({foam_value(faces[name])})'}
                                         for name, kind in self.patch_types.items()}) + ')'})

    def write_field(self, name, value):
        default = {'U': {'type': 'noSlip'}, 'p': {'type': 'fixedFluxPressure', 'value': 'uniform 0'}}[name]
        boundary = {patch: {'type': kind} if kind in ('wedge', 'empty') else default
                    for patch, kind in self.patch_types.items()}
        boundary.update(self.patches.get(name, {}))
        self.write_dict(f'0/{name}', {'dimensions': DIMENSIONS[name], 'internalField': f'uniform {value}',
                                      'boundaryField': boundary}, 'volVectorField' if name == 'U' else 'volScalarField')

    def decompose(self, ranks, method='r'):
        split = {'r': (ranks, 1, 1), 'z': (1, 1, ranks)}[method]
        self.write_dict('system/decomposeParDict', {
            'numberOfSubdomains': ranks, 'method': 'simple', 'simpleCoeffs': {'n': split, 'delta': 1e-3}})
        self._must('decomposePar', '-force')

    def map(self, x, d, ranks=1, void='divided', **entries):
        """Run testMap; cells, particles and the number outside."""
        rows = np.column_stack([x, np.broadcast_to(d, len(x))])
        self.write_file('constant/map.csv', 'x,y,z,d\n' + '\n'.join(','.join(map(repr, map(float, r))) for r in rows)
                        + '\n')
        self.write_file('constant/testProperties', foam_dict({
            'voidFraction': {'type': void},
            # No layers at walls among particles
            'coupling': {'voidFraction': {'type': 'none'}, 'momentum': 'none', 'forces': {'drag': {'type': 'Stokes'}}},
            **entries}))
        done = self.run('testMap', ranks=ranks)
        assert done.code == 0, done.output
        cells, particles = (np.genfromtxt(self.path / name, delimiter=',', names=True, ndmin=1)
                            for name in ('cells.csv', 'particles.csv'))
        return cells, particles, int(re.search(r'Outside (\d+)', done.output)[1])


def points_of_divided():
    """Offsets of the 29 points in radii, by the radii in divided.H."""
    directions = [np.array(n, float) - 1 for n in np.ndindex(3, 3, 3)]
    directions = [n for n in directions if np.abs(n).sum() in (1, 3)]
    offsets = [np.zeros(3)]
    for a, b in ((1 / 29, 15 / 29), (15 / 29, 1.0)):
        r = 0.75 * (b**(4 / 3) - a**(4 / 3)) / (b - a)
        offsets += [r * n / np.linalg.norm(n) for n in directions]
    return np.array(offsets)


def awkward(n=80, seed=1):
    """Random places of the cylinder; on the axis, and next to it; on faces between rings; at the rim and on it."""
    rng = np.random.default_rng(seed)
    special = [0, 0, 0, 1e-18, 1e-12, 1e-6, 5e-5, 1e-3, 2e-3, R - 2e-4, R - 1e-9, R]
    r = np.concatenate([R * np.sqrt(rng.uniform(0, 1, n)), special])
    phi = rng.uniform(0, 2 * np.pi, len(r))
    phi[-8:-2] = [0, np.pi / 2, np.pi, 1.5 * np.pi, 0.1, -0.02]
    z = rng.uniform(4e-4, H - 4e-4, len(r))
    z[n + 1] = 3e-3
    return np.stack([r * np.cos(phi), r * np.sin(phi), z], axis=1), rng.uniform(1e-5, 4e-4, len(r))


# --- The map

@pytest.mark.parametrize('ranks, cut', [(1, ''), (2, 'r'), (2, 'z')])
@pytest.mark.parametrize('void', ['divided', 'particleCentre'])
def test_volume_is_kept_and_shared_by_radius(tmp_path, void, ranks, cut):
    """The body has what the particles have to 1e-12, and every ring what the radii of the 29 points (or the centre)
    say; nothing on the axis or the rim is lost."""
    case = WedgeCase(tmp_path)
    case.mesh()
    if ranks > 1:
        case.decompose(ranks, cut)
    x, d = awkward()
    for before in (False, True):
        cells, particles, outside = case.map(x, d, ranks, void, before=before)
        assert outside == 0
        assert np.abs(particles['weights'] - 1).max() < 1e-13
        assert abs(RING * cells['V'].sum() / (np.pi * R**2 * H) - 1) < 1e-12
        assert abs(RING * cells['solid'].sum() / sphere(d).sum() - 1) < 1e-12

    # Points within 1e-9 of a face may go to either side; of others the ring is certain
    nr, nz = case.cells
    offsets = points_of_divided() if void == 'divided' else np.zeros((1, 3))
    expected, unsure = np.zeros((nr, nz)), np.zeros((nr, nz))
    for centre, diameter in zip(x, d):
        # The first of the offsets' axes is radial
        p = np.array([np.hypot(*centre[:2]), 0, centre[2]]) + 0.5 * diameter * offsets
        place = np.stack([np.hypot(p[:, 0], p[:, 1]) / R * nr, p[:, 2] / H * nz], axis=1)
        place = place[place[:, 0] <= nr * (1 + 1e-9)]
        on_face = np.any((np.abs(place - np.round(place)) < 1e-8) & (np.round(place) > 0), axis=1)
        for k, is_unsure in zip(np.minimum(place.astype(int), [nr - 1, nz - 1]), on_face):
            share = sphere(diameter) / len(place)
            if is_unsure:
                unsure[max(k[0] - 1, 0):k[0] + 2, max(k[1] - 1, 0):k[1] + 2] += share
            else:
                expected[tuple(k)] += share
    found = np.zeros((nr, nz))
    # Centroid of a ring of a wedge is beyond its middle, but inside it
    found[(cells['x'] / C / R * nr).astype(int), (cells['z'] / H * nz).astype(int)] = RING * cells['solid']
    assert np.all(found > expected - 1e-12 * expected.max())
    assert np.all(found < expected + unsure + 1e-12 * expected.max())
    assert (unsure == 0).sum() > 10


@pytest.mark.parametrize('ranks, cut', [(1, ''), (2, 'r'), (2, 'z')])
@pytest.mark.parametrize('void', ['trilinear', 'Gaussian', 'bigParticle'])
def test_smooth_models_share_in_the_middle_plane(tmp_path, void, ranks, cut):
    """Shares by the models' formulas with distances in the middle plane, at any azimuth, to 1e-12 of the fullest; with
    the cells' volumes as weights for the kernels, without for the box."""
    case = WedgeCase(tmp_path)
    case.mesh()
    if ranks > 1:
        case.decompose(ranks, cut)
    x, d = awkward()
    d = np.maximum(d, 1e-4)
    entries = {'trilinear': {}, 'Gaussian': {'width': 5e-4}, 'bigParticle': {'scale': 6}}[void]
    cells, particles, outside = case.map(x, d, ranks, voidFraction={'type': void, **entries})
    assert outside == 0
    assert np.abs(particles['weights'] - 1).max() < 1e-13

    (nr, nz), expected = case.cells, np.zeros(len(cells))
    dr, dz = R / nr, H / nz
    h = np.sqrt(dr * dz)
    for centre, diameter in zip(x, d):
        r, z = np.hypot(*centre[:2]), centre[2]
        away = np.hypot(cells['x'] - r * C, cells['z'] - z)
        if void == 'trilinear':
            i, k = (cells['x'] / C / dr).astype(int), (cells['z'] / dz).astype(int)
            w = np.maximum(1 - np.abs(r / dr - i - 0.5), 0) * np.maximum(1 - np.abs(z / dz - k - 0.5), 0)
        elif void == 'Gaussian':
            w = cells['V'] * np.maximum(np.exp(-0.5 * (away / 5e-4)**2) - np.exp(-8), 0)
        else:
            w = cells['V'] * np.clip((np.maximum(3 * diameter, np.sqrt(0.75) * h) - away) / h + 0.5, 0, 1)
        expected += sphere(diameter) * w / w.sum()
    assert np.abs(RING * cells['solid'] - expected).max() < 1e-12 * expected.max()


def test_exact_overlap_with_rings_is_refused(tmp_path):
    case = WedgeCase(tmp_path)
    case.mesh()
    case.write_file('constant/map.csv', 'x,y,z,d\n')
    case.write_file('constant/testProperties', 'voidFraction { type exactOverlap; }\n')
    done = case.run('testMap')
    assert done.code != 0 and done.output.count('FATAL') == 1
    assert all(words in done.output for words in ('testProperties', 'exactOverlap', 'wedge', 'divided')), done.output


@pytest.mark.parametrize('ranks, cut', [(1, ''), (2, 'r')])
def test_linear_fields_are_exact_in_space(tmp_path, ranks, cut):
    """u_r = a r, u_phi = b r (solid rotation), u_z = c + e z: in space (a x - b y, a y + b x, c + e z), to 1e-12 of
    the largest, wherever the particle is."""
    a, b, c, e = 30.0, -12.0, 0.2, 25.0
    case = WedgeCase(tmp_path)
    case.mesh()
    if ranks > 1:
        case.decompose(ranks, cut)
    x, d = awkward(seed=2)
    # In the mesh x is r cos(theta/2); gradU is d(x).d/dx(U)
    gradU = (a / C, b / C, 0, 0, 0, 0, 0, 0, e)
    _, particles, outside = case.map(x, d, ranks, gather=True, centre=(0, 0, 0), U=(0, 0, c), gradU=gradU,
                                     square=(0, 0, 0))
    assert outside == 0
    expected = np.stack([a * x[:, 0] - b * x[:, 1], a * x[:, 1] + b * x[:, 0], c + e * x[:, 2]], axis=1)
    found = vectors(particles, 'ux uy uz')
    assert np.abs(found - expected).max() < 1e-12 * np.abs(expected).max()


def test_shear_of_the_axial_flow_is_exact(tmp_path):
    """u_z = b r: the sides of the wedge, whose values are those of the cell, must not flatten it (sin^2(2.5 deg))."""
    case = WedgeCase(tmp_path)
    case.mesh()
    x, d = awkward(seed=3)
    _, particles, _ = case.map(x, d, gather=True, centre=(0, 0, 0), U=(0, 0, 0), gradU=(0, 0, 7.0 / C) + (0,) * 6,
                               square=(0, 0, 0))
    r = np.hypot(x[:, 0], x[:, 1])
    assert np.abs(particles['uz'] - 7 * r).max() < 1e-12 * 7 * R


def test_a_narrow_hole_is_the_axis_and_a_wide_one_is_not(tmp_path):
    """Below 1e-4 of the outer radius what is in the hole counts; in a wide one it is outside."""
    x = np.array([[0, 0, 1e-3], [1e-8, 0, 1e-3], [0, 3e-3, 1e-3]])
    for hole, n_outside in ((1e-7, 0), (1e-3, 2)):
        case = WedgeCase(tmp_path / str(hole), hole=hole)
        case.mesh()
        cells, _, outside = case.map(x, 1e-4)
        assert outside == n_outside
        assert abs(RING * cells['solid'].sum() / ((3 - n_outside) * sphere(1e-4)) - 1) < 1e-12


# --- The exchange

def cloud(path, momentum='semiImplicit', void='divided', n_steps=5, spin=0.0, ring=None, **control):
    """150 grains of 0.4 mm in a cylinder of gas, or a ring of them at the azimuths ring."""
    dt = 1e-4
    case = WedgeCase(path, rho=1.2, nu=1.5e-5, tolerance=1e-13, deltaT=dt, endTime=n_steps * dt,
                     **{'writeInterval': n_steps, **control})
    rng = np.random.default_rng(5)
    if ring is None:
        grid = (np.array(list(np.ndindex(10, 10, 12))) + 0.5 - [5, 5, 0]) * [1e-3, 1e-3, H / 12]
        grid = np.vstack([grid, [[0, 0, z] for z in (np.arange(12) + 0.5) * H / 12]])
        grid = grid[np.hypot(grid[:, 0], grid[:, 1]) < R - 4e-4]
        x = grid[rng.permutation(len(grid))[:150]]
        if not np.any(np.hypot(x[:, 0], x[:, 1]) == 0):
            x[0] = [0, 0, 0.5 * H / 12]
        v = rng.uniform(-0.3, 0.3, x.shape) + spin * np.stack([-x[:, 1], x[:, 0], 0 * x[:, 0]], axis=1)
    else:
        x = turned(np.array([2.3e-3, 0, 3.1e-3]), ring)
        v = turned(np.array([0.3, 0.1, -0.2]), ring)
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': 4e-4, 'vx': v[:, 0], 'vy': v[:, 1], 'vz': v[:, 2]})
    case.properties = {
        'engine': 'liggghts', 'materials': {'glass': GLASS}, 'contacts': CONTACTS, 'insertion': FILE,
        'walls': {'all': {'type': 'patch', 'patches': (quoted('.*'),), 'material': 'glass'}},
        'output': ('csv', 'cloud', 'vtk'),
        'coupling': case.coupling('DiFelice', void, momentum=momentum)}
    case.mesh()
    return case


def run(case, ranks=1):
    done = case.run('cfdDemFoam', ranks=ranks, timeout=120)
    assert done.code == 0, done.output
    return done


@pytest.mark.parametrize('ranks', [1, 2])
@pytest.mark.parametrize('momentum, void', [('semiImplicit', 'divided'), ('explicit', 'divided'),
                                            ('semiImplicit', 'particleCentre')])
def test_what_the_fluid_loses_particles_receive(tmp_path, momentum, void, ranks):
    """Radial, azimuthal and axial momentum of every step to 1e-12 of the sum of magnitudes; the volume to 1e-12."""
    case = cloud(tmp_path, momentum, void)
    if ranks > 1:
        case.decompose(ranks)
    done = run(case, ranks)
    assert 'momentum to particles (radial azimuthal axial)' in done.output
    header = (tmp_path / 'postProcessing/exchange/0/ledger.dat').read_text().split('\n')[0]
    assert 'received.radial received.azimuthal received.axial lost.radial' in header
    rows = case.ledger()
    assert len(rows) == 5
    received, lost = (vectors(rows, f'{k}x {k}y {k}z') for k in 'rl')
    assert np.all(np.abs(received).max(axis=0) > 1e-4 * rows['scale'].max())
    assert np.all(np.linalg.norm(received - lost, axis=1) < 1e-12 * rows['scale'])
    volume = 150 * sphere(4e-4)
    assert np.abs(rows['held'] / volume - 1).max() < 1e-12
    assert np.abs(rows['represented'] / volume - 1).max() < 1e-12


@pytest.mark.parametrize('cut', ['r', 'z'])
def test_ranks_give_the_same(tmp_path, cut):
    """Velocities of particles after 5 steps, solvers converged to 1e-13."""
    one, two = cloud(tmp_path / 'one'), cloud(tmp_path / 'two')
    two.decompose(2, cut)
    run(one)
    run(two, 2)
    a, b = one.table(5e-4), two.table(5e-4)
    assert np.array_equal(a['id'], b['id'])
    assert np.abs(vectors(a) - vectors(b)).max() < 1e-9 * np.abs(vectors(a)).max()


def test_a_ring_of_particles_stays_one(tmp_path):
    """Seven particles at odd azimuths, each the first one turned, also after 20 steps: to 1e-10 of the speed."""
    phi = np.array([0, 0.3, 1.1, 2.0, 2.9, 4.4, 5.6])
    case = cloud(tmp_path, ring=phi, n_steps=20, gravity=(0, 0, -9.81))
    run(case)
    rows = case.table(2e-3)
    v, x = vectors(rows), vectors(rows, 'x y z')
    speed = np.linalg.norm(v[0])
    assert np.abs(v - turned(v[0], phi)).max() < 1e-10 * speed
    assert np.abs(x - turned(x[0], phi)).max() < 1e-12


def test_rotating_particles_make_the_fluid_swirl(tmp_path):
    """Solid rotation, walls that slip: azimuthal momentum of the fluid after a step, of the whole ring, is what the
    particles lost: positive about z. Radial convection of so slow a fluid is below 1e-3 of it."""
    case = cloud(tmp_path, n_steps=1, spin=300.0)
    case.patches['U'] = {p: {'type': 'slip'} for p in ('bottom', 'top', 'side')}
    case.write()
    run(case)
    row = case.ledger()[0]
    time = case.times()[0]
    U, alphac = case.field('U', time), case.field('alphac', time)
    nr, nz = case.cells
    ring = np.pi * R**2 / nr**2 * (2 * np.arange(nr) + 1) * H / nz
    momentum = 1.2 * (alphac.reshape(nz, nr) * ring * U[:, 1].reshape(nz, nr)).sum()
    assert momentum > 0
    assert abs(momentum / -row['ry'] - 1) < 1e-3


def settling(case):
    """One grain of 0.1 mm in water at rest, one way."""
    case.fields = {'U': '(0 0 0)', 'p': '0'}
    case.particles({'x': 0.0, 'y': 0.0, 'z': 0.9 * H, 'd': 1e-4})
    case.properties = {'engine': 'liggghts', 'materials': {'glass': GLASS}, 'contacts': CONTACTS, 'insertion': FILE,
                       'output': ('csv',), 'coupling': case.coupling('SchillerNaumann', 'none', momentum='none')}
    case.mesh()
    run(case)
    return case.table(case.control['endTime'])


def test_settling_on_the_axis_as_in_space(tmp_path):
    """One way: the same velocity and place as in a box of fluid, to 1e-12; it stays on the axis."""
    more = dict(endTime=0.1, deltaT=1e-3, writeInterval=100)
    wedge = settling(WedgeCase(tmp_path / 'wedge', **more))
    box = settling(FluidCase(tmp_path / 'box', lower=(-R, -R, 0), upper=(R, R, H), cells=(5, 5, 8), **more))
    assert wedge['vz'][0] < -5e-3
    assert abs(wedge['vz'][0] / box['vz'][0] - 1) < 1e-12
    assert abs(wedge['z'][0] / box['z'][0] - 1) < 1e-12
    assert abs(wedge['x'][0]) < 1e-15 and abs(wedge['y'][0]) < 1e-15


# --- Walls

def inside(case, rows, radii):
    """All spheres inside the true surface, but for the overlap of contacts (2 % of the radius)."""
    r, z = np.hypot(rows['x'], rows['y']), rows['z']
    slope = (radii[1] - radii[0]) / H
    gap = (radii[0] + slope * z - r) / np.hypot(1, slope) - rows['d'] / 2
    assert gap.min() > -0.01 * rows['d'].max(), gap.min()
    assert (z - rows['d'] / 2).min() > -0.01 * rows['d'].max()
    return gap


@pytest.mark.parametrize('ranks', [1, 2])
@pytest.mark.parametrize('radii', [(R, R), (2e-3, R), (0.5e-3, 6e-3)])
def test_revolved_walls_keep_all_particles(tmp_path, radii, ranks):
    """Packed and let fall in a cylinder, and in hoppers: none leaves, some touch the wall at many azimuths."""
    case = WedgeCase(tmp_path, radii=radii, application='demFoam', endTime=0.05, deltaT=5e-4, writeInterval=100)
    case.properties = {
        'engine': 'liggghts', 'materials': {'glass': GLASS}, 'contacts': CONTACTS, 'output': ('csv',),
        'walls': {'all': {'type': 'patch', 'patches': ('bottom', 'side'), 'material': 'glass', 'segments': 60}},
        'insertion': {'bed': {'type': 'packed', 'number': 250, 'material': 'glass', 'seed': 1,
                              'diameter': {'type': 'mono', 'value': 6e-4},
                              'region': {'type': 'cylinder', 'point1': (0, 0, 0.5 * H), 'point2': (0, 0, H),
                                         'radius': 0.5 * sum(radii)}}}}
    case.mesh()
    if ranks > 1:
        case.decompose(ranks)
    done = case.run('demFoam', ranks=ranks, timeout=120)
    assert done.code == 0, done.output
    rows = case.table(0.05)
    assert len(rows) == 250
    gap = inside(case, rows, radii)
    touching = rows[gap < 1e-5 + 2 * R * (1 - np.cos(np.pi / 60))]
    quadrants = np.unique((np.arctan2(touching['y'], touching['x']) // (np.pi / 2)))
    assert len(quadrants) == 4


def test_prism_in_the_cylinder(tmp_path):
    """A grain pressed on the middle of a face of the prism of N = 8 rests at R cos(pi/8) - d/2; the header's formula.
    Contact stiffness and weight allow 1e-3 of the radius."""
    case = WedgeCase(tmp_path, application='demFoam', endTime=0.1, deltaT=1e-3, writeInterval=100,
                     gravity=tuple(9.81 * np.array([np.cos(np.pi / 8), np.sin(np.pi / 8), 0])))
    case.particles({'x': 4e-3 * np.cos(np.pi / 8), 'y': 4e-3 * np.sin(np.pi / 8), 'z': 0.5 * H, 'd': 4e-4})
    case.properties = {
        'engine': 'liggghts', 'materials': {'glass': GLASS}, 'contacts': CONTACTS, 'output': ('csv',),
        'insertion': FILE, 'walls': {'all': {'type': 'patch', 'patches': ('side',), 'material': 'glass', 'segments': 8}}}
    case.mesh()
    done = case.run('demFoam')
    assert done.code == 0, done.output
    row = case.table(0.1)
    assert abs(np.hypot(row['x'], row['y'])[0] - (R * np.cos(np.pi / 8) - 2e-4)) < 2e-7


# --- Output, check and errors

@pytest.mark.parametrize('ranks', [1, 2])
def test_cloud_in_the_wedge_and_points_in_space(tmp_path, ranks):
    """The cloud, as foamToVTK reads it after reconstructPar, is the folded table, with the true places beside it; the
    pvd series is the table itself. To 1e-9: some positions are written in single precision digits by foamToVTK."""
    case = cloud(tmp_path, n_steps=1)
    if ranks > 1:
        case.decompose(ranks)
    run(case, ranks)
    if ranks > 1:
        assert case.run('reconstructPar').code == 0
    time = case.times()[0]
    rows = case.table(1e-4)
    x = vectors(rows, 'x y z')

    def of_cloud(name):
        text = (tmp_path / time / 'lagrangian/particles' / name).read_text()
        body = re.search(r'\n\d+\s*\((.*)\n\)', text, re.S)[1]
        return np.array([re.sub('[()]', ' ', line).split() for line in body.strip().split('\n')], float)

    order = np.argsort(of_cloud('id')[:, 0])
    folded = np.stack([C * np.hypot(x[:, 0], x[:, 1]), 0 * x[:, 0], x[:, 2]], axis=1)
    assert np.abs(of_cloud('positions')[order, :3] - folded).max() < 1e-12
    assert np.abs(of_cloud('inSpace')[order] - x).max() < 1e-14
    phi = np.arctan2(x[:, 1], x[:, 0])
    off_axis = np.hypot(x[:, 0], x[:, 1]) > 1e-12
    expected = np.array([turned(v, -angle) for v, angle in zip(vectors(rows), phi)])
    assert np.abs(of_cloud('U')[order] - expected)[off_axis].max() < 1e-12
    done = case.run('foamToVTK', '-latestTime', '-ascii')
    assert done.code == 0 and 'particles' in done.output, done.output

    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
    points = []
    for path in (tmp_path / 'VTK/particles').glob(f'particles_{time}*.vtp'):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(path))
        reader.Update()
        if reader.GetOutput().GetNumberOfPoints():
            points.append(vtk_to_numpy(reader.GetOutput().GetPoints().GetData()))
    points = np.vstack(points)
    assert sorted(map(tuple, points)) == sorted(map(tuple, x))


def test_own_disturbance_is_that_of_the_ring(tmp_path):
    """One cell, in which nothing holds the fluid: it gains F t/(rho V) of the whole ring, 0.3 % of the slip, and what is
    taken off is that, so that the particle slows down as in a fluid at rest. Within a step the fluid's answer still reaches
    the particle, by the kick: a quarter of the 0.3 %, with four steps."""
    rho, nu, d, v0, dt, n = 10.0, 1e-5, 1e-3, 5e-4, 5e-3, 4
    case = WedgeCase(tmp_path, cells=(1, 1), open_ends=('bottom', 'top'), rho=rho, nu=nu, gravity=(0, 0, 0), deltaT=dt,
                     endTime=n * dt, writeInterval=n, tolerance=1e-14)
    case.particles({'x': 2e-3, 'y': 0, 'z': 4e-3, 'd': d, 'vz': v0})
    case.patches = {'U': {'side': {'type': 'slip'}, **{e: {'type': 'zeroGradient'} for e in ('bottom', 'top')}},
                    'p': {e: {'type': 'fixedValue', 'value': 'uniform 0'} for e in ('bottom', 'top')}}
    case.properties = {'engine': 'liggghts', 'materials': {'glass': GLASS}, 'contacts': CONTACTS, 'insertion': FILE,
                       'output': ('csv',), 'coupling': case.coupling(
                           'Stokes', 'none', pressure=False, model='B', seenVelocity={'own': {'type': 'undisturbed'}})}
    case.mesh()
    run(case)
    change = case.table(n * dt)['vz'][0] / v0 - 1
    expected = np.expm1(-3 * np.pi * rho * nu * d * n * dt / (2500.0 * sphere(d)))
    assert case.field('U', case.times()[-1]).max() > 1e-3 * v0
    assert abs(change / expected - 1) < 3e-3 / n


def test_dry_run_tells_of_the_wedge(tmp_path):
    """5 degrees, 2 pi/sin(5 deg) = 72.09; the innermost ring is 2 mm wide; gravity across the axis is warned of."""
    case = cloud(tmp_path, gravity=(9.81, 0, 0))
    done = case.run('cfdDemFoam', '-dry-run')
    assert done.code == 0, done.output
    assert re.search(r'Wedge mesh of 5 degrees about the axis \(0 0 1\) through \(0 0 0\): it stands for 72\.0915 times',
                     done.output), done.output
    assert re.search(r'particle diameter over that of innermost ring +0\.2 +ok', done.output), done.output
    assert re.search(r'particle diameter over cell width +0\.4 +ok', done.output), done.output
    assert re.search(r'WARNING: gravity \(9\.81\d* 0 0\) is not along the axis', done.output), done.output


@pytest.mark.parametrize('change, words', [
    ({'patches': ('front', 'side')}, ('front', 'wedge patch', 'Take it out')),
    ({'segments': 4}, ('segments', '4', 'at least 8'))])
def test_walls_refused(tmp_path, change, words):
    case = cloud(tmp_path)
    case.properties['walls']['all'].update(change)
    case.write()
    done = case.run('cfdDemFoam')
    assert done.code != 0
    assert all(w in done.output for w in words), done.output


def test_one_wedge_patch_is_refused(tmp_path):
    case = cloud(tmp_path)
    path = tmp_path / 'constant/polyMesh/boundary'
    text = path.read_text()
    path.write_text(re.sub(r'(front\s*\{\s*type\s+)wedge', r'\1patch', text))
    case.write_file('constant/map.csv', 'x,y,z,d\n')
    case.write_file('constant/testProperties', 'voidFraction { type none; }\n')
    done = case.run('testMap')
    assert done.code != 0
    assert 'The mesh has 1 wedge patches' in done.output, done.output


# --- Averages of the phase

@pytest.mark.parametrize('phi', [0.0, 1.3, 4.0])
def test_averages_are_those_of_the_ring(tmp_path, phi):
    """Two spheres at an azimuth, pressed together along the radius and moving with (0.1, 0.02, 0.3) m/s in radial,
    azimuthal and axial direction: the same fields at each; moment F r of the contact (Hertz, no damping) in the ring."""
    d, distance = 4e-4, 3.99e-4
    x = turned(np.array([[2e-3, 0, 1.5e-3], [2e-3 + distance, 0, 1.5e-3]]), phi)
    v = turned(np.array([[0.1, 0.02, 0.3]]), phi)[0]
    fields = ('alpha.particles', 'U.particles', 'granularTemperature', 'collisionalStress', 'contactNumber')
    case = WedgeCase(tmp_path, cells=(2, 2), gravity=(0, 0, 0), deltaT=1e-7, endTime=1e-7, writeInterval=1, functions={
        'phase': {'type': 'particleAverages', 'libs': '(dewFunctionObjects)', 'fields': fields,
                  'writeControl': 'writeTime'}})
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': d, 'vx': v[0], 'vy': v[1], 'vz': v[2]})
    case.properties = {
        'engine': 'liggghts', 'materials': {'glass': GLASS}, 'insertion': FILE, 'output': ('csv',),
        'contacts': {**CONTACTS, 'default': {'restitution': 1.0, 'friction': 0.3}},
        'coupling': {'voidFraction': {'type': 'particleCentre'}, 'momentum': 'none', 'forces': {}}}
    case.mesh()
    done = case.run('cfdDemFoam')
    assert done.code == 0, done.output
    text = {name: (case.path / '1e-07' / name).read_text() for name in fields}

    def first(name):
        body = re.search(r'internalField\s+nonuniform\s+List<\w+>\s*\d+\s*\(\s*\(?([^()\n]*)', text[name])[1]
        return np.array(body.split(), dtype=float)

    volume = np.pi * (R / 2)**2 * H / 2
    rows = case.table(1e-7)
    r = np.linalg.norm(np.diff(vectors(rows, 'x y z'), axis=0))
    force = 4 / 3 * GLASS['youngsModulus'] / (2 * (1 - 0.3**2)) * np.sqrt(d / 4) * (d - r)**1.5
    assert np.isclose(first('alpha.particles')[0], 2 * sphere(d) / volume, rtol=1e-10)
    assert np.allclose(first('U.particles'), [0.1, 0.02, 0.3], rtol=1e-5)
    assert np.allclose(first('collisionalStress'), [force * r / volume, 0, 0, 0, 0, 0], rtol=1e-5,
                       atol=1e-5 * force * r / volume)
    assert first('contactNumber')[0] == 1
