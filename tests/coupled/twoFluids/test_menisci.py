"""Capillary attraction of spheres in the surface that interDemFoam has: its field of sigma, the angle of capillaryForce."""
import numpy as np
from scipy.special import k1

from colloidTheory import capillary_charge
from test_twoFluids import CAPILLARITY, box, solve


def test_attraction_in_a_surface_of_two_fluids(tmp_path):
    """Two spheres 0.3 R above their rest, at the start: what the entry immersion adds to their velocities is
    2 pi sigma Q^2 q (K1(q L) - K1(q Lc)) t/m towards each other, 3 % (1 % of the time is before the first force, 2 % of the
    relaxation), and nothing in sum."""
    d, sigma, angle, length, cut, level = 2e-4, 0.072, 110, 2.7e-3, 2e-3, 0.0131
    R, L, t = d/2, 8e-4, 1e-4
    mass = 2500 * np.pi/6 * d**3
    z = R * (0.3 - np.cos(np.deg2rad(angle)))
    v = {}
    for on in (False, True):
        case = box(tmp_path/str(on), [(0.0161, 0.0163, level + z), (0.0161 + L, 0.0163, level + z)], density=2500, d=d,
                   forces={**CAPILLARITY, 'capillarity': {'type': 'capillaryForce', 'contactAngle': angle, 'pull': 'plane'}},
                   sigma=sigma, level=level, upper=(0.032, 0.032, 0.024), cells=(8, 8, 6), mu=(1e-3, 1.8e-5), endTime=t,
                   deltaT=t, writeInterval=1, tolerance=1e-9, sub=1e-6, gravity=(0, 0, 0))
        if on:
            case.properties['immersion'] = {'capillaryLength': length, 'cutOff': cut}
        case.mesh()
        solve(case)
        row = case.table(t)
        v[on] = row['vx']
    # The surface pulls them down meanwhile, m z'' = -2 pi sigma z: the mean of Q^2 over the way
    s = np.linspace(0, t, 2001)
    path = -R*np.cos(np.deg2rad(angle)) + 0.3*R*np.cos(np.sqrt(2*np.pi*sigma/mass)*s)
    Q2 = np.mean([capillary_charge(R, angle, R - h, 1/length)**2 for h in path[::20]])
    force = 2*np.pi*sigma*Q2/length*(k1(L/length) - k1(cut/length))
    found = v[True] - v[False]
    assert abs(found[0]/(force*t/mass) - 1) < 0.03, (found, force*t/mass)
    assert abs(found.sum()) < 1e-6*abs(found[0])
