"""interEvapDemFoam without particles: balances, limits, restarts, ranks, messages.

Expected values are closed forms written here, symmetries, or other runs of the same case. Tolerances: those of the
linear solvers (1e-15 of the matrix' scale) and of the iterations between vapour and heat, 1e-11, summed over the steps;
ledger.dat has ten digits.
"""
import re

import numpy as np
import pytest

from evaporationCase import (BOILING_WATER, IDEAL_GAS, P0, RHO_GAS, RING, EvaporationCase, saturated)


def cap_volume(a, theta):
    t = np.tan(theta / 2)
    return np.pi * a**3 * t * (3 + t * t) / 6


def cap_angle(V, a):
    low, high = 1e-3, np.pi - 1e-3
    for _ in range(100):
        mid = (low + high) / 2
        low, high = (mid, high) if cap_volume(a, mid) < V else (low, mid)
    return low


def cap_area(a, theta):
    """2 pi R h"""
    return np.pi * a**2 * (1 + np.tan(theta / 2)**2)


def drop(path, **keywords):
    case = EvaporationCase(path, **keywords)
    case.path.mkdir(exist_ok=True)
    return case


# --- The balance

@pytest.mark.parametrize('energy', [False, True], ids=['isothermal', 'energy'])
@pytest.mark.parametrize('gas', ['quasiSteady', 'transient'])
def test_balance(tmp_path, gas, energy):
    """Liquid lost = vapour stored + vapour out, at every step; steps of a tenth of a per cent to some per cent."""
    case = drop(tmp_path, endTime=100, deltaT=20 if gas == 'quasiSteady' else 0.05)
    case.control['endTime'] = 8 * case.control['deltaT']
    case.gas, case.liquid = IDEAL_GAS, BOILING_WATER
    case.change.update(gas=gas, energy=energy)
    case.prepare()
    output = case.go()
    errors, table = case.errors(output), case.ledger()
    assert len(errors) == len(table) == 8
    assert errors.max() < 1e-8, errors
    # What the mesh has lost, by the volume of the drop, is what evaporated
    lost = 997 * (cap_volume(1e-3, np.pi / 3) - table.volume)
    assert np.abs(lost / table.evaporated - 1).max() < 1e-5 and (table.evaporated > 0).all()
    assert (np.abs(table.stored) > 0).all() == (gas == 'transient')
    # Latent heat cools the surface
    assert (table.Tsurface.min() < 297.9) == energy and table.Tsurface.max() <= 298.15


def test_balance_to_the_end(tmp_path):
    """Also when the drop dries within a step."""
    case = drop(tmp_path, theta=20, endTime=1e4, adjustTimeStep=True, maxVolumeChange=0.05, maxCo=1e9, maxDeltaT=1e9,
                writeControl='adjustableRunTime', writeInterval=1e5)
    case.control['functions'] = {'deposit': {
        'type': 'depositStatistics', 'libs': '(dewFunctionObjects)', 'centre': (0, 0, 0), 'normal': (0, 0, 1),
        'contactRadius': 1e-3, 'writeControl': 'writeTime'}}
    case.prepare()
    output = case.go()
    assert 'The liquid has dried' in output
    table = case.ledger()
    assert case.errors(output).max() < 1e-8 and table.volume[-1] == 0
    assert abs(table.evaporated[-1] / (997 * cap_volume(1e-3, np.radians(20))) - 1) < 1e-6
    # The end is a write time for function objects, too; going on from there is a run of no steps
    written = case.path / 'postProcessing/deposit/0/density.dat'
    last = float(written.read_text().splitlines()[-1].split()[0])
    assert abs(last / table.time[-1] - 1) < 1e-8
    case.control['startFrom'] = 'latestTime'
    case.liquid = {'type': 'library', 'liquid': 'H2O'}      # ends the run at 0 K, the mean of no liquid
    case.write()
    assert 'The liquid has dried' in case.go()


def test_dries_in_one_step(tmp_path):
    """A step much longer than the life is refused, and a drop between the cell centres."""
    case = drop(tmp_path, endTime=1e6, deltaT=1e5)
    case.prepare()
    message = case.message()
    assert '100 % of the liquid' in message and 'Lower deltaT' in message


def test_iterations(tmp_path):
    """Those between vapour and its flow are as many as asked for, but in the first step, and said."""
    case = drop(tmp_path, endTime=2)
    case.gas, case.liquid, case.T, case.T_substrate = IDEAL_GAS, BOILING_WATER, 350.0, 350.0
    case.prepare()
    solution = case.path / 'system/fvSolution'
    solution.write_text(re.sub(r'(gas\s*{\s*nCorrectors\s+)\d+', r'\g<1>1', solution.read_text()))
    output = case.go()
    said = re.findall(r'^gas: (\d+) iterations, last change (\S+), left (\S+)$', output, re.M)
    assert len(said) == 2 and 1 < int(said[0][0]) <= 20 and int(said[1][0]) == 1
    # One is not enough where the surface has moved, and that is said, too
    assert float(said[0][2]) < 1e-5 and float(said[1][1]) > 0.1 and output.count('still change by') == 1


# --- Limits

@pytest.mark.parametrize('gas', ['quasiSteady', 'transient'])
def test_saturated(tmp_path, gas):
    """Around it the gas is saturated: the drop stays."""
    case = drop(tmp_path, endTime=500, deltaT=100)
    case.change['gas'] = gas
    case.Y = case.Y_outer = float(saturated())
    case.prepare()
    case.go()
    table, V = case.ledger(), cap_volume(1e-3, np.pi / 3)
    assert np.abs(table.evaporated / (997 * V)).max() < 1e-10
    assert np.abs(table.volume / V - 1).max() < 1e-9
    assert table.maxU.max() < 1e-12


def test_condensation(tmp_path):
    """Without Stefan flow and in a gas of one density the equations are linear: 2 Ys outside gives -1 the rate of 0."""
    rates = []
    for Y in (0.0, 2 * float(saturated())):
        case = drop(tmp_path / f'{Y:g}', endTime=1)
        case.change['evaporation'] = {'type': 'diffusion', 'stefanFlow': False}
        case.Y = case.Y_outer = Y
        case.prepare()
        case.go()
        rates.append(case.ledger().rate[0])
    assert rates[0] > 0 and abs(rates[1] / rates[0] + 1) < 1e-8
    growing = case.ledger()
    assert growing.volume[-1] > cap_volume(1e-3, np.pi / 3)


def test_cold_drop_in_humid_air(tmp_path):
    """Water condenses on a cold drop and warms it."""
    case = drop(tmp_path, endTime=5)
    case.liquid, case.gas = BOILING_WATER, IDEAL_GAS
    case.change['energy'] = True
    case.T, case.T_substrate = 303.15, 283.15
    case.Y = case.Y_outer = 0.02            # saturated at about 298 K
    case.prepare()
    output = case.go()
    table = case.ledger()
    assert (table.rate < 0).all() and (np.diff(table.volume) > 0).all() and table.volume[0] > cap_volume(1e-3, np.pi / 3)
    assert 283.15 < table.Tsurface[-1] < 303.15 and case.errors(output).max() < 1e-8


def test_hotter_than_boiling(tmp_path):
    """Substrate and air at 380 K: evaporation keeps the surface below the boiling point."""
    case = drop(tmp_path, endTime=1, deltaT=0.2)
    case.liquid, case.gas = BOILING_WATER, IDEAL_GAS
    case.change['energy'] = True
    case.T = case.T_substrate = 380.0
    case.prepare()
    output = case.go()
    hottest = np.array(re.findall(r'surface at \S+ K \(\S+ to (\S+)\)', output), dtype=float)
    assert len(hottest) == 5 and hottest.max() < 373.15 and case.errors(output).max() < 1e-8
    assert (case.ledger().rate > 0).all()


@pytest.mark.parametrize('T_far, n', [(298.15, 16), (373.15, 16)])
def test_wet_bulb(tmp_path, T_far, n):
    """A half sphere on a substrate that gives no heat is half a free sphere, whose wet bulb is, for one density, diffusivity,
    conductivity and heat capacity (e.g. Spalding; Turns, An Introduction to Combustion, ch. 3),

        rho D ln(1 + BM) = kappa/cp ln(1 + BT),  BM = (Ys - Yinf)/(1 - Ys),  BT = cp (Tinf - Ts)/hv

    and the rate of the half 2 pi R rho D ln(1 + BM). 0.3 K and 3 % are the bounds of the mesh, 16 cells to the radius, and of
    the far field, which is not that of Stefan flow. The drop starts near the temperature it goes to.
    """
    p, M = P0, 18.0153e-3
    hv, cp, kappa, rhoD, Ru = 2.442e6, 1006, 0.026, RHO_GAS * 2.5e-5, 8.31446

    def saturation(T):
        x = np.exp(hv * M / Ru * (1 / 373.15 - 1 / T))
        return x * 18.0153 / (x * 18.0153 + (1 - x) * 28.9647)

    low, high = 250.0, 373.0
    for _ in range(100):
        T = 0.5 * (low + high)
        BM, BT = saturation(T) / (1 - saturation(T)), cp * (T_far - T) / hv
        low, high = (T, high) if rhoD * np.log1p(BM) < kappa / cp * np.log1p(BT) else (low, T)

    case = drop(tmp_path, theta=90, n=n, line='constantAngle', deltaT=1, endTime=60)
    case.liquid = BOILING_WATER
    case.change['energy'] = True
    case.T = T_far
    far = {'type': 'farField', 'infinity': f'uniform {T_far}', 'value': f'uniform {T_far}'}
    case.outer_T, case.substrate_T = far, {'type': 'zeroGradient'}
    case.outer = {'type': 'farField', 'infinity': 'uniform 0', 'value': 'uniform 0'}
    case.prepare()
    case.write_dict('system/setFieldsDict', {
        'defaultFieldValues': '()', 'regions': f'(fieldToCell {{ field alpha.liquid; min 0.5; max 2; fieldValues ('
                                               f'volScalarFieldValue T {T + 0.3}); }})'})
    case._must('setFields')
    case.go()
    table = case.ledger()
    assert abs(table.Tsurface[-1] - T) < 0.3, (table.Tsurface[-1], T)
    rate = 2 * np.pi * table.contactRadius[-1] * rhoD * np.log1p(BM)
    assert abs(table.rate[-1] / rate - 1) < 0.03, table.rate[-1] / rate


def test_nothing_moves(tmp_path):
    """A drop that does not evaporate has no flow at all, and keeps its volume."""
    case = drop(tmp_path, theta=70, endTime=50, deltaT=10)
    case.change = {'evaporation': {'type': 'none'}, 'energy': False}
    case.with_vapour = False
    case.prepare()
    case.go()
    table = case.ledger()
    assert table.maxU.max() < 1e-12 and (table.evaporated == 0).all()
    assert np.abs(table.volume / cap_volume(1e-3, np.radians(70)) - 1).max() < 1e-9


@pytest.mark.parametrize('line', ['pinned', 'constantAngle'])
def test_fixed_flux(tmp_path, line):
    """dV = - J A dt/rho with the area at the start of each step."""
    a, theta, J, dt = 1e-3, np.pi / 3, 2e-3, 2.0
    case = drop(tmp_path, line=line, endTime=8 * dt, deltaT=dt)
    case.change = {'evaporation': {'type': 'fixedFlux', 'flux': J}, 'energy': False}
    case.with_vapour = False
    case.prepare()
    case.go()
    volumes, V = [], cap_volume(a, theta)
    for _ in range(8):
        V -= J * cap_area(a, theta) * dt / 997
        volumes.append(V)
        if line == 'pinned':
            theta = cap_angle(V, a)
        else:
            a = np.cbrt(V / cap_volume(1, theta))
    assert volumes[-1] < 0.95 * cap_volume(1e-3, np.pi / 3)
    assert np.abs(case.ledger().volume / volumes - 1).max() < 1e-8


def test_fixed_flux_of_a_film(tmp_path):
    """dh/dt = - J/rho, also through the layers of cells; the liquid below rests."""
    J, dt = 0.2, 0.05
    case = drop(tmp_path, film=1.03e-3, n=20, endTime=20 * dt, deltaT=dt)
    case.change = {'evaporation': {'type': 'fixedFlux', 'flux': J}, 'energy': False}
    case.with_vapour = False
    case.prepare()
    case.go()
    table = case.ledger()
    assert np.abs(table.thickness / (1.03e-3 - J / 997 * table.time) - 1).max() < 1e-9
    assert table.thickness[-1] < 0.85e-3
    # Only a surface that passes from one layer to the next in a step takes liquid across their face, half wetted
    assert table.maxU.max() < 2.01 * J / 997 and table.maxU[:2].max() < 1e-12


def test_stefan_tube(tmp_path):
    """The flux through 3 mm of gas in mole fractions, with and without Stefan flow: J. Stefan (1873)."""
    case = drop(tmp_path, film=1e-3, endTime=1)
    case.gas = IDEAL_GAS
    case.liquid = {k: v for k, v in BOILING_WATER.items() if k not in ('Tboil', 'pBoil')} | {'pSat': 20000}
    g = 18.0153e-3 * P0 * 2.5e-5 / (8.314462618 * 298.15 * 3e-3)
    x = 20000 / P0
    for stefan, expected in ((True, -g * np.log(1 - x)), (False, g * x)):
        case.change['evaporation'] = {'type': 'diffusion', 'stefanFlow': stefan}
        case.prepare()
        case.go()
        # Mean rho D of 24 cells: 3e-5 measured, falling as the square of their size
        assert abs(case.ledger().rate[0] / 1e-6 / expected - 1) < 1e-4


@pytest.mark.parametrize('gas', ['quasiSteady'])
def test_scale(tmp_path, gas):
    """A drop of 1 um and one of 1 mm have the same rate over R D dc."""
    rates = []
    for a in (1e-6, 1e-3):
        case = drop(tmp_path / f'{a:g}', a=a, endTime=1e-3 * (a / 1e-3)**2, deltaT=1e-3 * (a / 1e-3)**2)
        case.prepare()
        case.go()
        rates.append(case.ledger().rate[0] / (a * 2.5e-5 * RHO_GAS * saturated()))
    assert abs(rates[0] / rates[1] - 1) < 1e-6
    # Popov's pi f(60 degrees), of ten radii and few cells
    assert abs(rates[1] / (np.pi * 1.6188) - 1) < 0.15


# --- The same in other ways

def harder(path, **keywords):
    """Everything on: vapour stored, heat, Stefan flow."""
    case = drop(path, endTime=0.6, deltaT=0.1, writeInterval=3, **keywords)
    case.gas, case.liquid = IDEAL_GAS, BOILING_WATER
    case.change.update(gas='transient', energy=True)
    return case


def test_ranks_restart_reconstruct(tmp_path):
    """On two ranks, interrupted, and joined again: the same volumes, temperatures, fields."""
    one = harder(tmp_path / 'one')
    one.prepare()
    two, half = one.copy(tmp_path / 'two'), one.copy(tmp_path / 'half')
    one.go()
    table = one.ledger()
    assert table.volume[-1] < table.volume[0]

    def same(other, rows, tolerance):
        lost = table.volume[0] - table.volume[-1]
        assert np.allclose(other.volume, table.volume[rows], rtol=0, atol=tolerance * lost + 2e-10 * table.volume[0])
        assert np.allclose(other.evaporated, table.evaporated[rows], rtol=tolerance, atol=0)
        assert np.allclose(other.Tsurface, table.Tsurface[rows], rtol=1e-8, atol=0)

    two.decompose(2)
    two.go(2)
    same(two.ledger(), slice(None), 1e-8)

    half.control['endTime'] = 0.3
    half.write()
    half.go()
    same(half.ledger(), slice(0, 3), 1e-12)
    half.control['endTime'] = 0.6
    half.write()
    half.go()
    same(half.ledger('0.3'), slice(3, 6), 1e-9)

    # Joined: the fields of one rank; and it goes on from there
    two._must('reconstructPar')
    for name in ('alpha.liquid', 'Y.liquid', 'T'):
        mine, theirs = field(one, name, '0.6'), field(two, name, '0.6')
        assert len(mine) > 300 and np.abs(mine - theirs).max() < 1e-8 * np.abs(mine).max(), name
    for time in ('0.6',):
        for folder in [two.path / time, *two.path.glob(f'processor*/{time}')]:
            folder.rename(folder.parent / 'taken')
    two.control['startFrom'] = 'latestTime'
    two.write()
    two.go()
    same(two.ledger('0.3'), slice(3, 6), 1e-8)


def test_restart_goes_on_at_its_step(tmp_path):
    """The length of the step after a restart follows from the rate before it: that of the uninterrupted run."""
    control = {'adjustTimeStep': True, 'maxVolumeChange': 0.01, 'maxCo': 1e9, 'maxDeltaT': 1e9,
               'writeControl': 'timeStep', 'writeInterval': 4}
    one = drop(tmp_path / 'one', endTime=40, deltaT=4, **control)
    one.prepare()
    one.go()
    table = one.ledger()
    at = min((folder.name for folder in one.path.glob('[1-9]*')), key=float)
    assert abs(float(at) / table.time[3] - 1) < 1e-8
    one.control.update(startFrom='startTime', startTime=at)
    one.write()
    one.go()
    again = one.ledger(at)
    assert len(table) > 6 and np.diff(table.time)[3] < 1.15 * np.diff(table.time)[2]
    assert np.allclose(again.time, table.time[4:], rtol=1e-9, atol=0)


def field(case, name, time):
    text = (case.path / time / name).read_text()
    body = re.search(r'internalField\s+nonuniform\s+List<\w+>\s*\d+\s*\((.*?)\)\s*;', text, re.S)[1]
    return np.array(body.split(), dtype=float)


def test_along_another_axis(tmp_path):
    """The axis of the wedge along x or y, or upside down: the same rates."""
    rates = []
    for turn in (lambda p: p, lambda p: (p[2], p[0], p[1]), lambda p: (p[1], p[2], p[0]), lambda p: (p[0], -p[1], -p[2])):
        case = harder(tmp_path / str(len(rates)))
        case.turn = turn
        case.prepare()
        case.go()
        rates.append(case.ledger().rate)
    assert np.abs(np.array(rates) / rates[0] - 1).max() < 1e-8


# --- What a user can get wrong

BAD = {
    'noVapourField': (dict(with_vapour=False), {}, ('needs the mass fraction', 'Y.liquid', 'evaporation { type none; }')),
    'boiling': (dict(T=400.0), {}, ('boils', '373.15', 'lower the temperature')),
    'unknownEntry': ({}, {'speed': 1}, ("Unknown entry 'speed'", 'phaseChangeProperties')),
    'unknownLaw': ({}, {'evaporation': {'type': 'HertzKnudsen'}}, ('HertzKnudsen', 'diffusion', 'fixedFlux')),
    'noLaw': ({}, {'evaporation': None}, ("'evaporation'", 'phaseChangeProperties')),
    'gasWord': ({}, {'gas': 'steady'}, ('steady', 'quasiSteady', 'transient')),
    'flux': ({}, {'evaporation': {'type': 'fixedFlux'}}, ("'flux'", 'evaporation')),
}


@pytest.mark.parametrize('name', BAD)
def test_bad_input(tmp_path, name):
    """One message that names what is wrong, and the remedy."""
    case = drop(tmp_path)
    attributes, changes, words = BAD[name]
    case.gas, case.liquid = IDEAL_GAS, BOILING_WATER
    for key, value in attributes.items():
        setattr(case, key, value)
    for key, value in changes.items():
        case.change[key] = value
    case.change = {k: v for k, v in case.change.items() if v is not None}
    case.prepare()
    message = case.message()
    assert all(word in message for word in words), message


def test_closed_vessel(tmp_path):
    case = drop(tmp_path)
    case.prepare()
    boundary = tmp_path / 'constant/polyMesh/boundary'
    boundary.write_text(re.sub(r'(outer\s*{\s*type\s+)patch', r'\1wall', boundary.read_text()))
    message = case.message()
    for word in ('closed in', 'pressure p0', 'constant/polyMesh/boundary'):
        assert word in message


def test_no_liquid(tmp_path):
    case = drop(tmp_path)
    case.mesh()
    message = case.message()
    assert 'There is no liquid' in message and 'setSphericalCap' in message


def test_drop_that_does_not_fit(tmp_path):
    """Of another angle than alpha, and too large for the mesh."""
    case = drop(tmp_path)
    case.prepare()
    case.motion['contactAngle'] = 61.0
    case.write()
    assert 'do not fit' in case.message()

    case.motion['contactRadius'] = 11e-3
    case.write()
    done = case.run('setSphericalCap')
    assert done.code != 0 and 'does not fit the mesh' in done.output


def test_drop_leaves(tmp_path):
    """A drop that grows into the outer boundary."""
    case = drop(tmp_path, line='constantAngle', endTime=1e4, deltaT=100)
    case.change = {'evaporation': {'type': 'fixedFlux', 'flux': -0.5}, 'energy': False}
    case.with_vapour = False
    case.prepare()
    message = case.message()
    assert 'leaves the mesh' in message and 'Make the mesh larger' in message


@pytest.mark.parametrize('a, sigma, words, code', [
    (3e-3, 0.072, ('not quite', 'Bo ='), 0), (8e-3, 0.072, ('no spherical cap', 'Bo ='), 1),
    (1e-3, 1e-7, ('no spherical cap', 'Ca ='), 1)], ids=['warning', 'Bo', 'Ca'])
def test_validity(tmp_path, a, sigma, words, code):
    """Numbers of the capillary and the Bond number are printed; out of range it warns, or ends."""
    case = drop(tmp_path, a=a, endTime=0.01, deltaT=0.01)
    case.liquid['sigma'] = sigma
    if code and words[1] == 'Ca =':
        case.gravity = (0, 0, 0)
        case.liquid['mu'] = 1.0
    case.prepare()
    done = case.run('interEvapDemFoam')
    assert (done.code != 0) == bool(code), done.output[-2000:]
    text = re.sub(r'\s+', ' ', done.output)
    assert 'drop: Ca' in text and all(word in text for word in words), done.output[-2000:]
    assert ('FOAM Warning' in done.output) == (not code)
