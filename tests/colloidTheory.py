"""Closed forms of colloids that runs are compared with: aggregation, profiles, motion. SI, or any units that fit together."""
import numpy as np
from scipy.optimize import brentq


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


# --- Forces at a gap h of spheres of radii a and b, or of a sphere and a wall (b None)

def derjaguin(a, b=None):
    return a if b is None else a * b / (a + b)


def hamaker(h, A, a, b=None):
    """F and U of H.C. Hamaker, Physica 4 (1937) 1058-1072, F by differentiation; in double precision for h > 1e-4 a."""
    if b is None:
        return (-A / 6 * (a / h**2 + a / (h + 2*a)**2 - 1 / h + 1 / (h + 2*a)),
                -A / 6 * (a / h + a / (h + 2*a) + np.log(h / (h + 2*a))))
    r, p, q = h + a + b, h * (h + 2*a + 2*b), (h + 2*a) * (h + 2*b)
    return (A / 6 * (-4*a*b*r * (1 / p**2 + 1 / q**2) + 2*r * (1 / p - 1 / q)),
            -A / 6 * (2*a*b / p + 2*a*b / q + np.log(p / q)))


def constant_potential(h, eps, kappa, psi, a, b=None):
    """F and U of two surfaces at the same potential: R. Hogg, T.W. Healy, D.W. Fuerstenau, Trans. Faraday Soc. 62 (1966)
    1638-1651."""
    x, scale = np.exp(-kappa * h), 4 * np.pi * eps * derjaguin(a, b) * psi**2
    return scale * kappa * x / (1 + x), scale * np.log1p(x)


def over_heights(law, x, s, least):
    """F and U of a law(h), held below a least gap, averaged over a Gaussian of heights of standard deviation s, by
    trapezia over 10 s on each side; the kink is a point of them."""
    h = np.sort(np.append(np.linspace(x - 10*s, x + 10*s, 20001), least))
    F, U = law(np.maximum(h, least))
    share = np.exp(-((h - x) / s)**2 / 2) / (s * np.sqrt(2*np.pi))
    return tuple(float(np.trapz(share * y, h)) for y in (F, U + F * np.maximum(least - h, 0)))


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


# --- Menisci

def capillary_charge(r, theta, film, q):
    """r sin(psi) at the contact line of a sphere in a film, whose meniscus rises by Derjaguin's formula, contact angle in
    degrees, q the inverse of the capillary length (P. A. Kralchevsky, K. Nagayama, Adv. Colloid Interface Sci. 85 (2000) 145)"""
    def line(b):
        beta = np.arccos(np.clip(b / r - 1, -1, 1))
        return r * np.sin(beta), beta - np.deg2rad(theta)

    def excess(b):
        radius, psi = line(b)
        return b - film - radius * np.sin(psi) * np.log(4 / (np.exp(np.euler_gamma) * q * radius * (1 + np.cos(psi))))

    rest = r * (1 + np.cos(np.deg2rad(theta)))
    b = film if abs(film - rest) < 1e-12 * r else brentq(excess, *sorted((film, rest)), xtol=1e-22, rtol=1e-15)
    radius, psi = line(b)
    return radius * np.sin(psi)
