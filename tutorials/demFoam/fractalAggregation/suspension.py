#!/usr/bin/python3
"""The set-up, and the neighbours in it. Usage: suspension.py SEED CASE   writes particles.csv, seed, box in constant"""
import sys

import numpy as np

R, MU, T, A = 2.5e-7, 8.9e-4, 298.15, 8e-20
KT = 1.380649e-23*T
MIN_GAP, CUT_OFF = 25e-9, 500e-9
D = KT/(6*np.pi*MU*R)
N, PHI = 2000, 2e-3
BOX = float(f'{(N*4/3*np.pi*R**3/PHI)**(1/3):.4g}')
SEEDS = ('1', '2', '3')


def U(h):
    """Energy over kT at a gap h: Hamaker, straight below MIN_GAP, and zero from CUT_OFF on"""
    def bare(g):
        r, a = g + 2*R, 4*R*R
        return -A/6*(a/2/(r*r - a) + a/2/r**2 + np.log1p(-a/r**2))/KT
    less = 1e-4*MIN_GAP
    slope = (bare(MIN_GAP + less) - bare(MIN_GAP - less))/(2*less)
    g = np.maximum(h, MIN_GAP)
    return np.where(h < CUT_OFF, bare(g) + slope*(h - g) - bare(CUT_OFF), 0)


def stability():
    """Fuchs' W = 2 R int exp(U/kT)/r^2 dr from contact on"""
    r = np.linspace(2*R, 2*R + CUT_OFF, 400001)
    f = np.exp(U(r - 2*R))/r**2
    return 2*R*((f[1:] + f[:-1]).sum()/2*(r[1] - r[0]) + 1/r[-1])


# Distance at which a sphere that takes up all it meets would meet as many
CAPTURE = 2*R/stability()


def neighbours(x, reach):
    """Pairs of the periodic box closer than reach, by cells: time in proportion to the number"""
    n = int(BOX/reach)
    cell = np.floor(x/BOX*n).astype(int) % n
    key = (cell[:, 0]*n + cell[:, 1])*n + cell[:, 2]
    order = key.argsort(kind='stable')
    key = key[order]
    pairs = []
    for shift in np.ndindex(3, 3, 3):
        near = (cell[order] + np.array(shift) - 1) % n
        near = (near[:, 0]*n + near[:, 1])*n + near[:, 2]
        begin, end = np.searchsorted(key, near), np.searchsorted(key, near, side='right')
        number = end - begin
        i = np.repeat(np.arange(len(x)), number)
        j = np.arange(number.sum()) - np.repeat(number.cumsum() - number - begin, number)
        i, j = order[i], order[j]
        r = x[j] - x[i]
        r -= BOX*np.round(r/BOX)
        keep = (i < j) & ((r*r).sum(axis=1) < reach**2)
        pairs.append(np.stack([i[keep], j[keep]], axis=1))
    return np.concatenate(pairs)


if __name__ == '__main__':
    seed, case = sys.argv[1:]
    rng = np.random.default_rng(int(seed))
    # At random, those that another has already met anew
    x = rng.uniform(0, BOX, (N, 3))
    while len(close := neighbours(x, CAPTURE)):
        later = np.unique(close[:, 1])
        x[later] = rng.uniform(0, BOX, (len(later), 3))
    with open(f'{case}/constant/box', 'w') as out:
        out.write(f'box {BOX:.9g};\n')
    with open(f'{case}/constant/seed', 'w') as out:
        out.write(f'seed {seed};\n')
    with open(f'{case}/constant/particles.csv', 'w') as out:
        out.write('x,y,z,d\n')
        for row in x:
            out.write(','.join(f'{v:.9g}' for v in row) + f',{2*R:.9g}\n')
