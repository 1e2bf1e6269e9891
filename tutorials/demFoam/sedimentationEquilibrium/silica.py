#!/usr/bin/python3
"""The set-up, and what Boltzmann expects of it. Usage: silica.py CASE   writes constant/particles.csv"""
import sys

import numpy as np

R, RHO, WATER, G, MU, T = 5e-7, 2000.0, 997.0, 9.81, 8.9e-4, 298.15
KT, PHI = 1.380649e-23*T, 1.380649e-23*T/1.602176634e-19
EPS, DEBYE, ZETA, MIN_GAP, CUT_OFF = 78.5*8.8541878128e-12, 30e-9, 25e-3, 150e-9, 500e-9
N, SIDE, SEED = 1000, 1e-3, 1

# Barometric length kT/(weight - buoyancy), and diffusivity far from the floor
LENGTH = KT/((RHO - WATER)*G*4/3*np.pi*R**3)
D = KT/(6*np.pi*MU*R)
# The slowest change of the profile, exp(-t/RELAX), in a fluid without hindrance
RELAX = 4*LENGTH**2/D


def U(h):
    """Energy over kT at a gap h of the floor: weight, and superposition of double layers, straight below MIN_GAP"""
    top = 64*np.pi*EPS*R*PHI**2*np.tanh(ZETA/(4*PHI))**2/KT
    g = np.maximum(h, MIN_GAP)
    layer = top*np.exp(-g/DEBYE)*(1 + (g - h)/DEBYE) - top*np.exp(-CUT_OFF/DEBYE)
    return h/LENGTH + np.where(h < CUT_OFF, layer, 0)


def mobility(h):
    """Along the normal of the floor, relative to Stokes'"""
    y = h/R
    return (6*y*y + 2*y)/(6*y*y + 9*y + 2)


def shares(edges, weight=None):
    """Of the particles between edges; and their mean gap. weight 1/mobility: without the drift"""
    h = np.linspace(0, 30*LENGTH, 600001)
    p = np.exp(-U(h))*(1 if weight is None else weight(np.maximum(h, 1e-12)))
    total = np.concatenate([[0], np.cumsum((p[1:] + p[:-1])/2)])
    h, total = h, total/total[-1]
    return np.diff(np.interp(edges, h, total)), (h*p).sum()/p.sum()


if __name__ == '__main__':
    rng = np.random.default_rng(SEED)
    # A square grid, so that none overlap; gaps evenly from 0.2 um to 1.8 um
    n = int(np.ceil(np.sqrt(N)))
    places = (np.array(list(np.ndindex(n, n)))[:N] + 0.5)*SIDE/n
    gaps = rng.permutation(np.linspace(0.2e-6, 1.8e-6, N))
    with open(f'{sys.argv[1]}/constant/particles.csv', 'w') as out:
        out.write('x,y,z,d\n')
        for (x, y), h in zip(places, gaps):
            out.write(f'{x:.9g},{y:.9g},{R + h:.9g},{2*R:.9g}\n')
