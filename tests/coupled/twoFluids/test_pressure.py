"""The level of the pressure in a closed box is set at one cell: it changes nothing but the level, and costs nothing.

The equations are those of pressure differences: as many iterations with one level as with another, but for rounding of a
pressure that is a thousand times its differences (the limit of 10 %); a drop with sigma/R = 36 Pa, its water at the cell of
the level, where a change of level is the slowest of all to converge.
"""
import re

import numpy as np
import pytest

from twoFluidCase import TwoFluidCase

SIDE, N, STEPS = 5e-3, 20, 5


class Drop(TwoFluidCase):
    """An eighth of it."""

    level_of_pressure = 0.0

    def write(self):
        super().write()
        (self.path/'constant/particleProperties').unlink()
        path = self.path/'system/fvSolution'
        text = path.read_text().replace('relTol 0;', 'relTol 0.01;').replace('pRefValue 0;', f'pRefValue {self.level_of_pressure};')
        path.write_text(text)
        self.write_dict('system/setLiquidDict', {'liquid': 'water', 'shapes': {
            'drop': {'type': 'sphere', 'centre': (0, 0, 0), 'radius': 0.4*SIDE}}})

    def iterations(self):
        self.mesh()
        assert self.run('setLiquid').code == 0
        done = self.run('interDemFoam')
        assert done.code == 0, done.output[-2000:]
        found = [int(n) for n in re.findall(r'p_rgh.*No Iterations (\d+)', done.output)]
        # And one for the pressure at the start
        assert len(found) == 3*STEPS + 1
        return sum(found)


def test_level_of_pressure(tmp_path):
    step = 0.2*(1000*(SIDE/N)**3/(12.6*0.073))**0.5
    taken, pressure = {}, {}
    for level in (0.0, 1e5):
        case = Drop(tmp_path/f'{level:g}', level=0, upper=(SIDE,)*3, cells=(N,)*3, sigma=0.073, tolerance=1e-8,
                    deltaT=step, endTime=STEPS*step, writeInterval=STEPS, writeFormat='ascii', writePrecision=16,
                    gravity=(0, 0, 0))
        case.level_of_pressure = level
        taken[level] = case.iterations()
        pressure[level] = case.field('p_rgh', case.times()[-1])
        assert pressure[level][0] == pytest.approx(level, abs=1e-9)
    assert taken[1e5] < 1.1*taken[0.0], taken
    jump = np.ptp(pressure[0.0])
    assert 60 < jump < 90
    assert np.abs(pressure[1e5] - 1e5 - pressure[0.0]).max() < 1e-3*jump
