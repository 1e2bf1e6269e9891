"""Cases of interEvapDemFoam in a column one cell wide, with a surface that the flow carries; and their closed forms.

    case = ColumnCase(tmp_path, cells=100, length=5e-3, surface=0.5e-3)     # gas below the surface, liquid above it
    case = ColumnCase(tmp_path, cells=75, length=1.5e-3, surface=0.5e-3, gas_first=False)
    case.T = lambda x: ...                                                  # or a number; alpha and Y likewise
    case.T_low = 378.15
    case.mesh()
    output = case.go()
    x = case.positions(output)

Distances are along the column from the patch low, a wall, to the patch high, that is open, or with closed=True a wall
that lets no heat through.
"""
import re
from math import erf, erfc, exp, pi, sqrt

import numpy as np

from dewCase import Case, foam_dict, foam_value

P0 = 101325

# The liquid and its vapour of the Stefan problem (A) and of the sucking interface
STEAM = {'k': 0.025, 'rho': 0.581, 'Cp': 2030, 'hv': 2.26e6, 'Tsat': 373.15}
BOILING = {'k': 0.671, 'rho': 958.4, 'Cp': 4216}


def root(function, low, high):
    """Of a function that rises."""
    for _ in range(200):
        mid = (low + high) / 2
        low, high = (low, mid) if function(mid) > 0 else (mid, high)
    return low


class Stefan:
    """Gas that a wall superheats by dT, between it and liquid at its boiling point: x = 2 lambda sqrt(a t)."""

    def __init__(self, dT=5, gas=None):
        g = {**STEAM, **(gas or {})}
        self.dT, self.gas = dT, g
        self.a = g['k'] / (g['rho'] * g['Cp'])
        self.growth = root(lambda s: s * exp(s * s) * erf(s) - g['Cp'] * dT / (sqrt(pi) * g['hv']), 1e-9, 5)

    def x(self, t):
        return 2 * self.growth * np.sqrt(self.a * t)

    def time(self, x):
        return (x / (2 * self.growth))**2 / self.a

    def T(self, x, t):
        s = np.array([erf(y) for y in np.atleast_1d(x / (2 * sqrt(self.a * t)))]) / erf(self.growth)
        return self.gas['Tsat'] + self.dT * np.maximum(1 - s, 0)


class Sucking:
    """Liquid superheated by dT far away, gas at the boiling point: x = 2 beta sqrt(a t)."""

    def __init__(self, dT=5):
        g, l = STEAM, BOILING
        self.dT = dT
        self.a, self.aL = g['k'] / (g['rho'] * g['Cp']), l['k'] / (l['rho'] * l['Cp'])
        self.ratio = g['rho'] / l['rho']
        self.stretch = sqrt(self.a / self.aL)

        def excess(b):
            s = b * self.ratio * self.stretch
            return b - dT * g['Cp'] * l['k'] * sqrt(self.a) * exp(-s * s) / (
                g['hv'] * g['k'] * sqrt(pi * self.aL) * erfc(s))
        self.growth = root(excess, -5, 5)

    def x(self, t):
        return 2 * self.growth * np.sqrt(self.a * t)

    def T(self, x, t):
        shift = self.growth * (self.ratio - 1) * self.stretch
        far = erfc(self.growth * self.ratio * self.stretch)
        s = np.array([erfc(y) for y in x / (2 * sqrt(self.aL * t)) + shift])
        return STEAM['Tsat'] + np.where(x < self.x(t), 0, self.dT * np.maximum(1 - s / far, 0))


class ColumnCase(Case):
    """Liquid water; patches low, high and sides."""

    def __init__(self, path, cells, length, surface, gas_first=True, mirrored=False, grading=1, closed=False, **control):
        super().__init__(path, **{'application': 'interEvapDemFoam', 'gravity': (0, 0, 0), 'writeFormat': 'ascii',
                                  'writePrecision': 17, 'timePrecision': 12, 'writeInterval': 100000, **control})
        self.closed = closed
        self.n, self.length, self.surface, self.gas_first, self.mirrored = cells, length, surface, gas_first, mirrored
        self.edges = np.linspace(0, length, cells + 1)
        if grading != 1:
            r = grading**(1 / (cells - 1))
            self.edges = length * (r**np.arange(cells + 1) - 1) / (r**cells - 1)
        self.grading = grading
        self.width = length / cells
        self.law, self.energy, self.transient = {'type': 'interfaceEquilibrium'}, True, True
        g, l = STEAM, BOILING
        self.liquid = {'type': 'constant', 'name': 'water', 'W': 18.015, 'rho': l['rho'], 'mu': 2.82e-4, 'Cp': l['Cp'],
                       'kappa': l['k'], 'hv': g['hv'], 'sigma': 0.0588, 'Tboil': g['Tsat'], 'pBoil': P0}
        self.gas = {'type': 'constant', 'p0': P0, 'Wc': 18.015, 'rho': g['rho'], 'D': 2e-5, 'Cp': g['Cp'],
                    'kappa': g['k'], 'mu': 1.23e-5}
        self.T, self.T_low, self.T_high, self.Y, self.Y_high = g['Tsat'], g['Tsat'], g['Tsat'], None, 0.0
        self.properties = {'engine': 'none', 'coupling': {'voidFraction': {'type': 'none'}, 'momentum': 'none',
                                                          'forces': {}}}

    @property
    def centres(self):
        return (self.edges[1:] + self.edges[:-1]) / 2

    def scale(self, factor):
        """All lengths by a factor; times go by its square."""
        for name in ('length', 'surface', 'width', 'edges'):
            setattr(self, name, getattr(self, name) * factor)
        for name in ('endTime', 'deltaT'):
            self.control[name] *= factor**2

    def write_block_mesh(self):
        L, w = self.length, self.width
        low, high = ('(1 2 6 5)', '(0 4 7 3)') if self.mirrored else ('(0 4 7 3)', '(1 2 6 5)')
        grading = 1 / self.grading if self.mirrored else self.grading
        kind = 'wall' if self.closed else 'patch'
        self.write_dict('system/blockMeshDict', {
            'scale': 1, 'vertices': [(0, 0, 0), (L, 0, 0), (L, w, 0), (0, w, 0), (0, 0, w), (L, 0, w), (L, w, w), (0, w, w)],
            'blocks': f'(hex (0 1 2 3 4 5 6 7) ({self.n} 1 1) simpleGrading ({grading!r} 1 1))',
            'boundary': f'(low {{type wall; faces ({low});}} high {{type {kind}; faces ({high});}} '
                        'sides {type empty; faces ((0 1 5 4) (3 7 6 2) (0 3 2 1) (4 5 6 7));})'})

    def values(self, value):
        v = value(self.centres) if callable(value) else np.broadcast_to(value, self.n)
        v = v[::-1] if self.mirrored else v
        return f'nonuniform List<scalar> {self.n}(' + ' '.join(repr(float(x)) for x in v) + ')'

    def field_file(self, name, dimensions, internal, low, high, kind='volScalarField'):
        self.write_dict(f'0/{name}', {'dimensions': dimensions, 'internalField': internal, 'boundaryField': {
            'low': low, 'high': high, 'sides': {'type': 'empty'}}}, kind)

    def write(self):
        super().write()
        same = {'type': 'zeroGradient'}
        no_slip, no_flux = {'type': 'noSlip'}, {'type': 'fixedFluxPressure', 'value': 'uniform 0'}
        wet = np.clip((self.edges[1:] - self.surface) / np.diff(self.edges), 0, 1)
        alpha = wet if self.gas_first else np.clip((self.surface - self.edges[:-1]) / np.diff(self.edges), 0, 1)
        if not (self.path / '0').exists():
            self.field_file('T', '[0 0 0 1 0 0 0]', self.values(self.T),
                            {'type': 'fixedValue', 'value': f'uniform {self.T_low!r}'} if self.T_low else same,
                            same if self.closed else
                            {'type': 'inletOutlet' if self.gas_first else 'fixedValue',
                             'inletValue': f'uniform {self.T_high!r}', 'value': f'uniform {self.T_high!r}'})
            self.field_file('U', '[0 1 -1 0 0 0 0]', 'uniform (0 0 0)', no_slip, no_slip if self.closed else
                            {'type': 'pressureInletOutletVelocity', 'value': 'uniform (0 0 0)'}, 'volVectorField')
            self.field_file('p_rgh', '[1 -1 -2 0 0 0 0]', 'uniform 0', no_flux, no_flux if self.closed else
                            {'type': 'fixedValue', 'value': 'uniform 0'})
            self.field_file('alpha.water', '[0 0 0 0 0 0 0]', self.values(lambda x: alpha), same, same)
            if self.Y is not None:
                self.field_file('Y.water', '[0 0 0 0 0 0 0]', self.values(self.Y), same, same if self.closed else
                                {'type': 'fixedValue', 'value': f'uniform {self.Y_high!r}'})
        self.write_dict('constant/liquidProperties', self.liquid)
        self.write_dict('constant/gasProperties', self.gas)
        self.write_dict('constant/phaseChangeProperties', {
            'evaporation': self.law, 'energy': self.energy, 'gas': 'transient' if self.transient else 'quasiSteady'})
        self.write_dict('constant/surfaceProperties', {
            'liquid': 'water', 'surfaceMotion': {'type': 'isoAdvector'}, 'surfaceTension': {'sigma': 0},
            'curvature': {'type': 'gradAlpha'}})
        self.write_dict('constant/turbulenceProperties', {'simulationType': 'laminar'})
        self.write_dict('system/fvSchemes', {
            'ddtSchemes': {'default': 'Euler'}, 'gradSchemes': {'default': 'Gauss linear'},
            'divSchemes': {'default': 'none', 'div(rhoPhi,U)': 'Gauss upwind', '"div\\(\\(\\(\\(?alphacRho.*"': 'Gauss linear'},
            'laplacianSchemes': {'default': 'Gauss linear corrected'},
            'interpolationSchemes': {'default': 'linear'}, 'snGradSchemes': {'default': 'corrected'}})
        symmetric = {'solver': 'PCG', 'preconditioner': 'DIC', 'tolerance': 1e-15, 'relTol': 0, 'maxIter': 5000}
        other = {'solver': 'PBiCG', 'preconditioner': 'DILU', 'tolerance': 1e-15, 'relTol': 0}
        self.write_dict('system/fvSolution', {
            'solvers': {'"(chi|extension|p_rgh).*"': symmetric, '"(Y.*|T|U).*"': other, '"alpha.*"': {'nLimiterIter': 3}},
            'PIMPLE': {'momentumPredictor': False, 'nOuterCorrectors': 1, 'nCorrectors': 2,
                       **({'pRefCell': 0, 'pRefValue': 0} if self.closed else {})},
            'gas': {'nCorrectors': 30, 'tolerance': 1e-11}})

    def go(self, ranks=1, timeout=120):
        done = self.run('interEvapDemFoam', ranks=ranks, timeout=timeout)
        assert done.code == 0, done.output[-4000:]
        return done.output

    def volumes(self, output):
        """Of the liquid, after each step [m3]."""
        steps = re.split(r'^Time = \S+\n', output, flags=re.M)[1:]
        found = [re.findall(r'^alpha\.water: volume (\S+)', step, re.M) for step in steps]
        return np.array([float(v[-1]) for v in found])

    def positions(self, output):
        """Distance of the surface from the patch low, after each step [m]."""
        x = self.volumes(output) / self.width**2
        return self.length - x if self.gas_first else x

    def ledger(self, start='0'):
        path = self.path / 'postProcessing' / 'evaporation' / start / 'ledger.dat'
        names = [re.sub(r'\W.*', '', name) for name in path.read_text().splitlines()[0].split()[1:]]
        return np.rec.fromarrays(np.loadtxt(path, ndmin=2).T, names=names)

    def heat(self, start='0'):
        """Columns of heat.dat, and how far each step is from closing, of the largest [-]"""
        rows = np.loadtxt(self.path / 'postProcessing' / 'evaporation' / start / 'heat.dat', ndmin=2).T
        stored, into, latent, moved = rows[1:]
        error = np.abs(stored - into + latent - moved)
        return rows, error / np.max(np.abs(rows[1:]), axis=0)

    def errors(self, output):
        """Of the balance, relative, of every step in a log"""
        return np.array(re.findall(r'^evaporated .*? error (\S+);', output, re.M), dtype=float)
