"""The surface of a drop on a substrate: its overlap with cells and faces, and how it moves.

testSurface (this folder) moves it by given losses. Expected values come from the formulas written here, which are not
those of the code: rings are integrated as polynomials in z between the z where the sphere crosses their corners; boxes
over slices, with Gauss points between such z, and each slice as a rectangle cut by a circle; caps by
V = pi a^3 (2 - 3 cos + cos^3)/(3 sin^3), inverted by bisection. Tolerances: shares to 1e-11, where the
differences of R^3 in these formulas leave 1e-12; sums to 1e-12, N ulp of N cells.
"""
import re

import numpy as np
import pytest

from dewCase import Case, foam_dict, foam_value

A = 25e-6
HALF = np.radians(1)


def cap_volume(a, theta):
    """Of the whole cap [m3]."""
    c, s = np.cos(theta), np.sin(theta)
    return np.pi * a**3 * (2 - 3 * c + c**3) / (3 * s**3)


def cap_angle(V, a):
    """By bisection [rad]."""
    low, high = 1e-3, np.pi - 1e-3
    for _ in range(200):
        mid = (low + high) / 2
        low, high = (mid, high) if cap_volume(a, mid) < V else (low, mid)
    return low


def sphere(a, theta):
    """Radius, and height of the centre above the substrate."""
    return a / np.sin(theta), -a / np.tan(theta)


class SurfaceCase(Case):
    """A drop at the origin (or centre) on zMin of a box, or on the patch substrate of a graded wedge of 2 degrees."""

    def __init__(self, path, theta=60, a=A, line=None, steps=0, wedge=True, lost=(), **keywords):
        super().__init__(path, **{'application': 'testSurface', 'endTime': steps * 1e-3, 'deltaT': 1e-3,
                                  'writeInterval': 1, **keywords})
        self.wedge = wedge
        self.motion = {'type': 'quasiStatic', 'substrate': 'substrate' if wedge else 'zMin', 'contactRadius': a,
                       'contactAngle': float(theta), 'contactLine': line or {'type': 'pinned'}}
        self.lost, self.validity, self.shear = lost, None, 0
        self.size, self.wedge_cells, self.grading = (4.1 * A, 4.6 * A), (37, 41), (5, 0.3)

    def write(self):
        super().write()
        self.write_dict('constant/surfaceProperties', {'liquid': 'water', 'surfaceMotion': self.motion})
        test = {'lost': tuple(float(v) for v in self.lost)}
        if self.validity:
            test['validity'] = self.validity
        self.write_dict('constant/testProperties', test)
        (self.path / '0').mkdir(exist_ok=True)

    def write_block_mesh(self):
        if not self.wedge:
            return super().write_block_mesh()
        # OpenFOAM's wedge: a vertex at radius r is r away from the axis
        L, H = self.size
        x, y = L * np.cos(HALF), L * np.sin(HALF)
        z = H + self.shear
        vertices = [(0, 0, 0), (x, -y, 0), (x, y, 0), (0, 0, H), (x, -y, z), (x, y, z)]
        n, g = self.wedge_cells, self.grading
        boundary = {'substrate': {'type': 'wall', 'faces': '((0 2 1 0))'}, 'top': {'type': 'patch', 'faces': '((3 4 5 3))'},
                    'side': {'type': 'patch', 'faces': '((1 2 5 4))'}, 'front': {'type': 'wedge', 'faces': '((0 1 4 3))'},
                    'back': {'type': 'wedge', 'faces': '((0 3 5 2))'}}
        self.write_dict('system/blockMeshDict', {
            'scale': 1, 'vertices': vertices,
            'blocks': f'(hex (0 1 2 0 3 4 5 3) {foam_value((n[0], 1, n[1]))} simpleGrading {foam_value((g[0], 1, g[1]))})',
            'boundary': f'({foam_dict(boundary)})'})

    def edges(self, k):
        """Of the cells along r (0) or z (1) of the wedge."""
        n, g, L = self.wedge_cells[k], self.grading[k], self.size[k]
        sizes = g**(np.arange(n) / (n - 1))
        return L * np.concatenate([[0], np.cumsum(sizes) / sizes.sum()])

    def fill(self, ranks=1):
        done = self.run('setSphericalCap', ranks=ranks)
        assert done.code == 0, done.output
        return done.output

    def go(self, ranks=1):
        done = self.run('testSurface', ranks=ranks)
        assert done.code == 0, done.output
        return done.output

    def csv(self, name, ranks=1):
        """All ranks' rows of a table."""
        return np.concatenate([np.atleast_1d(np.genfromtxt(self.path / f'{name}{k}.csv', delimiter=',', names=True))
                               for k in range(ranks)])

    def step_table(self):
        return np.atleast_1d(np.genfromtxt(self.path / 'steps.csv', delimiter=',', names=True))


def filled(path, **keywords):
    case = SurfaceCase(path, **keywords)
    case.mesh()
    case.fill()
    return case


def rings(a, theta, r0, r1, z0, z1):
    """Liquid in rings, and area of the surface in them, as fractions: 2 D arrays or scalars, one by one."""
    R, zc = sphere(a, theta)

    def s(z):
        return R**2 - (z - zc)**2

    V, S = np.zeros(r0.shape), np.zeros(r0.shape)
    for k in np.ndindex(r0.shape):
        cuts = [z0[k], z1[k]]
        for r in (r0[k], r1[k]):
            if r < R:
                cuts += [zc - np.sqrt(R**2 - r**2), zc + np.sqrt(R**2 - r**2)]
        cuts = np.unique(np.clip(cuts, z0[k], z1[k]))
        for p, q in zip(cuts[:-1], cuts[1:]):
            middle = s((p + q) / 2)
            if middle >= r1[k]**2:
                V[k] += np.pi * (r1[k]**2 - r0[k]**2) * (q - p)
            elif middle > r0[k]**2:
                V[k] += np.pi * ((R**2 - r0[k]**2) * (q - p) - ((q - zc)**3 - (p - zc)**3) / 3)
                S[k] += 2 * np.pi * R * (q - p)
    return V, S


@pytest.mark.parametrize('theta', [20, 60, 90, 120, 150])
def test_rings(tmp_path, theta):
    """Cells, faces and area on a graded wedge; the whole to round-off."""
    case = filled(tmp_path, theta=theta)
    case.go()
    cells, t = case.csv('cells'), np.radians(theta)
    re, ze = case.edges(0), case.edges(1)
    i = np.searchsorted(re, cells['x'] / np.cos(HALF)) - 1
    j = np.searchsorted(ze, cells['z']) - 1
    ring = 2 * np.pi / np.sin(2 * HALF)
    V, S = rings(A, t, re[i], re[i + 1], ze[j], ze[j + 1])
    whole = np.pi * (re[i + 1]**2 - re[i]**2) * (ze[j + 1] - ze[j])
    assert np.abs(cells['alpha'] - V / whole).max() < 1e-11
    assert np.abs(cells['area'] * ring - S).max() < 1e-9 * A**2
    assert (cells['alpha'][V == 0] == 0).all() and (cells['alpha'][V > whole * (1 - 1e-12)] == 1).all()
    assert 0 <= cells['alpha'].min() and cells['alpha'].max() <= 1
    total = (cells['alpha'] * cells['V']).sum() * ring
    assert abs(total / cap_volume(A, t) - 1) < 1e-12
    R, zc = sphere(A, t)
    assert abs(cells['area'].sum() * ring / (2 * np.pi * R * (R + zc)) - 1) < 1e-12

    # Distance, normal and curvature at the true radius
    r = cells['x'] / np.cos(HALF)
    distance = np.hypot(r, cells['z'] - zc)
    assert np.abs(cells['psi'] - (R - distance)).max() < 1e-10 * A
    assert np.abs(cells['nx'] - r / distance).max() < 1e-10 and np.abs(cells['ny']).max() < 1e-10
    assert np.abs(cells['nz'] - (cells['z'] - zc) / distance).max() < 1e-10
    assert np.abs(cells['curvature'] * R - 1).max() < 1e-12
    patch = case.csv('psi')
    on = patch['z'] < 1e-9 * A
    assert on.sum() >= len(re) - 1
    assert np.abs(patch['psi'][on] - (R - np.hypot(patch['x'][on] / np.cos(HALF), zc))).max() < 1e-10 * A

    # Faces: upright ones by height, level ones by area
    faces = case.csv('faces')
    r, z = faces['x'] / np.cos(HALF), faces['z']
    upright = np.array([np.abs(re - v).min() < 1e-6 * A for v in r]) & (np.abs(faces['y']) < 1e-9 * A)
    level = np.array([np.abs(ze - v).min() < 1e-6 * A for v in z]) & (np.abs(faces['y']) < 1e-9 * A)
    assert upright.sum() > 1000 and level.sum() > 1000
    k = np.searchsorted(ze, z[upright]) - 1
    half = np.sqrt(np.maximum(R**2 - r[upright]**2, 0))
    wet = np.clip(np.minimum(ze[k + 1], zc + half) - np.maximum(ze[k], zc - half), 0, None) / (ze[k + 1] - ze[k])
    assert np.abs(faces['alphaf'][upright] - wet).max() < 1e-11
    k = np.searchsorted(re, r[level]) - 1
    wet = (np.clip(R**2 - (z[level] - zc)**2, re[k]**2, re[k + 1]**2) - re[k]**2) / (re[k + 1]**2 - re[k]**2)
    assert np.abs(faces['alphaf'][level] - wet).max() < 1e-11

    # Where the way between two centres leaves the sphere
    ways = case.csv('crossing')
    assert len(ways) > 10
    x = np.array([ways['x'], ways['y'], ways['z']]) * (1 - ways['t']) + np.array([ways['u'], ways['v'], ways['w']]) * ways['t']
    assert np.abs(np.hypot(x[0] / np.cos(HALF), x[2] - zc) / R - 1).max() < 1e-12


def rectangle(rho2, x0, x1, y0, y1):
    """Area of a disc about the origin in a rectangle."""
    if rho2 <= 0:
        return 0.0
    rho = np.sqrt(rho2)

    def under(x):
        """Integral of sqrt(rho^2 - x^2) from 0."""
        x = np.clip(x, -rho, rho)
        y = np.sqrt(max(rho2 - x * x, 0))
        return (x * y + rho2 * np.arctan2(x, y)) / 2

    cuts = [x0, x1, -rho, rho]
    for y in (y0, y1):
        if abs(y) < rho:
            cuts += [-np.sqrt(rho2 - y * y), np.sqrt(rho2 - y * y)]
    cuts = np.unique(np.clip(cuts, max(x0, -rho), min(x1, rho))) if x0 < rho and x1 > -rho else []
    area = 0.0
    for p, q in zip(cuts[:-1], cuts[1:]):
        f = np.sqrt(max(rho2 - ((p + q) / 2)**2, 0))
        if min(y1, f) <= max(y0, -f):
            continue
        area += (y1 * (q - p) if y1 < f else under(q) - under(p)) - (y0 * (q - p) if y0 > -f else under(p) - under(q))
    return area


GAUSS = np.polynomial.legendre.leggauss(40)


def box_volume(R, c, low, high):
    """Of a ball in a box, over slices; the cosine takes away the roots at the ends of each piece."""
    low, high = np.array(low) - c, np.array(high) - c
    cuts = [low[2], high[2], -R, R]
    for x in (low[0], high[0], None):
        for y in (low[1], high[1], None):
            d2 = R**2 - (x or 0)**2 - (y or 0)**2
            if d2 > 0:
                cuts += [-np.sqrt(d2), np.sqrt(d2)]
    if low[2] >= R or high[2] <= -R:
        return 0.0
    cuts = np.unique(np.clip(cuts, max(low[2], -R), min(high[2], R)))
    V = 0.0
    for p, q in zip(cuts[:-1], cuts[1:]):
        angle = (GAUSS[0] + 1) * np.pi / 2
        z = (p + q) / 2 - (q - p) / 2 * np.cos(angle)
        weight = GAUSS[1] * np.pi / 2 * (q - p) / 2 * np.sin(angle)
        V += sum(w * rectangle(R**2 - v * v, low[0], high[0], low[1], high[1]) for w, v in zip(weight, z))
    return V


@pytest.mark.parametrize('theta, lower, centre', [
    (20, (0, 0, 0), (0, 0, 0)), (90, (0, 0, 0), (0, 0, 0)), (150, (0, 0, 0), (0, 0, 0)),
    (60, (-2.2 * A, 0, 0), (1e-7, 0, 0)), (110, (-2.3 * A, -2.4 * A, 0.1 * A), (3e-7, 5e-7, 0.1 * A))])
def test_boxes(tmp_path, theta, lower, centre):
    """A quarter, a half and a whole drop in boxes."""
    upper = (2.3 * A, 2.2 * A, 4.1 * A)
    n = tuple(int(round((u - v) / (0.27 * A))) for u, v in zip(upper, lower))
    case = SurfaceCase(tmp_path, theta=theta, wedge=False, lower=lower, upper=upper, cells=n)
    case.motion['centre'] = centre
    case.mesh()
    case.fill()
    case.go()
    cells, t = case.csv('cells'), np.radians(theta)
    R, zc = sphere(A, t)
    c = np.array(centre) + [0, 0, zc]
    share = np.prod([0.5 if v == w else 1 for v, w in zip(lower[:2], centre[:2])])
    whole = share * cap_volume(A, t)
    assert abs((cells['alpha'] * cells['V']).sum() / whole - 1) < 1e-12
    assert abs(cells['area'].sum() / (share * 2 * np.pi * R * (R + zc)) - 1) < 1e-11

    h = (np.array(upper) - lower) / n
    x = np.array([cells['x'], cells['y'], cells['z']]).T
    near = np.flatnonzero(np.abs(np.linalg.norm(x - c, axis=1) - R) < np.linalg.norm(h))
    assert len(near) > 50
    some = np.random.default_rng(1).choice(near, min(100, len(near)), replace=False)
    V = np.array([box_volume(R, c, x[k] - h / 2, x[k] + h / 2) for k in some])
    assert np.abs(cells['alpha'][some] - V / h.prod()).max() < 1e-11
    assert ((V > 1e-3 * h.prod()) & (V < 0.999 * h.prod())).sum() > 10
    far = np.setdiff1d(np.arange(len(x)), near)
    assert np.isin(cells['alpha'][far], (0, 1)).all() and (cells['area'][far] == 0).all()

    # Level faces by the disc in them
    faces = case.csv('faces')
    f = np.array([faces['x'], faces['y'], faces['z']]).T
    level = np.flatnonzero((np.abs((f[:, 2] - lower[2]) / h[2] - np.round((f[:, 2] - lower[2]) / h[2])) < 1e-6)
                           & (faces['area'] < h[0] * h[1] * (1 + 1e-9)))
    wet = np.array([rectangle(R**2 - (f[k, 2] - c[2])**2, *(f[k, 0] - c[0] + h[0] / 2 * np.array([-1, 1])),
                              *(f[k, 1] - c[1] + h[1] / 2 * np.array([-1, 1]))) for k in level]) / (h[0] * h[1])
    assert np.abs(faces['alphaf'][level] - wet).max() < 1e-11 and ((wet > 0.01) & (wet < 0.99)).sum() > 5


def test_large_cells(tmp_path):
    """A cell larger than the ball, which is nearly closed: one cell has all of the surface."""
    case = SurfaceCase(tmp_path, theta=175, wedge=False, a=2e-6, lower=(-4 * A, -4.1 * A, 0), upper=(4.2 * A, 4 * A, 8 * A),
                       cells=(1, 1, 1))
    case.mesh()
    case.fill()
    case.go()
    cells = case.csv('cells')
    R, zc = sphere(2e-6, np.radians(175))
    assert abs(cells['alpha'][0] * cells['V'][0] / cap_volume(2e-6, np.radians(175)) - 1) < 1e-11
    assert abs(cells['area'][0] / (2 * np.pi * R * (R + zc)) - 1) < 1e-11


def test_sheared_wedge(tmp_path):
    """Rings whose sections are no rectangles: the whole to round-off, also of flat caps."""
    for theta in (0.02, 1, 40, 130):
        case = SurfaceCase(tmp_path / str(theta), theta=theta)
        case.path.mkdir()
        case.shear = 0.5 * A
        case.mesh()
        case.fill()
        case.go()
        cells, t = case.csv('cells'), np.radians(theta)
        T = np.tan(t / 2)
        total = (cells['alpha'] * cells['V']).sum() * 2 * np.pi / np.sin(2 * HALF)
        assert abs(total / (np.pi * A**3 * T * (3 + T * T) / 6) - 1) < 1e-12


LINES = {'pinned': {'type': 'pinned'}, 'constantAngle': {'type': 'constantAngle'},
         'receding': {'type': 'pinnedThenReceding', 'recedingAngle': 30.0}}


@pytest.mark.parametrize('line', LINES)
@pytest.mark.parametrize('sign', [1, -1])
def test_motion(tmp_path, line, sign):
    """Volume, radius and angle of every step, up or down; speed and faces of the last one."""
    theta, n = np.radians(60), 8
    V0, ring = cap_volume(A, theta), 2 * np.pi / np.sin(2 * HALF)
    lost = sign * V0 * np.array([0.05, 0.1, 0.15, 0.1, 0.1, 0.1, 0.1, 0.1])
    case = filled(tmp_path, theta=60, line=LINES[line], steps=n, lost=lost / ring)
    case.go()
    table = case.step_table()
    V = V0 - np.concatenate([[0], np.cumsum(lost)])
    assert np.allclose(table['V'], V, rtol=1e-12, atol=0) and np.allclose(table['held'] * ring, V, rtol=1e-11, atol=0)
    angle = np.array([cap_angle(v, A) for v in V])
    if line == 'constantAngle':
        a, angle = A * np.cbrt(V / V0), np.full(n + 1, theta)
    elif line == 'receding':
        moved = angle < np.radians(30)
        assert moved.any() == (sign > 0) and not moved.all()
        angle[moved] = np.radians(30)
        a = np.where(moved, A * np.cbrt(V / cap_volume(A, np.radians(30))), A)
    else:
        a = np.full(n + 1, A)
    assert np.allclose(table['a'], a, rtol=1e-9, atol=0) and np.allclose(table['theta'], angle, rtol=1e-9, atol=0)

    # Speed: the new foot point seen from the old sphere
    cells = case.csv('cells')
    (R0, z0), (R1, z1) = (sphere(a[k], angle[k]) for k in (-2, -1))
    r, z = cells['x'] / np.cos(HALF), cells['z'] - z1
    d = np.hypot(r, z)
    speed = (np.hypot(r / d * R1, z / d * R1 + z1 - z0) - R0) / 1e-3
    assert np.abs(cells['speed'] - speed).max() < 1e-8 * np.abs(speed).max()

    # What left the faces' mean: old and new shares
    last = SurfaceCase(tmp_path, theta=60, line=LINES[line], steps=n, lost=lost / ring)
    shares = []
    for k in (-2, -1):
        still = filled(tmp_path / f'still{k}', theta=np.degrees(angle[k]), a=float(a[k]))
        still.go()
        shares.append(still)
    assert np.abs(cells['alpha'] - shares[1].csv('cells')['alpha']).max() < 1e-8
    assert np.abs(cells['old'] - shares[0].csv('cells')['alpha']).max() < 1e-8
    mean = (shares[0].csv('faces')['alphaf'] + shares[1].csv('faces')['alphaf']) / 2
    assert np.abs(last.csv('faces')['alphaf'] - mean).max() < 1e-8


@pytest.mark.parametrize('line', LINES)
def test_dry(tmp_path, line):
    """The last of the liquid goes; nothing more can."""
    V0 = cap_volume(A, np.radians(60)) * np.sin(2 * HALF) / (2 * np.pi)
    parts = [0.5, 0.3, 0.1, 0.09, 0.009, 0.0009, 0.0001]
    case = filled(tmp_path, line=LINES[line], steps=9, lost=V0 * np.array(parts + [0, 0]))
    output = case.go()
    cells, table = case.csv('cells'), case.step_table()
    assert (table['V'][-3:] == 0).all() and table['V'][-4] > 0 and 'drop: dry' in output
    assert (cells['alpha'] == 0).all() and (cells['psi'] < 0).all() and (cells['area'] == 0).all()
    assert (cells['inside'] == 0).all() and (cells['curvature'] == 0).all()
    assert np.allclose(np.linalg.norm([cells['nx'], cells['ny'], cells['nz']], axis=0), 1, atol=1e-12)

    for more, words in ((1e-18, 'neither loses nor gains'), (-1e-18, 'neither loses nor gains')):
        case.lost = V0 * np.array(parts + [0, more / V0])
        case.control['startFrom'] = 'startTime'
        case.write()
        done = case.run('testSurface')
        assert done.code != 0 and words in done.output, done.output
    case.lost = V0 * np.array(parts[:-1] + [0.000101, 0, 0])
    case.write()
    done = case.run('testSurface')
    assert done.code != 0 and 'was to lose' in done.output, done.output


def same(one, other, tolerance):
    """Tables with equal numbers, relative to the largest of each column."""
    for name in one.dtype.names:
        scale = A if name in 'xyz' else 1 if name[0] == 'n' else max(np.abs(one[name]).max(), 1e-30)
        assert np.abs(one[name] - other[name]).max() <= tolerance * scale, name


@pytest.mark.parametrize('line', LINES)
def test_restart(tmp_path, line):
    """Continued equals uninterrupted, also what the last step leaves for the next one; ascii fields of six digits."""
    V0 = cap_volume(A, np.radians(60)) * np.sin(2 * HALF) / (2 * np.pi)
    lost = V0 * np.array([0.1, 0.3, 0.2, 0.1, 0.1, 0.1])
    full = filled(tmp_path / 'full', line=LINES[line], steps=6, lost=lost)
    half = full.copy(tmp_path / 'half')
    full.go()
    for end in (3, 3, 6):
        half.control.update(endTime=end * 1e-3, writeFormat='ascii', writePrecision=6)
        half.write()
        half.go()
        if end == 3:
            saved = half.csv('cells'), half.csv('faces')
            third = full.copy(tmp_path / f'third{len(list(tmp_path.iterdir()))}')
            third.control.update(endTime=3e-3, startFrom='startTime')
            third.write()
            third.go()
            expected = third.csv('cells')
            expected['old'] = saved[0]['old']
            same(expected, saved[0], 1e-12)
            same(third.csv('faces'), saved[1], 1e-12)
    same(full.csv('cells'), half.csv('cells'), 1e-12)
    same(full.csv('faces'), half.csv('faces'), 1e-12)
    assert full.step_table()[-1] == half.step_table()[-1] or \
        np.allclose(list(full.step_table()[-1]), list(half.step_table()[-1]), rtol=1e-12, atol=0)


def test_ranks(tmp_path):
    """Two ranks, cut along the radius: begun, filled, continued by decomposePar."""
    V0 = cap_volume(A, np.radians(60)) * np.sin(2 * HALF) / (2 * np.pi)
    lost = V0 * np.array([0.05, 0.15, 0.1, 0.05, 0.05, 0.05])
    one = SurfaceCase(tmp_path / 'one', steps=6, lost=lost, line=LINES['receding'])
    one.grading = (20, 0.3)        # half of the cells are in the drop, the cut passes through it
    one.path.mkdir()
    one.mesh()
    one.fill()
    two = one.copy(tmp_path / 'two')
    one.go()

    def sort(table):
        keys = np.round(np.array([table['x'], table['y'], table['z']]) / 1e-12)
        return table[np.lexsort(keys)]

    def compare():
        same(sort(one.csv('cells')), sort(two.csv('cells', 2)), 1e-11)
        mine, theirs = sort(one.csv('faces')), sort(two.csv('faces', 2))
        keys = [set(map(tuple, np.round(np.array([t['x'], t['y'], t['z'], t['area'] * 1e6]).T / 1e-12))) for t in (mine, theirs)]
        assert keys[0] == keys[1]
        # Faces on the cut come twice, with the same bits
        twice = np.flatnonzero(np.all([np.abs(np.diff(theirs[k])) < 1e-15 for k in 'xyz'], axis=0))
        assert 41 <= len(twice) <= 45 and (theirs['alphaf'][twice] == theirs['alphaf'][twice + 1]).all()
        assert ((theirs['alphaf'][twice] > 0) & (theirs['alphaf'][twice] < 1)).any()
        same(mine, np.delete(theirs, twice), 1e-12)

    two.decompose(2)
    two.go(2)
    compare()

    # Filled in parallel
    for p in two.path.glob('processor*/0/alpha.water'):
        p.unlink()
    two.control['startFrom'] = 'startTime'
    two.write()
    two.fill(2)
    two.go(2)
    compare()

    # Begun on one rank, continued on two
    for p in two.path.glob('processor*'):
        p.rename(two.path / ('old' + p.name))
    two.control.update(startFrom='startTime', endTime=3e-3)
    two.write()
    two.go()
    two.control.update(startFrom='latestTime', endTime=6e-3)
    two.write()
    done = two.run('decomposePar', '-latestTime')
    assert done.code == 0, done.output
    two.go(2)
    compare()


BAD = {
    'noPatch': ({'substrate': 'floor'}, {}, ('substrate', 'floor', 'no such patch', 'side')),
    'unknownEntry': ({'radius': 1e-6}, {}, ("Unknown entry 'radius'", 'contactRadius')),
    'unknownType': ({'type': 'levelSet'}, {}, ('levelSet', 'quasiStatic')),
    'unknownLine': ({'contactLine': {'type': 'glued'}}, {}, ('glued', 'pinnedThenReceding')),
    'noLine': ({'contactLine': None}, {}, ("'contactLine'", 'Add:')),
    'angle': ({'contactAngle': 190.0}, {}, ('contactAngle', '190', '179')),
    'zeroAngle': ({'contactAngle': 0.0}, {}, ('contactAngle', 'is 0')),
    'radius': ({'contactRadius': -1e-6}, {}, ('contactRadius', 'greater than zero')),
    'receding': ({'contactLine': {'type': 'pinnedThenReceding', 'recedingAngle': 70.0}}, {}, ('recedingAngle', '70', '60')),
    'offAxis': ({'centre': (1e-6, 0, 0)}, {}, ('axis of the wedge', '1e-06')),
    'aboveSubstrate': ({'centre': (0, 0, 1e-6)}, {}, ('not on it', '1e-06')),
    'notThatPlane': ({'substrate': 'side'}, {}, ('not flat',)),
    'otherAngle': ({'contactAngle': 61.0}, {}, ('do not fit', 'setSphericalCap')),
    'leaves': ({'contactLine': {'type': 'constantAngle'}}, {'lost': [-1e-14] * 30}, ('leaves the mesh', 'Make the mesh larger')),
}


@pytest.fixture(scope='module')
def good(tmp_path_factory):
    return filled(tmp_path_factory.mktemp('surface') / 'good')


@pytest.mark.parametrize('name', BAD)
def test_bad_input(tmp_path, good, name):
    """One message that names the entry, its value and the remedy."""
    case = good.copy(tmp_path / 'case')
    changes, others, words = BAD[name]
    case.motion.update(changes)
    case.motion = {k: v for k, v in case.motion.items() if v is not None}
    if others:
        case.lost = others['lost']
        case.control['endTime'] = 1e-3 * len(case.lost)
    case.write()
    done = case.run('testSurface')
    assert done.code != 0
    assert len(re.findall(r'FOAM FATAL', done.output)) == 1, done.output
    for word in words:
        assert word in done.output, (word, done.output)


def test_grown(tmp_path):
    """A pinned drop that becomes a ball."""
    case = filled(tmp_path, theta=170, a=3e-7, steps=2)
    more = [cap_volume(3e-7, np.radians(178.9)) - cap_volume(3e-7, np.radians(170)), 6e-15]
    case.lost = -np.array(more) * np.sin(2 * HALF) / (2 * np.pi)
    case.write()
    done = case.run('testSurface')
    assert done.code != 0 and 'grown to a contact angle' in done.output and 'constantAngle' in done.output, done.output
    assert done.output.count('drop: volume') == 2


def test_no_liquid(tmp_path, good):
    """alpha is zero everywhere; a drop larger than the mesh."""
    case = good.copy(tmp_path / 'case')
    case.write_dict('0/alpha.water', {'dimensions': '[0 0 0 0 0 0 0]', 'internalField': 'uniform 0', 'boundaryField': {
        '".*"': {'type': 'zeroGradient'}, 'front': {'type': 'wedge'}, 'back': {'type': 'wedge'}}}, 'volScalarField')
    done = case.run('testSurface')
    assert done.code != 0 and 'no liquid' in done.output and 'setSphericalCap' in done.output, done.output
    # Boundary conditions that are there are kept
    case.fill()
    assert b'".*"' in (case.path / '0/alpha.water').read_bytes() or b'zeroGradient' in (case.path / '0/alpha.water').read_bytes()
    case.motion['contactRadius'] = 5 * A
    case.write()
    done = case.run('setSphericalCap')
    assert done.code != 0 and 'does not fit the mesh' in done.output, done.output


def test_other_record(tmp_path, good):
    """alpha of another drop than the one of uniform/surface."""
    case = good.copy(tmp_path / 'case')
    V0 = cap_volume(A, np.radians(60)) * np.sin(2 * HALF) / (2 * np.pi)
    case.lost = [0.1 * V0, 0.1 * V0]
    case.control['endTime'] = 1e-3
    case.write()
    case.go()
    (case.path / '0.001/alpha.water').write_bytes((case.path / '0/alpha.water').read_bytes())
    done = case.run('testSurface')
    assert done.code != 0 and 'is not that of the drop' in done.output, done.output


def test_utility(good):
    """What setSphericalCap says."""
    output = good.fill()
    numbers = [float(v) for v in re.findall(r'(?<=\s)\d[\d.e+-]*(?=\s)', output[output.index('Volume'):output.index('Writing')])]
    V = cap_volume(A, np.radians(60))
    expected = [V * np.sin(2 * HALF) / 2 / np.pi, V, A, 60, A * np.tan(np.radians(30)), A / np.sin(np.radians(60))]
    assert np.allclose(numbers, expected, rtol=1e-5, atol=0), output


@pytest.mark.parametrize('values, words, code', [
    ((0.07, 1000, 1e-3, 9.81, 1e-3), (), 0), ((0.07, 1000, 1e-3, 9.81, 0.14), ('FOAM Warning',), 0),
    ((0.07, 1000, 1e-3, 9.81, 14), ('no spherical cap', 'Ca'), 1), ((1e-6, 1000, 1e-6, 9.81, 1e-3), ('no spherical cap', 'Bo'), 1)])
def test_validity(tmp_path, good, values, words, code):
    """Numbers; one warning; the end."""
    case = good.copy(tmp_path / 'case')
    case.validity = values
    case.write()
    done = case.run('testSurface')
    assert (done.code != 0) == bool(code), done.output
    assert done.output.count('FOAM Warning') == (1 if 'FOAM Warning' in words else 0)
    for word in words:
        assert word in done.output
    sigma, rho, mu, g, U = values
    numbers = re.search(r'drop: Ca (\S+), Bo (\S+)', done.output)
    assert np.allclose([float(v) for v in numbers.groups()],
                       [mu * U / sigma, rho * g * A * A * np.tan(np.radians(30)) / sigma], rtol=1e-5)


def test_packed_in_drop(tmp_path):
    """Whole spheres inside the drop, without overlap, also in the rim."""
    d, theta = 1e-6, np.radians(40)
    R, zc = sphere(A, theta)
    case = Case(tmp_path, lower=(-2 * A, -2 * A, 0), upper=(2 * A, 2 * A, 2 * A), gravity=(0, 0, 0), deltaT=1e-6, endTime=1e-6,
                writeInterval=1)
    case.properties = {
        'engine': 'prescribed', 'output': ('csv',),
        'materials': {'glass': {'youngsModulus': 5e7, 'poissonsRatio': 0.29, 'density': 2500}},
        'insertion': {'colloid': {'type': 'packed', 'material': 'glass', 'number': 500, 'diameter': {'type': 'mono', 'value': d},
                                  'region': {'type': 'sphericalCap', 'centre': (0, 0, 0), 'axis': (0, 0, 1),
                                             'contactRadius': A, 'contactAngle': 40.0}}}}
    case.mesh()
    done = case.run('demFoam')
    assert done.code == 0, done.output
    rows = case.table(1e-6)
    x = np.array([rows[k] for k in 'xyz']).T
    assert len(x) == 500
    assert x[:, 2].min() >= d / 2 and np.linalg.norm(x - [0, 0, zc], axis=1).max() <= R - d / 2
    apart = np.linalg.norm(x[:, None] - x[None], axis=2) + np.eye(len(x))
    assert apart.min() >= d * (1 - 1e-9)
    assert x[:, 2].max() > 0.8 * (R + zc) - d and np.hypot(x[:, 0], x[:, 1]).max() > 0.8 * A


# --- A film

def film_case(path, h, wedge=True, **keywords):
    case = SurfaceCase(path, wedge=wedge, **keywords)
    case.motion = {'type': 'film', 'substrate': 'substrate' if wedge else 'zMin', 'thickness': float(h)}
    case.path.mkdir(exist_ok=True)
    case.mesh()
    zero = {'type': 'zeroGradient'}
    sides = {'"(substrate|top|side)"': zero, '"(front|back)"': {'type': 'wedge'}} if wedge else {'".*"': zero}
    case.write_dict('0/alpha.water', {'dimensions': '[0 0 0 0 0 0 0]', 'internalField': 'uniform 0',
                                      'boundaryField': sides}, 'volScalarField')
    return case


@pytest.mark.parametrize('share', [0.003, 0.5, 0.777])
@pytest.mark.parametrize('wedge', [True, False])
def test_film(tmp_path, wedge, share):
    """Layers of cells on a wedge and in a box: shares of cells and faces, area, distance."""
    H = 4.6 * A
    case = film_case(tmp_path, share * H, wedge, **({} if wedge else {'upper': (A, 1.1 * A, H), 'cells': (3, 4, 40)}))
    case.go()
    cells, faces, h = case.csv('cells'), case.csv('faces'), share * H
    edges = case.edges(1) if wedge else np.linspace(0, H, 41)
    j = np.searchsorted(edges, cells['z']) - 1
    low, high = edges[j], edges[j + 1]
    assert np.abs(cells['alpha'] - np.clip((h - low) / (high - low), 0, 1)).max() < 1e-11
    # The box' half is the end of a layer
    cut = (low < h * (1 - 1e-9)) & (h <= high * (1 + 1e-9))
    assert np.abs(cells['area'][cut] * (high - low)[cut] / cells['V'][cut] - 1).max() < 1e-9
    assert (cells['area'][~cut] == 0).all() and cut.sum() == (37 if wedge else 12)
    assert np.abs(cells['psi'] - (h - cells['z'])).max() < 1e-12 * A and (cells['nz'] == 1).all()
    assert (cells['curvature'] == 0).all() and (cells['inside'] == (cells['z'] < h)).all()
    ways = case.csv('crossing')
    assert (len(ways) > 10) == (share > 0.1) and np.abs(ways['z'] * (1 - ways['t']) + ways['w'] * ways['t'] - h).max(initial=0) < 1e-12 * A

    # Upright faces by height, level ones all or none
    level = np.array([np.abs(edges - v).min() < 1e-6 * A for v in faces['z']])
    assert (faces['alphaf'][level] == (faces['z'][level] < h * (1 - 1e-9))).all()
    k = np.searchsorted(edges, faces['z'][~level]) - 1
    wet = np.clip((h - edges[k]) / (edges[k + 1] - edges[k]), 0, 1)
    # The triangles at the sides of a wedge reach its axis: they have another share
    right = np.abs(faces['y'][~level]) < 1e-9 * A if wedge else np.ones(len(k), bool)
    assert right.sum() > 100 and np.abs(faces['alphaf'][~level] - wet)[right].max() < 1e-11


def test_film_in_oblique_cells(tmp_path):
    """Cells whose tops are inclined: the whole of volume and area to round-off, at any thickness."""
    for share in (0.01, 0.3, 0.61, 0.93):
        case = film_case(tmp_path / str(share), share * 4.6 * A)
        case.shear = 0.8 * A
        case.mesh()
        case.go()
        cells, h = case.csv('cells'), share * 4.6 * A
        base = case.size[0]**2 * np.sin(2 * HALF) / 2
        assert abs((cells['alpha'] * cells['V']).sum() / (base * h) - 1) < 1e-12
        assert abs(cells['area'].sum() / base - 1) < 1e-11
        assert ((cells['alpha'] > 0.01) & (cells['alpha'] < 0.99)).sum() > 30


def test_film_motion(tmp_path):
    """Thickness of every step, speed, means of faces; restart; two ranks; to the end."""
    H, h0 = 4.6 * A, 2 * A
    base = (4.1 * A)**2 * np.sin(2 * HALF) / 2
    lost = base * h0 * np.array([0.1, 0.2, -0.15, 0.3, 0.15, 0.1])
    full = film_case(tmp_path / 'full', h0, steps=6, lost=lost)
    half, two = full.copy(tmp_path / 'half'), full.copy(tmp_path / 'two')
    full.go()
    table = full.step_table()
    h = h0 * (1 - np.concatenate([[0], np.cumsum([0.1, 0.2, -0.15, 0.3, 0.15, 0.1])]))
    assert np.allclose(table['a'], h, rtol=1e-12, atol=0)
    assert np.allclose(table['held'], base * h, rtol=1e-11, atol=0)
    assert np.allclose(table['V'], np.pi * (4.1 * A)**2 * h, rtol=1e-11, atol=0)
    cells = full.csv('cells')
    assert np.allclose(cells['speed'], (h[-1] - h[-2]) / 1e-3, rtol=1e-10, atol=0)
    faces, edges = full.csv('faces'), full.edges(1)
    upright = np.array([np.abs(edges - v).min() > 1e-6 * A for v in faces['z']]) & (np.abs(faces['y']) < 1e-9 * A)
    k = np.searchsorted(edges, faces['z'][upright]) - 1
    wet = sum(np.clip((v - edges[k]) / (edges[k + 1] - edges[k]), 0, 1) for v in h[-2:]) / 2
    assert np.abs(faces['alphaf'][upright] - wet).max() < 1e-10

    for end in (3, 6):
        half.control.update(endTime=end * 1e-3, writeFormat='ascii', writePrecision=6)
        half.write()
        half.go()
    same(full.csv('cells'), half.csv('cells'), 1e-12)
    same(full.csv('faces'), half.csv('faces'), 1e-12)

    two.decompose(2)
    two.go(2)
    assert np.allclose(two.step_table()['a'], table['a'], rtol=1e-12, atol=0)
    other = two.csv('cells', 2)
    order = [np.lexsort((np.round(t['x'] / 1e-12), np.round(t['z'] / 1e-12))) for t in (cells, other)]
    same(cells[order[0]], other[order[1]], 1e-11)

    # All of it, and more
    full.control['startFrom'] = 'startTime'
    for more, words in ((0, 'film: dry'), (1e-18, 'neither loses nor gains')):
        full.lost = base * h0 * np.array([0.5, 0.4, 0.1, 0, 0, 0]) + [0, 0, 0, more, 0, 0]
        full.write()
        done = full.run('testSurface')
        assert (done.code == 0) == (more == 0) and words in done.output, done.output
    full.lost = base * h0 * np.array([0.5, 0.51, 0, 0, 0, 0])
    full.write()
    done = full.run('testSurface')
    assert done.code != 0 and 'was to lose' in done.output, done.output


FILM_BAD = {
    'noPatch': ({'substrate': 'floor'}, ('substrate', 'floor', 'no such patch', 'side')),
    'thickness': ({'thickness': -1.0}, ('thickness', 'greater than zero')),
    'unknownEntry': ({'contactAngle': 60.0}, ("Unknown entry 'contactAngle'", 'thickness')),
    'axis': ({'substrate': 'side'}, ('side', 'axis of the wedge')),
    'curved': ({'substrate': 'front'}, ('front', 'axis of the wedge')),
    'overflow': ({'thickness': 5 * A}, ('does not fit', 'upright')),
}


@pytest.mark.parametrize('name', FILM_BAD)
def test_film_bad_input(tmp_path, name):
    case = film_case(tmp_path, A)
    changes, words = FILM_BAD[name]
    case.motion.update(changes)
    case.write()
    done = case.run('testSurface')
    message = re.sub(r'\s+', ' ', done.output)
    assert done.code != 0 and message.count('FOAM FATAL') == 1, done.output
    assert all(word in message for word in words), done.output


def test_film_of_another_volume(tmp_path):
    """Fields and record of other runs are refused."""
    case = film_case(tmp_path, A, steps=2, lost=[0, 0])
    case.control.update(writeFormat='ascii')
    case.write()
    case.go()
    case.control['endTime'] = 3e-3
    case.lost = [0, 0, 0]
    case.write()
    record = case.path / '0.002' / 'uniform' / 'surface'
    text = record.read_text()
    record.write_text(re.sub(r'thickness +\S+;', f'thickness {1.1 * A};', text))
    done = case.run('testSurface')
    assert done.code != 0 and 'is not that of a film' in done.output, done.output
