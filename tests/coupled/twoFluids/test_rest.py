"""Fluids at rest without particles: a level across the mesh; a drop in a mesh that is refined where the surface is.

Expected: no flow, and the volume that was set. Two cells of a tilted level see the surface at slightly other places, as its
planes are exact to the tolerance of the reconstruction only; the limits are a tenth of the pass mark of benchmarks (1e-3 m/s).
"""
import re

import numpy as np
import pytest

from twoFluidCase import TwoFluidCase, beyond_bounds, liquid_volumes

SIDE = 0.01
FASTEST = re.compile(r'^Flow: at most (\S+) m/s', re.M)


class Alone(TwoFluidCase):
    """Without constant/particleProperties; the liquid set by shapes."""

    shapes = None

    def write(self):
        super().write()
        (self.path/'constant/particleProperties').unlink()
        # A predictor without the first pressure would leave some 1e-6 m/s
        path = self.path/'system/fvSolution'
        path.write_text(path.read_text().replace('PIMPLE\n{', 'PIMPLE\n{\n    momentumPredictor no;'))
        self.write_dict('system/setLiquidDict', {'liquid': 'water', 'shapes': self.shapes})

    def mesh(self):
        super().mesh()
        assert self.run('setLiquid').code == 0


def box(path, cells, **keywords):
    case = Alone(path, **{'level': 0.5*SIDE, 'upper': (SIDE, SIDE*cells[1]/cells[0], SIDE), 'cells': cells,
                          'tolerance': 1e-13, 'writeInterval': 1000, 'timePrecision': 9, **keywords})
    return case


@pytest.mark.parametrize('angle', [0.0, 20.0, 45.0])
def test_tilted_level_rests(tmp_path, angle):
    """Gravity at an angle to the mesh, without surface tension (with it the level would bend at the walls)."""
    a = np.radians(angle)
    n = np.array([np.sin(a), 0, np.cos(a)])
    case = box(tmp_path, (24, 1, 24), cyclic='y', gravity=tuple(-9.81*n), deltaT=1e-4, endTime=0.02)
    case.shapes = {'level': {'type': 'plane', 'point': (SIDE/2, 0, SIDE/2), 'normal': tuple(n)}}
    case.mesh()
    result = case.run('interDemFoam')
    assert result.code == 0, result.output[-2000:]
    assert max(map(float, FASTEST.findall(result.output))) < 2e-4
    volumes = liquid_volumes(result.output)
    assert np.abs(volumes/volumes[0] - 1).max() < 1e-12 and beyond_bounds(result.output) < 1e-9


def refined(path, ranks=1, K=1000.0):
    """A drop with the curvature it has, in a box that is refined around the surface."""
    case = box(path, (12, 12, 12), sigma=0.07, gravity=(0, 0, 0), deltaT=2e-5, endTime=4e-4, writeFormat='ascii', writePrecision=16)
    case.shapes = {'drop': {'type': 'sphere', 'centre': (SIDE/2,)*3, 'radius': 2/K}}
    case.surface['curvature'] = {'type': 'prescribed', 'K': K}
    case.mesh()
    case.write_dict('constant/dynamicMeshDict', {
        'dynamicFvMesh': 'rankIndependentRefineFvMesh', 'dynamicFvMeshLibs': '(dewRefinedMesh)', 'refineInterval': 1,
        'field': 'alpha.water', 'lowerRefineLevel': 0.001, 'upperRefineLevel': 0.999, 'unrefineLevel': 10,
        'nBufferLayers': 2, 'maxRefinement': 1, 'maxCells': 100000, 'correctFluxes': '((phi none))', 'dumpLevel': False})
    if ranks > 1:
        case.decompose(ranks)
    result = case.run('interDemFoam', ranks=ranks)
    assert result.code == 0, result.output[-2000:]
    return result.output


def test_drop_in_a_refined_mesh(tmp_path):
    """With the curvature given, pressure balances it on split cells too: 1e-10 m/s. The volume is that of before the split,
    and two ranks say the same."""
    one, two = refined(tmp_path/'one'), refined(tmp_path/'two', 2)
    assert int(re.findall(r'Selected (\d+) cells for refinement', one)[0]) > 100
    for output in (one, two):
        assert max(map(float, FASTEST.findall(output))) < 1e-10
        volumes = liquid_volumes(output)
        assert np.abs(volumes/(4/3*np.pi*0.002**3) - 1).max() < 1e-9
