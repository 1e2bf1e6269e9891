#!/usr/bin/python3
"""Write system/scale, constant/timeStep and constant/particles.csv of a case. Usage: lattice.py DIAMETER DYNAMICS CASE"""
import itertools
import sys

# Polystyrene in water
RHO, MU, T = 1055, 8.9e-4, 298.15
KT = 1.380649e-23*T

# Particles along an edge, and their spacing in diameters
N, SPACING = 10, 19

# Sub-step over relaxation time, sub-steps a step, steps
TIMES = {'inertial': (0.2, 15, 40), 'overdamped': (20, 10, 40)}


def relaxation(d):
    """m/(3 pi mu d) [s]"""
    return RHO*d*d/(18*MU)


if __name__ == '__main__':
    d, (share, n, steps), case = float(sys.argv[1]), TIMES[sys.argv[2]], sys.argv[3]
    # Few digits: names of times and whole numbers of sub-steps
    dt = float(f'{share*relaxation(d):.2e}')

    with open(f'{case}/system/scale', 'w') as out:
        out.write(f'box {N*SPACING*d:.6g};\nstep {n*dt:.9g};\nduration {steps*n*dt:.9g};\n')

    with open(f'{case}/constant/timeStep', 'w') as out:
        out.write(f'timeStep {{ deltaT {dt:.6g}; }}\n')

    with open(f'{case}/constant/particles.csv', 'w') as out:
        out.write('x,y,z,d\n')
        for place in itertools.product(range(N), repeat=3):
            out.write(','.join(f'{(k + 0.5)*SPACING*d:.9g}' for k in place) + f',{d:.9g}\n')
