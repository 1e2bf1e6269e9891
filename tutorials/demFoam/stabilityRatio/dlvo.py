#!/usr/bin/python3
"""The set-up, and Fuchs' integral for it. Usage: dlvo.py VARIANT CASE   writes constant/particles.csv, constant/zeta"""
import itertools
import sys

import numpy as np

R, MU, T, A = 1e-7, 8.9e-4, 298.15, 2e-20
KT, PHI = 1.380649e-23*T, 1.380649e-23*T/1.602176634e-19
EPS, DEBYE, MIN_GAP, CUT_OFF = 78.5*8.8541878128e-12, 20e-9, 4e-9, 150e-9
D = KT/(6*np.pi*MU*R)

# Distances of centres at which pairs begin, and have escaped
START, ESCAPE = 1.25*2*R, 1.75*2*R
# Potential of the surfaces [V], and pairs along the three edges of a lattice, by height of the barrier
VARIANTS = {'0kT': (0, (12, 12, 10)), '2kT': (8.124e-3, (12, 12, 10)), '5kT': (10.75e-3, (20, 20, 12))}
SPACING = 4e-6                                          # of pairs [m]
SEED = 1


def bare(h, zeta):
    """Energy over kT at a gap h: Hamaker, and superposition of double layers"""
    r, a = h + 2*R, 4*R*R
    waals = -A/6*(a/2/(r*r - a) + a/2/r**2 + np.log1p(-a/r**2))
    return (waals + 32*np.pi*EPS*R*PHI**2*np.tanh(zeta/(4*PHI))**2*np.exp(-h/DEBYE))/KT


def U(h, zeta):
    """The same, straight below MIN_GAP, and zero from CUT_OFF on"""
    less = 1e-4*MIN_GAP
    slope = (bare(MIN_GAP + less, zeta) - bare(MIN_GAP - less, zeta))/(2*less)
    g = np.maximum(h, MIN_GAP)
    return np.where(h < CUT_OFF, bare(g, zeta) + slope*(h - g) - bare(CUT_OFF, zeta), 0)


def resistance(low, high, zeta):
    """2 R times the integral of exp(U/kT)/r^2 between distances; Fuchs' stability ratio from 2 R to infinity"""
    if np.isinf(high):
        far = 2*R + CUT_OFF
        return resistance(low, far, zeta) + 2*R/far if low < far else 2*R/low
    r = np.linspace(low, high, 400001)
    f = np.exp(U(r - 2*R, zeta))/r**2
    return 2*R*(f[1:] + f[:-1]).sum()/2*(r[1] - r[0])


def barrier(zeta):
    """Height over kT, and gap"""
    h = np.geomspace(MIN_GAP, CUT_OFF, 20001)
    u = U(h, zeta)
    return u.max(), h[u.argmax()]


def stability(zeta):
    return resistance(2*R, np.inf, zeta)


def captured(zeta, start=START, escape=ESCAPE):
    """Share of pairs from start that touch before they escape"""
    return resistance(start, escape, zeta)/resistance(2*R, escape, zeta)


if __name__ == '__main__':
    variant, case = sys.argv[1:]
    zeta, number = VARIANTS[variant]
    rng = np.random.default_rng(SEED)
    with open(f'{case}/constant/zeta', 'w') as out:
        out.write(f'zeta {zeta:.6g};\n')
    with open(f'{case}/constant/particles.csv', 'w') as out:
        out.write('x,y,z,d\n')
        for place in itertools.product(*map(range, number)):
            n = rng.normal(size=3)
            n *= START/2/np.linalg.norm(n)
            for side in -1, 1:
                out.write(','.join(f'{x:.12g}' for x in (np.array(place) + 0.5)*SPACING + side*n) + f',{2*R:.9g}\n')
