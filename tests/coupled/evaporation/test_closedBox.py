"""A film of water in a sealed box of dry gas: it evaporates until the partial pressure of the vapour is pSat(T).

Of an ideal gas, exactly: p0 = (mc/Wc + mv/Wv) Ru T/V, and at the end mv = pSat Wv V/(Ru T), with V, the gas, larger than at
the start by what has evaporated over the density of the liquid.
"""
import re

import numpy as np
import pytest

from evaporationCase import IDEAL_GAS, P0, WATER, WC, WV, EvaporationCase

RU, T, A, FILM, P_SAT = 8.31446261815324, 298.15, 1e-3, 0.52e-3, WATER['pSat']
BOX = 4 * A**3
CARRIER = P0 * WC * 1e-3 / (RU * T) * (BOX - FILM * A**2)


class SealedBox(EvaporationCase):
    """Of 1 x 1 x 4 mm; diffusion takes (4 mm)^2/D, some 0.6 s"""

    def __init__(self, path, n=4, **control):
        super().__init__(path, a=A, n=n, film=FILM, **{'endTime': 4, 'deltaT': 0.02, **control})
        self.gas = dict(IDEAL_GAS)
        self.change['gas'] = 'transient'
        self.outer = {'type': 'zeroGradient'}

    def write_block_mesh(self):
        super().write_block_mesh()
        path = self.path / 'system/blockMeshDict'
        path.write_text(path.read_text().replace('outer {type patch;', 'outer {type wall;'))

    def pressures(self, output):
        found = re.findall(r'^p0 (\S+) Pa, carrier (\S+) kg', output, re.M)
        return np.array(found, dtype=float).T


def check(case, output):
    pressure, carrier = case.pressures(output)
    table = case.ledger()
    volume = BOX - table.volume

    # Of every step: what has evaporated is in the gas, the carrier stays, and both make the pressure. What evaporates
    # in a step leaves the liquid at its end
    assert case.errors(output).max() < 1e-10
    assert np.abs(carrier / CARRIER - 1).max() < 1e-10
    before = np.concatenate([[BOX - FILM * A**2], volume[:-1]])
    exact = (CARRIER / WC + table.evaporated / WV) * 1e3 * RU * T / before
    assert np.abs(pressure / exact - 1).max() < 1e-10
    liquid = (FILM * A**2 - table.volume) * WATER['rho']
    # The volume has ten digits in the table
    assert np.abs(table.evaporated - liquid).max() < 1e-10 * WATER['rho'] * FILM * A**2
    return pressure, table, volume


def test_evaporates_to_equilibrium(tmp_path):
    """Masses of the ideal gas at every step; the end as it must be, by 0.1 %."""
    case = SealedBox(tmp_path)
    case.prepare()
    pressure, table, volume = check(case, case.go())

    vapour = P_SAT * WV * 1e-3 * volume[-1] / (RU * T)
    assert table.evaporated[-1] == pytest.approx(vapour, rel=1e-3)
    air = CARRIER / (WC * 1e-3) * RU * T / volume[-1]
    assert pressure[-1] == pytest.approx(air + P_SAT, rel=1e-5)


def test_restart_and_ranks(tmp_path):
    """In two parts, and on two ranks, the same pressures."""
    logs = []
    for name, ranks in (('one', 1), ('two', 2)):
        case = SealedBox(tmp_path / name, endTime=0.2, writeInterval=5)
        case.prepare()
        if ranks > 1:
            case.decompose(ranks)
        logs.append(case.pressures(case.go(ranks))[0])
    assert logs[1] == pytest.approx(logs[0], rel=1e-9)

    case = SealedBox(tmp_path / 'one', startFrom='startTime', startTime=0.1, endTime=0.2)
    case.write_dict('system/controlDict', case.control)
    assert case.pressures(case.go())[0] == pytest.approx(logs[0][5:], rel=1e-9)


@pytest.mark.parametrize('change', ['density', 'quasiSteady'])
def test_refused(tmp_path, change):
    """Without a density that depends on the pressure, or without mass, it cannot be."""
    case = SealedBox(tmp_path)
    if change == 'density':
        from evaporationCase import CONSTANT_GAS
        case.gas = dict(CONSTANT_GAS)
    else:
        case.change['gas'] = 'quasiSteady'
    case.prepare()
    text = case.message()
    for word in ('closed in', 'idealGas', 'transient', "'patch'"):
        assert word in text
