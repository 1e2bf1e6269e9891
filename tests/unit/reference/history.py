#!/usr/bin/python3
"""Writes history.csv: integrals of the kernels of Basset and of Mei & Adrian (1992, eq. 25 with fH = 0.75 + 0.105 Re)
by mpmath's quadrature with 20 digits; and windows.csv: force of a sinusoid with a window of Basset's kernel.
"""
from mpmath import exp, expj, mp, mpf, pi, quad, sqrt

mp.dps = 20


def basset(s, R, nu, w):
    return R / sqrt(pi * nu * s)


def mei_adrian(s, R, nu, w):
    fH = mpf('0.75') + mpf('0.105') * 2 * R * w / nu
    return ((pi * s * nu / R**2)**mpf('0.25') + (pi / 2 * w**3 / (R * nu * fH**3) * s**2)**mpf('0.5'))**-2


def integral(K, a, b):
    """Over [a, b], in x = sqrt(s)."""
    return quad(lambda x: 2 * x * K(x * x), [sqrt(a), sqrt(b)])


def row(R, nu, w, a, b, h):
    values = []
    for kernel in (basset, mei_adrian):
        def K(s, k=kernel):
            return k(s, R, nu, w) if s > 0 else mpf(0)
        values += [integral(K, a, b), integral(lambda s: K(s) * (1 - s / h), mpf(0), h)]
        values += [quad(lambda t: integral(K, a + t, b + t), [0, h]) / h]
    return values


def main():
    with open('history.csv', 'w') as out:
        out.write('# Integral of the kernel from a to b, of the newest step h, of a step from a to b over the next h;\n'
                  '# of Basset and of Mei and Adrian [s]: python3 history.py\n# R [m], nu [m2/s], slip [m/s], a, b, h [s]\n')
        for R, nu, w in ((5e-4, 1e-6, 1e-3), (5e-4, 1e-6, 0.05), (5e-5, 1.5e-5, 0.1)):
            unit = 1e-3 * R * R / nu
            for a, b in ((0, 1), (1, 2), (2, 3.5), (19, 20)):
                numbers = (R, nu, w, a * unit, b * unit, unit)
                values = row(*(mpf(n) for n in numbers))
                out.write(','.join(repr(float(n)) for n in (*numbers, *values)) + '\n')

    with open('windows.csv', 'w') as out:
        out.write('# In-phase and 90 degrees ahead part of int K dw/dt, w = sin(omega t), K s^-1/2 up to the window,\n'
                  '# omega 1; then with the tail W^-1/2 exp(1/2 - s/(2 W)); python3 history.py\n# window W [s]\n')
        for W in (3.0, 6.0, 12.0, 24.0):
            inside = quad(lambda x: 2 * expj(x * x), [0, *(sqrt(mpf(W) * k / 8) for k in range(1, 9))])
            decay = 1 / mpf(2 * W) - 1j
            both = inside + exp(mpf(1) / 2 - decay * W) / decay / sqrt(W)
            values = [inside.imag, inside.real, both.imag, both.real]
            out.write(','.join(repr(float(n)) for n in (W, *values)) + '\n')


main()
