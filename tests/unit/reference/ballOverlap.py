#!/usr/bin/python3
"""Volume of a unit ball within half-spaces n.x < d: one plane, an edge, a corner, a tetrahedron. Writes ballOverlap.csv.

The area of the disc at height z that lies within the half-spaces is a polygon with arcs; it is found by clipping chords:
at each y the half-spaces leave one interval of x. Nested Gauss-Legendre quadrature between all kinks in y, and adaptive in
z (scipy), gives 12 digits. No formula of the code is used.
"""
import numpy as np
from scipy.integrate import quad

GAUSS = np.polynomial.legendre.leggauss(48)


def area(z, planes):
    """Of the disc of the unit ball at height z within the half-spaces"""
    rho2 = 1 - z*z
    if rho2 <= 0:
        return 0.0
    rho = np.sqrt(rho2)
    # Kinks: where lines meet the circle and each other
    ys = [-rho, rho]
    lines = [(n[0], n[1], d - n[2]*z) for n, d in planes]
    for a, b, c in lines:
        s = a*a + b*b
        if s > 1e-28 and c*c < s*rho2:
            h = np.sqrt(rho2/s - (c/s)**2)
            ys += [b*c/s + a*h, b*c/s - a*h]
    for i, (a, b, c) in enumerate(lines):
        for p, q, r in lines[:i]:
            det = a*q - b*p
            if abs(det) > 1e-14:
                ys.append((a*r - c*p)/det)
    ys = np.unique(np.clip(ys, -rho, rho))
    total = 0.0
    for lower, upper in zip(ys[:-1], ys[1:]):
        # y = middle + half sin(t): smooth at the ends of the circle
        t = np.pi/2*GAUSS[0]
        y = (lower + upper)/2 + (upper - lower)/2*np.sin(t)
        weight = np.pi/2*GAUSS[1]*(upper - lower)/2*np.cos(t)
        half = np.sqrt(np.maximum(rho2 - y*y, 0))
        left, right = -half, half.copy()
        for a, b, c in lines:
            rest = c - b*y
            if abs(a) < 1e-15:
                right = np.where(rest < 0, left, right)
            elif a > 0:
                right = np.minimum(right, rest/a)
            else:
                left = np.maximum(left, rest/a)
        total += np.sum(weight*np.maximum(right - left, 0))
    return total


def kinks(planes):
    """Heights at which what the half-spaces leave of a disc changes its form"""
    zs = {-1.0, 1.0}
    n = [np.array(p[0], float) for p in planes]
    d = [float(p[1]) for p in planes]
    for i in range(len(n)):
        s = np.hypot(n[i][0], n[i][1])
        if abs(d[i]) < 1:
            h = s*np.sqrt(1 - d[i]**2)
            zs |= {d[i]*n[i][2] + h, d[i]*n[i][2] - h}
        for j in range(i):
            e = np.cross(n[i], n[j])
            if np.linalg.norm(e) > 1e-12:
                p = np.linalg.lstsq(np.array([n[i], n[j]]), np.array([d[i], d[j]]), rcond=None)[0]
                h2 = 1 - p @ p
                if h2 > 0:
                    w = np.sqrt(h2)*e/np.linalg.norm(e)
                    zs |= {(p + w)[2], (p - w)[2]}
                zs.add(p[2])
            for k in range(j):
                m = np.array([n[i], n[j], n[k]])
                if abs(np.linalg.det(m)) > 1e-12:
                    zs.add(np.linalg.solve(m, [d[i], d[j], d[k]])[2])
    return sorted(z for z in zs if -1 <= z <= 1)


def volume(planes):
    planes = [(np.array(n, float)/np.linalg.norm(n), d/np.linalg.norm(n)) for n, d in planes]
    zs = kinks(planes)
    total = 0.0
    for lower, upper in zip(zs[:-1], zs[1:]):
        if upper - lower > 1e-13:
            # z = middle + half sin(t), as above
            def f(t, lower=lower, upper=upper):
                half = (upper - lower)/2
                return area((lower + upper)/2 + half*np.sin(t), planes)*half*np.cos(t)
            total += quad(f, -np.pi/2, np.pi/2, epsabs=1e-12, epsrel=1e-11, limit=200)[0]
    return total


def main():
    rows = []

    def row(*planes):
        rows.append(([x for n, d in planes for x in (*n, d)], volume(planes)))

    for d in (-0.999, -0.7, -0.2, 0, 0.3, 0.9, 0.9999):
        row(((0.36, 0.48, 0.8), d))
    for degrees in (1, 20, 60, 90, 135, 175):
        a = np.radians(degrees)
        for d1, d2 in ((0, 0), (0.2, -0.3), (0.5, 0.4)):
            row(((1, 0, 0), d1), ((-np.cos(a), np.sin(a), 0), d2))
    for d in ((0, 0, 0), (0.1, -0.2, 0.3), (-0.4, -0.3, -0.2), (0.5, 0.6, 0.2), (0.9, 0.1, -0.1)):
        row(((1, 0, 0), d[0]), ((0, 1, 0), d[1]), ((0, 0, 1), d[2]))
    for d in ((0.2, 0.2, 0.2, 0.2), (0.5, 0.1, 0.3, 0.4), (0.1, 0.9, -0.1, 0.6), (0.99, 0.3, 0.7, 0.2)):
        row(((1, 1, 1), d[0]), ((1, -1, -1), d[1]), ((-1, 1, -1), d[2]), ((-1, -1, 1), d[3]))

    with open('ballOverlap.csv', 'w') as stream:
        print('# Volume of a unit ball within half-spaces n.x < d. From ballOverlap.py: quadrature, 11 digits', file=stream)
        print('# volume, then nx, ny, nz, d of each half-space', file=stream)
        for planes, v in rows:
            print(','.join([f'{v:.14g}'] + [repr(float(x)) for x in planes]), file=stream)


main()
