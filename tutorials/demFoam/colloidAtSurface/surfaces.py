#!/usr/bin/python3
"""The runs and what is known of them in closed form.

Usage: surfaces.py              names of the runs
       surfaces.py RUN FOLDER   writes a case into the folder
"""
import sys

import numpy as np

R, RHO, SIGMA, MU, WATER = 5e-7, 1055.0, 0.072, 8.9e-4, 997.0
MASS = RHO*4/3*np.pi*R**3
SP = 6*np.pi*MU*R
K = 2*np.pi*SIGMA                                       # stiffness of the surface [N/m]
SIDE = 1e-4                                             # of the box [m]
DROP = 2e-5                                             # radius of the drop [m]
ANGLES = 30, 60, 90, 120, 150
# Kinetic energy over that of detachment
SHARES = 0.90, 0.98, 1.02, 1.10

# detach with pull plane, line with pull contactLine
RUNS = ['float', 'film-rigid', 'film-mobile'] + [
    f'{kind}-{shape}-{angle}' for kind in ('rest', 'detach', 'line') for shape in ('plane', 'sphere') for angle in ANGLES]

# Of the film: Hamaker constant, least thickness, ranges; force that drives particles to the surface, their films at the
# start, and the time for each run
HAMAKER, LEAST, RANGE, FORCE, FILMS = 1e-20, 5e-10, 1e-7, 2e-12, (2e-8, 4e-8, 8e-8)
TIMES = {'film-rigid': 4e-4, 'film-mobile': 1e-4}

# Energy of detachment over that of Pieranski
MODELS = {'plane': 1, 'contactLine': 2/3}


def parts(run):
    """What is done, on which surface, at which angle"""
    kind, shape, angle = (run.split('-') + ['plane', '90'])[:3]
    return (kind, 'plane', 60) if kind == 'film' else (kind, shape, float(angle))


def rest(angle):
    """Height of the centre over the surface at rest"""
    return -R*np.cos(np.radians(angle))


def energy(angle, pull):
    """Least energy of detachment"""
    return MODELS[pull]*np.pi*R**2*SIGMA*(1 - abs(np.cos(np.radians(angle))))**2


def thinned(run, h, t):
    """Film after a time: Sp dh/dt + k (1/h - 1/range) dh/dt = -F - A (1/h^2 - 1/range^2), by Runge and Kutta"""
    k = 6*np.pi*MU*R**2*(0.25 if run == 'film-mobile' else 1)
    A = HAMAKER*R/6

    def slope(h):
        return -(FORCE + A*(h**-2 - RANGE**-2))/(SP + k*(1/h - 1/RANGE))

    n = 20000
    for _ in range(n):
        a = slope(h)
        b = slope(h + 0.5*t/n*a)
        c = slope(h + 0.5*t/n*b)
        h += t/n/6*(a + 2*b + 2*c + slope(h + t/n*c))
    return h


def hung(angle):
    """Height at rest once the film has broken: weight and what buoyancy is left, on the stiffness of the surface"""
    z = rest(angle)/R
    share = (1 - z)**2*(2 + z)/4
    return rest(angle) + FORCE/K*(RHO - share*WATER)/(RHO - WATER)


def directions(run, n):
    """Where on the surface: beside each other on a plane, all round on a drop"""
    if parts(run)[1] == 'plane':
        return np.tile([0.0, 0, 1], (n, 1)), np.stack([4e-6*np.arange(n) - 1e-5, 0*np.arange(n), 0*np.arange(n)], 1)
    turn = np.arange(n)*2.4
    z = 1 - 2*(np.arange(n) + 0.5)/n
    e = np.stack([np.sqrt(1 - z*z)*np.cos(turn), np.sqrt(1 - z*z)*np.sin(turn), z], 1)
    return e, DROP*e


def heights(x, run):
    """Of centres over the surface"""
    y = np.asarray(x) - SIDE/2
    return y[:, 2] if parts(run)[1] == 'plane' else np.linalg.norm(y, axis=1) - DROP


def particles(run):
    """Positions and velocities"""
    kind, shape, angle = parts(run)
    if kind == 'rest':
        # From nearly all in to nearly all out
        start, speed = np.array([-0.99, -0.3, 0.3, 0.99])*R, np.zeros(4)
    elif kind == 'film':
        start, speed = -R - np.array(FILMS), np.zeros(len(FILMS))
    elif kind == 'float':
        start, speed = np.array([-0.9, -0.5, -0.1])*R, np.zeros(3)
    else:
        side = -1 if angle <= 90 else 1                 # the nearer way out
        pull = 'contactLine' if kind == 'line' else 'plane'
        speed = side*np.sqrt(2*np.array(SHARES)*energy(angle, pull)/MASS)
        start = np.full(len(SHARES), rest(angle))
    normal, foot = directions(run, len(start))
    return SIDE/2 + foot + start[:, None]*normal, speed[:, None]*normal


def write(run, folder):
    kind, shape, angle = parts(run)
    surface = ('type plane; point (5e-5 5e-5 5e-5); normal (0 0 1);' if shape == 'plane'
               else f'type sphere; centre (5e-5 5e-5 5e-5); radius {DROP};')
    surface += (' stiffness 1e-9;' if kind == 'float' else
                f' surfaceTension {SIGMA}; contactAngle {angle:g}; pull {"contactLine" if kind == "line" else "plane"};')
    if kind == 'film':
        surface += (f' film {{ minThickness {LEAST}; drainage {{ surface {run[5:]}; range {RANGE}; }}'
                    f' vanDerWaals {{ HamakerConstant {HAMAKER}; range {RANGE}; }} }}')
    # Friction over 2 pi sigma, or period over 2 pi
    relaxation, period = SP/K, np.sqrt(MASS/K)
    dt, n, steps = {'rest': (relaxation, 100, 10), 'float': (2e-3, 5, 1000),
                    'film': (1e-7, 100, 1000)}.get(kind, (0.002*period, 50, 60))
    dt = float(f'{dt:.3g}')
    with open(f'{folder}/constant/run', 'w') as out:
        # Without friction where energies are compared
        free = kind in ('detach', 'line')
        out.write(f'materials {{ polystyrene {{ density {WATER/2 if kind == "float" else RHO}; }} }}\n'
                  f'fluid {{ viscosity {1e-9 if free else MU}; surface {{ {surface} }} }}\n'
                  f'dynamics {{ {"type inertial;" if free else f"type overdamped; viscosity {MU};"} }}\n'
                  f'timeStep {{ deltaT {dt:.9g}; }}\n')
    with open(f'{folder}/system/run', 'w') as out:
        out.write(f'step {n*dt:.9g};\nduration {steps*n*dt:.9g};\n')
    # In the film upwards, to the surface
    gravity = {'float': -9.81, 'film': FORCE/MASS/(1 - WATER/RHO)}.get(kind, 0)
    with open(f'{folder}/constant/g', 'w') as out:
        out.write('FoamFile { version 2.0; format ascii; class uniformDimensionedVectorField; object g; }\n'
                  f'dimensions [0 1 -2 0 0 0 0];\nvalue (0 0 {gravity});\n')
    with open(f'{folder}/constant/particles.csv', 'w') as out:
        out.write('x,y,z,vx,vy,vz,d\n')
        for row in np.hstack(particles(run)):
            out.write(','.join(f'{value:.12g}' for value in row) + f',{2*R:.9g}\n')


if __name__ == '__main__':
    if sys.argv[1:]:
        write(*sys.argv[1:])
    else:
        print(*RUNS, sep='\n')
