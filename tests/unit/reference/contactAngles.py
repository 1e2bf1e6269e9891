#!/usr/bin/python3
"""Writes contactAngles.csv: laws of Kistler and of Cox and Voinov as published, the inverse by Brent's method."""
from math import acos, degrees, log, radians, tanh

from scipy.optimize import brentq


def hoffman(x):
    return acos(1 - 2*tanh(5.16*(x/(1 + 1.31*x**0.99))**0.706)) if x > 0 else 0.0


def kistler(advancing, receding, Ca):
    static = radians(advancing if Ca > 0 else receding)
    return degrees(hoffman(Ca + brentq(lambda x: hoffman(x) - static, 0, 100, xtol=1e-16)))


def cox(static, L, slip, Ca):
    return degrees(max(radians(static)**3 + 9*Ca*log(L/slip), 0)**(1/3))


print('# Dynamic contact angles (python3 contactAngles.py): S. F. Kistler in Wettability (1993) 311; O. V. Voinov,')
print('# Fluid Dyn. 11 (1976) 714. Law 0 Kistler: law, thetaA, thetaR [degrees], 0, Ca, theta [degrees]')
print('# Law 1 Cox and Voinov: law, theta [degrees], L [m], lambda [m], Ca, theta [degrees]')
for angles in ((90, 60), (120, 120), (60, 0), (30, 15)):
    for speed in (-0.1, -1e-3, -1e-5, 1e-5, 1e-3, 0.01, 0.1, 1.0):
        print(f'0,{angles[0]},{angles[1]},0,{speed!r},{kistler(*angles, speed)!r}')
for static in (0, 30, 60, 110):
    for lengths in ((1e-5, 1e-9), (1e-4, 1e-8), (1e-6, 5e-7)):
        for speed in (-0.1, -1e-4, 1e-4, 1e-3, 0.01):
            print(f'1,{static},{lengths[0]!r},{lengths[1]!r},{speed!r},{cox(static, *lengths, speed)!r}')
