#!/usr/bin/python3
"""A drop of water in air without an end, at rest: wet bulb, rate and life from the equations of a sphere.

Usage: reference.py -list       # the runs of this tutorial
       reference.py RUN         # its conditions, as system/drop of the case
       reference.py -table      # wet bulb and K of all runs
       reference.py -life       # of the run hot: a line for each of 100 times

Nothing of DEW is used. In steady air the flow q = mDot/(4 pi R) [kg/m/s] of the vapour through all spheres gives

    rho D dY/ds = q (1 - Y),    kappa dT/ds = q (hv + int_Ts^T Cpv dT),    s = R/r from 1 to 0

exact for vapour in air that does not move, with rho, D, kappa of the place; K = -d(d^2)/dt = 8 q/rhoL. With constant
properties, and one heat capacity,

    q = rho D ln(1 + BM) = kappa/Cp ln(1 + BT),  BM = (Ys - Yinf)/(1 - Ys),  BT = Cp (Tinf - Ts)/hv

The life of the hot drop is transient: vapour and heat in the gas, heat in the liquid, radial cells that shrink with the
drop (finite volumes, methods of lines), with one simplification: the flow of the gas is q at all radii.

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


class Life:
    """Of a drop in dry air: times t [s], (d/d0)^2, surface [K] and speed of the vapour at the surface [m/s]"""

    def __init__(self, R, T_far, density, n=90, liquid=20, far=300.0):
        self.T_far, self.density = T_far, density
        self.faces = 1 + (far - 1)*(np.geomspace(1, 3e4, n + 1) - 1)/(3e4 - 1)
        self.x = (self.faces[1:] + self.faces[:-1])/2
        self.inner = np.linspace(0, 1, liquid + 1)
        self.xl = (self.inner[1:] + self.inner[:-1])/2
        self.n, self.liquid = n, liquid
        start = np.concatenate([np.zeros(n), np.full(n + liquid, T_far), [R]])
        stop = lambda _, y: y[-1] - 0.15*R                          # noqa: E731
        stop.terminal = True
        found = solve_ivp(self.slopes, (0, 1e3), start, method='BDF', events=stop, rtol=1e-5,
                          atol=np.concatenate([np.full(n, 1e-8), np.full(n + liquid, 1e-4), [1e-6*R]]))
        self.t, self.d2 = found.t, (found.y[-1]/R)**2
        surface = [self.surface(y) for y in found.y.T]
        self.Ts = np.array([Ts for Ts, _ in surface])
        self.speed = np.array([m for _, m in surface])/rho(mass(p_sat(self.Ts)/P0), self.Ts)

    def surface(self, y):
        """Temperature and what evaporates [kg/m2/s], by the balance of heat"""
        Y, T, Tl, R = y[0], y[self.n], y[-2], y[-1]
        gas, liquid = R*(1 - 1/self.x[0]), R*(1 - self.xl[-1])

        def flux(Ts):
            Ys = mass(p_sat(Ts)/P0)
            return rho((Y + Ys)/2, (T + Ts)/2)*diffusivity((T + Ts)/2)*np.log1p((Ys - Y)/(1 - Ys))/gas

        def excess(Ts):
            Ys = mass(p_sat(Ts)/P0)
            return (kappa((Y + Ys)/2, (T + Ts)/2)*(T - Ts)/gas + kappa_liquid(Tl)*(Tl - Ts)/liquid
                    - flux(Ts)*latent(Ts))
        Ts = Tl
        for _ in range(6):
            e = excess(Ts)
            Ts -= e*1e-3/(excess(Ts + 1e-3) - e)
        return Ts, flux(Ts)

    def slopes(self, _, y):
        n, x = self.n, self.x
        Y, T, Tl, R = y[:n], y[n:2*n], y[2*n:-1], y[-1]
        Ts, m = self.surface(y)
        Ys = mass(p_sat(Ts)/P0)
        dR = -m/self.density

        # Values on and between the surface, the cells and the far end; gradients of 1/x
        values = [np.concatenate([[s], f, [end]]) for s, f, end in ((Ys, Y, 0.0), (Ts, T, self.T_far))]
        at = np.concatenate([[1.0], x, [self.faces[-1]]])
        Yf, Tf = ((v[1:] + v[:-1])/2 for v in values)
        dY, dT = (np.diff(v)/(1/at[:-1] - 1/at[1:])/R for v in values)      # x^2 d/dr
        j = -rho(Yf, Tf)*diffusivity(Tf)*dY                                 # x^2 times the flux
        heat = -kappa(Yf, Tf)*dT
        volume = (self.faces[1:]**3 - self.faces[:-1]**3)/3*R
        density = rho(Y, T)
        cp = Y*cp_steam(T) + (1 - Y)*cp_air(T)

        # Advection not in the form of fluxes: as what it carries over, less what it has
        flow = np.full(n + 1, m)
        capacity = flow*(Yf*cp_steam(Tf) + (1 - Yf)*cp_air(Tf)) + j*(cp_steam(Tf) - cp_air(Tf))

        def carried(flux, face, cell):
            return flux[1:]*(face[1:] - cell) - flux[:-1]*(face[:-1] - cell)
        faceY, faceT = (np.concatenate([[s], np.interp(self.faces[1:-1], x, f), [end]])
                        for s, f, end in ((Ys, Y, 0.0), (Ts, T, self.T_far)))
        move = x*dR/R
        rateY = -(np.diff(j) + carried(flow, faceY, Y))/(density*volume) + move*np.gradient(Y, x)
        rateT = -(np.diff(heat) + carried(capacity, faceT, T))/(density*cp*volume) + move*np.gradient(T, x)

        k, c = kappa_liquid(Tl), self.density*cp_liquid(Tl)
        inner = np.zeros(self.liquid + 1)
        inner[1:-1] = -(k[1:] + k[:-1])/2*np.diff(Tl)/np.diff(self.xl)/R
        inner[-1] = -k[-1]*(Ts - Tl[-1])/(1 - self.xl[-1])/R
        shells = (self.inner[1:]**3 - self.inner[:-1]**3)/3*R
        rateL = -np.diff(self.inner**2*inner)/(c*shells) + self.xl*dR/R*np.gradient(Tl, self.xl)
        return np.concatenate([rateY, rateT, rateL, [dR]])


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
    elif argument == '-life':
        life = Life(HOT_RADIUS, HOT, wet_bulb('hot')[2])
        for t in np.linspace(0, life.t[-1], 101):
            print(*(f'{v:.8g}' for v in (t, *(np.interp(t, life.t, f) for f in (life.d2, life.Ts, life.speed)))))
    elif argument in runs():
        conditions(argument)
    else:
        print(f'Unknown run {argument}; known: ' + ' '.join(runs()), file=sys.stderr)
        return 1
    return 0


if __name__ == '__main__':
    sys.exit(main())
