"""The spheres of each run, and where they should float: closed form."""
from math import acos, cos, pi, radians, sin

import numpy as np

G, RHO, AIR, SIGMA, LEVEL = 9.81, 1000, 1.2, 0.072, 0.0131


def share(z):
    """Of the volume that is in the liquid, the centre z radii above the level."""
    return (1 - z)**2*(2 + z)/4


def force(z, d, density, sigma, theta):
    """Upwards: buoyancy of both parts and tension at the contact line less the weight [N]."""
    beta = acos(max(-1.0, min(1.0, -z)))
    return (pi/6*d**3*G*(AIR + (RHO - AIR)*share(z) - density)
            + pi*d*sigma*sin(beta)*sin(radians(theta) - beta))


def critical(d, theta):
    """Density that the most the surface holds, pi d sigma sin^2(theta/2) at beta = theta/2, carries."""
    z = -cos(radians(theta)/2)
    return AIR + (RHO - AIR)*share(z) + pi*d*SIGMA*sin(radians(theta)/2)**2/(G*pi/6*d**3)


def rest(d, density, sigma, theta):
    """Height of the centre above the level over the radius, at stable rest; None for one that sinks."""
    z = np.linspace(-1, 1, 200001)
    F = np.array([force(a, d, density, sigma, theta) for a in z])
    falls = np.flatnonzero((F[:-1] >= 0) & (F[1:] < 0))
    return z[falls[-1]] if len(falls) else None


# Run: tension, contact angle, spheres by diameter and density
RUNS = {
    'noTension': (0, 0, [(2e-3, (RHO + AIR)/2), (2e-3, 250), (2e-3, 800), (1e-3, (RHO + AIR)/2)]),
    'angle60': (SIGMA, 60, [(2e-3, 500), (2e-3, 1000), (5e-4, 2500), (2e-4, 7800)]),
    'angle110': (SIGMA, 110, [(2e-3, 1500), (2e-4, 2500), (1e-3, 0.97*critical(1e-3, 110)),
                              (1e-3, 1.03*critical(1e-3, 110))]),
}
PLACES = [(7.3e-3, 8.1e-3), (24.9e-3, 7.7e-3), (8.2e-3, 24.6e-3), (23.8e-3, 25.1e-3)]


def start(d, density, sigma, theta):
    """A fifth of a radius above the place of rest; one that is too heavy where the surface holds the most."""
    z = rest(d, density, sigma, theta)
    return -cos(radians(theta)/2) if z is None else min(z + (0.2 if sigma == 0 else 0.1), 0.9)


def write(run):
    """Files of a run, in its folder constant."""
    sigma, theta, balls = RUNS[run]
    material = 'youngsModulus 2e5; poissonsRatio 0.3;'
    with open('constant/spheres', 'w') as out:
        print('materials\n{\n    wall { %s density 1000; }' % material, file=out)
        for k, (_, density) in enumerate(balls):
            print('    sphere%d { %s density %r; }' % (k, material, float(density)), file=out)
        print('}', file=out)
    with open('constant/particles.csv', 'w') as out:
        print('x,y,z,d,material', file=out)
        for k, (d, density) in enumerate(balls):
            z = LEVEL + start(d, density, sigma, theta)*d/2
            print(f'{PLACES[k][0]},{PLACES[k][1]},{z!r},{d},sphere{k}', file=out)
    with open('constant/capillarity', 'w') as out:
        if sigma:
            print(f'capillarity {{ type capillaryForce; contactAngle {theta}; }}', file=out)
    with open('constant/surfaceTension', 'w') as out:
        print(f'surfaceTension {{ sigma {sigma}; }}', file=out)
