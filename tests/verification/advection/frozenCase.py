"""Cases of frozenFlow: liquid in a flow given in closed form.

    case = FrozenCase(tmp_path, cells=(64, 64, 1), alpha=disc(64, (0.5, 0.75), 0.15), flow={'type': 'vortex', 'period': 8})
    result = case.solve()
    error = case.error()
"""
import numpy as np

from dewCase import SIDES, Case, foam_value
from fluidCase import FluidCase

COLUMNS = ['steps', 'start', 'end', 'low', 'high', 'moved', 'cut', 'advection', 'reconstruction']


def chord_area(x, y, r):
    """Area of a disc of radius r about the origin in the quadrant (-inf, x) (-inf, y)."""
    x, y = np.clip(x, -r, r), np.clip(y, -r, r)

    def half(h):                                # left of h
        return r**2*(np.pi - np.arccos(h/r)) + h*np.sqrt(np.maximum(r**2 - h**2, 0))

    def primitive(t):                           # of sqrt(r^2 - t^2)
        return 0.5*(t*np.sqrt(np.maximum(r**2 - t**2, 0)) + r**2*np.arcsin(np.clip(t/r, -1, 1)))

    w = np.sqrt(np.maximum(r**2 - y**2, 0))
    # Left of x: the disc below y is min(y, top) + bottom where the top is above -|y|
    inner = primitive(np.clip(x, -w, w)) - primitive(-w) + y*(np.clip(x, -w, w) + w)
    left = half(np.minimum(x, -w))
    right = half(np.maximum(x, w)) - half(w)
    return np.where(y >= 0, inner + left + right, inner)


def disc_in_boxes(x, y, centre, r):
    """Area of the disc in each box between the lines x and y, of the shape (ny, nx)."""
    a = chord_area(*np.meshgrid(x - centre[0], y - centre[1]), r)
    return a[1:, 1:] - a[1:, :-1] - a[:-1, 1:] + a[:-1, :-1]


def disc(n, centre, r, length=1.0):
    """Shares of the squares of a box of n x n."""
    lines = np.linspace(0, length, n + 1)
    return (disc_in_boxes(lines, lines, centre, r)/(length/n)**2).ravel().clip(0, 1)


def notched_disc(n, centre=(0.5, 0.75), r=0.15, width=0.06, depth=0.25, length=1.0):
    """Zalesak's disc: its slot, open at the bottom, ends depth above the lowest point."""
    lines = np.linspace(0, length, n + 1)
    whole = disc_in_boxes(lines, lines, centre, r)
    x = lines.clip(centre[0] - width/2, centre[0] + width/2)
    y = lines.clip(None, centre[1] - r + depth)
    return ((whole - disc_in_boxes(x, y, centre, r))/(length/n)**2).ravel().clip(0, 1)


def sphere(n, centre, r, length=1.0):
    """Shares of the cubes of a box of n x n x n, by Gauss' rule along z."""
    lines = np.linspace(0, length, n + 1)
    points, weights = np.polynomial.legendre.leggauss(10)
    h = length/n
    shares = np.zeros((n, n, n))
    for k in range(n):
        low, high = max(k*h, centre[2] - r), min((k + 1)*h, centre[2] + r)
        for p, w in zip(points, weights):
            if high > low:
                z = 0.5*(low + high) + 0.5*(high - low)*p
                rho = np.sqrt(max(r**2 - (z - centre[2])**2, 0))
                shares[k] += 0.5*(high - low)*w*disc_in_boxes(lines, lines, centre, rho) if rho > 0 else 0
    return (shares/h**3).ravel().clip(0, 1)


class FrozenCase(FluidCase):
    """A box with liquid in a frozen flow; flat along z if it has one cell there."""

    def __init__(self, path, cells, alpha, flow, length=1.0, reconstruction=None, solids=None, entries=None,
                 patches=tuple(SIDES), **keywords):
        self.flat, self.names = cells[2] == 1, patches
        upper = tuple(length*n/cells[0] for n in cells)
        super().__init__(path, upper=upper, cells=cells,
                         **{'application': 'frozenFlow', 'writePrecision': 16, 'writeInterval': 100000, **keywords})
        self.alpha, self.flow = np.asarray(alpha, dtype=float), flow
        self.entries = dict(entries or {}, **({'solids': solids} if solids else {}))
        self.reconstruction = reconstruction

    def write(self):
        Case.write(self)
        surface = {'liquid': 'water', 'surfaceMotion': {'type': 'isoAdvector'}}
        if self.reconstruction:
            surface['reconstruction'] = self.reconstruction
        self.write_dict('constant/surfaceProperties', surface)
        self.write_dict('constant/frozenFlow', {'flow': self.flow, **self.entries})
        self.write_fields()

    def write_fields(self):
        """Shares and a velocity whose values the program sets."""
        def patches(kind):
            return {name: {'type': 'cyclic' if name[0] in self.cyclic else
                           'empty' if name == 'axis' or self.flat and name[0] == 'z' else
                           'wedge' if name in ('front', 'back') else kind} for name in self.names}

        self.write_dict('0/alpha.water', {
            'dimensions': '[0 0 0 0 0 0 0]', 'boundaryField': patches('zeroGradient'),
            'internalField': f'nonuniform List<scalar> {len(self.alpha)} {foam_value(self.alpha)}'}, 'volScalarField')
        velocity = patches('fixedValue')
        for patch in velocity.values():
            if patch['type'] == 'fixedValue':
                patch['value'] = 'uniform (0 0 0)'
        self.write_dict('0/U', {'dimensions': '[0 1 -1 0 0 0 0]', 'boundaryField': velocity,
                                'internalField': 'uniform (0 0 0)'}, 'volVectorField')

    def write_block_mesh(self):
        super().write_block_mesh()
        if self.flat:
            path = self.path / 'system/blockMeshDict'
            text = path.read_text()
            for name in ('zMin', 'zMax'):
                head, tail = text.split(f'{name}\n', 1)
                text = f'{head}{name}\n' + tail.replace('wall', 'empty', 1)
            path.write_text(text)

    def solve(self, ranks=1, timeout=600):
        """Run; the values of the last line of the log."""
        result = self.run('frozenFlow', ranks=ranks, timeout=timeout)
        assert result.code == 0, result.output
        line = next(row for row in result.output.splitlines() if row.startswith('result '))
        return dict(zip(COLUMNS, map(float, line.split()[1:])))

    def shares(self, ranks=1):
        """At the end."""
        time = self.times('processor0' if ranks > 1 else '.')[-1]
        return self.joined_field('alpha.water', time, ranks)

    def error(self):
        """Sum |alpha - start|/sum start."""
        return np.abs(self.shares() - self.alpha).sum()/self.alpha.sum()
