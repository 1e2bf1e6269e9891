"""Liquid put into shapes: shares of cells and volumes of shapes on boxes, wedges, sheared and warped meshes.

Expected values come from closed forms written here. Tolerances: sums to 1e-12 (ulp of some hundred cells) of planes and
balls; 1e-9 of curved surfaces that are integrated (Gauss points, halved until 1e-11 of a cell), 1e-6 of cells that two
curved surfaces cross (tangent planes in 1/64 of a cell).
"""
import re
import shutil

import numpy as np
import pytest

from dewCase import Case, foam_dict, foam_value, quoted
from fluidCase import read_field

PI = np.pi


class LiquidCase(Case):
    """A box of 1 x 1 x 1 m (times scale) with shapes."""

    def __init__(self, path, shapes, **keywords):
        super().__init__(path, **{'lower': (0, 0, 0), 'upper': (1, 1, 1), 'cells': (8, 8, 8), 'writeFormat': 'ascii',
                                  'application': 'setLiquid', **keywords})
        self.shapes, self.liquid = shapes, 'water'

    def write(self):
        super().write()
        self.write_dict('system/setLiquidDict', {'liquid': self.liquid, 'shapes': self.shapes})

    def fill(self, ranks=1):
        done = self.run('setLiquid', ranks=ranks)
        assert done.code == 0, done.output
        return done.output

    def alpha(self, folder='.'):
        return read_field(self.path / folder / '0' / 'alpha.water')


def liquid(output):
    """Volume of the liquid in the mesh, and relative differences of the shapes."""
    errors = [float(v) for v in re.findall(r'relative difference (\S+)', output)]
    return float(re.search(r'Liquid in the mesh (\S+) m3', output)[1]), errors


def fill(path, shapes, **keywords):
    case = LiquidCase(path, shapes, **keywords)
    case.mesh()
    return case, *liquid(case.fill())


def cap_volume(a, theta):
    c, s = np.cos(theta), np.sin(theta)
    return PI * a**3 * (2 - 3 * c + c**3) / (3 * s**3)


SHAPES = {
    'plane': ({'type': 'plane', 'point': (.5, .5, .5), 'normal': (.3, .4, .77)}, 0.5, 1e-12),
    'box': ({'type': 'box', 'min': (.11, .22, .33), 'max': (.47, .83, .91)}, .36 * .61 * .58, 1e-12),
    'tilted': ({'type': 'box', 'centre': (.5, .5, .5), 'span': (.2, .3, .4), 'e1': (1, 1, 0), 'e2': (-1, 1, 0)}, .024,
               1e-12),
    'sphere': ({'type': 'sphere', 'centre': (.51, .47, .53), 'radius': .31}, 4 * PI / 3 * .31**3, 1e-12),
    'inCell': ({'type': 'sphere', 'centre': (.56, .57, .55), 'radius': .03}, 4 * PI / 3 * .03**3, 1e-12),
    'octant': ({'type': 'sphere', 'centre': (0, 0, 0), 'radius': .4}, PI / 6 * .4**3, 1e-12),
    'touching': ({'type': 'sphere', 'centre': (.5, .5, .5), 'radius': .25}, 4 * PI / 3 * .25**3, 1e-7),
    'ellipsoid': ({'type': 'ellipsoid', 'centre': (.51, .5, .53), 'semiAxes': (.3, .2, .4), 'e1': (1, 1, 0),
                   'e2': (-1, 1, 0)}, 4 * PI / 3 * .024, 1e-12),
    'cap60': ({'type': 'sphericalCap', 'base': (.51, .5, 0), 'normal': (0, 0, 1), 'contactRadius': .3,
               'contactAngle': 60}, cap_volume(.3, PI / 3), 1e-11),
    'cap120': ({'type': 'sphericalCap', 'base': (.51, .5, 0), 'normal': (0, 0, 1), 'volume': .1, 'contactAngle': 120},
               0.1, 1e-11),
    'disc': ({'type': 'cylinder', 'centre': (.51, .47, 0), 'axis': (0, 0, 1), 'radius': .31}, PI * .31**2, 1e-9),
    'skewCylinder': ({'type': 'cylinder', 'centre': (.51, .5, .53), 'axis': (1, 2, 3), 'radius': .2, 'length': .5},
                     PI * .02, 1e-6),
    'wave': ({'type': 'wave', 'point': (0, .52, .5), 'normal': (0, 1, 0), 'direction': (1, 0, 0), 'wavelength': 1,
              'amplitude': .1}, .52, 1e-9),
    'partOfWave': ({'type': 'wave', 'point': (.1, .52, .5), 'normal': (0, 0, -1), 'direction': (1, 0, 0),
                    'wavelength': .8, 'amplitude': .1, 'phase': 30},
                   .5 + .1 * .8 / (2 * PI) * (np.sin(2 * PI * .9 / .8 + PI / 6) - np.sin(-2 * PI * .1 / .8 + PI / 6)),
                   1e-9)}


@pytest.mark.parametrize('scale', [1, 1e-6])
@pytest.mark.parametrize('name', SHAPES)
def test_volume(tmp_path, name, scale):
    """The volume by formula, and the program knows it; the same in micrometres."""
    shape, expected, tolerance = SHAPES[name]
    scaled = {k: v if k in ('type', 'normal', 'axis', 'direction', 'e1', 'e2', 'contactAngle', 'phase')
              else scale**3 * v if k == 'volume' else tuple(scale * x for x in v) if isinstance(v, tuple) else scale * v
              for k, v in shape.items()}
    case, held, errors = fill(tmp_path / 'case', {'it': scaled}, upper=(scale,) * 3)
    assert abs(held / scale**3 / expected - 1) < tolerance + 1e-11          # printed with 12 digits
    assert len(errors) == 1 and abs(errors[0]) < tolerance
    alpha = case.alpha()
    assert alpha.min() >= 0 and alpha.max() <= 1
    assert abs(alpha.sum() / 512 / expected - 1) < tolerance


def test_cells_of_disc(tmp_path):
    """Every cell of a disc: chords integrated with 2e5 midpoints."""
    R, n = 0.31, 10
    case, _, _ = fill(tmp_path / 'case', {'it': SHAPES['disc'][0]}, cells=(n, n, 1))
    alpha = case.alpha().reshape(n, n)
    edges = np.linspace(0, 1, n + 1)
    m = 200_000
    for i in range(n):
        x = edges[i] + (np.arange(m) + .5) / m / n - .51
        half = np.sqrt(np.maximum(R**2 - x**2, 0))
        for j in range(n):
            low = np.maximum(edges[j] - .47, -half)
            high = np.minimum(edges[j + 1] - .47, half)
            share = np.where(half > 0, np.maximum(high - low, 0), 0).mean() * n
            assert abs(alpha[j, i] - share) < 1e-7          # of the midpoints, at ends of chords


def test_several(tmp_path):
    """Add, remove, outside; a sphere in a plane, spheres that cross."""
    R, d = .2, .2
    ball, lens = 4 * PI / 3 * R**3, PI * (4 * R + d) * (2 * R - d)**2 / 12
    plane = {'type': 'plane', 'point': (0, 0, .5), 'normal': (0, 0, 1)}
    low = {'type': 'sphere', 'centre': (.51, .52, .43), 'radius': R}
    high = {'type': 'sphere', 'centre': (.51, .52, .63), 'radius': R}

    def held(name, **shapes):
        return fill(tmp_path / name, shapes)[1]

    hole = {'type': 'sphere', 'centre': (.51, .52, .5), 'radius': R, 'action': 'remove'}
    core = {'type': 'sphere', 'centre': (.51, .52, .5), 'radius': R / 2}
    assert abs(held('nested', a=plane, b=hole, c=core) - (.5 - ball / 2 + ball / 8)) < 1e-11
    assert abs(held('box', a=plane, b={'type': 'box', 'min': (.3, .3, .4), 'max': (.61, .62, .71)})
               - (.5 + .31 * .32 * .21)) < 1e-11
    assert abs(held('outside', a={**low, 'outside': True}) - (1 - ball)) < 1e-11
    assert abs(held('union', a=low, b=high) - (2 * ball - lens)) < 1e-6 * ball
    assert abs(held('difference', a=low, b={**high, 'action': 'remove'}) - (ball - lens)) < 1e-6 * ball
    assert abs(held('outsideOfTwo', a={'type': 'plane', 'point': (0, 0, 0), 'normal': (0, 0, -1)},
                    b={**low, 'action': 'remove', 'outside': True}) - ball) < 1e-11


CUBE = [((0, 0, 0), (1, 1, 0), (1, 0, 0)), ((0, 0, 0), (0, 1, 0), (1, 1, 0)),
        ((0, 0, 1), (1, 0, 1), (1, 1, 1)), ((0, 0, 1), (1, 1, 1), (0, 1, 1)),
        ((0, 0, 0), (1, 0, 0), (1, 0, 1)), ((0, 0, 0), (1, 0, 1), (0, 0, 1)),
        ((0, 1, 0), (1, 1, 1), (1, 1, 0)), ((0, 1, 0), (0, 1, 1), (1, 1, 1)),
        ((0, 0, 0), (0, 0, 1), (0, 1, 1)), ((0, 0, 0), (0, 1, 1), (0, 1, 0)),
        ((1, 0, 0), (1, 1, 0), (1, 1, 1)), ((1, 0, 0), (1, 1, 1), (1, 0, 1))]


def stl(path, triangles):
    text = 'solid it\n'
    for triangle in triangles:
        text += 'facet normal 0 0 0\nouter loop\n'
        text += ''.join('vertex ' + ' '.join(repr(float(x)) for x in v) + '\n' for v in triangle)
        text += 'endloop\nendfacet\n'
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text + 'endsolid it\n')


def turned(triangles, M, shift):
    return [[tuple(M @ np.array(v, float) + shift) for v in t] for t in triangles]


def rotation():
    a, b = .3, .5
    return (np.array([[np.cos(a), -np.sin(a), 0], [np.sin(a), np.cos(a), 0], [0, 0, 1]])
            @ np.array([[1, 0, 0], [0, np.cos(b), -np.sin(b)], [0, np.sin(b), np.cos(b)]]))


@pytest.mark.parametrize('inwards', [False, True])
def test_closed_surface(tmp_path, inwards):
    """A turned cube of triangles: as the box of the same place, cell by cell; with normals inwards too."""
    M, shift = rotation(), np.array([.4, .3, .2])
    cube = turned(CUBE, .4 * M, shift)
    if inwards:
        cube = [t[::-1] for t in cube]
    case = LiquidCase(tmp_path / 'stl', {'it': {'type': 'closedSurface', 'file': quoted('cube.stl')}})
    stl(case.path / 'constant/triSurface/cube.stl', cube)
    case.mesh()
    held, errors = liquid(case.fill())
    # STL holds single precision: 6e-8
    assert abs(held / .4**3 - 1) < 1e-6 and abs(errors[0]) < 1e-11

    box, _, _ = fill(tmp_path / 'box', {'it': {
        'type': 'box', 'centre': tuple(shift + .4 * M @ (.5, .5, .5)), 'span': (.4, .4, .4), 'e1': tuple(M[:, 0]),
        'e2': tuple(M[:, 1])}})
    assert np.abs(case.alpha() - box.alpha()).max() < 2e-6


def warp(case):
    """Move the inner points of a box: faces that are not flat, cells that need not be convex."""
    path = case.path / 'constant/polyMesh/points'
    text = path.read_text()
    head, body = text.split('(\n', 1)
    body, tail = body.rsplit('\n)\n', 1)
    x = np.array([[float(v) for v in row.strip('()').split()] for row in body.split('\n')])
    inner = ((x > 1e-9) & (x < 1 - 1e-9)).all(axis=1)
    shift = np.random.default_rng(5).uniform(-.025, .025, x.shape)
    x[inner] += shift[inner]
    path.write_text(head + '(\n' + '\n'.join('(' + ' '.join(repr(float(v)) for v in p) + ')' for p in x) + '\n)\n' + tail)


@pytest.mark.parametrize('name', ['plane', 'sphere', 'disc', 'tilted'])
def test_warped_mesh(tmp_path, name):
    """Cells with faces that are not flat: still the same sum. Tetrahedra that a disc only just enters may be missed."""
    shape, expected, _ = SHAPES[name]
    case = LiquidCase(tmp_path / 'case', {'it': shape})
    case.mesh()
    warp(case)
    held, errors = liquid(case.fill())
    tolerance = 1e-6 if name == 'disc' else 1e-11
    assert abs(held / expected - 1) < tolerance and abs(errors[0]) < tolerance


class WedgeCase(LiquidCase):
    """A wedge of 5 degrees about z, radius and height 1."""

    def write_block_mesh(self):
        half = np.radians(2.5)
        x, y = np.cos(half), np.sin(half)
        vertices = [(0, 0, 0), (x, -y, 0), (x, y, 0), (0, 0, 1), (x, -y, 1), (x, y, 1)]
        boundary = {'bottom': {'type': 'wall', 'faces': '((0 2 1 0))'}, 'top': {'type': 'patch', 'faces': '((3 4 5 3))'},
                    'side': {'type': 'patch', 'faces': '((1 2 5 4))'}, 'front': {'type': 'wedge', 'faces': '((0 1 4 3))'},
                    'back': {'type': 'wedge', 'faces': '((0 3 5 2))'}}
        self.write_dict('system/blockMeshDict', {
            'scale': 1, 'vertices': vertices,
            'blocks': f'(hex (0 1 2 0 3 4 5 3) {foam_value((12, 1, 13))} simpleGrading (1 1 1))',
            'boundary': f'({foam_dict(boundary)})'})


@pytest.mark.parametrize('shape, expected', [
    ({'type': 'sphere', 'centre': (0, 0, .5), 'radius': .31}, 4 * PI / 3 * .31**3),
    ({'type': 'sphere', 'centre': (0, 0, 0), 'radius': .31}, 2 * PI / 3 * .31**3),
    ({'type': 'ellipsoid', 'centre': (0, 0, .5), 'semiAxes': (.31, .31, .4)}, 4 * PI / 3 * .31**2 * .4),
    ({'type': 'sphericalCap', 'base': (0, 0, 0), 'normal': (0, 0, 1), 'contactRadius': .4, 'contactAngle': 110},
     cap_volume(.4, np.radians(110))),
    ({'type': 'cylinder', 'centre': (0, 0, .5), 'axis': (0, 0, 1), 'radius': .4, 'length': .51}, PI * .4**2 * .51),
    ({'type': 'plane', 'point': (0, 0, .437), 'normal': (0, 0, 1)}, PI * .437)],
    ids=['sphere', 'hemisphere', 'ellipsoid', 'cap', 'cylinder', 'plane'])
def test_wedge(tmp_path, shape, expected):
    """The whole ring."""
    case = WedgeCase(tmp_path / 'case', {'it': shape})
    case.mesh()
    ring = float(re.search(r'in the whole ring (\S+) m3', case.fill())[1])
    assert abs(ring / expected - 1) < 1e-9


@pytest.mark.parametrize('name', ['sphere', 'disc', 'wave'])
def test_ranks(tmp_path, name):
    """1 = 2 ranks: the same cells; faces come in another order."""
    case, held, _ = fill(tmp_path / 'one', {'it': SHAPES[name][0]})
    two = case.copy(tmp_path / 'two')
    shutil.rmtree(two.path / '0')
    two.decompose(2)
    both, errors = liquid(two.fill(ranks=2))
    assert abs(both / held - 1) < 1e-12 and abs(errors[0]) < 1e-9
    parts = np.concatenate([two.alpha(f'processor{rank}') for rank in range(2)])
    assert np.abs(np.sort(parts) - np.sort(case.alpha())).max() < 1e-12


def test_keeps_boundary_conditions(tmp_path):
    case = LiquidCase(tmp_path / 'case', {'it': SHAPES['sphere'][0]})
    case.mesh()
    walls = {side: {'type': 'inletOutlet', 'inletValue': 'uniform 0', 'value': 'uniform 0'}
             for side in ('xMin', 'xMax', 'yMin', 'yMax', 'zMin', 'zMax')}
    case.write_dict('0/alpha.water', {'dimensions': '[0 0 0 0 0 0 0]', 'internalField': 'uniform 0',
                                      'boundaryField': walls}, 'volScalarField')
    case.fill()
    assert (case.path / '0/alpha.water').read_text().count('inletOutlet') == 6


BAD = {
    'noShape': ({}, 'No shape'),
    'type': ({'it': {'type': 'spere'}}, 'sphericalCap'),
    'radius': ({'it': {'type': 'sphere', 'centre': (0, 0, 0), 'radius': -1}}, 'radius'),
    'missing': ({'it': {'type': 'sphere', 'radius': 1}}, 'centre'),
    'spelling': ({'it': {**SHAPES['sphere'][0], 'radios': 1}}, 'radios'),
    'action': ({'it': {**SHAPES['sphere'][0], 'action': 'take'}}, 'Known: add remove'),
    'away': ({'it': {'type': 'sphere', 'centre': (5, 5, 5), 'radius': 1}}, 'no liquid'),
    'span': ({'it': {'type': 'box', 'min': (0, 0, 0), 'max': (1, 0, 1)}}, 'max > min'),
    'axes': ({'it': {**SHAPES['tilted'][0], 'e2': (1, 0, 0)}}, 'perpendicular'),
    'normal': ({'it': {'type': 'plane', 'point': (0, 0, 0), 'normal': (0, 0, 0)}}, 'normal'),
    'direction': ({'it': {**SHAPES['wave'][0], 'direction': (1, 1, 0)}}, 'perpendicular'),
    'capTwice': ({'it': {**SHAPES['cap60'][0], 'volume': 1}}, 'one of them'),
    'angle': ({'it': {**SHAPES['cap60'][0], 'contactAngle': 190}}, 'contactAngle'),
    'noFile': ({'it': {'type': 'closedSurface', 'file': quoted('no.stl')}}, 'no file'),
    'open': ({'it': {'type': 'closedSurface', 'file': quoted('open.stl')}}, 'not closed')}


@pytest.mark.parametrize('name', BAD)
def test_bad_input(tmp_path, name):
    shapes, message = BAD[name]
    case = LiquidCase(tmp_path / 'case', shapes)
    stl(case.path / 'constant/triSurface/open.stl', CUBE[:-1])
    case.mesh()
    done = case.run('setLiquid')
    assert done.code != 0 and message in done.output, done.output
    assert 'setLiquidDict' in done.output


@pytest.mark.parametrize('shape', [{'type': 'sphere', 'centre': (.1, 0, .5), 'radius': .3}, SHAPES['wave'][0],
                                   SHAPES['plane'][0], SHAPES['box'][0]], ids=['sphere', 'wave', 'plane', 'box'])
def test_not_of_revolution(tmp_path, shape):
    case = WedgeCase(tmp_path / 'case', {'it': shape})
    case.mesh()
    done = case.run('setLiquid')
    assert done.code != 0 and 'not a body of revolution' in done.output, done.output
