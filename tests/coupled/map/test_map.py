"""Particles on the mesh: which cell holds them, how their volume is shared, what they see of the fluid.

testMap (this folder) finds the cells of a table of particles that is dealt to the ranks irrespective of the mesh.
Expected values come from the formulas written here: the cell of a point of a box by division, of any other mesh by the
half-spaces of its faces, as blockMesh wrote them; the 29 points of the void fraction model 'divided' by the radii in
its header. Tolerances: a sum of N numbers is good to about N ulp, 1e-13 for all here.
"""
import re

import numpy as np
import pytest

from dewCase import foam_dict, foam_value, quoted
from fluidCase import FluidCase

# Ranks and decompositions; scotch is part of the installation
CUTS = [(1, 'simple'), (2, 'simple'), (2, 'hierarchical'), (2, 'scotch'), (4, 'hierarchical'), (4, 'scotch')]

# The first plane side that a point on a face belongs to is the lower one, within this share of the face's size
TIE = 1e-9


class MapCase(FluidCase):
    """A box whose corners may be moved: vertices by a function, grading along the axes."""

    def __init__(self, path, grading=(1, 1, 1), move=None, **keywords):
        super().__init__(path, **{'writeFormat': 'ascii', 'writePrecision': 17, **keywords})
        self.grading, self.move = grading, move

    def write_block_mesh(self):
        super().write_block_mesh()
        path = self.path / 'system/blockMeshDict'
        text = path.read_text().replace('simpleGrading (1 1 1)', f'simpleGrading {foam_value(self.grading)}')
        if self.move is not None:
            corners = [self.move(np.array([(self.lower, self.upper)[bit][k] for k, bit in enumerate(bits)], float))
                       for bits in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
                                    (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))]
            text = re.sub(r'vertices .*;', f'vertices {foam_value(corners)};', text)
        path.write_text(text)

    def map(self, x, d, ranks=1, **entries):
        """Run testMap; cells, particles and the number outside."""
        rows = np.column_stack([x, np.broadcast_to(d, len(x))])
        self.write_file('constant/map.csv', 'x,y,z,d\n' + '\n'.join(','.join(map(repr, map(float, r))) for r in rows)
                        + '\n')
        self.write_file('constant/testProperties', foam_dict({
            'voidFraction': {'type': 'divided'},
            'coupling': {'voidFraction': {'type': 'none'}, 'momentum': 'none', 'forces': {'drag': {'type': 'Stokes'}}}, **entries}))
        done = self.run('testMap', ranks=ranks)
        assert done.code == 0, done.output
        cells, particles = (np.genfromtxt(self.path / name, delimiter=',', names=True, ndmin=1)
                            for name in ('cells.csv', 'particles.csv'))
        return cells, particles, int(re.search(r'Outside (\d+)', done.output)[1])


def vectors(rows, names='x y z'):
    return np.stack([rows[n] for n in names.split()], axis=1)


def points_of_divided():
    """Offsets of the 29 points in radii: a core, and two shells of 14 that end at 1, 15 and 29 parts of the volume."""
    directions = [np.array(n, float) for n in np.ndindex(3, 3, 3)]
    directions = [n - 1 for n in directions if np.abs(n - 1).sum() in (1, 3)]
    offsets = [np.zeros(3)]
    for a, b in ((1 / 29, 15 / 29), (15 / 29, 1.0)):
        r = 0.75 * (b**(4 / 3) - a**(4 / 3)) / (b - a)
        offsets += [r * n / np.linalg.norm(n) for n in directions]
    return np.array(offsets)


def shared_volume(x, d, upper, cells, cyclic):
    """Volume of particles in the cells of a box from the origin, cell (i, j, k) at [i, j, k]."""
    upper, cells = np.array(upper), np.array(cells)
    sums = np.zeros(cells)
    offsets = points_of_divided()
    for centre, diameter in zip(x, d):
        h = upper / cells
        index = np.ceil((centre + 0.5 * diameter * offsets) / h - TIE).astype(int) - 1
        for k, axis in enumerate('xyz'):
            if axis in cyclic:
                index[:, k] %= cells[k]
        index = index[np.all((index >= 0) & (index < cells), axis=1)]
        for i, j, k in index:
            sums[i, j, k] += np.pi / 6 * diameter**3 / len(index)
    return sums


def by_index(cells, upper, n):
    """The column solid at [i, j, k], by the centres of the cells."""
    index = np.floor(vectors(cells) / (np.array(upper) / np.array(n))).astype(int)
    result = np.full(n, np.nan)
    result[tuple(index.T)] = cells['solid']
    return result


def awkward(upper, cells, seed):
    """Random centres and those on faces, edges and corners of cells, at the middle plane, near walls and at corners of
    the box; diameters to half a cell."""
    rng = np.random.default_rng(seed)
    upper, cells = np.array(upper), np.array(cells)
    h = upper / cells
    x = rng.uniform(0.02, 0.98, (60, 3)) * upper
    d = rng.uniform(0.05, 0.5, 60) * h.min()
    inner = [rng.integers(1, cells, 3) for _ in range(24)]
    special = [np.where(np.arange(3) <= k % 3, node * h, (node + rng.uniform(0.2, 0.8, 3)) * h)
               for k, node in enumerate(inner)]
    special += [np.array([0.5, a, b]) * upper for a, b in rng.uniform(0.1, 0.9, (10, 2))]
    near = 0.03 * h
    special += [near, upper - near, np.array([near[0], upper[1] / 2, upper[2] - near[2]])]
    special += [np.array([near[0], 0.31 * upper[1], 0.77 * upper[2]]), np.array([0.3, 0.41, 1]) * upper - [0, 0, near[2]]]
    x = np.vstack([x, special])
    d = np.concatenate([d, np.full(len(special), 0.4 * h.min())])
    order = rng.permutation(len(x))
    return x[order], d[order]


# --- Shares

@pytest.mark.parametrize('ranks, method', CUTS)
@pytest.mark.parametrize('cyclic', ['', 'x', 'xyz'])
def test_volume_is_shared_by_the_formula(tmp_path, cyclic, ranks, method):
    """Conserved to 1e-13; per cell as the formula to 1e-12 of the fullest; the walk from elsewhere ends the same."""
    upper, n = (4e-3, 3e-3, 2e-3), (8, 6, 4)
    case = MapCase(tmp_path, upper=upper, cells=n, cyclic=cyclic)
    case.mesh()
    x, d = awkward(upper, n, 1)
    expected = shared_volume(x, d, upper, n, cyclic)
    total = np.sum(np.pi / 6 * d**3)
    assert abs(expected.sum() / total - 1) < 1e-13

    if ranks > 1:
        case.decompose(ranks, method)
    for before in (False, True):
        cells, particles, outside = case.map(x, d, ranks, before=before)
        assert outside == 0
        assert abs(cells['solid'].sum() / total - 1) < 1e-13
        assert np.abs(by_index(cells, upper, n) - expected).max() < 1e-12 * expected.max()
        assert np.abs(particles['weights'] - 1).max() < 1e-13


def test_centre_gives_all_to_one_cell(tmp_path):
    """particleCentre: the cell by division; a point on a face goes to the lower side, on any rank."""
    upper, n = (4e-3, 3e-3, 2e-3), (8, 6, 4)
    case = MapCase(tmp_path, upper=upper, cells=n)
    case.mesh()
    x, d = awkward(upper, n, 2)
    expected = np.zeros(n)
    for index, diameter in zip(np.ceil(x / (np.array(upper) / n) - TIE).astype(int) - 1, d):
        expected[tuple(index)] += np.pi / 6 * diameter**3
    for ranks, method in ((1, 'simple'), (4, 'scotch')):
        if ranks > 1:
            case.decompose(ranks, method)
        cells, _, outside = case.map(x, d, ranks, voidFraction={'type': 'particleCentre'})
        assert outside == 0
        assert np.abs(by_index(cells, upper, n) - expected).max() < 1e-12 * expected.max()


@pytest.mark.parametrize('ranks', [1, 2])
def test_outside_is_counted_and_gets_nothing(tmp_path, ranks):
    """Centres beyond a wall: no cell, no weights, no fluid; the volume shared is that of the others."""
    upper, n = (4e-3, 3e-3, 2e-3), (8, 6, 4)
    case = MapCase(tmp_path, upper=upper, cells=n)
    case.mesh()
    if ranks > 1:
        case.decompose(ranks)
    x = np.array([[1e-3, 1e-3, 1e-3], [5e-3, 1e-3, 1e-3], [3.3e-3, 1e-3, 1e-3], [1e-3, -1e-5, 1e-3],
                  [2e-3, 2e-3, 1.0]])
    d = np.full(5, 4e-4)
    cells, particles, outside = case.map(x, d, ranks, gather=True, centre=(0, 0, 0), U=(1, 2, 3), gradU=(0,) * 9,
                                         square=(0, 0, 0))
    assert outside == 3
    assert abs(cells['solid'].sum() / (2 * np.pi / 6 * 4e-4**3) - 1) < 1e-13
    gone = np.array([False, True, False, True, True])
    assert np.array_equal(particles['cell'] < 0, gone)
    assert np.array_equal(particles['weights'][gone], [-1, -1, -1])      # the value it came with
    assert np.array_equal(vectors(particles, 'ux uy uz'), np.where(gone[:, None], 0, [1, 2, 3]))


# --- The cell that holds a point

@pytest.mark.parametrize('h, origin', [(1e-6, 0), (1.0, 0), (1e-6, 1e-2), (1.0, 1e4)])
def test_cell_of_a_box(tmp_path, h, origin):
    """1000 random points: the cell by division, with cells of 1 um and 1 m, also 1e4 cells from the origin."""
    n = np.array([7, 5, 6])
    lower = np.full(3, float(origin))
    case = MapCase(tmp_path, lower=tuple(lower), upper=tuple(lower + n * h), cells=tuple(n))
    case.mesh()
    share = np.random.default_rng(3).uniform(0, 1, (1000, 3)) * n
    x = lower + share * h
    index = np.floor(share).astype(int)
    expected = index[:, 0] + n[0] * (index[:, 1] + n[1] * index[:, 2])
    # Coordinates have been rounded: nearer to a face than this, the cell is not known
    sure = np.all(np.abs(share - np.round(share)) > 1e-6, axis=1)
    assert sure.sum() > 990
    _, particles, outside = case.map(x, 0.1 * h)
    assert outside == 0
    assert np.array_equal(particles['cell'][sure], expected[sure])


def poly_mesh(path):
    """Planes of the faces (centre, area vector), and the faces and signs of each cell, from the ascii polyMesh."""
    def body(name):
        text = (path / 'constant/polyMesh' / name).read_text()
        return re.search(r'\n(\d+)\s*\n\(\n(.*)\n\)', text, re.S)[2]
    points = np.array([line.strip('()').split() for line in body('points').split('\n')], float)
    faces = [points[np.array(m[1].split(), int)] for m in re.finditer(r'\d+\(([\d ]+)\)', body('faces'))]
    owner, neighbour = (np.array(body(name).split(), int) for name in ('owner', 'neighbour'))
    centres = np.array([f.mean(axis=0) for f in faces])
    areas = np.array([0.5 * np.cross(f[2] - f[0], f[3] - f[1]) for f in faces])
    cells = [([], []) for _ in range(owner.max() + 1)]
    for sign, ends in ((1, owner), (-1, neighbour)):
        for face, cell in enumerate(ends):
            cells[cell][0].append(face)
            cells[cell][1].append(sign)
    return centres, areas / np.linalg.norm(areas, axis=1)[:, None], cells


def rotation():
    """A rotation that leaves no axis where it was."""
    a, b = np.radians(33), np.radians(-21)
    about_z = np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]])
    about_x = np.array([[1, 0, 0], [0, np.cos(b), -np.sin(b)], [0, np.sin(b), np.cos(b)]])
    return about_x @ about_z


SHEAR = np.array([[1, 0.4, 0.3], [0, 1, 0.2], [0, 0, 1]])
MESHES = {
    'graded': dict(grading=(8, 0.2, 3)),
    'rotated': dict(move=lambda x: rotation() @ x),
    'sheared and graded': dict(move=lambda x: SHEAR @ x, grading=(4, 1, 0.5)),
    # A frustum: planar faces, no two of a cell's sides parallel
    'tapered': dict(move=lambda x: x * [1 - 0.4 * x[2] / 2e-3, 1 - 0.4 * x[2] / 2e-3, 1])}


@pytest.mark.parametrize('kind', MESHES)
def test_cell_of_other_meshes(tmp_path, kind):
    """600 random points: the one cell on the inner side of all whose faces they lie, also by a walk from elsewhere and
    on two ranks."""
    case = MapCase(tmp_path, upper=(4e-3, 3e-3, 2e-3), cells=(7, 6, 5), **MESHES[kind])
    case.mesh()
    centres, normals, cells = poly_mesh(tmp_path)
    rng = np.random.default_rng(4)
    corners = centres[[f for c in cells for f in c[0]]]
    x = rng.uniform(corners.min(axis=0), corners.max(axis=0), (600, 3))
    height = np.einsum('pfk,fk->pf', x[:, None] - centres, normals)
    inside = np.array([np.max(height[:, c[0]] * c[1], axis=1) for c in cells]).T       # [point, cell]
    expected = np.where(inside.min(axis=1) < 0, inside.argmin(axis=1), -1)
    sure = np.abs(inside.min(axis=1)) > 1e-9 * 4e-3
    assert sure.all() and (expected >= 0).sum() > 150

    _, serial, outside = case.map(x, 1e-5)
    assert np.array_equal(serial['cell'], expected)
    assert outside == (expected < 0).sum()
    case.decompose(2, 'scotch')
    _, parallel, outside = case.map(x, 1e-5, ranks=2, before=True)
    assert outside == (expected < 0).sum()
    assert np.abs(vectors(parallel) - vectors(serial)).max() < 1e-15 * 4e-3 * 10


# --- What a particle sees of the fluid

def gathered(case, x, scale, ranks=1, **field):
    values = {'centre': (0, 0, 0), 'U': (0, 0, 0), 'gradU': (0,) * 9, 'square': (0, 0, 0), **field}
    _, particles, _ = case.map(x, 0.1 * scale, ranks, gather=True, **values)
    return vectors(particles, 'ux uy uz'), vectors(particles, 'ex ey ez')


@pytest.mark.parametrize('kind', ['box', 'graded', 'rotated', 'sheared and graded'])
@pytest.mark.parametrize('h', [1e-6, 1.0])
def test_linear_field_is_seen_exactly(tmp_path, h, kind):
    """To 1e-10 of the field's range; a constant one to 1e-15. Cells of 1 um and 1 m. In the sheared mesh, whose cells
    are not right in front of the boundary's faces, away from the boundary."""
    n, scale = np.array([6, 5, 4]), h
    grid = {'box': {}, 'graded': dict(grading=(5, 0.3, 2)), 'rotated': dict(move=lambda x: rotation() @ x),
            'sheared and graded': dict(move=lambda x: SHEAR @ x, grading=(4, 1, 0.5))}[kind]
    case = MapCase(tmp_path, upper=tuple(n * h), cells=tuple(n), **grid)
    case.mesh()
    case.decompose(2)
    share = np.random.default_rng(5).uniform(0.01, 0.99, (300, 3))
    if 'sheared' in kind:
        # The end cells are at most 0.3, 0.2 and 0.34 of the sides
        share = [0.35, 0.25, 0.35] + share * ([0.6, 0.7, 0.6] - np.array([0.35, 0.25, 0.35]))
    x = share * n * h
    if 'move' in grid:
        x = np.array([grid['move'](p) for p in x])
    gradient = np.array([0.3, -0.7, 0.2, 0.5, 0.1, -0.4, 0.9, -0.2, 0.6])

    for ranks in (1, 2):
        seen, exact = gathered(case, x, scale, ranks, U=(1, -2, 3), gradU=tuple(gradient / h))
        expected = np.array([1, -2, 3]) + x @ gradient.reshape(3, 3) / h
        assert np.abs(exact - expected).max() < 1e-13 * np.ptp(expected)
        assert np.abs(seen - expected).max() < 1e-10 * np.ptp(expected), f'{ranks} ranks'

        seen, _ = gathered(case, x, scale, ranks, U=(1, -2, 3))
        assert np.abs(seen - [1, -2, 3]).max() < 3e-15, f'{ranks} ranks'


def test_curved_field_is_seen_to_second_order(tmp_path):
    """|r|^2 at the same inner points on 8^3 and 16^3 cells: the largest error is a quarter, within a fifth of it."""
    x = np.random.default_rng(6).uniform(0.3, 0.7, (800, 3)) * 1e-3
    worst = []
    for n in (8, 16, 32):
        case = MapCase(tmp_path / str(n), upper=(1e-3,) * 3, cells=(n,) * 3)
        case.mesh()
        seen, exact = gathered(case, x, 1e-5, centre=(5e-4, 5e-4, 5e-4), square=(1e6, 0, 0))
        worst.append(np.abs(seen - exact).max())
    assert worst[0] > 1e-3
    for coarse, fine in zip(worst, worst[1:]):
        assert 3.2 < coarse / fine < 5


# --- A mesh that moves

def moving(path, **keywords):
    """The box of the tests above in cfdDemFoam: prescribed particles, at rest, in a gas; 10 steps of 1 ms."""
    upper, n = (4e-3, 3e-3, 2e-3), (8, 6, 4)
    case = MapCase(path, rho=1.2, nu=1.5e-5, upper=upper, cells=n, deltaT=1e-3, endTime=1e-2, writeInterval=1,
                   gravity=(0, 0, 0), **keywords)
    # What the mesh covers at all times
    x = np.random.default_rng(9).uniform(0.3, 0.7, (60, 3)) * upper
    d = np.full(60, 2e-4)
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': d})
    case.properties = {
        'engine': 'prescribed', 'materials': {'glass': {'youngsModulus': 1e7, 'poissonsRatio': 0.3, 'density': 2500}},
        'insertion': {'some': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'glass'}},
        'overlapTolerance': 1.9, 'output': ('csv',), 'coupling': case.coupling('Stokes')}
    case.patches['U'] = {s: {'type': 'movingWallVelocity', 'value': 'uniform (0 0 0)'}
                         for s in ('xMin', 'xMax', 'yMin', 'yMax', 'zMin', 'zMax')}
    return case, x, d, upper, n


def check_moved(case, x, d, n, ranks, box):
    """alphac by the formula in the box (lower, upper) of every time; volume conserved; small continuity errors."""
    done = case.run('cfdDemFoam', ranks=ranks)
    assert done.code == 0, done.output
    total = np.sum(np.pi / 6 * d**3)
    ledger = case.ledger()
    assert len(ledger) == 10
    assert np.abs(ledger['represented'] / total - 1).max() < 1e-12      # 1 - alphac of 1e-2 is good to 1e-14
    errors = [float(v) for v in re.findall(r'sum local = (\S+),', done.output)]
    assert len(errors) == 20 and max(errors) < 1e-8, max(errors)
    for k, time in enumerate(case.times('.' if ranks == 1 else 'processor0')):
        lower, upper = box((k + 1) * 1e-3)
        size = upper - lower
        solid = shared_volume(x - lower, d, size, n, '')
        expected = 1 - solid / np.prod(size / n)
        alphac = case.joined_field('alphac', time, ranks).reshape(n[::-1]).transpose(2, 1, 0)
        assert np.abs(alphac - expected).max() < 1e-10, time
    assert np.abs(solid - shared_volume(x, d, np.array(case.upper), n, '')).max() > 0.1 * solid.max()


@pytest.mark.parametrize('ranks', [1, 2])
def test_mesh_moves_past_particles(tmp_path, ranks):
    """A stock solid-body motion at 0.1 m/s along a slant, 1 mm in all, two cells; the gas moves along."""
    case, x, d, upper, n = moving(tmp_path)
    velocity = np.array([0.1, -0.05, 0.02])
    case.fields['U'] = foam_value(velocity)
    case.mesh()
    case.write_dict('constant/dynamicMeshDict', {
        'dynamicFvMesh': 'dynamicMotionSolverFvMesh', 'motionSolver': 'solidBody',
        'solidBodyMotionFunction': 'linearMotion', 'velocity': velocity})
    if ranks > 1:
        case.decompose(ranks)
    check_moved(case, x, d, n, ranks, lambda t: (velocity * t, np.array(upper) + velocity * t))


def test_vortices_in_a_moving_mesh(tmp_path):
    """Taylor's vortices decay by viscosity alone, in a mesh at rest as in one that passes over them at five times their
    velocity. What is left over exp(-2 nu k^2 t): Euler's step costs u k dt/2 k u t, 1 % at rest and 5 % in passing; a
    velocity of the mesh counted twice costs 12 %."""
    left = []
    for velocity in ((0, 0, 0), (0.1, 0, 0)):
        L, nu, n = 0.01, 1e-6, 12
        case = FluidCase(tmp_path / str(velocity[0]), upper=(L, L, L / n), cells=(n, n, 1), cyclic='xyz', rho=1000, nu=nu,
                         gravity=(0, 0, 0), deltaT=2e-4, endTime=0.1, writeInterval=500, writeFormat='ascii',
                         writePrecision=12)
        c = (np.arange(n) + 0.5) * 2 * np.pi / n
        y, x = np.meshgrid(c, c, indexing='ij')
        U = 0.02 * np.stack([np.sin(x) * np.cos(y), -np.cos(x) * np.sin(y), 0 * x], axis=-1).reshape(-1, 3)
        case.fields['U'] = U
        glass = {'youngsModulus': 1e7, 'poissonsRatio': 0.3, 'density': 2500}
        case.properties = {'engine': 'prescribed', 'output': (), 'materials': {'glass': glass},
                           'insertion': {'one': {'type': 'file', 'file': quoted('constant/particles.csv'),
                                                 'material': 'glass'}},
                           'coupling': case.coupling('Stokes', 'none', momentum='none')}
        case.particles({'x': 5.1e-3, 'y': 5.2e-3, 'z': 4e-4, 'd': 1e-6})
        case.mesh()
        case.write_dict('constant/dynamicMeshDict', {
            'dynamicFvMesh': 'dynamicMotionSolverFvMesh', 'motionSolver': 'solidBody',
            'solidBodyMotionFunction': 'linearMotion', 'velocity': velocity})
        done = case.run('cfdDemFoam')
        assert done.code == 0, done.output
        exact = np.exp(-2 * nu * (2 * np.pi / L)**2 * 0.1)
        left.append(np.sqrt((case.field('U', case.times()[-1])**2).mean() / (U**2).mean()) / exact)
    assert 0.98 < left[0] < 1.005 and 0.93 < left[1] < 1.005, left


def squeeze(case):
    """Move the side xMax in by 0.4 sin(50 t) mm; the gas leaves at xMin."""
    case.patches['U']['xMin'] = {'type': 'pressureInletOutletVelocity', 'value': 'uniform (0 0 0)'}
    case.patches['p'] = {'xMin': {'type': 'fixedValue', 'value': 'uniform 0'}}
    case.mesh()
    path = case.path / 'system/fvSolution'
    path.write_text(path.read_text().replace('"p.*"', '"(p.*|cellDisplacement)"'))
    case.write_dict('constant/dynamicMeshDict', {
        'dynamicFvMesh': 'dynamicMotionSolverFvMesh', 'motionSolverLibs': '("libfvMotionSolvers.so")',
        'motionSolver': 'displacementLaplacian', 'displacementLaplacianCoeffs': {'diffusivity': 'uniform'}})
    boundary = {s: {'type': 'slip'} for s in ('yMin', 'yMax', 'zMin', 'zMax')}
    boundary['xMin'] = {'type': 'fixedValue', 'value': 'uniform (0 0 0)'}
    boundary['xMax'] = {'type': 'oscillatingDisplacement', 'amplitude': (-4e-4, 0, 0), 'omega': 50,
                        'value': 'uniform (0 0 0)'}
    case.write_dict('0/pointDisplacement', {'dimensions': '[0 1 0 0 0 0 0]', 'internalField': 'uniform (0 0 0)',
                                            'boundaryField': boundary}, 'pointVectorField')


def test_mesh_is_squeezed(tmp_path):
    """A side moves in by 0.4 sin(50 t) mm, all cells become thinner by the same share; the gas leaves at the other."""
    case, x, d, upper, n = moving(tmp_path)
    squeeze(case)
    check_moved(case, x, d, n, 1,
                lambda t: (np.zeros(3), np.array(upper) - [4e-4 * np.sin(50 * t), 0, 0]))
