"""Cases of interDemFoam: a FluidCase with two fluids and the surface between them.

    case = TwoFluidCase(tmp_path, upper=(...), cells=(...), level=0.02, endTime=1e-2, deltaT=1e-4)
    case.properties = {..., 'coupling': case.coupling('SchillerNaumann')}
    case.mesh(); result = case.run('interDemFoam')
    volumes = liquid_volumes(result.output)
"""
import re

import numpy as np

from dewCase import SIDES
from fluidCase import DIMENSIONS, FluidCase

DIMENSIONS.update({'p_rgh': '[1 -1 -2 0 0 0 0]', 'alpha.water': '[0 0 0 0 0 0 0]'})

SURFACE = re.compile(r'^alpha\.water: volume (\S+) m3, from (\S+) to 1 ([+-]) (\S+)', re.M)
UNBALANCED = re.compile(r'unbalanced (\S+?),?\s')


def liquid_volumes(output):
    """Volume of the liquid after each step [m3]."""
    return np.array([float(v) for v, *_ in SURFACE.findall(output)])


def beyond_bounds(output):
    """How far alpha went below 0 or above 1."""
    rows = SURFACE.findall(output)
    return max(max(-float(low), float(over) if sign == '+' else 0) for _, low, sign, over in rows)


def unbalanced(output):
    """Momentum that particles received less what the fluids lost, over the sum of magnitudes; the worst step."""
    return max(float(u) for u in UNBALANCED.findall(output))


class TwoFluidCase(FluidCase):
    """A box of water up to some height, air above, with particles."""

    def __init__(self, path, level, rho=(1000, 1.2), mu=(1e-3, 1.8e-5), sigma=0.0, motion='isoAdvector', **keywords):
        super().__init__(path, **{'application': 'interDemFoam', 'pressure_correctors': 3, **keywords})
        z = np.linspace(self.lower[2], self.upper[2], self.cells[2] + 1)
        share = np.clip((level - z[:-1])/np.diff(z), 0, 1)
        self.fields = {'U': '(0 0 0)', 'p_rgh': '0',
                       'alpha.water': np.repeat(share, self.cells[0]*self.cells[1])}
        self.transport = {'phases': ('water', 'air'), **{
            name: {'transportModel': 'Newtonian', 'nu': mu[k]/rho[k], 'rho': rho[k]}
            for k, name in enumerate(('water', 'air'))}}
        self.surface = {'liquid': 'water', 'surfaceMotion': {'type': motion},
                        'surfaceTension': {'sigma': sigma}}
        self.convection = 'Gauss linearUpwind grad(U)'
        self.patches['p_rgh'] = {side: {'type': 'fixedFluxPressure', 'value': 'uniform 0'}
                                 for side in SIDES if side[0] not in self.cyclic}
        self.patches['U'] = {side: {'type': 'slip'} for side in SIDES if side[0] not in self.cyclic}

    def write(self):
        """Dictionaries and fields."""
        super().write()
        path = self.path/'system/fvSchemes'
        path.write_text(path.read_text().replace(
            'div(((alphac*nuEff)*dev2(T(grad(U)))))', '"div\\(\\(\\(\\(?alphacRho.*"'))
        path = self.path/'system/fvSolution'
        path.write_text(path.read_text().replace('    "p.*"', '    "alpha.*"\n    {\n        nLimiterIter 3;\n    }\n    "p.*"', 1))
        self.write_dict('constant/surfaceProperties', self.surface)
