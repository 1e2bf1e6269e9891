"""A shallow layer of water under a gas without friction, warmer on the left: away from the ends it flows, without net flux,

    U = g beta G h^3/(48 nu) (8 s^3 - 15 s^2 + 6 s),      s = y/h

with G, the gradient of the temperature, negative here: the solution of nu U''' = g beta G with U = 0 below and U' = 0 above, by hand.
Density of water at 295 and 305 K by Tanaka et al., Metrologia 38 (2001) 301: 997.777 and 995.031 kg/m3; its viscosity
here is what the solver says it is.
"""
import re

import numpy as np
import pytest

from columnCase import ColumnCase
from dewCase import run_command
from fluidCase import read_field

H, LENGTH, COLD, HOT = 0.5e-3, 3e-3, 295.0, 305.0
NX, NY = 48, 15


class Layer(ColumnCase):
    """Two thirds of the height are water; patches left, right, bottom, top, sides"""

    def __init__(self, path, **control):
        super().__init__(path, 1, LENGTH, H, gravity=(0, -9.81, 0), endTime=0.8, deltaT=4e-4, writeInterval=2000, **control)
        self.law = {'type': 'none'}
        self.liquid = {'type': 'library', 'liquid': 'H2O'}
        self.gas = {'type': 'constant', 'p0': 101325, 'Wc': 28.96, 'rho': 1.2, 'D': 2e-5, 'Cp': 1000, 'kappa': 0.6,
                    'mu': 1e-8}

    def write_block_mesh(self):
        L, h, w = LENGTH, 1.5 * H, 1e-4
        self.write_dict('system/blockMeshDict', {
            'scale': 1, 'vertices': [(0, 0, 0), (L, 0, 0), (L, h, 0), (0, h, 0), (0, 0, w), (L, 0, w), (L, h, w), (0, h, w)],
            'blocks': f'(hex (0 1 2 3 4 5 6 7) ({NX} {NY} 1) simpleGrading (1 1 1))',
            'boundary': '(left {type wall; faces ((0 4 7 3));} right {type wall; faces ((1 2 6 5));} '
                        'bottom {type wall; faces ((0 1 5 4));} top {type wall; faces ((3 7 6 2));} '
                        'sides {type empty; faces ((0 3 2 1) (4 5 6 7));})'})

    def file(self, name, dimensions, values, patches, kind='volScalarField'):
        self.write_dict(f'0/{name}', {'dimensions': dimensions, 'internalField': values,
                                      'boundaryField': {'sides': {'type': 'empty'}, **patches}}, kind)

    def write(self):
        super().write()
        x, y = np.meshgrid((np.arange(NX) + 0.5) / NX, np.arange(NY))
        listed = 'nonuniform List<scalar> {}({})'
        T = listed.format(NX * NY, ' '.join(repr(float(v)) for v in (HOT + (COLD - HOT) * x).ravel()))
        alpha = listed.format(NX * NY, ' '.join(str(int(v < NY * 2 // 3)) for v in y.ravel()))
        walls, same = '"(left|right|bottom|top)"', {'type': 'zeroGradient'}
        self.file('T', '[0 0 0 1 0 0 0]', T, {
            'left': {'type': 'fixedValue', 'value': f'uniform {HOT}'},
            'right': {'type': 'fixedValue', 'value': f'uniform {COLD}'}, '"(bottom|top)"': same})
        self.file('U', '[0 1 -1 0 0 0 0]', 'uniform (0 0 0)', {
            '"(left|right|bottom)"': {'type': 'noSlip'}, 'top': {'type': 'slip'}}, 'volVectorField')
        self.file('p_rgh', '[1 -1 -2 0 0 0 0]', 'uniform 0', {walls: {'type': 'fixedFluxPressure', 'value': 'uniform 0'}})
        self.file('alpha.water', '[0 0 0 0 0 0 0]', alpha, {walls: same})
        path = self.path / 'system/fvSolution'
        text = path.read_text().replace('nCorrectors     30', 'nCorrectors     2')
        path.write_text(text.replace('PIMPLE\n{', 'PIMPLE\n{\n    pRefCell 0;\n    pRefValue 0;', 1))


def test_return_flow(tmp_path):
    case = Layer(tmp_path)
    case.mesh()
    case.go()
    end = max((p for p in tmp_path.iterdir() if re.fullmatch(r'[\d.e-]+', p.name)), key=lambda p: float(p.name))
    U = read_field(end / 'U').reshape(NY, NX, 3)[:NY * 2 // 3, NX // 2 - 1:NX // 2 + 1, 0].mean(axis=1)

    done = run_command(['thermoTable', '-liquid', 'water', '-T', '300', '-property', 'mu', '-csv', 'mu.csv'], tmp_path, 60)
    assert done.code == 0
    mu = float((tmp_path / 'mu.csv').read_text().split()[-1].split(',')[1])
    s = (np.arange(NY * 2 // 3) + 0.5) / (NY * 2 // 3)
    exact = -9.81 * (997.777 - 995.031) / LENGTH * H**3 / (48 * mu) * (8 * s**3 - 15 * s**2 + 6 * s)
    # 6 % at the surface with ten cells, 1.5 % with twenty
    assert np.abs(U - exact).max() < 0.08 * np.abs(exact).max()
