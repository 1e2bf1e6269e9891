"""interEvapDemFoam with the laws of evaporation that are there as others have published them: speciesDiffusion, saufi, and
HardtWondra with its smeared area.

What these schemes give in a Stefan tube is solved here by hand, beside Stefan's own solution: a test of the code is the
first, how far the scheme is off the second. Tolerances: some more than measured here, which is stated beside them.
"""
import re

import numpy as np
import pytest

from columnCase import P0, root
from evaporationCase import BOILING_WATER, IDEAL_GAS, RHO_GAS, WATER, WV, EvaporationCase, saturated
from fluidCase import read_field
from test_columns import stefan
from transportedCase import TransportedCase

RU, T, AIR = 8.31446, 298.15, 28.9647
STEP = 5e-4
FAR = {'type': 'farField', 'infinity': 'uniform 0', 'value': 'uniform 0'}


# --- In a Stefan tube

class Vapour:
    """Of molar mass W [g/mol] in air."""

    def __init__(self, W, D, x_surface, x_infinity):
        self.W, self.D, self.x, self.x_infinity = W, D, x_surface, x_infinity

    def Y(self, x):
        return x * self.W / (x * self.W + (1 - x) * AIR)

    def mole(self, Y):
        return Y / self.W / (Y / self.W + (1 - Y) / AIR)

    def rho(self, Y):
        return P0 * 1e-3 / (RU * T) / (Y / self.W + (1 - Y) / AIR)

    def stefan(self, x_start, length):
        """Flux from a point of mole fraction x to the top [kg/m2/s]"""
        return self.W * 1e-3 * P0 * self.D / (RU * T * length) * np.log((1 - self.x_infinity) / (1 - x_start))

    def film(self, thickness, length):
        """Flux of a film from the surface, by values there and its mean gradient, and Stefan's from its end on"""
        Ys = self.Y(self.x)

        def linear(Y):
            return self.rho(Y) * self.D / thickness * (Ys - Y) / (1 - Ys)
        low, high = sorted((Ys, self.Y(self.x_infinity)))
        Y = root(lambda Y: self.stefan(self.mole(Y), length - thickness) - linear(Y), low, high)
        return linear(Y)


def tube(path, law, vapour, cell=25.33, n=75, transient=False, steps=3, **keywords):
    """Liquid in so many cells of n of 1.5 mm, below gas; steps are short for the flow that it makes."""
    from columnCase import ColumnCase
    path.mkdir(exist_ok=True)
    L = 1.5e-3
    case = ColumnCase(path, n, L, cell * L / n, gas_first=False, endTime=steps * STEP, deltaT=STEP, **keywords)
    case.law, case.transient, case.energy = law, transient, False
    case.T = case.T_low = case.T_high = T
    case.Y = case.Y_high = float(vapour.Y(vapour.x_infinity))
    case.liquid = {'type': 'constant', 'name': 'liquid', 'W': vapour.W, 'rho': 1000, 'mu': 8.9e-4, 'Cp': 4181,
                   'kappa': 0.606, 'hv': 2.442e6, 'sigma': 0.072, 'pSat': vapour.x * P0}
    case.gas = {'type': 'idealGas', 'p0': P0, 'carrier': {'type': 'air'},
                'diffusivity': {'D0': vapour.D, 'Tref': T, 'pRef': P0, 'n': 1.75},
                'vapour': {'type': 'constant', 'mu': 1e-5, 'Cp': 1900, 'kappa': 0.019}}
    case.mesh()
    return case


def rate(case, output, law):
    """Flux and place of the surface at the end; the ledger closes, and the liquid has lost what has evaporated (a step's is on its way)."""
    x, table = case.positions(output), case.ledger()
    assert case.errors(output).max() < 1e-10, law
    lost = 1000 * (case.surface - x[-1]) * case.width**2
    # To ten digits of the volume
    assert abs(lost + table.rate[-1] * STEP - table.evaporated[-1]) < 1e-9 * 1000 * case.surface * case.width**2
    return table.rate[-1] / case.width**2, x[-1]


WATER_IN_AIR = (18.0153, 2.5e-5, 0.0313, 0.0)
TUBES = {
    'water': (WATER_IN_AIR, {}), 'mirrored': (WATER_IN_AIR, {'mirrored': True}),
    'transient': (WATER_IN_AIR, {'transient': True, 'steps': 500}),
    'heavy': ((46.068, 1.19e-5, 0.5, 0.0), {}), 'light': ((10.0, 3e-5, 0.7, 0.1), {}),
    'condensation': ((46.068, 1.19e-5, 0.1, 0.4), {}),
}


@pytest.mark.parametrize('name', TUBES)
def test_species_diffusion_in_a_tube(tmp_path, name):
    """The film from the surface, in its true place, to the next centre: within 6e-5, which is the gas'
    and the same with the law diffusion."""
    vapour, keywords = Vapour(*TUBES[name][0]), TUBES[name][1]
    case = tube(tmp_path, {'type': 'speciesDiffusion'}, vapour, 25.55, **keywords)
    N, x = rate(case, case.go(), name)
    dx = 1.5e-3 / 75
    assert abs(N / vapour.film(26.5 * dx - x, 1.5e-3 - x) - 1) < 1e-4


@pytest.mark.parametrize('renormalise', ['global', 'local'])
@pytest.mark.parametrize('cell', [25.2, 25.8], ids=['less', 'more'])
@pytest.mark.parametrize('name', TUBES)
def test_saufi_in_a_tube(tmp_path, name, cell, renormalise):
    """A film over two cells from the centre of the one with the surface, wherever in it that is: within 6e-5, as above."""
    vapour, keywords = Vapour(*TUBES[name][0]), TUBES[name][1]
    case = tube(tmp_path, {'type': 'saufi', 'renormalise': renormalise}, vapour, cell, **keywords)
    N, _ = rate(case, case.go(), name)
    dx = 1.5e-3 / 75
    assert abs(N / vapour.film(2 * dx, 1.5e-3 - 25.5 * dx) - 1) < 1e-4


@pytest.mark.parametrize('law, name, place, order, error', [
    ('speciesDiffusion', 'light', 0.55, 2, 0.0046), ('saufi', 'water', 0.2, 1, 0.032),
    ('saufi', 'water', 0.8, 1, -0.031)])
def test_order(tmp_path, law, name, place, order, error):
    """Off Stefan's flux with 15 and 30 cells, a third of them liquid, and the surface in the same place of a cell; that of
    saufi is 0.3 of a cell too near, or too far, and with 15 cells that is 3 %."""
    vapour = Vapour(*TUBES[name][0])
    errors = []
    for n in (15, 30):
        case = tube(tmp_path / str(n), {'type': law}, vapour, n // 3 + place, n)
        N, x = rate(case, case.go(), law)
        errors.append(N / vapour.stefan(vapour.x, 1.5e-3 - x) - 1)
    assert abs(errors[0] / error - 1) < 0.1 and abs(np.log2(errors[0] / errors[1]) - order) < 0.2, errors


# --- Around drops

def drop(kind, path, law, n=10, ideal=False, energy=False, **control):
    path.mkdir(exist_ok=True)
    case = kind(path, theta=90, n=n, **control)
    case.change.update(evaporation=law, energy=energy, gas='transient' if ideal else 'quasiSteady')
    if ideal:
        case.gas, case.liquid = dict(IDEAL_GAS), dict(BOILING_WATER)
    case.outer = dict(FAR)
    return case


@pytest.mark.parametrize('n, off', [(10, -0.0227), (20, -0.0010)])
def test_saufi_around_a_drop(tmp_path, n, off):
    """Half a drop, rate over that of the law diffusion on the same mesh, which is 0.6 % below that of a sphere. Half a cell
    would be 5 % with 10 cells to its radius, and 2.5 % with 20; -2.27 and -0.10 % are no others' numbers but measured here,
    to know how far the scheme is off."""
    rates = []
    for law in ('diffusion', 'saufi'):
        case = drop(EvaporationCase, tmp_path / law, {'type': law}, n, endTime=1)
        case.prepare()
        output = case.go()
        assert case.errors(output).max() < 1e-10
        rates.append(case.ledger().rate[0])
    sphere = 2 * np.pi * 1e-3 * RHO_GAS * 2.5e-5 * -np.log(1 - saturated())
    assert abs(rates[0] / sphere - 1) < 0.01
    assert abs(rates[1] / rates[0] - 1) < 0.5 / n and abs(rates[1] / rates[0] - 1 - off) < 1e-3, rates


@pytest.mark.parametrize('law', ['saufi', 'speciesDiffusion'])
def test_balance_with_heat(tmp_path, law):
    """In a gas that stores, with heat, steps of some per cent."""
    case = drop(EvaporationCase, tmp_path, {'type': law}, 8, True, True, endTime=0.4, deltaT=0.05)
    case.prepare()
    output = case.go()
    assert case.errors(output).max() < 1e-10
    assert case.ledger().Tsurface[-1] < 297.9


@pytest.mark.parametrize('law', [{'type': 'saufi'}, {'type': 'saufi', 'renormalise': 'local'}, {'type': 'speciesDiffusion'}],
                         ids=['saufi', 'saufiLocal', 'speciesDiffusion'])
@pytest.mark.parametrize('outside', [0.0, 0.04], ids=['evaporation', 'condensation'])
def test_drop_that_the_flow_carries(tmp_path, law, outside):
    """On 1 and 2 ranks, its volume is what the ledger says, and alpha stays in its bounds."""
    tables = []
    for ranks in (1, 2):
        case = drop(TransportedCase, tmp_path / str(ranks), law, 8, endTime=0.02, deltaT=1e-3, sigma=1e-4)
        case.Y, case.outer = outside, {'type': 'farField', 'infinity': f'uniform {outside}', 'value': f'uniform {outside}'}
        case.prepare()
        if ranks > 1:
            case.decompose(ranks)
        output = case.go(ranks)
        assert case.errors(output).max() < 1e-10
        table = case.ledger()
        assert (table.rate < 0).all() == (outside > 0)
        # A step's is on its way
        lost = 997 * (2 / 3 * np.pi * 1e-9 - table.volume)[1:]
        assert np.abs(lost / table.evaporated[:-1] - 1).max() < 1e-2, lost / table.evaporated[:-1]
        low, high = np.array(re.findall(r'^alpha\.\w+: volume \S+ m3, from (\S+) to 1 \+ (\S+)', output, re.M), dtype=float).T
        assert low.min() >= 0 and high.max() < 1e-12
        tables.append(table)
    for name in ('evaporated', 'rate', 'volume'):
        assert np.allclose(tables[0][name], tables[1][name], rtol=1e-8, atol=0), name


# --- Where the liquid loses it

@pytest.mark.parametrize('renormalise', ['global', 'local'])
def test_renormalised(tmp_path, renormalise):
    """A layer of liquid between two of the same gas, with 0.6 and 0.95 of the cells at its surfaces: the little vapour there
    sees the same. Each surface loses what evaporates there, if it is local; if not, by sqrt(alpha (1 - alpha))."""
    case = tube(tmp_path, {'type': 'saufi', 'renormalise': renormalise}, Vapour(18.0153, 2.5e-5, 1e-6, 0.0), 25, 60, steps=1,
                writeInterval=1)
    case.field_file('Y.water', '[0 0 0 0 0 0 0]', 'uniform 0', *2 * [{'type': 'fixedValue', 'value': 'uniform 0'}])
    x = np.arange(60)
    alpha = np.where((x > 25) & (x < 34), 1.0, 0.0)
    alpha[25], alpha[34] = 0.6, 0.95
    case.field_file('alpha.water', '[0 0 0 0 0 0 0]', case.values(lambda _: alpha), *2 * [{'type': 'zeroGradient'}])
    output = case.go()
    leaving = read_field(case.path / f'{STEP:g}' / 'leaving')
    low, high = leaving[:30].sum(), leaving[30:].sum()
    both = low + high
    assert abs(both * case.width**3 / (case.ledger().rate[0] * STEP) - 1) < 1e-9
    f = [np.sqrt(a * (1 - a)) for a in (0.6, 0.95)]
    expected = 0.5 if renormalise == 'local' else f[0] / sum(f)
    assert abs(low / both / expected - 1) < 1e-4 and (low > 0) and case.errors(output).max() < 1e-10


# --- Area by the gradient of alpha

def smeared_area(n):
    """Of half a sphere of radius 1 on even cells about its axis, 1/n in size: shares of 40 x 40 points, gradient by Gauss'
    theorem, mirrored below."""
    m, k = n + 4, 40
    fine = (np.arange(m * k) + 0.5) / (n * k)
    r, z = np.meshgrid(fine, fine, indexing='ij')
    inside = (r * r + z * z < 1) * r
    cells = inside.reshape(m, k, m, k).sum((1, 3)) / r.reshape(m, k, m, k).sum((1, 3))
    a = np.pad(cells, ((1, 1), (1, 1)), 'edge')
    a[-1], a[:, -1] = 0, 0
    h = 1 / n
    edge, centre = np.arange(m + 1) * h, (np.arange(m) + 0.5) * h
    on_r, on_z = 0.5 * (a[1:, 1:-1] + a[:-1, 1:-1]), 0.5 * (a[1:-1, 1:] + a[1:-1, :-1])
    along_r = (edge[1:, None] * on_r[1:] - edge[:-1, None] * on_r[:-1]) / (centre[:, None] * h) - cells / centre[:, None]
    along_z = (on_z[:, 1:] - on_z[:, :-1]) / h
    return (np.hypot(along_r, along_z) * 2 * np.pi * centre[:, None] * h * h).sum()


def kinetics(path, n, area, T, kind=EvaporationCase, **control):
    """Half a drop in its vapour, one temperature; rate over that of its surface"""
    path.mkdir(exist_ok=True)
    C = 1e-6
    case = kind(path, theta=90, n=n, **{'endTime': 1e-6, 'deltaT': 1e-6, **control})
    case.liquid = dict(BOILING_WATER)
    case.change['evaporation'] = {'type': 'HardtWondra', 'accommodation': C, 'area': area}
    case.T = case.T_substrate = T
    case.with_vapour = False
    case.prepare()
    output = case.go()
    h = 2 * C / (2 - C) * WATER['hv']**2 * RHO_GAS / 373.15**1.5 * np.sqrt(WV * 1e-3 / (2 * np.pi * RU))
    return case.ledger().rate / (h * (T - 373.15) / WATER['hv'] * 2 * np.pi * 1e-6), output


@pytest.mark.parametrize('T', [380.0, 366.3], ids=['evaporation', 'condensation'])
@pytest.mark.parametrize('n', [10, 20])
def test_area_of_the_gradient(tmp_path, n, T):
    """That of the planes is exact, that of the gradient what it is by hand: 1.35 and 1.40 % too large, on finer meshes 1.40."""
    true, _ = kinetics(tmp_path / 'true', n, 'reconstructed', T)
    assert abs(true[0] - 1) < 1e-6
    smeared, _ = kinetics(tmp_path / 'smeared', n, 'gradAlpha', T)
    expected = smeared_area(n) / (2 * np.pi)
    assert 1.01 < expected < 1.02 and abs(smeared[0] - expected) < 5e-4, (smeared[0], expected)


def test_smeared_source_in_the_stefan_problem(tmp_path):
    """Kinetics that do not count: what the smeared source adds is an error of first order, -2.4 and -1.2 %."""
    errors = [stefan(tmp_path / str(n), n, law={'type': 'HardtWondra', 'accommodation': 1, 'area': 'gradAlpha'})[0]
              for n in (50, 100)]
    assert abs(errors[0]) < 0.03 and 0.8 < np.log2(errors[0] / errors[1]) < 1.3, errors


# --- Bad input

@pytest.mark.parametrize('law, words', [
    ({'type': 'saufi', 'renormalise': 'none'}, ('renormalise', 'global', 'local', 'none')),
    ({'type': 'saufi', 'stefanFlow': False}, ('stefanFlow', 'phaseChangeProperties', 'renormalise')),
    ({'type': 'speciesDiffusion', 'renormalise': 'local'}, ('renormalise', 'phaseChangeProperties', 'stefanFlow')),
    ({'type': 'HardtWondra', 'accommodation': 1, 'area': 'smeared'}, ('area', 'reconstructed', 'gradAlpha', 'smeared')),
    ({'type': 'Saufi'}, ('Saufi', 'saufi', 'speciesDiffusion')),
], ids=['renormalise', 'saufi', 'speciesDiffusion', 'area', 'type'])
def test_bad_input(tmp_path, law, words):
    """One message, with the entry and what it may be."""
    case = drop(EvaporationCase, tmp_path, law, 8)
    case.prepare()
    message = case.message()
    assert all(word in message for word in words), message
