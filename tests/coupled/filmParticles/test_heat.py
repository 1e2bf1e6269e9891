"""Heat between particles and an evaporating liquid or the gas above it, in interEvapDemFoam with a surface that the flow
carries. Closed forms: m cp dT/dt = - Nu kappa pi d (T - Tf) with Nu = 2 + 0.6 Re^(1/2) Pr^(1/3) of Ranz and Marshall,
Chem. Eng. Prog. 48 (1952) 141, with the properties of what is around the particle. Balances are identities of the
equations.
"""
import numpy as np
import pytest

from columnCase import BOILING, STEAM
from evaporationCase import WATER, EvaporationCase
from filmCase import FilmCase

D, RHO_P, CP_P, T_F, T_P = 1e-4, 2500.0, 500.0, 300.0, 350.0
MU_L, MU_G = 2.82e-4, 1.23e-5
MASS = RHO_P*np.pi/6*D**3
LIQUID = {'rho': BOILING['rho'], 'mu': MU_L, 'k': BOILING['k'], 'Cp': BOILING['Cp']}
GAS = {'rho': STEAM['rho'], 'mu': MU_G, 'k': STEAM['k'], 'Cp': STEAM['Cp']}
RANZ_MARSHALL = {'heatTransfer': {'type': 'RanzMarshall'}}


def film(path, positions, cells=10, length=1e-2, surface=5e-3, coupling=None, T=T_P, engine='prescribed', **keywords):
    properties = {k: keywords.pop(k) for k in ('velocity', 'timeStep') if k in keywords}
    case = FilmCase(path, cells, length, surface, **keywords)
    case.law, case.T, case.T_low, case.T_high = {'type': 'none'}, T_F, T_F, T_F
    case.spheres(positions, D, engine=engine, T=T, density=RHO_P, heatCapacity=CP_P,
                 coupling={**RANZ_MARSHALL, **(coupling or {})}, **properties)
    return case


def rate(around, v):
    """Nu kappa pi d/(m cp) [1/s]"""
    Re, Pr = around['rho']*abs(v)*D/around['mu'], around['mu']*around['Cp']/around['k']
    return (2 + 0.6*Re**0.5*Pr**(1/3))*around['k']*np.pi*D/(MASS*CP_P)


@pytest.mark.parametrize('x, v, around', [(2.5e-3, 0.0, LIQUID), (2.2e-3, 0.02, LIQUID), (7.5e-3, 0.0, GAS),
                                          (6.2e-3, 0.5, GAS)])
def test_cools_by_the_law(tmp_path, x, v, around):
    """In the liquid and in the gas, at rest and moved through them; the fluid stays as it is (heat none)."""
    dt = 0.1/rate(around, v)
    case = film(tmp_path, [(x, 9e-4, 1.1e-3)], velocity=f'constant (0 {v!r} 0)', coupling={'heat': 'none'},
                endTime=20*dt, deltaT=dt, writeInterval=20)
    case.mesh()
    case.go()
    T = case.table(20*dt)['T'][0]
    assert T - T_F == pytest.approx((T_P - T_F)*np.exp(-rate(around, v)*20*dt), rel=1e-9)


def test_from_gas_into_liquid(tmp_path):
    """Through the surface, at constant speed: with the properties of both by the share of the sphere in each (cap of a
    sphere), integrated here in a thousand times smaller steps. The share is that of the middle of a step: second order."""
    v, x0, surface, n = -0.1, 5.3e-3, 5e-3, 120
    dt = 6e-3/n
    case = film(tmp_path, [(x0, 9e-4, 1.1e-3)], surface=surface, velocity=f'constant ({v!r} 0 0)',
                coupling={'heat': 'none'}, endTime=n*dt, deltaT=dt, writeInterval=n//4)
    case.mesh()
    case.go()
    fine = 1000*n
    t = (np.arange(fine) + 0.5)*6e-3/fine
    beyond = np.clip((x0 + v*t - surface)/(D/2), -1, 1)         # of the centre, in radii
    share = (1 - beyond)**2*(2 + beyond)/4
    mixed = {k: share*LIQUID[k] + (1 - share)*GAS[k] for k in ('rho', 'mu', 'k')}
    mixed['Cp'] = (share*LIQUID['rho']*LIQUID['Cp'] + (1 - share)*GAS['rho']*GAS['Cp'])/mixed['rho']
    loss = np.cumsum(rate(mixed, v))*6e-3/fine
    for k in range(1, 5):
        T = case.table(k*n//4*dt)['T'][0]
        assert T - T_F == pytest.approx((T_P - T_F)*np.exp(-loss[k*fine//4 - 1]), rel=2e-3), k


def test_in_a_film_that_keeps_its_shape(tmp_path):
    """The same law with a quasi-static surface, where particles see the liquid."""
    tau = MASS*CP_P/(2*WATER['kappa']*np.pi*D)
    case = EvaporationCase(tmp_path, film=0.5e-3, endTime=2*tau, deltaT=0.1*tau, writeInterval=20)
    case.change, case.with_vapour = {'evaporation': {'type': 'none'}, 'energy': True}, False
    like = film(tmp_path, [(4e-4, 5e-4, 2.2e-4)], coupling={'heat': 'none'})
    case.properties = like.properties
    case.prepare()
    case.go()
    assert case.table(2*tau)['T'][0] - case.T == pytest.approx((T_P - case.T)*np.exp(-2), rel=1e-9)


def energy(case, time, n, share=1.0):
    """Of fluid and particles over that at T_F, by fields and particles [J]"""
    T, alpha = case.field('T', time), case.field('alpha.water', time)
    V = case.width**3
    rhoCp = alpha*LIQUID['rho']*LIQUID['Cp'] + (1 - alpha)*GAS['rho']*GAS['Cp']
    fluid = np.sum(np.broadcast_to(share*rhoCp*(T - T_F), (n,)))*V
    return fluid, MASS*CP_P*np.sum(case.table(float(time))['T'] - T_F)


def closed(path, **keywords):
    x = np.random.default_rng(5).uniform(0, 1, (40, 3))*(8e-3, 2e-3, 2e-3) + (1e-3, 0, 0)
    case = film(path, x, closed=True, coupling={'voidFraction': {'type': 'divided'}}, **{
        'endTime': 0.1, 'deltaT': 5e-3, 'writeInterval': 10, **keywords})
    case.T_low = None
    return case


def test_nothing_is_lost(tmp_path):
    """40 hot spheres in a closed box of liquid and gas: what the fluid holds is what they have given, to 1e-10."""
    case = closed(tmp_path)
    case.mesh()
    case.go()
    time = case.times()[-1]
    fluid, particles = energy(case, time, case.n*case.sides**2, case.field('alphac', time))
    given = 40*MASS*CP_P*(T_P - T_F) - particles - case.pending_heat(time).sum()
    assert given > 0.5*40*MASS*CP_P*(T_P - T_F)
    assert fluid == pytest.approx(given, rel=1e-10)
    assert fluid == pytest.approx(-case.ledger().heatLost.sum(), rel=1e-10)


def test_ranks_and_restart(tmp_path):
    """Two ranks, and a run in two parts, as one."""
    results = []
    for name, ranks in (('one', 1), ('two', 2)):
        case = closed(tmp_path / name)
        case.mesh()
        if ranks > 1:
            case.decompose(ranks)
        case.go(ranks)
        results.append((case.joined_field('T', '0.1', ranks), case.table(0.1)['T']))
    for a, b in zip(*results):
        assert np.abs(a - b).max() < 1e-9

    case = closed(tmp_path / 'one', startFrom='startTime', startTime=0.05)
    case.write()
    case.go()
    assert np.abs(case.field('T', '0.1') - results[0][0]).max() < 1e-9
    assert np.abs(case.table(0.1)['T'] - results[0][1]).max() < 1e-9
