"""Cases of solvers with a fluid: a Case with fields, schemes and transport properties.

    case = FluidCase(tmp_path, upper=(...), cells=(...), cyclic='xyz', endTime=1e-2, deltaT=1e-3)
    case.fields['U'] = '(0.1 0 0)'                  # uniform
    case.patches['U'] = {'zMin': {'type': 'fixedValue', 'value': 'uniform (0 0 0.1)'}}
    case.properties = {..., 'coupling': case.coupling('Stokes')}
    case.mesh(); case.run('cfdDemFoam')
    ledger = case.ledger()
"""
import re

import numpy as np

from dewCase import SIDES, Case, foam_value, quoted

DIMENSIONS = {'U': '[0 1 -1 0 0 0 0]', 'p': '[0 2 -2 0 0 0 0]', 'T': '[0 0 0 1 0 0 0]'}

# Columns of postProcessing/exchange/<start>/ledger.dat
LEDGER = ['time', 'held', 'represented', 'clipped', 'outside', 'rx', 'ry', 'rz', 'lx', 'ly', 'lz', 'scale',
          'heatReceived', 'heatLost', 'heatScale', 'lagging']


def read_field(path):
    """Internal values of an ascii field."""
    text = path.read_text()
    uniform = re.search(r'internalField\s+uniform\s+(.*?);', text)
    if uniform:
        return np.array(uniform[1].strip('()').split(), dtype=float)
    body = re.search(r'internalField\s+nonuniform\s+List<\w+>\s*\d+\s*\((.*?)\)\s*;', text, re.S)[1]
    values = np.array(body.replace('(', ' ').replace(')', ' ').split(), dtype=float)
    return values.reshape(-1, 3) if 'List<vector>' in text else values


class FluidCase(Case):
    """A box of fluid with particles."""

    def __init__(self, path, rho=1000, nu=1e-6, tolerance=1e-10, outer=1, pressure_correctors=2, **keywords):
        super().__init__(path, **{'application': 'cfdDemFoam', **keywords})
        self.transport = {'transportModel': 'Newtonian', 'nu': f'[0 2 -1 0 0 0 0] {nu!r}', 'rho': rho}
        self.fields = {'U': '(0 0 0)', 'p': '0'}
        self.patches = {}
        self.tolerance, self.outer, self.pressure_correctors = tolerance, outer, pressure_correctors
        self.convection = 'Gauss linear'

    @staticmethod
    def coupling(drag, void_fraction='divided', pressure=True, **entries):
        """The sub-dictionary coupling with one drag law."""
        forces = {'drag': {'type': drag}}
        if pressure:
            forces['pressure'] = {'type': 'pressureGradientForce'}
        return {'voidFraction': {'type': void_fraction}, 'forces': forces, **entries}

    def write(self):
        """Dictionaries and fields."""
        super().write()
        self.write_dict('system/fvSchemes', {
            'ddtSchemes': {'default': 'Euler'},
            'gradSchemes': {'default': 'Gauss linear'},
            'divSchemes': {'default': self.convection, 'div(((alphac*nuEff)*dev2(T(grad(U)))))': 'Gauss linear'},
            'laplacianSchemes': {'default': 'Gauss linear corrected'},
            'interpolationSchemes': {'default': 'linear'},
            'snGradSchemes': {'default': 'corrected'}})
        linear = {'solver': 'PBiCGStab', 'preconditioner': 'DILU', 'tolerance': self.tolerance, 'relTol': 0}
        pressure = {'solver': 'PCG', 'preconditioner': 'DIC', 'tolerance': self.tolerance, 'relTol': 0}
        scalars = ''.join('|' + name for name in self.fields if name not in DIMENSIONS)
        self.write_dict('system/fvSolution', {
            'solvers': {'"p.*"': pressure, f'"(U|T|k|epsilon{scalars}).*"': linear},
            'PIMPLE': {'nOuterCorrectors': self.outer, 'nCorrectors': self.pressure_correctors,
                       'nNonOrthogonalCorrectors': 0, 'pRefCell': 0, 'pRefValue': 0}})
        self.write_dict('constant/transportProperties', self.transport)
        self.write_dict('constant/turbulenceProperties', {'simulationType': 'laminar'})
        for name, value in self.fields.items():
            self.write_field(name, value)

    def write_field(self, name, value):
        """A uniform field, or one of a list of values; walls: no slip, zero gradient of p and all others [mol/m3]."""
        default = {'U': {'type': 'noSlip'}, 'p': {'type': 'fixedFluxPressure', 'value': 'uniform 0'}}.get(
            name, {'type': 'zeroGradient'})
        boundary = {}
        for patch in SIDES:
            boundary[patch] = {'type': 'cyclic'} if patch[0] in self.cyclic else default
        boundary.update(self.patches.get(name, {}))
        kind = 'volVectorField' if name == 'U' else 'volScalarField'
        if isinstance(value, str):
            internal = f'uniform {value}'
        else:
            internal = f'nonuniform List<{"vector" if name == "U" else "scalar"}> {len(value)} {foam_value(value)}'
        self.write_dict(f'0/{name}', {'dimensions': DIMENSIONS.get(name, '[0 -3 0 0 1 0 0]'), 'internalField': internal,
                                      'boundaryField': boundary}, kind)

    def decompose(self, ranks, method='simple'):
        """Cut the mesh: simple along x, hierarchical along y first, or scotch."""
        split = (ranks, 1, 1) if ranks < 4 else (2, 2, 1)
        self.write_dict('system/decomposeParDict', {
            'numberOfSubdomains': ranks, 'method': method,
            'simpleCoeffs': {'n': (ranks, 1, 1), 'delta': 1e-3},
            'hierarchicalCoeffs': {'n': split, 'delta': 1e-3, 'order': 'yxz'}})
        self._must('decomposePar', '-force')

    def joined_field(self, name, time, ranks):
        """Internal values of an ascii field of a run on some ranks, in the order of the whole mesh."""
        if ranks == 1:
            return self.field(name, time)
        parts, cells = [], []
        for rank in range(ranks):
            folder = self.path / f'processor{rank}'
            text = (folder / 'constant/polyMesh/cellProcAddressing').read_text()
            cells.append(np.array(re.search(r'\n\d+\s*\(([\d\s]*)\)', text)[1].split(), dtype=int))
            values = self.field(name, time, folder.name)
            uniform = len(values) != len(cells[-1])
            parts.append(np.broadcast_to(values, (len(cells[-1]),) + values.shape).squeeze() if uniform else values)
        return np.concatenate(parts)[np.argsort(np.concatenate(cells))]

    def ledger(self, start='0'):
        """The balance of every step, a structured array with the columns LEDGER, then those of scalars."""
        path = self.path / 'postProcessing' / 'exchange' / start / 'ledger.dat'
        rows = np.loadtxt(path, ndmin=2)
        scalars = path.read_text().split('\n')[0].split()[len(LEDGER) + 1:]
        return np.rec.fromarrays(rows.T, names=LEDGER + scalars)

    def field(self, name, time, folder='.'):
        """Internal values of an ascii field."""
        return read_field(self.path / folder / str(time) / name)
