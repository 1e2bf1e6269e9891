"""How each void fraction model shares particles over cells: closed forms written here, any number of ranks, 2D, cyclics.

testMap (this folder) gives the volume of particles in each cell. On boxes the shares follow from the formulas in the
models' headers, summed here over all images of a particle; on meshes with faces that are not flat the exact overlap is
compared with a count of random points. Tolerances: N numbers add up to N ulp: 1e-12 of the fullest cell.
"""
import re

import numpy as np
import pytest

from test_map import TIE, MapCase, awkward, by_index, vectors

MODELS = {
    'trilinear': {'type': 'trilinear'},
    'Gaussian': {'type': 'Gaussian', 'diameters': 1.2},
    'bigParticle': {'type': 'bigParticle', 'scale': 6},
    'exactOverlap': {'type': 'exactOverlap'},
    'divided': {'type': 'divided', 'points': 50}}
CLOSED = ['trilinear', 'Gaussian', 'bigParticle']


def weights(model, away, d, h):
    """Of cells whose centres are away from a particle, without their common factor."""
    r = np.linalg.norm(away, axis=-1)
    if model == 'trilinear':
        return np.prod(np.maximum(1 - np.abs(away) / h, 0), axis=-1)
    if model == 'Gaussian':
        s = MODELS[model]['diameters'] * d
        return np.where(r < 4 * s, np.exp(-r**2 / (2 * s**2)) - np.exp(-8.0), 0)
    width = np.cbrt(np.prod(h))
    return np.clip((max(MODELS[model]['scale'] * d / 2, np.sqrt(0.75) * width) - r) / width + 0.5, 0, 1)


def expected_solid(model, x, d, upper, n, cyclic=''):
    upper, h = np.array(upper), np.array(upper) / n
    centres = np.stack(np.meshgrid(*[(np.arange(k) + 0.5) * w for k, w in zip(n, h)], indexing='ij'), axis=-1)
    images = np.stack(np.meshgrid(*[[-1, 0, 1] if axis in cyclic else [0] for axis in 'xyz']), axis=-1).reshape(-1, 3)
    solid = np.zeros(n)
    for p, diameter in zip(x, d):
        w = sum(weights(model, centres - (p + image * upper), diameter, h) for image in images)
        if not w.any():
            w[tuple(np.ceil(p / h - TIE).astype(int) - 1)] = 1
        solid += np.pi / 6 * diameter**3 * w / w.sum()
    return solid


UPPER, CELLS = (4e-3, 3e-3, 2e-3), (8, 6, 4)


def particles():
    """Awkward places; diameters of 0.05 to 0.5 mm in cells of 0.5 mm, one in ten of them ten times smaller."""
    x, d = awkward(UPPER, CELLS, 1)
    d[::10] *= 0.1
    # Half a period is 1 mm, and the Gaussian reaches 4.8 d
    return x, np.minimum(d, 2e-4)


@pytest.fixture(scope='module')
def boxes(tmp_path_factory):
    """A box for each choice of cyclics and cut; models run in it in turn."""
    made = {}

    def box(cyclic, ranks, method):
        key = cyclic, ranks, method
        if key not in made:
            made[key] = MapCase(tmp_path_factory.mktemp('box'), upper=UPPER, cells=CELLS, cyclic=cyclic)
            made[key].mesh()
            if ranks > 1:
                made[key].decompose(ranks, method)
        return made[key]
    return box


@pytest.mark.parametrize('ranks, method', [(1, 'simple'), (2, 'simple'), (2, 'scotch'), (4, 'hierarchical'),
                                           (4, 'scotch')])
@pytest.mark.parametrize('cyclic', ['', 'x', 'xyz'])
@pytest.mark.parametrize('model', CLOSED)
def test_shares_follow_the_formula(boxes, model, cyclic, ranks, method):
    """Per cell to 1e-12 of the fullest, near walls, corners of ranks and across cyclics that the cut goes through."""
    x, d = particles()
    cells, rows, outside = boxes(cyclic, ranks, method).map(x, d, ranks, voidFraction=MODELS[model])
    assert outside == 0
    expected = expected_solid(model, x, d, UPPER, CELLS, cyclic)
    assert abs(cells['solid'].sum() / np.sum(np.pi / 6 * d**3) - 1) < 1e-12
    assert np.abs(rows['weights'] - 1).max() < 1e-13
    assert np.abs(by_index(cells, UPPER, CELLS) - expected).max() < 1e-12 * expected.max()


@pytest.mark.parametrize('model', ['exactOverlap', 'divided'])
@pytest.mark.parametrize('cyclic', ['', 'xyz'])
def test_ranks_give_the_same_shares(boxes, model, cyclic):
    """1, 2 and 4 ranks, any cut: to 1e-10 of the fullest cell; a constant is gathered exactly."""
    x, d = particles()
    serial = None
    for ranks, method in ((1, 'simple'), (2, 'simple'), (2, 'scotch'), (4, 'hierarchical'), (4, 'scotch')):
        cells, rows, _ = boxes(cyclic, ranks, method).map(x, d, ranks, voidFraction=MODELS[model])
        solid = by_index(cells, UPPER, CELLS)
        serial = solid if serial is None else serial
        assert np.abs(solid - serial).max() < 1e-10 * serial.max(), (ranks, method)
        assert abs(cells['solid'].sum() / np.sum(np.pi / 6 * d**3) - 1) < 1e-12
        assert np.abs(rows['weights'] - 1).max() < 1e-13


def test_exact_overlap_of_caps_and_corners(boxes):
    """Balls at a face, across a cyclic, at an edge and a corner: cap pi h^2 (3 R - h)/3, quarters and eighths."""
    R = 1e-4
    offset = 3e-5
    h = R - offset
    cap = np.pi * h**2 * (3 * R - h) / 3 / (4 / 3 * np.pi * R**3)
    for x, shares in (([1e-3 + offset, 1.25e-3, 0.75e-3], [cap, 1 - cap]), ([offset, 1.25e-3, 0.75e-3], [cap, 1 - cap]),
                      ([1e-3, 1e-3, 0.75e-3], [1 / 4] * 4), ([2e-3, 1.5e-3, 1e-3], [1 / 8] * 8),
                      ([0, 0, 0], [1 / 8] * 8), ([1.2e-3, 1.3e-3, 0.3e-3], [1])):
        for ranks, method in ((1, 'simple'), (4, 'hierarchical')):
            cells, _, _ = boxes('xyz', ranks, method).map(np.array([x]), 2 * R, ranks, voidFraction=MODELS['exactOverlap'])
            got = np.sort(cells['solid'][cells['solid'] > 0]) / (4 / 3 * np.pi * R**3)
            # 1e-9 of the face's size is what a tie is worth
            assert len(got) == len(shares) and np.abs(got - np.sort(shares)).max() < 1e-12, (x, ranks, got)


# --- Faces that are not flat

def distort(case, seed=3, share=0.15):
    """Move the inner points of an ascii mesh at random by up to this share of a cell."""
    path = case.path / 'constant/polyMesh/points'
    text = path.read_text()
    head, body, tail = re.split(r'(?<=\n\()\n|\n(?=\)\n)', text)[:3]
    points = np.array([line.strip('()').split() for line in body.split('\n')], float)
    upper, h = np.array(case.upper), np.array(case.upper) / case.cells
    inner = np.all((points > 1e-9) & (points < upper - 1e-9), axis=1)
    move = np.random.default_rng(seed).uniform(-share, share, points.shape) * h
    points[inner] += move[inner]
    lines = '\n'.join('({:.17g} {:.17g} {:.17g})'.format(*p) for p in points)
    path.write_text(f'{head}\n{lines}\n{tail}')


def polyhedra(path):
    """Triangles of each cell, outward, about the centre of each face as OpenFOAM has it."""
    def body(name):
        return re.search(r'\n(\d+)\s*\n\(\n(.*)\n\)', (path / 'constant/polyMesh' / name).read_text(), re.S)[2]
    points = np.array([line.strip('()').split() for line in body('points').split('\n')], float)
    faces = [points[np.array(m[1].split(), int)] for m in re.finditer(r'\d+\(([\d ]+)\)', body('faces'))]
    owner, neighbour = (np.array(body(name).split(), int) for name in ('owner', 'neighbour'))
    cells = [[] for _ in range(owner.max() + 1)]
    for i, f in enumerate(faces):
        g = np.roll(f, -1, axis=0)
        middle = f.mean(axis=0)
        area = np.linalg.norm(np.cross(g - f, middle - f), axis=1)
        centre = np.sum(area[:, None] * (f + g + middle) / 3, axis=0) / area.sum() if len(f) > 3 else middle
        triangles = np.stack([np.broadcast_to(centre, f.shape), f, g], axis=1)
        cells[owner[i]].append(triangles)
        if i < len(neighbour):
            cells[neighbour[i]].append(triangles[:, [0, 2, 1]])
    return [np.concatenate(c) for c in cells]


def test_exact_overlap_against_random_points(tmp_path):
    """Cells with warped faces: the share of 1e6 random points of a ball that lie in a cell, within 3 sigma for 12 of
    them, by the tetrahedra of a cell about its middle; the overlaps with all cells add up to the ball to 1e-12."""
    n, upper = (5, 4, 3), (5e-3, 4e-3, 3e-3)
    case = MapCase(tmp_path, upper=upper, cells=n)
    case.mesh()
    distort(case)
    rng = np.random.default_rng(8)
    x = rng.uniform(0.25, 0.75, (40, 3)) * upper
    d = rng.uniform(1e-4, 1.4e-3, 40)
    _, rows, _ = case.map(x, d, voidFraction=MODELS['exactOverlap'], overlap=True)
    assert np.abs(rows['overlap'] - 1).max() < 1e-12

    shapes = polyhedra(tmp_path)
    N, checked = 1_000_000, 0
    for i in range(4):
        cells, _, _ = case.map(x[i:i + 1], 1.2e-3, voidFraction=MODELS['exactOverlap'])
        share = cells['solid'] / (np.pi / 6 * 1.2e-3**3)
        direction = rng.normal(size=(N, 3))
        points = x[i] + 0.6e-3 * np.cbrt(rng.uniform(size=(N, 1))) * direction / np.linalg.norm(direction, axis=1)[:, None]
        for c in np.argsort(share)[-3:]:
            triangles = shapes[c]
            apex = triangles.mean(axis=(0, 1))
            inside = np.zeros(N, bool)
            for t in triangles:
                b = (points - apex) @ np.linalg.inv((t - apex))
                inside |= np.all(b >= 0, axis=1) & (b.sum(axis=1) <= 1)
            sigma = np.sqrt(share[c] * (1 - share[c]) / N)
            assert abs(inside.mean() - share[c]) < 3 * sigma, (i, c, inside.mean(), share[c])
            checked += 0.01 < share[c] < 0.99
    assert checked >= 9

    # Ranks: the same polyhedra
    serial, _, _ = case.map(x, d, voidFraction=MODELS['exactOverlap'])
    case.decompose(4, 'scotch')
    parallel, _, _ = case.map(x, d, 4, voidFraction=MODELS['exactOverlap'])
    order = [np.lexsort(np.round(vectors(c) / 1e-9).T) for c in (serial, parallel)]
    assert np.abs(serial['solid'][order[0]] - parallel['solid'][order[1]]).max() < 1e-10 * serial['solid'].max()


# --- 2D, graded, continuity

@pytest.mark.parametrize('model', MODELS)
def test_two_dimensions(tmp_path, model):
    """An empty third direction, two ranks: all of a particle is in the cells, however far it sticks out."""
    case = MapCase(tmp_path, upper=(4e-3, 3e-3, 1e-4), cells=(8, 6, 1), empty='z')
    case.mesh()
    rng = np.random.default_rng(2)
    x = rng.uniform(0.05, 0.95, (60, 3)) * (4e-3, 3e-3, 1e-4)
    solids = []
    for ranks in (1, 2):
        if ranks > 1:
            case.decompose(ranks)
        cells, rows, outside = case.map(x, 2e-4, ranks, voidFraction=MODELS[model])
        assert outside == 0
        assert abs(cells['solid'].sum() / (60 * np.pi / 6 * 2e-4**3) - 1) < 1e-12
        assert np.abs(rows['weights'] - 1).max() < 1e-13
        solids.append(by_index(cells, (4e-3, 3e-3, 1e-4), (8, 6, 1)))
    assert np.abs(solids[0] - solids[1]).max() < 1e-10 * solids[0].max()


@pytest.mark.parametrize('model', ['trilinear', 'Gaussian', 'bigParticle', 'exactOverlap'])
def test_no_jump_on_the_way(tmp_path, model):
    """A particle goes 1e-3 d through a face, the middle of a cell, and near an edge along a slant, on a graded mesh: no
    share changes by more than 2e-3, where a real ball changes by 3/2 of 1e-3; a jump would be of order one."""
    n, upper, d = (6, 5, 4), (6e-3, 5e-3, 4e-3), 4e-4
    case = MapCase(tmp_path, upper=upper, cells=n, grading=(3, 0.4, 1))
    case.mesh()
    text = (case.path / 'constant/polyMesh/points').read_text()
    points = np.array([line.strip('()').split() for line in text.split('\n') if re.fullmatch(r'\(\S+ \S+ \S+\)', line)], float)
    tx, ty = (np.unique(np.round(points[:, k], 12)) for k in (0, 1))
    for at, way in (([tx[2], ty[2] + 2e-4, 1.9e-3], [1, 0, 0]), ([(tx[2] + tx[3]) / 2, ty[2] + 2e-4, 1.9e-3], [1, 0, 0]),
                    ([tx[2], ty[3], 2e-3], [0.6, 0.5, 0.62]), ([tx[4], (ty[1] + ty[2]) / 2, 3e-3], [-0.6, 0.5, 0.62])):
        shares = [case.map((np.array(at) + side * 0.5e-3 * d * np.array(way))[None], d, voidFraction=MODELS[model])[0]
                  ['solid'] / (np.pi / 6 * d**3) for side in (-1, 1)]
        assert np.abs(shares[1] - shares[0]).max() < 2e-3, at
