"""interEvapDemFoam with drops that the flow carries: rates of the quasi-static surface's solver, and their end."""
import re
import sys

import numpy as np
import pytest

from dewCase import ROOT
from evaporationCase import RHO_GAS, EvaporationCase, saturated
from transportedCase import TransportedCase

sys.path.append(str(ROOT / 'etc/python'))
import dropletTheory as theory


def drop(kind, path, theta, n, **control):
    """As in Popov's theory: no Stefan flow, one temperature, gas without end."""
    path.mkdir(exist_ok=True)
    case = kind(path, theta=theta, n=n, **control)
    case.change['evaporation'] = {'type': 'diffusion', 'stefanFlow': False}
    case.outer = {'type': 'farField', 'infinity': 'uniform 0', 'value': 'uniform 0'}
    case.prepare()
    return case


@pytest.mark.parametrize('theta', [60, 90, 120])
def test_rate_of_the_quasi_static_surface(tmp_path, theta):
    """Over 20 ms, with a surface tension that just holds the shape: the rate on the same mesh within 0.3 %."""
    still = drop(EvaporationCase, tmp_path / 'still', theta, 10, endTime=1e-3, deltaT=1e-3)
    still.go()
    rate = still.ledger().rate[0]
    moving = drop(TransportedCase, tmp_path / 'moving', theta, 10, sigma=1e-4, endTime=0.02, deltaT=1e-3)
    output = moving.go()
    table = moving.ledger()
    assert np.abs(table.rate / rate - 1).max() < 3e-3, table.rate / rate - 1
    assert moving.errors(output).max() < 1e-11
    popov = theory.rate(np.radians(theta), 1e-3, 2.5e-5, RHO_GAS * saturated())
    assert abs(table.rate[-1] / popov - 1) < 0.02


def test_dries_out(tmp_path):
    """A flux that takes the drop in some steps: it is gone, nothing else is, and the run goes on."""
    case = TransportedCase(tmp_path, theta=90, n=8, sigma=1e-4, endTime=0.3, deltaT=1e-3, writeInterval=10000,
                           adjustTimeStep=True, maxCo=0.4, maxDeltaT=1e-3)
    # Gas that takes little room
    case.gas['rho'] = 100
    case.change['evaporation'] = {'type': 'fixedFlux', 'flux': 5.0}
    case.with_vapour = False
    case.prepare()
    output = case.go()
    table = case.ledger()
    assert abs(table.time[-1] - 0.3) < 1e-3 and table.rate[0] > 0 and table.rate[-1] == 0
    assert abs(float(re.findall(r'volume (\S+) m3, from', output)[-1])) < 1e-24
    assert table.out.max() == 0
    mass = 997 * 2 / 3 * np.pi * 1e-9
    assert abs(table.evaporated[-1] / mass - 1) < 2e-3, table.evaporated[-1] / mass
    assert np.isfinite(table.maxU).all() and 'nan' not in output
