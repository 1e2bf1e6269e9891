"""The closed forms of tests/colloidTheory.py against independent limits, integrals and differential equations."""
import numpy as np
import pytest

import colloidTheory as theory


def test_transient_kernel_is_the_current_of_diffusion():
    """dc/dt = 2 D (c'' + 2 c'/r), c(d) = 0, c = 1 at first: u = r c obeys u_t = 2 D u_rr; Crank-Nicolson on a fine mesh."""
    D, d, time = 0.7, 1.3, 0.4
    r = np.linspace(d, d + 12, 6001)
    steps = 2000
    step, dt = r[1] - r[0], time / steps
    f = 2 * D * dt / (2 * step**2)
    size = len(r) - 2
    matrix = np.zeros((3, size))
    matrix[0, 1:], matrix[1], matrix[2, :-1] = -f, 1 + 2 * f, -f
    from scipy.linalg import solve_banded
    u = r.copy()
    u[0] = 0
    for i in range(steps):
        # Backward steps first, against the jump at the start
        if i < 20:
            for _ in range(2):
                right = u[1:-1].copy()
                right[-1] += f * u[-1]
                u[1:-1] = solve_banded((1, 1), matrix, right)
        else:
            right = u[1:-1] + f * (u[2:] - 2 * u[1:-1] + u[:-2])
            right[-1] += f * u[-1]
            u[1:-1] = solve_banded((1, 1), matrix, right)
    slope = (-3 * u[0] + 4 * u[1] - u[2]) / (2 * step) / d
    current = 4 * np.pi * d**2 * 2 * D * slope
    assert abs(current / theory.smoluchowski_kernel(time, D, d) - 1) < 1e-4


def test_numbers_of_clusters():
    """Integral and derivatives of the kernel's law; half of the clusters are gone after 1/(4 pi D d n0) without the
    transient term."""
    n0, D, d, t, e = 3e-4, 0.7, 1.3, 50.0, 1e-3
    k = theory.smoluchowski_kernel(t, D, d)

    def slope(function):
        return (function(t + e, n0, D, d) - function(t - e, n0, D, d)) / (2 * e)
    n, n1 = theory.clusters(t, n0, D, d), theory.singles(t, n0, D, d)
    assert abs(slope(theory.clusters) / (-k * n**2 / 2) - 1) < 1e-7
    assert abs(slope(theory.singles) / (-k * n1 * n) - 1) < 1e-7
    area = theory.integral(lambda q: theory.smoluchowski_kernel(q**2, D, d) * 2 * q, 0, np.sqrt(t))
    assert abs(area / theory.smoluchowski_kernel_integral(t, D, d) - 1) < 1e-12
    half = 1 / (4 * np.pi * D * d * 1e-12)
    assert abs(theory.clusters(half, 1e-12, D, d) / 0.5e-12 - 1) < 1e-4


def test_stability_ratio():
    """1 without forces; a step of energy u to the gap g; quadrature in another variable, with scipy."""
    R, kT = 2.0, 0.5
    assert abs(theory.stability_ratio(lambda h: 0 * h, R, kT) - 1) < 1e-13
    step = theory.stability_ratio(lambda h: np.where(h < 1, 3 * kT, 0), R, kT, kink=[1])
    assert abs(step / (np.exp(3) * 0.2 + 0.8) - 1) < 1e-12
    # Coulomb's 3 kT 2 R/r: (exp(3) - 1)/3, exactly
    coulomb = theory.stability_ratio(lambda h: 6 * kT * R / (2 * R + h), R, kT)
    assert abs(coulomb / ((np.exp(3) - 1) / 3) - 1) < 1e-12

    from scipy.integrate import quad

    def energy(h):
        return kT * (20 * np.exp(-5 * h) - 0.1 / h)
    own = theory.stability_ratio(energy, R, kT, 1e-3, theory.pair_resistance)
    other = sum(quad(lambda q: np.exp(energy(np.exp(q)) / kT) * theory.pair_resistance(np.exp(q), R)
                     * 2 * R / (2 * R + np.exp(q))**2 * np.exp(q), low, high, epsabs=0, epsrel=1e-11)[0]
                for low, high in zip((np.log(1e-3), -4, -2, 0, 5), (-4, -2, 0, 5, 40)))
    assert abs(own / other - 1) < 1e-8


def test_pair_resistance_limits():
    """Taylor's R/(2 h) near, 1 + 3/2 R/r far."""
    assert abs(theory.pair_resistance(1e-7, 1) * 2e-7 - 1) < 1e-5
    assert abs((theory.pair_resistance(1e4, 1) - 1) * 1e4 - 1.5) < 1e-3


@pytest.mark.parametrize('length, height', [(1, 0.01), (1, 3), (0.1, 7)])
def test_barometric(length, height):
    density = theory.integral(lambda z: theory.barometric(z, length, height) / height, 0, height)
    mean = theory.integral(lambda z: z * theory.barometric(z, length, height) / height, 0, height)
    assert abs(density - 1) < 1e-12
    assert abs(mean / theory.barometric_mean(length, height) - 1) < 1e-10


def test_brenner():
    """Values of H. Brenner (1961), table 1: cosh(a) and drag; limits near (R.G. Cox, H. Brenner 1967) and far."""
    for centre, drag in ((1.5430806, 3.0361), (2.3524096, 1.8375), (3.7621957, 1.4129), (10.0676620, 1.1252)):
        assert abs(1 / theory.brenner_mobility(centre - 1) / drag - 1) < 5e-5
    assert abs(1 / theory.brenner_mobility(1e-4) - (1e4 - np.log(1e-4) / 5 + 0.9713)) < 2e-3
    assert abs(theory.brenner_mobility(999.0) - (1 - 9 / 8e3 + 5e-10)) < 1e-12


def test_mean_square():
    """Ballistic, diffusive, and dx2/dt = 2 kT/friction (1 - exp(-t/tau))."""
    kT, m, friction = 2.0, 0.3, 5.0
    assert abs(theory.mean_square(1e-5, kT, m, friction) / (kT / m * 1e-10) - 1) < 1e-4
    assert abs(theory.mean_square(1e5, kT, m, friction) / (2 * kT / friction * 1e5) - 1) < 1e-5
    slope = (theory.mean_square(0.1001, kT, m, friction) - theory.mean_square(0.0999, kT, m, friction)) / 2e-4
    assert abs(slope / (2 * kT / friction * (1 - np.exp(-0.1 * friction / m))) - 1) < 1e-6


def test_dissipative_particles():
    """Usual fluid: density 3, a 25, friction 4.5. Estimates as integrals of the weight over the neighbours, and the
    Schmidt number 1/2 + (2 pi gamma rho)^2/70875 of Groot and Warren."""
    rho, gamma = 3, 4.5
    weight = theory.integral(lambda r: 4 * np.pi * r**2 * (1 - r)**2, 0, 1)
    fourth = theory.integral(lambda r: 4 * np.pi * r**4 * (1 - r)**2, 0, 1)
    # D = 3 kT/(gamma rho [w]) , nu = D/2 + gamma rho [r2 w]/30
    assert abs(theory.dpd_diffusivity(rho, gamma) / (3 / (gamma * rho * weight)) - 1) < 1e-12
    extra = theory.dpd_viscosity(rho, gamma) - theory.dpd_diffusivity(rho, gamma) / 2
    assert abs(extra / (gamma * rho * fourth / 30) - 1) < 1e-12
    schmidt = theory.dpd_viscosity(rho, gamma) / theory.dpd_diffusivity(rho, gamma)
    assert abs(schmidt - (0.5 + (2 * np.pi * gamma * rho)**2 / 70875)) < 1e-12
    assert abs(theory.dpd_pressure(3, 25) - 25.725) < 1e-12
