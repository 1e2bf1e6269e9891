#!/usr/bin/python3
"""The spheres: placed at random without overlap in the cyclic box, by a fixed seed.

Usage: bed.py > particles.csv
"""
import random

N, D = 1000, 3e-3       # spheres and their diameter [m]
L, CELLS = 0.06, 6      # edge of the box [m], and cells along it


def centres():
    """Random sequential addition; positions in metres, rounded to 1 nm"""
    rng = random.Random(1)
    grid, result = {}, []
    n = int(L/D)        # squares of the search
    while len(result) < N:
        x = tuple(round(L*rng.random(), 9) for _ in range(3))
        square = [int(n*c/L) % n for c in x]
        near = [(square[0] + i) % n*n*n + (square[1] + j) % n*n + (square[2] + k) % n
                for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)]
        if all(sum(((a - b + L/2) % L - L/2)**2 for a, b in zip(x, other)) > (1.01*D)**2
               for key in near for other in grid.get(key, [])):
            grid.setdefault(square[0]*n*n + square[1]*n + square[2], []).append(x)
            result.append(x)
    return result


if __name__ == '__main__':
    print('x,y,z,d')
    for centre in centres():
        print(','.join(map(repr, (*centre, D))))
