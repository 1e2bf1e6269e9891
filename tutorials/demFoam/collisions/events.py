#!/usr/bin/python3
"""The events of the six cases, the same for all sizes: lengths in diameters, velocities in m/s.

Usage: events.py hertz|hooke|floor|incline|bounce|stacked DIAMETER > particles.csv
"""
import sys
from math import cos, pi, radians, sin, sqrt
from typing import NamedTuple

# Of glass, as in the dictionaries
E, NU, RHO = 5e9, 0.25, 2500
DENSITY = {'glass': RHO, 'steel': 7500}

GD = 9.81*0.02          # gravity times diameter, the same for all sizes [m2/s2]
INCLINE = radians(30)

TOUCH = 0.0203          # time to touch, in seconds for a diameter of 1 m; not a multiple of the sub-step
SPEEDS = [0.01, 0.1, 1]
UNEQUAL_SPEEDS = [0.1, 1]
AXIS = (2/7, 3/7, 6/7)  # of the collisions between particles

V0 = 0.5                # on the floor
SLIP = {'mu10': 0.1, 'mu30': 0.3, 'mu60': 0.6}
ROLL = {'roll02': 0.02, 'roll10': 0.1}
TILTED = {'mu05': 0.05, 'mu10': 0.1, 'mu15': 0.15, 'mu18': 0.18, 'mu30': 0.3, 'mu60': 0.6}
DROPS = {'e60': 0.6, 'e75': 0.75, 'e90': 0.9}
HEIGHTS = [0.2, 0.5]    # of the fall, in diameters
MU = 0.1                # of the oblique impacts
OBLIQUE = [45, 60, 75]  # degrees from the normal
LID = 1.9
STACK = {'glass': 0.46, 'steel': 1.415}


class Particle(NamedTuple):
    material: str
    x: tuple
    v: tuple = (0, 0, 0)
    d: float = 1
    spin: float = 0     # omega d along y [m/s]


def overlap(share=1):
    """Static overlap, in diameters, under a share of the weight: (4/3) E* sqrt(R) overlap^1.5 = share m g"""
    e_star = E/(2*(1 - NU**2))
    return (share*RHO*pi/6*GD*0.75*sqrt(2)/e_star)**(2/3)


def pair(centre, first, second, v1, v2):
    """Two particles, (material, d) each, that meet with v1 and v2 along AXIS"""
    gap = (first[1] + second[1])/2 + (v1 - v2)*TOUCH

    def on_axis(particle, s, v):
        return Particle(particle[0], tuple(c + s*n for c, n in zip(centre, AXIS)),
                        tuple(v*n for n in AXIS), particle[1])

    return [on_axis(first, -gap/2, v1), on_axis(second, gap/2, v2)]


def collisions():
    glass, steel = ('glass', 1), ('steel', 2)
    result = []
    for i, v in enumerate(SPEEDS):
        result += pair((3, 3 + 3*i, 4), glass, glass, 0.7*v, -0.3*v)
    for i, v in enumerate(UNEQUAL_SPEEDS):
        result += pair((8, 3 + 5*i, 4), glass, steel, 0.8*v, -0.2*v)
    for i, v in enumerate(SPEEDS):
        result.append(Particle('glass', (13, 3 + 3*i, 0.5 + v*TOUCH), (0, 0, -v)))
    return result


def floor():
    z = 0.5 - overlap()
    slips = [Particle(name, (2, 2 + 2*i, z), (V0, 0, 0)) for i, name in enumerate(SLIP)]
    rolls = [Particle(name, (2, 10 + 2*i, z), (V0, 0, 0), spin=2*V0) for i, name in enumerate(ROLL)]
    return slips + rolls + [Particle('glass', (2, 16, 7.4), (0.2, 0, 0))]


def incline():
    z = 0.5 - overlap(cos(INCLINE))
    return [Particle(name, (2, 2 + 2*i, z)) for i, name in enumerate(TILTED)]


def bounce():
    drops = [Particle(name, (2 + 3*i, 2 + 3*j, 0.5 + h))
             for i, h in enumerate(HEIGHTS) for j, name in enumerate(DROPS)]
    oblique = [Particle('e100', (2, 11 + 2*i, 0.6), (0.5*sin(radians(a)), 0, -0.5*cos(radians(a))))
               for i, a in enumerate(OBLIQUE)]
    return drops + oblique


def stacked():
    return [Particle(name, (8, 10, z)) for name, z in STACK.items()]


CASES = {'hertz': collisions, 'hooke': collisions, 'floor': floor, 'incline': incline, 'bounce': bounce,
         'stacked': stacked}


def table(case, d):
    yield 'x,y,z,d,vx,vy,vz,wx,wy,wz,material'
    for p in CASES[case]():
        values = [*(d*x for x in p.x), d*p.d, *p.v, 0, p.spin/d, 0]
        yield ','.join([*map(repr, values), p.material])


if __name__ == '__main__':
    if len(sys.argv) != 3 or sys.argv[1] not in CASES:
        sys.exit(__doc__)
    for line in table(sys.argv[1], float(sys.argv[2])):
        print(line)
