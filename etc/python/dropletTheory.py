"""Closed forms for drying droplets, to compare runs with. Used by tests and by validate of tutorials:

    import os, sys
    sys.path.append(os.environ['DEW_DIR'] + '/etc/python')
    import dropletTheory

All in SI, angles in radians. Needs numpy.
"""
import numpy as np

GAS_CONSTANT = 8.314462618


def integral(f, lower, upper, panels=40, points=20):
    """Integral of a smooth function by Gauss's rule on equal panels."""
    x, w = np.polynomial.legendre.leggauss(points)
    edges = np.linspace(lower, upper, panels + 1)
    middle, half = (edges[1:] + edges[:-1]) / 2, (edges[1:] - edges[:-1]) / 2
    return np.sum(half[:, None] * w * f(middle[:, None] + half[:, None] * x))


# --- Vapour from a sessile droplet, by diffusion alone

def popov(theta):
    """f of the evaporation rate pi R D dc f of a spherical cap with the contact angle theta, 0 <= theta < pi: Yu.O.
    Popov, Phys. Rev. E 71 (2005) 036313. f(0) = 4/pi, f(pi/2) = 2."""
    def integrand(t):
        # (1 + cosh(2 theta t))/sinh(2 pi t) tanh((pi - theta) t), without large numbers
        e = np.exp
        ratio = (2 * e(-2 * np.pi * t) + e(-2 * (np.pi - theta) * t) + e(-2 * (np.pi + theta) * t)) \
            / -np.expm1(-4 * np.pi * t)
        return ratio * np.tanh((np.pi - theta) * t)

    # It falls as exp(-2 (pi - theta) t)
    return np.tan(theta / 2) + 4 * integral(integrand, 0, 20 / (np.pi - theta))


def rate(theta, radius, diffusivity, difference):
    """Evaporation rate [kg/s] of a cap of contact radius [m]; difference of vapour concentration [kg/m3]."""
    return np.pi * radius * diffusivity * difference * popov(theta)


def volume(theta, radius):
    """Volume of a spherical cap [m3]."""
    c = np.cos(theta)
    return np.pi * radius**3 / 3 * (2 + c) * np.sin(theta) / (1 + c)**2


def height(theta, radius):
    """Height of a spherical cap [m]."""
    return radius * np.tan(theta / 2)


def pinned_time(theta0, theta):
    """t D dc/(rho R^2) until a pinned cap has gone from theta0 to theta: from dtheta/dt = -(1 + cos theta)^2 f."""
    return integral(np.vectorize(lambda a: 1 / ((1 + np.cos(a))**2 * popov(a))), theta, theta0, 4)


def pinned_life(theta0):
    """t_f D dc/(rho R^2) with a pinned contact line."""
    return pinned_time(theta0, 0)


def constant_angle_life(theta0):
    """t_f D dc/(rho R0^2) at constant contact angle: R^2 falls linearly."""
    c = np.cos(theta0)
    return (2 - 3 * c + c**3) / (2 * np.sin(theta0)**3 * popov(theta0))


# --- Flow and deposit in a thin pinned droplet, R.D. Deegan et al., Phys. Rev. E 62 (2000) 756

def ring_velocity(x, rest, radius=1.0):
    """Mean radial velocity [m/s] at x = r/R, the time rest = t_f - t before the end: from the mass balance of a
    parabolic height with J = J0 (1 - x^2)^(-1/2)."""
    return radius / (4 * x * rest) * ((1 - x**2)**-0.5 - (1 - x**2))


def ring_fraction(t):
    """Share of the solute in the ring at the share t of the life; solute uniform at first, carried along."""
    return (1 - (1 - t)**0.75)**(4 / 3)


# --- Vapour through a tube

def stefan_flux(pressure, temperature, diffusivity, length, x_surface, x_end=0.0, stefan_flow=True):
    """Molar flux [mol/m2/s] of a vapour through a gas at rest: J. Stefan (1873); without Stefan flow, Fick's law."""
    conductance = pressure * diffusivity / (GAS_CONSTANT * temperature * length)
    if stefan_flow:
        return conductance * np.log((1 - x_end) / (1 - x_surface))
    return conductance * (x_surface - x_end)
