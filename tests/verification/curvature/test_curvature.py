"""Curvature, distance and normal of balls whose shares of the cells are exact: curvatureErrors.

To beat, at 25 cells a radius (mean, largest error): reconstructed distance 0.7 %, 3.1 % in 2D, 0.6 % in 3D (H. Scheufler,
J. Roenby, J. Comput. Phys. 383 (2019) 1, and DLR's TwoPhaseFlow); height functions 0.16 %, 0.2 %. At walls, reconstructed
distance: largest errors of 9 to 76 % for 15 to 75 degrees. Limits, where not said otherwise: twice what was measured.
"""
import pathlib
import re
import sys

import numpy as np
import pytest

from dewCase import SIDES, Case

sys.path.append(str(pathlib.Path(__file__).resolve().parents[1] / 'advection'))
from meshes import square_of_triangles, write_prisms      # noqa: E402

COLUMNS = ('cells', 'average', 'largest', 'near', 'psi', 'psiLargest', 'around', 'n', 'nLargest', 'time')


class Balls(Case):
    """A mesh and some balls. kind: 2D (empty along z), 3D, wedge (radius along x, axis z)."""

    def __init__(self, path, lower, upper, cells, kind='2D', grading=(1, 1, 1), **keywords):
        super().__init__(path, lower, upper, cells, writeFormat='ascii', **keywords)
        self.kind, self.grading = kind, grading

    def write_block_mesh(self):
        """A box, or a wedge of 5 degrees."""
        if self.kind == 'wedge':
            radius, a = self.upper[0], np.radians(2.5)
            x, y = radius*np.cos(a), radius*np.sin(a)
            corners = [p for z in (self.lower[2], self.upper[2]) for p in ((0, 0, z), (x, -y, z), (x, y, z))]
            block, faces = '(0 1 2 0 3 4 5 3)', {'outer': '(1 2 5 4)', 'zMin': '(0 2 1 0)', 'zMax': '(3 4 5 3)',
                                                 'front': '(0 1 4 3)', 'back': '(0 3 5 2)'}
        else:
            corners = [[(self.lower, self.upper)[bit][k] for k, bit in enumerate(bits)]
                       for bits in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))]
            block, faces = '(0 1 2 3 4 5 6 7)', SIDES
        boundary = {name: {'type': self.type(name), 'faces': f'({face})'} for name, face in faces.items()}
        for name in boundary:
            if boundary[name]['type'] == 'cyclic':
                boundary[name]['neighbourPatch'] = name[0] + ('Max' if name.endswith('Min') else 'Min')
        n = '({} {} {})'.format(*self.cells)
        grading = '({} {} {})'.format(*self.grading)
        self.write_dict('system/blockMeshDict', {
            'scale': 1, 'vertices': corners, 'blocks': f'(hex {block} {n} simpleGrading {grading})',
            'boundary': '(' + ''.join(f'{k} {{ type {v["type"]}; '
                                      + (f'neighbourPatch {v["neighbourPatch"]}; ' if 'neighbourPatch' in v else '')
                                      + f'faces {v["faces"]}; }} ' for k, v in boundary.items()) + ')'})

    def type(self, name):
        """Of a patch."""
        if name in ('front', 'back'):
            return 'wedge'
        if self.kind == '2D' and name[0] == 'z':
            return 'empty'
        return 'cyclic' if name[0] in self.cyclic else 'wall'

    def write(self):
        """With a field of shares to begin with."""
        super().write()
        patches = ('outer', 'zMin', 'zMax', 'front', 'back') if self.kind == 'wedge' else (*SIDES, 'sides')
        kinds = {p: self.type(p) for p in patches}
        self.write_dict('0/alpha.water', {
            'dimensions': '[0 0 0 0 0 0 0]', 'internalField': 'uniform 0',
            'boundaryField': {p: {'type': 'zeroGradient' if k == 'wall' else k} for p, k in kinds.items()}},
            'volScalarField')
        self.write_dict('system/fvSchemes', {
            'ddtSchemes': {'default': 'Euler'}, 'gradSchemes': {'default': 'Gauss linear'},
            'divSchemes': {'default': 'none'}, 'laplacianSchemes': {'default': 'none'},
            'interpolationSchemes': {'default': 'linear'}, 'snGradSchemes': {'default': 'corrected'}})

    def errors(self, model, balls, ranks=1, image=''):
        """Of balls (centre, radius, contact angles by patch), a structured array; and what the program said."""
        self.write_dict('constant/surfaceProperties', {
            'liquid': 'water', 'surfaceMotion': {'type': 'still'}, 'curvature': {'type': model},
            'distance': {'type': 'reconstructed'}})
        shapes = ' '.join(f'b{i} {{ centre ({c[0]!r} {c[1]!r} {c[2]!r}); radius {r!r}; {image} contactAngles {{ '
                          + ' '.join(f'{p} {{ type constant; theta {t}; }}' for p, t in angles.items()) + ' } }'
                          for i, (c, r, angles) in enumerate(balls))
        self.write_dict('system/shapesDict', {'shapes': f'({shapes})'})
        result = self.run('curvatureErrors', ranks=ranks, timeout=600)
        assert result.code == 0, result.output
        rows = np.array([line.split()[1:] for line in result.output.splitlines() if line.startswith('shape ')], float)
        assert len(rows) == len(balls)
        return np.rec.fromarrays(rows.T, names=COLUMNS), result.output


def ball_mesh(path, kind, n, scale=1.0, **keywords):
    """A mesh around a ball of the radius scale, n cells a radius."""
    half = scale*round(1.6*n)/n
    m = 2*round(1.6*n)
    if kind == 'wedge':
        return Balls(path, (0, 0, -half), (half, 0, half), (m//2, 1, m), 'wedge', **keywords)
    depth = (-half, half) if kind == '3D' else (0, 0.1*scale)
    return Balls(path, (-half, -half, depth[0]), (half, half, depth[1]), (m, m, m if kind == '3D' else 1), kind, **keywords)


def balls(kind, n, number, scale=1.0, seed=1):
    """Centres at random within a cell."""
    random = np.random.default_rng(seed)
    result = []
    for _ in range(number):
        c = random.uniform(-0.5, 0.5, 3)/n*scale
        if kind == 'wedge':
            c[:2] = 0
        if kind == '2D':
            c[2] = 0.05*scale
        result.append((tuple(c.tolist()), scale, {}))
    return result


def total(errors):
    """Mean and largest error over all balls [%]."""
    return 100*(errors.cells*errors.average).sum()/errors.cells.sum(), 100*errors.largest.max()


# Cells a radius, balls; mean and largest error in percent. Heights are exact on circles and spheres but for what is left of
# the quadrature over columns that end at the edge of the ball, 0.006 measured in 2D at 6.4. In 3D at 6.4 columns along no
# axis are within the ball at some corners
EXACT = {'2D-6.4': (6.4, 200, 1e-3, 0.02), '2D-12.8': (12.8, 200, 1e-3, 1e-3), '2D-25': (25, 50, 1e-3, 1e-3),
         'wedge-6.4': (6.4, 50, 1e-3, 1e-3), 'wedge-12.8': (12.8, 50, 1e-3, 1e-3),
         '3D-6.4': (6.4, 3, 0.15, 6.0), '3D-10': (10, 3, 1e-3, 1e-3)}


@pytest.mark.parametrize('name', EXACT)
def test_height_function(tmp_path, name):
    """Exact wherever the ball is in the cells, also those that it has just entered."""
    n, number, mean, largest = EXACT[name]
    kind = name.split('-')[0]
    case = ball_mesh(tmp_path, kind, n)
    case.mesh()
    found = total(case.errors('heightFunction', balls(kind, n, number))[0])
    assert found[0] < mean and found[1] < largest


@pytest.mark.parametrize('model, mean, largest', [
    ('heightFunction', 1e-3, 1e-3), ('reconstructedDistance', 0.35, 1.5), ('paraboloid', 0.45, 4.0)])
def test_25_cells_a_radius(tmp_path, model, mean, largest):
    """Better than the numbers above, on a disc."""
    case = ball_mesh(tmp_path, '2D', 25)
    case.mesh()
    found = total(case.errors(model, balls('2D', 25, 20))[0])
    assert found[0] < mean and found[1] < largest


def test_graded(tmp_path):
    """Cells up to 3 times as long as others, along both axes: exact as well."""
    case = ball_mesh(tmp_path, '2D', 10)
    case.grading = (3, 2, 1)
    case.mesh()
    found = total(case.errors('heightFunction', balls('2D', 10, 20))[0])
    assert found[0] < 1e-3 and found[1] < 0.02


@pytest.mark.parametrize('kind', ['2D', 'wedge'])
@pytest.mark.parametrize('angle', range(15, 166, 15))
def test_contact_angle(tmp_path, kind, angle):
    """Caps on a wall: 25 cells a radius, also where the cap is not one cell high."""
    n = 25
    random = np.random.default_rng(angle)
    half = round(1.3*n)/n
    if kind == '2D':
        case = Balls(tmp_path, (-half, 0, 0), (half, 2.32, 0.1), (2*round(1.3*n), 58, 1))
    else:
        case = Balls(tmp_path, (0, 0, 0), (half, 0, 2.32), (round(1.3*n), 1, 58), 'wedge')
    case.mesh()
    caps = []
    for _ in range(6):
        r = random.uniform(1, 1.05)
        depth = -r*np.cos(np.radians(angle))
        c = (random.uniform(-.5, .5)/n, depth, 0.05) if kind == '2D' else (0.0, 0.0, depth)
        caps.append((tuple(float(v) for v in c), r, {'yMin' if kind == '2D' else 'zMin': angle}))
    found = total(case.errors('heightFunction', caps)[0])
    assert found[0] < 0.5 and found[1] < 8.5


def test_distance(tmp_path):
    """Within three cells of the surface: second order, and no worse than 1e-3 of a cell at 10 cells a radius."""
    for kind, limit in (('2D', 3e-4), ('3D', 1.5e-3), ('wedge', 2e-3)):
        case = ball_mesh(tmp_path/kind, kind, 10)
        case.mesh()
        errors, _ = case.errors('reconstructedDistance', balls(kind, 10, 3))
        assert errors.psi.max() < limit
        assert errors.n.max() < 2e-3


@pytest.mark.parametrize('model', ['heightFunction', 'paraboloid', 'reconstructedDistance'])
def test_ranks_and_scale(tmp_path, model):
    """1, 2 and 4 ranks agree, and a mesh of 2 um cells with one of 0.1 m."""
    found = []
    for scale, ranks in ((1.0, 1), (1.0, 2), (1.0, 4), (2e-5, 1)):
        case = ball_mesh(tmp_path/f'{scale}-{ranks}', '3D', 7, scale)
        case.mesh()
        if ranks > 1:
            case.decompose(ranks)
        errors, _ = case.errors(model, balls('3D', 7, 1, scale), ranks)
        found.append([float(errors[name][0]) for name in COLUMNS[:-1]])
    assert np.ptp(found, axis=0).max() < 1e-10


@pytest.mark.parametrize('model', ['heightFunction', 'paraboloid', 'reconstructedDistance'])
def test_cyclic(tmp_path, model):
    """A disc across a periodic boundary is like one that is not, on 1 and 2 ranks."""
    found = []
    for x, ranks in ((0.0, 1), (1.6, 1), (1.6, 2)):
        case = Balls(tmp_path/f'{x}-{ranks}', (-1.6, -1.6, 0), (1.6, 1.6, 0.1), (32, 32, 1), cyclic='x')
        case.mesh()
        if ranks > 1:
            case.decompose(ranks)
        errors, _ = case.errors(model, [((x, 0.03, 0.05), 1.0, {})], ranks, f'image ({x - 3.2} 0.03 0.05);')
        found.append([float(errors[name][0]) for name in COLUMNS[:-1]])
    assert np.ptp(found, axis=0).max() < 1e-10


def test_any_mesh(tmp_path):
    """Prisms over triangles: no columns, said so, paraboloids instead. Planes of single cells are far off there, which the
    mean shows: no more than a tenth of that by the gradient of alpha."""
    points, triangles = square_of_triangles(48, 3.2)
    case = Balls(tmp_path, (-1.6, -1.6, 0), (1.6, 1.6, 0.1), (32, 32, 1))
    case.write()
    write_prisms(tmp_path, points - 1.6, triangles, 0.1)
    ball = [((0.01, 0.02, 0.05), 1.0, {})]
    gradient = case.errors('gradAlpha', ball)[0].average[0]
    for model in ('heightFunction', 'paraboloid', 'reconstructedDistance'):
        errors, output = case.errors(model, ball)
        assert errors.average[0] < 0.35
        assert errors.average[0] < 0.1*gradient
        if model == 'heightFunction':
            assert re.search(r'line up in no columns', output)
            assert re.search(r' 0 cells by heights', output)
