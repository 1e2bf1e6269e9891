#!/usr/bin/python3
"""Write system/scale, constant/timeStep and constant/particles.csv of a case. Usage: beads.py RUN SEED CASE"""
import sys
from math import pi, sqrt

import numpy as np

# Beads of 1/3 of 1 um^3 of water; units of the fluid of Groot and Warren
RC, KT = 1e-6, 1.380649e-23*298.15
M = 1000*RC**3/3
TAU = RC*sqrt(M/KT)
D = 0.4*RC

# Box [RC]; amplitude of the waves vx, vy = V sin(2 pi z/L) [RC/TAU]; length of a run [TAU]
RUNS = {'rest': ((10, 10, 10), 0, 100), 'shear': ((7, 7, 20), 1.5, 35)}

# Sub-step, sub-steps a step: 0.01 TAU and TAU
DT, N = float(f'{0.01*TAU:.2e}'), 100


if __name__ == '__main__':
    (box, V, length), seed, case = RUNS[sys.argv[1]], int(sys.argv[2]), sys.argv[3]
    rng = np.random.default_rng(seed)
    n = 3*box[0]*box[1]*box[2]
    x = rng.uniform(0, 1, (n, 3))*box
    v = rng.normal(0, 1, (n, 3))
    v -= v.mean(axis=0)
    wave = V*np.sin(2*pi*x[:, 2]/box[2])
    v[:, 0] += wave
    v[:, 1] += wave

    with open(f'{case}/system/scale', 'w') as out:
        for axis, side in zip('xyz', box):
            out.write(f'L{axis} {side*RC:.6g};\n')
        out.write(f'step {N*DT:.9g};\nduration {length*N*DT:.9g};\n')

    with open(f'{case}/constant/timeStep', 'w') as out:
        out.write(f'timeStep {{ deltaT {DT:.6g}; }}\ndynamics {{ type inertial; seed {seed}; }}\n')

    with open(f'{case}/constant/particles.csv', 'w') as out:
        out.write('x,y,z,vx,vy,vz,d\n')
        for place, speed in zip(x*RC, v*RC/TAU):
            out.write(','.join(f'{value:.12g}' for value in (*place, *speed, D)) + '\n')
