#!/usr/bin/python3
"""Writes immersionForce.csv with 40 digits: the contact line of a sphere in a film and the attraction of two.

Columns: R, theta, film, q, height of the line, charge Q, L, F/sigma, U/sigma. The line is found by mpmath's secant method
in the angle beta, not by halving the height; Bessel functions are integrals, K_n(x) = int exp(-x cosh t) cosh(n t) dt.
"""
import mpmath as mp

mp.mp.dps = 40


def K(n, x):
    end = mp.acosh(1 + 120 / x)
    return mp.quad(lambda t: mp.exp(-x * mp.cosh(t)) * mp.cosh(n * t), mp.linspace(0, end, 12))


def line(R, theta, film, q):
    def charge(beta):
        return R * mp.sin(beta) * mp.sin(beta - theta)

    def miss(beta):
        slope = mp.cos(beta - theta)
        log = mp.log(4 / (mp.exp(mp.euler) * q * R * mp.sin(beta) * (1 + slope)))
        return (R * (1 + mp.cos(beta)) - film - charge(beta) * log) / R
    flat = mp.acos(film / R - 1)
    beta = mp.findroot(miss, (theta, flat), solver='anderson', tol=1e-60)
    return R * (1 + mp.cos(beta)), charge(beta)


if __name__ == '__main__':
    print('# R, theta, film, q, height, Q, L, F/sigma, U/sigma: python3 immersionForce.py')
    for R, theta, film, q in ((5e-7, 0.1, 8e-7, 370.0), (5e-7, 0.5, 6e-7, 370.0), (1e-6, 1.2, 1.9e-6, 1e4),
                              (2.5e-8, 0.3, 2e-8, 1e5), (5e-6, 1.5, 1e-6, 370.0)):
        b, Q = line(*(mp.mpf(v) for v in (R, theta, film, q)))
        for L in (2.5 * R, 20 * R, 1 / q, 8 / q):
            x = mp.mpf(q) * mp.mpf(L)
            F, U = -2 * mp.pi * Q * Q * q * K(1, x), -2 * mp.pi * Q * Q * K(0, x)
            print(','.join(repr(float(v)) for v in (R, theta, film, q, b, Q, L, F, U)))
