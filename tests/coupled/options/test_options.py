"""fvOptions with two fluids: sources of momentum, porosity, constraints; what no equation asks for is refused.

Two layers, water below air, that slide over each other without friction: each moves as its own density and viscosity say.
Expected: closed forms of one layer. Tolerances: of the pressure solver, and of nonlinear terms after some relaxation times.
"""
import numpy as np
import pytest

from dewCase import SIDES
from twoFluidCase import TwoFluidCase

RHO, MU = (1000.0, 1.2), (1e-3, 1.8e-5)
N = 8


class Layers(TwoFluidCase):
    """Water and air between slippery plates, cyclic along x and y, without particles."""

    def __init__(self, path, options, mu=MU, predictor='yes', zone='', **keywords):
        super().__init__(path, **{'level': 0.5e-2, 'upper': (1e-2, 1e-2, 1e-2), 'cells': (4, 1, N), 'cyclic': 'xy', 'mu': mu,
                                  'gravity': (0, 0, 0), 'deltaT': 1e-3, 'endTime': 0.02, 'writeFormat': 'ascii',
                                  'writePrecision': 16, 'writeInterval': 20, 'tolerance': 1e-13, **keywords})
        self.options = options
        self.predictor, self.zone = predictor, zone

    def write(self):
        super().write()
        (self.path/'constant/particleProperties').unlink()
        self.write_dict('system/fvOptions', self.options)
        path = self.path/'system/fvSolution'
        path.write_text(path.read_text().replace('PIMPLE\n{', f'PIMPLE\n{{\n    momentumPredictor {self.predictor};'))

    def write_block_mesh(self):
        super().write_block_mesh()
        path = self.path/'system/blockMeshDict'
        path.write_text(path.read_text().replace('6 7) (', f'6 7) {self.zone} ('))


def solved(case):
    """Velocities along x at the end: of the cells of water, of air."""
    case.mesh()
    result = case.run('interDemFoam')
    assert result.code == 0, result.output[-3000:]
    U = case.field('U', case.times()[-1])[:, 0].reshape(N, 4)
    return U[:N//2], U[N//2:], result.output


def force(Su, Sp=0, selection='all'):
    """A force of a volume [N/m3], and its part with U [N s/m4]."""
    return {'type': 'vectorSemiImplicitSource', 'selectionMode': selection, 'volumeMode': 'specific',
            'injectionRateSuSp': {'U': f'(({Su} 0 0) {Sp})'}}


@pytest.mark.parametrize('predictor', ['yes', 'no'])
def test_force_accelerates_each_fluid_by_its_density(tmp_path, predictor):
    """Without viscosity: U = s t/rho."""
    s = 10.0
    case = Layers(tmp_path, {'push': force(s)}, mu=(1e-30, 1e-30), predictor=predictor)
    water, air, _ = solved(case)
    assert np.abs(water/(s*0.02/RHO[0]) - 1).max() < 1e-9
    assert np.abs(air/(s*0.02/RHO[1]) - 1).max() < 1e-9
