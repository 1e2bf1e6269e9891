"""Closed forms of colloids that runs are compared with: aggregation, profiles, motion. SI, or any units that fit together."""
import numpy as np


def integral(function, low, high, panels=64):
    """Gauss-Legendre, 20 points in each of some equal panels."""
    x, w = np.polynomial.legendre.leggauss(20)
    edges = np.linspace(low, high, panels + 1)
    half = (edges[1:] - edges[:-1])[:, None] / 2
    points = edges[:-1, None] + half * (1 + x)
    return float((half * w * function(points)).sum())


# --- Aggregation of equal spheres, M. von Smoluchowski, Z. phys. Chem. 92 (1917) 129-168

def smoluchowski_kernel(t, D, d):
    """k(t) [m3/s] of the rate k n^2/2 of collisions per volume: the current to a sphere of radius d of particles that
    diffuse with 2 D, 4 pi (2 D) d (1 + d/sqrt(pi 2 D t))."""
    return 8 * np.pi * D * d * (1 + d / np.sqrt(2 * np.pi * D * t))


def smoluchowski_kernel_integral(t, D, d):
    """Of k from 0 to t."""
    return 8 * np.pi * D * d * (t + d * np.sqrt(2 * t / (np.pi * D)))


def clusters(t, n0, D, d):
    """Number of clusters of all sizes per volume, each pair of which collides as two single spheres (constant kernel
    but for its transient): dn/dt = -k n^2/2."""
    return n0 / (1 + n0 * smoluchowski_kernel_integral(t, D, d) / 2)


def singles(t, n0, D, d):
    """Spheres that have not met any: dn1/dt = -k n1 n."""
    return clusters(t, n0, D, d)**2 / n0


def pair_resistance(h, R):
    """Slowing of two spheres that approach, D(infinity)/D(h): E.P. Honig, G.J. Roebersen, P.H. Wiersema, J. Colloid
    Interface Sci. 36 (1971) 97-109."""
    u = h / R
    return (6 * u**2 + 13 * u + 2) / (6 * u**2 + 4 * u)


def stability_ratio(energy, R, kT, contact=0, resistance=None, kink=()):
    """W = 2 R int exp(U/kT) b/(2 R + h)^2 dh from the gap of contact on, N. Fuchs, Z. Phys. 89 (1934) 736-743; with b
    of pair_resistance, contact > 0 and U < 0 near it. Gaps where U has a kink."""
    b = resistance or (lambda h, R: 1)
    # s = 2 R/(2 R + h) makes the range finite; panels that are fine near contact
    edges = [2 * R / (2 * R + g) for g in (contact, *sorted(kink))] + [0]

    def part(q):
        s = start - (start - end) * q**3
        h = 2 * R * (1 / s - 1)
        return np.exp(energy(h) / kT) * b(h, R) * 3 * q**2 * (start - end)
    total = 0
    for start, end in zip(edges[:-1], edges[1:]):
        total += integral(part, 0, 1, 400)
    return total


# --- Sedimentation

def barometric(z, length, height):
    """Density at z over the mean between walls at 0 and height; length kT/(weight - buoyancy)."""
    return height / length * np.exp(-z / length) / -np.expm1(-height / length)


def barometric_mean(length, height):
    """Mean height."""
    return length - height / np.expm1(height / length)


# --- Motion

def brenner_mobility(gap):
    """Of a sphere of radius 1 along the normal of a wall, relative to Stokes': H. Brenner, Chem. Eng. Sci. 16 (1961)
    242-251. For a gap from 1e-4 to 1e3 in double precision (1e-7)."""
    a = np.log1p(gap + np.sqrt(gap * (2 + gap)))
    n = np.arange(1, int(40 / a) + 20)
    x = 2 * n + 1
    e = np.exp(-x * a)
    s = np.sinh(a)
    # Sides of the fraction times 2 exp(-x a)
    bottom = 2 * (1 - e)**2 - 2 * (x * s)**2 * e
    top = 2 * (1 - e**2) + 2 * x * np.sinh(2 * a) * e
    terms = n * (n + 1) / ((2 * n - 1) * (2 * n + 3)) * (top - bottom) / bottom
    return 3 / (4 * s * terms.sum())


def mean_square(t, kT, m, friction):
    """Displacement along one axis of a particle with thermal speed at the start: P. Langevin, C. R. Acad. Sci. 146
    (1908) 530-533; G.E. Uhlenbeck, L.S. Ornstein, Phys. Rev. 36 (1930) 823-841."""
    tau = m / friction
    return 2 * kT / friction * (t + tau * np.expm1(-t / tau))


# --- Dissipative particles, R.D. Groot, P.B. Warren, J. Chem. Phys. 107 (1997) 4423-4435, weight (1 - r/rc)^2

def dpd_diffusivity(rho, gamma, kT=1, rc=1):
    """Their estimate without conservative force, eq. 35: of the order of what is measured, not to some per cent."""
    return 45 * kT / (2 * np.pi * gamma * rho * rc**3)


def dpd_viscosity(rho, gamma, kT=1, rc=1):
    """Kinematic, mass 1: their estimate of kinetic and dissipative parts."""
    return dpd_diffusivity(rho, gamma, kT, rc) / 2 + 2 * np.pi * gamma * rho * rc**5 / 1575


def dpd_pressure(rho, a, kT=1, rc=1):
    """Their equation of state, 0.101 +- 0.001, for rho > 2."""
    return rho * kT + 0.101 * a * rc**4 * rho**2
