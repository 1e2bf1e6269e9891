"""A gas bubble or a drop in a flat box without gravity: cases of interDemFoam without particles.

    case = BubbleCase(tmp_path, n=40, force='levelSetCSF', distance='levelSet', curvature='levelSet')
    case.mesh()
    speeds = case.solve()
"""
import pathlib
import re
import sys

import numpy as np

from dewCase import SIDES
from fluidCase import DIMENSIONS, FluidCase

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent / 'advection'))
from frozenCase import disc_in_boxes  # noqa: E402

DIMENSIONS.update({'p_rgh': '[1 -1 -2 0 0 0 0]', 'alpha.water': '[0 0 0 0 0 0 0]'})

# Both fluids, of the bubble
RHO, MU, SIGMA, RADIUS = (1000, 1), (10, 0.1), 1.96, 0.25


class BubbleCase(FluidCase):
    """A box of 1 m x 2 m, no slip at bottom and top; a disc of gas of radius 0.25 m at (0.5, 0.5)."""

    def __init__(self, path, n, distance, curvature, force='CSF', height=2, scale=1.0, **keywords):
        cells = (n, height*n, 1)
        super().__init__(path, upper=(scale, height*scale, scale/n), cells=cells, gravity=(0, 0, 0), tolerance=1e-12,
                         pressure_correctors=3, **{'application': 'interDemFoam', 'writeFormat': 'ascii',
                                                   'writePrecision': 16, **keywords})
        x, y = np.linspace(0, 1, n + 1), np.linspace(0, height, height*n + 1)
        share = 1 - (disc_in_boxes(x, y, (0.5, 0.5), RADIUS)*n**2).ravel().clip(0, 1)
        self.properties = {'engine': 'none', 'coupling': {'voidFraction': {'type': 'none'}, 'forces': {}}}
        self.fields = {'U': '(0 0 0)', 'p_rgh': '0', 'alpha.water': share}
        self.transport = {'phases': ('water', 'air'), **{
            name: {'transportModel': 'Newtonian', 'nu': MU[k]/RHO[k], 'rho': RHO[k]}
            for k, name in enumerate(('water', 'air'))}}
        # A number is the curvature to prescribe
        self.surface = {'liquid': 'water', 'surfaceMotion': {'type': 'isoAdvector'}, 'distance': {'type': distance},
                        'curvature': {'type': curvature} if isinstance(curvature, str)
                        else {'type': 'prescribed', 'K': curvature},
                        'surfaceTension': {'type': force, 'sigma': SIGMA}}
        self.convection = 'Gauss linearUpwind grad(U)'
        flat = {side: {'type': 'empty'} for side in ('zMin', 'zMax')}
        self.patches = {
            'U': {'xMin': {'type': 'slip'}, 'xMax': {'type': 'slip'}, **flat}, 'alpha.water': flat,
            'p_rgh': {**{side: {'type': 'fixedFluxPressure', 'value': 'uniform 0'} for side in SIDES}, **flat}}

    def write(self):
        super().write()
        path = self.path/'system/fvSchemes'
        path.write_text(path.read_text().replace(
            'div(((alphac*nuEff)*dev2(T(grad(U)))))', '"div\\(\\(\\(\\(?alphacRho.*"'))
        self.write_dict('constant/surfaceProperties', self.surface)
        # A predictor with the pressure of the start, zero, would set the fluids in motion
        path = self.path/'system/fvSolution'
        path.write_text(path.read_text().replace('nOuterCorrectors', 'momentumPredictor no;\n    nOuterCorrectors'))

    def write_block_mesh(self):
        super().write_block_mesh()
        path = self.path/'system/blockMeshDict'
        text = path.read_text()
        for name in ('zMin', 'zMax'):
            head, tail = text.split(f'{name}\n', 1)
            text = f'{head}{name}\n' + tail.replace('wall', 'empty', 1)
        path.write_text(text)

    def solve(self, ranks=1, timeout=3600):
        """Run; the greatest speed of each step [m/s]. Keeps how far the level set is off the planes, in cells."""
        result = self.run('interDemFoam', ranks=ranks, timeout=timeout)
        assert result.code == 0, result.output
        self.displacements = np.array(re.findall(r'off the planes by (\S+) dx', result.output), dtype=float)
        return np.array(re.findall(r'^Flow: at most (\S+) m/s', result.output, re.M), dtype=float)
