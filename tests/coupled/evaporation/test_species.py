"""interEvapDemFoam with several species in the liquid and the gas, without particles.

Expected values are closed forms written here, or runs of the same case with the species named or divided otherwise.
"""
import re

import numpy as np
import pytest

from evaporationCase import CONSTANT_GAS, IDEAL_GAS, WATER, EvaporationCase

SAME = {'type': 'zeroGradient'}


class SpeciesCase(EvaporationCase):
    """liquids: dictionaries of liquidProperties by name; X, Y_outer: mass fractions by name."""

    def __init__(self, path, liquids, X, mixing='diffusion', **keywords):
        path.mkdir(exist_ok=True)
        super().__init__(path, **keywords)
        self.liquid = {'liquids': liquids, 'diffusivity': {'type': 'constant', 'D': 1e-9}}
        self.X, self.Y_far = X, {name: 0 for name in liquids}
        self.with_vapour = False
        self.change['liquid'] = {'mixing': mixing}

    def write(self):
        super().write()
        for name, value in self.X.items():
            self.field_file(f'X.{name}', '[0 0 0 0 0 0 0]', value, SAME, SAME)
        for name, value in self.Y_far.items():
            self.field_file(f'Y.{name}', '[0 0 0 0 0 0 0]', value, SAME,
                            {'type': 'fixedValue', 'value': f'uniform {value!r}'})
        path = self.path / 'system' / 'fvSolution'
        path.write_text(path.read_text().replace('(Y.*|T|U)', '([XY].*|T|U)').replace('(chi|pc)', '(chi|pc|liquidP.*)'))


def kind(name, pSat=3169, **more):
    return {**WATER, 'name': name, 'pSat': pSat, **more}


def balances(case, output):
    """Errors of every species, in every step"""
    return np.array(re.findall(r'error (\S+); rate', output), dtype=float)


@pytest.mark.parametrize('gas', ['constant', 'ideal'])
@pytest.mark.parametrize('n', [2, 3])
def test_copies(tmp_path, gas, n):
    """n times the same species evaporates as one of them. The tolerance is that of the iterations, 1e-11."""
    rates = []
    for m in (1, n):
        names = 'abc'[:m]
        X = dict(zip(names, {1: [1.0], 2: [0.25, 0.75], 3: [0.5, 0.25, 0.25]}[m]))
        case = SpeciesCase(tmp_path / str(m), {name: kind(name, 9000) for name in names}, X, endTime=100, deltaT=20)
        case.gas = dict(CONSTANT_GAS) if gas == 'constant' else dict(IDEAL_GAS)
        if gas == 'ideal':
            one = case.gas.pop('vapour')
            case.gas['vapours'] = {name: one for name in names}
            D = dict(case.gas['diffusivity'])
            case.gas['diffusivity'] = {'pairs': {f'{a}-{b}': D for i, a in enumerate(names)
                                                 for b in [*names[i + 1:], 'carrier']}}
        if m == 1:
            case.Y_far = {'liquid': 0}
        case.change['energy'] = True
        case.prepare()
        output = case.go()
        rates.append(case.ledger().rate)
        assert balances(case, output).max() < 1e-10
    assert rates[0] == pytest.approx(rates[1], rel=1e-8)


@pytest.mark.parametrize('film', [None, 0.5e-3], ids=['drop', 'film'])
def test_two_ideal_liquids_well_mixed(tmp_path, film):
    """Without Stefan flow and with the same molar mass everywhere n_1/n_10 = (n_2/n_20)^(D_1 p_1/(D_2 p_2)), as long as
    the liquid is of one composition: steps of 0.5 % of the volume at the start, and order one in the step."""
    liquids = {'a': kind('a', 7870, W=18.0), 'b': kind('b', 3169, W=18.0)}
    case = SpeciesCase(tmp_path, liquids, {'a': 0.4, 'b': 0.6}, mixing='well', film=film,
                       adjustTimeStep=True, maxVolumeChange=0.005, maxDeltaT=1000, deltaT=1,
                       endTime=4000 if film else 700)
    case.gas.update(Wc=18.0, D='(1.19e-5 2.5e-5)')
    case.change['evaporation'] = {'type': 'diffusion', 'stefanFlow': False}
    case.prepare()
    output = case.go()
    table = case.ledger()
    assert balances(case, output).max() < 1e-10
    start = 997 * table.volume[0] + table.evaporated[0]
    a = 1 - table.evaporated_a / (0.4 * start)
    b = 1 - table.evaporated_b / (0.6 * start)
    assert b[-1] < 0.8
    alpha = 1.19e-5 * 7870 / (2.5e-5 * 3169)
    assert a == pytest.approx(b**alpha, rel=0.01)
