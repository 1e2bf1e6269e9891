#!/usr/bin/python3
"""Writes wallMobility.csv: mobility of a sphere beside a plane wall, relative to Stokes'.

Columns: h/R, exact mobility along the normal, its slope d/d(h/R), and along the wall of a sphere free to rotate.

Normal: H. Brenner's series (1961) with 60 digits. Along the wall: nothing but Blake's Green's function (1971), Stokeslets
before a wall, on rings inside the sphere, whose strengths leave the least slip on it; force and torque are their sums.
With a fifth of the rings less it changes by less than 2e-4 at the gap 0.003, 1e-5 beyond 0.1 (asserted here).
"""
import mpmath as mp
import numpy as np

mp.mp.dps = 60


def normal(gap):
    a = mp.acosh(1 + gap)

    def term(n):
        x = 2 * n + 1
        top = 2 * mp.sinh(x * a) + x * mp.sinh(2 * a)
        bottom = 4 * mp.sinh(x * a / 2)**2 - (x * mp.sinh(a))**2
        return mp.mpf(n * (n + 1)) / ((2 * n - 1) * (2 * n + 3)) * (top / bottom - 1)
    total = mp.mpf(0)
    for n in range(1, int(45 / float(a)) + 60):
        total += term(n)
    return 3 / (4 * mp.sinh(a) * total)


def blake(x, y):
    """Velocities [i] at x of unit forces [j] at y before the wall z = 0, times 8 pi mu."""
    r, image = x - y, x - y * [1, 1, -1]
    height = y[..., 2]
    d, D = np.linalg.norm(r, axis=-1), np.linalg.norm(image, axis=-1)
    Z = image[..., 2]
    G = np.empty(d.shape + (3, 3))
    for i in range(3):
        for j in range(3):
            same = float(i == j)
            G[..., i, j] = (same / d + r[..., i] * r[..., j] / d**3 - same / D - image[..., i] * image[..., j] / D**3)
            # d/dR_j of height R_i/R^3 - (delta_i3/R + R_i R_3/R^3)
            slope = height * (same / D**3 - 3 * image[..., i] * image[..., j] / D**5)
            slope -= -float(i == 2) * image[..., j] / D**3 + same * Z / D**3
            slope -= float(j == 2) * image[..., i] / D**3 - 3 * image[..., i] * Z * image[..., j] / D**5
            G[..., i, j] += 2 * height * (-1 if j == 2 else 1) * slope
    return G


def along(gap, rings, depth=2.5):
    """Sphere of radius 1; x = (r cos, r sin, z), forces f = (a cos^2 + b sin^2, (a - b) sin cos, c cos) on a ring."""
    alpha = np.arccosh(1 + gap)
    focus = np.sinh(alpha)

    def nodes(xi, n):
        eta = np.pi * (np.arange(n) + 0.5) / n
        bottom = np.cosh(xi) - np.cos(eta)
        return focus * np.sin(eta) / bottom, focus * np.sinh(xi) / bottom
    xi = depth * alpha if alpha < 1 else alpha + 1.2
    r, z = nodes(xi, rings)
    R, Z = nodes(alpha, 2 * rings)
    count = 4 * rings
    phi = 2 * np.pi * (np.arange(count) + 0.5) / count
    co, si = np.cos(phi), np.sin(phi)
    sources = np.stack([r[:, None] * co, r[:, None] * si, z[:, None] + 0 * co], axis=-1)
    shapes = np.stack([np.stack([co * co, si * co, 0 * co], -1), np.stack([si * si, -si * co, 0 * co], -1),
                       np.stack([0 * co, 0 * co, co], -1)], axis=-1) / count           # phi, component, shape
    rows, right = [], []
    for radius, height in zip(R, Z):
        for angle, components in ((0, (0, 2)), (np.pi / 2, (0,))):
            point = np.array([radius * np.cos(angle), radius * np.sin(angle), height])
            G = blake(point, sources)
            u = np.einsum('spij,pjk->isk', G, shapes).reshape(3, -1)
            # Translation along x; rotation about y: w = (z - centre, 0, -x)
            moves = np.array([[1, 0, 0], [height - 1 - gap, 0, -point[0]]])
            for i in components:
                rows.append(u[i])
                right.append(moves[:, i])
    rows, right = np.array(rows), np.array(right)
    scale = np.linalg.norm(rows, axis=0)
    strength = np.linalg.lstsq(rows / scale, right, rcond=1e-15)[0]
    slip = np.abs(rows / scale @ strength - right).max()
    strength = (strength / scale[:, None]).reshape(rings, 3, 2)
    # Mean over a ring: a/2 + b/2 along x; torque about y
    force = (strength[:, 0] + strength[:, 1]).sum(0) / 2
    torque = ((z - 1 - gap)[:, None] * (strength[:, 0] + strength[:, 1]) / 2
              - r[:, None] * strength[:, 2] / 2).sum(0)
    # force = 6 pi mu f without the 8 pi mu
    f = force * 8 / 6
    free = f[0] - f[1] * torque[0] / torque[1]
    return 1 / free, 1 / f[0], slip


if __name__ == '__main__':
    print('# h/R, normal, d/d(h/R), along the wall: python3 wallMobility.py')
    for gap in (0.003, 0.005, 0.01, 0.03, 0.1, 0.3, 0.5, 1, 2, 5, 10, 30):
        slope = mp.diff(normal, mp.mpf(gap), h=mp.mpf(10)**-15)
        alpha = float(mp.acosh(1 + gap))
        rings = 24 + int(8 / alpha)
        first, _, _ = along(gap, rings * 4 // 5)
        second, _, slip = along(gap, rings)
        assert abs(first / second - 1) < (2e-4 if gap < 0.1 else 1e-5), (gap, slip, first, second)
        print(','.join(repr(float(v)) for v in (gap, normal(mp.mpf(gap)), slope)) + f',{second:.6f}')
