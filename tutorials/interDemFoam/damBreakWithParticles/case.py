"""Results of a run."""
import os
import re

import numpy as np

A, NX, NY, NZ = 0.05715, 50, 2, 30
H = A/10


def times(run):
    names = [t for t in os.listdir(f'runs/{run}') if re.fullmatch(r'\d+(\.\d+)?', t)]
    return sorted(names, key=float)


def alpha(run, time):
    """Shares [z, x], averaged across."""
    with open(f'runs/{run}/{time}/alpha.water') as stream:
        text = stream.read()
    body = re.search(r'internalField\s+nonuniform\s+List<scalar>\s*\d+\s*\((.*?)\n?\)\s*;', text, re.S)
    return np.array(body[1].split(), dtype=float).reshape(NZ, NY, NX).mean(axis=1)


def front(shares):
    """Length of the floor that is wet: to where the lowest cells are half full, between their centres [m]."""
    low = shares[0]
    wet = np.flatnonzero(low > 0.5)
    if not len(wet):
        return 0.0
    k = wet[-1]
    if k + 1 == NX:
        return NX*H
    return (k + 0.5 + (low[k] - 0.5)/max(low[k] - low[k + 1], 1e-12))*H


def spheres(run, time):
    return np.genfromtxt(f'runs/{run}/{time}/particles.csv', delimiter=',', names=True, dtype=None, encoding=None)
