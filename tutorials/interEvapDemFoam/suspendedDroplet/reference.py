#!/usr/bin/python3
"""A drop of water in air without an end, at rest: wet bulb, rate and life from the equations of a sphere.

Usage: reference.py -list       # the runs of this tutorial
       reference.py RUN         # its conditions, as system/drop of the case
       reference.py -table      # wet bulb and K of all runs

Nothing of DEW is used. In steady air the flow q = mDot/(4 pi R) [kg/m/s] of the vapour through all spheres gives

    rho D dY/ds = q (1 - Y),    kappa dT/ds = q (hv + int_Ts^T Cpv dT),    s = R/r from 1 to 0

exact for vapour in air that does not move, with rho, D, kappa of the place; K = -d(d^2)/dt = 8 q/rhoL. With constant
properties, and one heat capacity,

    q = rho D ln(1 + BM) = kappa/Cp ln(1 + BT),  BM = (Ys - Yinf)/(1 - Ys),  BT = Cp (Tinf - Ts)/hv

Properties: IAPWS (density of water; conductivity and viscosity of steam), DIPPR (its saturation, heat of vaporisation,
heat capacity, conductivity), JANAF (heat capacity of steam), U.S. Standard Atmosphere and Kyle (air), mixtures by
Wilke, D = 2.5e-5 m2/s (T/298.15)^1.75. Needs numpy and scipy.
"""
import sys

import numpy as np
from scipy.integrate import solve_ivp
from scipy.optimize import brentq, fsolve

RU, P0 = 8.31446261815324, 101325.0
WV, WC = 18.015e-3, 28.9647e-3

# Kelvin and per cent of humidity
PAIRS = [(298.15, 0), (298.15, 25), (298.15, 50), (298.15, 75), (323.15, 0), (323.15, 50), (360, 0), (373.15, 0),
         (473.15, 0), (646, 0)]
CONSTANT = [(298.15, 0), (298.15, 50), (373.15, 0)]
RADIUS, HOT_RADIUS, HOT = 50e-6, 0.35e-3, 360.0


def p_sat(T):
    return np.exp(73.649 - 7258.2/T - 7.3037*np.log(T) + 4.1653e-6*T**2)


def latent(T):
    t = T/647.13
    return 2889425.47876769*(1 - t)**(0.3199 + t*(-0.212 + t*0.25795))


def rho_liquid(T):
    c = (1 - T/647.096)**(1/3)
    return 322*(1 + 1.99274064*c + 1.09965342*c**2 - 0.510839303*c**5 - 1.75493479*c**16 - 45.5170352*c**43
                - 6.74694450e5*c**110)


def cp_liquid(T):
    return (15341.1046350264 + T*(-116.019983347211 + T*(0.451013044684985 + T*(-0.000783569247849015
            + T*5.20127671384957e-07))))


def kappa_liquid(T):
    return -0.4267 + T*(0.0056903 + T*(-8.0065e-06 + T*1.815e-09))


def cp_steam(T):
    return RU/WV*(4.1986352 + T*(-0.0020364017 + T*(6.5203416e-06 + T*(-5.4879269e-09 + T*1.771968e-12))))


def cp_air(T):
    return (28.11 + T*(1.967e-3 + T*(4.802e-6 - T*1.966e-9)))/WC


def mu_steam(T):
    t = T/647.096
    return 1e-4*np.sqrt(t)/(1.67752 + 2.20462/t + 0.6366564/t**2 - 0.241605/t**3)


def kappa_steam(T):
    t = T/647.096
    return 1e-3*np.sqrt(t)/(2.443221e-3 + 1.323095e-2/t + 6.770357e-3/t**2 - 3.454586e-3/t**3 + 4.096266e-4/t**4)


def mu_air(T):
    return 1.458e-6*T**1.5/(T + 110.4)


def kappa_air(T):
    return 2.64638e-3*T**1.5/(T + 245.4*10**(-12/T))


def mole(Y):
    return Y*WC/(Y*WC + (1 - Y)*WV)


def mass(x):
    return x*WV/(x*WV + (1 - x)*WC)


def kappa(Y, T):
    x = mole(Y)
    r = np.sqrt(mu_steam(T)/mu_air(T))
    vc = (1 + r*(WC/WV)**0.25)**2/np.sqrt(8*(1 + WV/WC))
    cv = (1 + (WV/WC)**0.25/r)**2/np.sqrt(8*(1 + WC/WV))
    return x*kappa_steam(T)/(x + (1 - x)*vc) + (1 - x)*kappa_air(T)/(1 - x + x*cv)


def rho(Y, T):
    return P0/(RU*T*(Y/WV + (1 - Y)/WC))


def diffusivity(T):
    return 2.5e-5*(T/298.15)**1.75


def far_vapour(T, humidity):
    return mass(humidity/100*p_sat(T)/P0)


def steady(T_far, Y_far):
    """Wet bulb [K] and q [kg/m/s], properties of the place"""
    def far(q, Ts):
        def slope(_, y):
            Y, T, h = y
            dT = q*h/kappa(Y, T)
            return [-q*(1 - Y)/(rho(Y, T)*diffusivity(T)), dT, cp_steam(T)*dT]
        end = solve_ivp(slope, (0, 1), [mass(p_sat(Ts)/P0), Ts, latent(Ts)], rtol=1e-9, atol=1e-12)
        return end.y[:2, -1]

    Ts, q = constant(T_far, Y_far)
    q, Ts = fsolve(lambda v: (far(v[0]*1e-6, v[1]) - [Y_far, T_far])*[100, 1], [q*1e6, Ts], xtol=1e-10)
    return Ts, q*1e-6


def constant(T_far, Y_far):
    """The same with constant properties, closed form"""
    def flows(Ts):
        Ys = mass(p_sat(Ts)/P0)
        return 1.18*2.5e-5*np.log1p((Ys - Y_far)/(1 - Ys)), 0.026/1006*np.log1p(1006*(T_far - Ts)/2.44e6)
    Ts = brentq(lambda T: np.subtract(*flows(T)), 230, min(T_far, 373), xtol=1e-10)
    return Ts, flows(Ts)[0]


def runs():
    """Name -> set of properties, temperature and vapour far away, radius"""
    table = {}
    for kind, pairs in (('constant', CONSTANT), ('real', PAIRS)):
        for T, humidity in pairs:
            table[f'{kind}-{T:.0f}-{humidity}'] = (kind, T, far_vapour(T, humidity), RADIUS)
    table['hot'] = ('real', HOT, 0.0, HOT_RADIUS)
    return table


def wet_bulb(run):
    """Temperature [K], K [m2/s], density of the liquid there"""
    kind, T, Y, _ = runs()[run]
    Ts, q = (constant if kind == 'constant' else steady)(T, Y)
    density = 997.0 if kind == 'constant' else rho_liquid(Ts)
    return Ts, 8*q/density, density


def conditions(run):
    _, T, Y, R = runs()[run]
    Ts, K, density = wet_bulb(run)
    life = 4*R**2/K
    hot = run == 'hot'
    # Water at 300 K, or as the air if that is colder; the hot drop as the air
    start = T if hot else min(T, 300)
    entries = {'radius': R, 'Tinfinity': T, 'Yinfinity': Y, 'Tstart': start, 'rho': density,
               'endTime': (0.9 if hot else 0.5)*life, 'deltaT': life/2000}
    for name, value in entries.items():
        print(f'{name:15} {value if isinstance(value, str) else format(value, ".12g")};')


def main():
    argument = sys.argv[1] if len(sys.argv) == 2 else ''
    if argument == '-list':
        print(*runs())
    elif argument == '-table':
        for run in runs():
            print('{:18} wet bulb {:.3f} K, K {:.5e} m2/s, liquid {:.2f} kg/m3'.format(run, *wet_bulb(run)))
    elif argument in runs():
        conditions(argument)
    else:
        print(f'Unknown run {argument}; known: ' + ' '.join(runs()), file=sys.stderr)
        return 1
    return 0


if __name__ == '__main__':
    sys.exit(main())
