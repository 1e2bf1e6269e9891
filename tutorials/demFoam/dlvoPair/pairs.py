#!/usr/bin/python3
"""The set-up and the potential in closed form. Usage: pairs.py CASE   writes particles.csv to standard output"""
import sys

import numpy as np

R, RHO, T, A = 5e-7, 1055.0, 373.0, 1.2e-20
EPS, DEBYE, MIN_GAP = 80*8.8541878128e-12, 5e-9, 5e-10
K, E = 1.380649e-23, 1.602176634e-19
KT, PHI = K*T, K*T/E
M = RHO*4/3*np.pi*R**3
START = 40e-9                                           # gap at the start [m]

# Potential of the surface [V]: of 1000 e/um2 by Grahame's equation, and that of the stable set
PSI = {'published': 2*PHI*np.arcsinh(1.602e-4*DEBYE/(2*EPS*PHI)), 'stable': 25e-3}


def U(h, case):
    """Energy of two spheres over kT: Hamaker, and superposition of double layers"""
    r, a = h + 2*R, 4*R*R
    waals = -A/6*(a/2/(r*r - a) + a/2/r**2 + np.log1p(-a/r**2))
    layer = 32*np.pi*EPS*R*PHI**2*np.tanh(PSI[case]/(4*PHI))**2*np.exp(-h/DEBYE)
    return (waals + layer)/KT


def barrier(case):
    """Height over kT, and gap, of the largest energy"""
    h = np.geomspace(MIN_GAP, START, 200001)
    u = U(h, case)
    k = np.argmax(u)
    return u[k], h[k]


def energies(case):
    """Kinetic energies of approach over kT at the start"""
    if case == 'published':
        return [1, 3, 10, 100]
    top = barrier(case)[0] - U(START, case)
    return [0.5*top, 0.9*top, 0.98*top, 1.02*top, 1.1*top, 1.5*top]


if __name__ == '__main__':
    print('x,y,z,vx,vy,vz,d')
    for i, e in enumerate(energies(sys.argv[1])):
        v = np.sqrt(e*KT/M)                             # each; m v^2 of both is e kT
        for side in -1, 1:
            print(f'{1e-5 + side*(R + START/2)!r},{3e-6*(i + 1)!r},2e-6,{-side*v!r},0,0,{2*R!r}')
