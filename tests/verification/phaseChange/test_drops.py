"""interEvapDemFoam with drops that the flow carries: rates of the quasi-static surface's solver, and their end."""
import re
import sys

import numpy as np
import pytest

from dewCase import ROOT
from evaporationCase import BOILING_WATER, IDEAL_GAS, RHO_GAS, EvaporationCase, saturated
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


@pytest.mark.parametrize('theta', [40, 60, 90, 120])
def test_rate_of_the_quasi_static_surface(tmp_path, theta):
    """Over 20 ms, with a surface tension that just holds the shape: the rate on the same mesh within 0.3 %, Popov's
    within 2 % (asked). Ten cells to the radius, twelve from there on: 0.4 % more than Popov's mesh without end.
    """
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


def test_contact_line_passes_a_cell(tmp_path):
    """The rate over Popov's depends little on where in its cell the contact line is, and does not leap: over a cell in
    tenths, the last one the steepest. With a wall that is wet or dry as a whole it leapt by 2.1 % as the centre of its
    face fell dry."""
    ratios = []
    for k in range(11):
        path = tmp_path / str(k)
        path.mkdir()
        case = EvaporationCase(path, theta=40, n=10, endTime=1e-3, deltaT=1e-3)
        case.change['evaporation'] = {'type': 'diffusion', 'stefanFlow': False}
        case.outer = {'type': 'farField', 'infinity': 'uniform 0', 'value': 'uniform 0'}
        a = case.motion['contactRadius'] = 1e-3 - k * 1e-5
        case.prepare()
        case.go()
        ratios.append(case.ledger().rate[0] / theory.rate(np.radians(40), a, 2.5e-5, RHO_GAS * saturated()))
    assert np.abs(np.diff(ratios)).max() < 1e-2, ratios
    assert np.abs(np.array(ratios) - 1).max() < 2.2e-2, ratios


# Rows of cells over the wall, of a drop that swings
WRINKLED = [[1, 1, 1, 1, 1, 1, 1, .9715, .0644], [1, 1, 1, 1, 1, 1, .8541, .2538],
            [.9999, .9999, 1, 1, .8357, .4110, .0274], [.7374, .6437, .4615, .1817, .0007]]


def test_foot_of_a_wrinkled_drop(tmp_path):
    """The surface at its foot is bent much, and says nothing of cells further out: the wall there is dry. It was not,
    and the rate a third too large."""
    case = drop(TransportedCase, tmp_path, 40, 10, sigma=1e-4, endTime=1e-6, deltaT=1e-6)
    path = tmp_path / '0/alpha.liquid'
    text = path.read_text()
    start = re.search(r'internalField\s+nonuniform\s+List<scalar>\s*(\d+)', text)
    alpha = np.zeros(int(start[1]))
    columns = 16
    for k, row in enumerate(WRINKLED):
        alpha[k * columns:k * columns + len(row)] = row
    listed = ' '.join(f'{value:g}' for value in alpha)
    path.write_text(f'{text[:start.start()]}internalField nonuniform List<scalar> {len(alpha)} ({listed});\n'
                    + text[text.index('boundaryField'):])
    case.go()
    table = case.ledger()
    a = 1e-3 * (table.volume[0] / theory.volume(np.radians(40), 1e-3))**(1 / 3)
    popov = theory.rate(np.radians(40), a, 2.5e-5, RHO_GAS * saturated())
    assert abs(table.rate[0] / popov - 1) < 0.1, table.rate[0] / popov


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


def test_heat_of_a_drop_closes(tmp_path):
    """A drop of water that cools as it evaporates: stored = in - latent + moved to 7e-5 of the latent heat, which is what
    the capacities of gas and liquid make that vary with temperature."""
    case = TransportedCase(tmp_path, theta=60, n=10, sigma=1e-4, endTime=0.05, deltaT=1e-3)
    case.change.update(energy=True, gas='transient', evaporation={'type': 'diffusion'})
    case.liquid, case.gas = dict(BOILING_WATER), dict(IDEAL_GAS)
    case.outer = {'type': 'farField', 'infinity': 'uniform 0', 'value': 'uniform 0'}
    case.prepare()
    case.go()
    stored, into, latent, moved = np.loadtxt(tmp_path / 'postProcessing/evaporation/0/heat.dat').T[1:]
    assert latent[-1] > 5e-4 and case.ledger().Tsurface[-1] < 297.9
    assert np.abs(stored - into + latent - moved)[5:].max() < 2e-4 * latent[-1]


@pytest.mark.parametrize('gas', ['quasiSteady', 'transient'])
def test_heat_of_a_drop_that_swings(tmp_path, gas):
    """A cap of 60 degrees that draws itself up to 90, at up to 1.1 m/s through its cells: heat goes with the mass of the
    liquid, and the ledger closes to 0.4 % of the latent heat. With the flux of the flow in its place it was wrong by 57 %
    (quasiSteady) and 98 % (transient)."""
    case = TransportedCase(tmp_path, theta=60, n=10, sigma=0.07, endTime=3e-3, deltaT=1e-5, writeInterval=10000,
                           adjustTimeStep=True, maxCo=0.3, maxDeltaT=2e-5)
    case.change.update(energy=True, gas=gas, evaporation={'type': 'diffusion'})
    case.liquid, case.gas = dict(BOILING_WATER), dict(IDEAL_GAS)
    case.outer = {'type': 'farField', 'infinity': 'uniform 0', 'value': 'uniform 0'}
    case.prepare()
    path = tmp_path / 'constant/surfaceProperties'
    path.write_text(path.read_text().replace('60.0', '90.0'))
    case.go()
    stored, into, latent, moved = np.loadtxt(tmp_path / 'postProcessing/evaporation/0/heat.dat').T[1:]
    assert case.ledger().maxU.max() > 0.2
    error = np.abs(stored - into + latent - moved).max() / latent[-1]
    assert error < 1e-2, error
