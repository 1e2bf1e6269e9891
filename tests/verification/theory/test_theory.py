"""The closed forms that runs are compared with (etc/python/dropletTheory.py), against numbers of the literature."""
import sys

import numpy as np
import pytest

from dewCase import ROOT

sys.path.append(str(ROOT / 'etc/python'))
import dropletTheory as theory      # noqa: E402

DEGREE = np.pi / 180

# Contact angle [degrees] and f; 90 by symmetry 2. The others agree within 0.05 % with the polynomial of R.G. Picknett and
# R. Bexon, J. Colloid Interface Sci. 61 (1977) 336 (below)
POPOV = {20: 1.3548, 30: 1.4055, 40: 1.4649, 50: 1.5350, 60: 1.6188, 70: 1.7201, 80: 1.8445, 90: 2.0, 100: 2.1985,
         110: 2.4589, 120: 2.8128, 130: 3.3169, 140: 4.0848, 150: 5.3812}


@pytest.mark.parametrize('angle, f', POPOV.items())
def test_popov(angle, f):
    """To the digits of the table."""
    assert abs(theory.popov(angle * DEGREE) - f) < 5.1e-5


@pytest.mark.parametrize('angle', [20, 40, 90, 120, 150])
def test_picknett_and_bexon(angle):
    """Their polynomial is C/Rs of a sphere of radius Rs = R/sin, and f = 2 C/R: independent of the integral."""
    a = angle * DEGREE
    c = 0.00008957 + 0.6333 * a + 0.1160 * a**2 - 0.08878 * a**3 + 0.01033 * a**4
    assert abs(2 * c / np.sin(a) / theory.popov(a) - 1) < 5e-4


def test_popov_limits():
    """A disc: 4/pi, H.C. Weber (1873); half a sphere: 2."""
    assert abs(theory.popov(0) - 4 / np.pi) < 1e-12
    assert abs(theory.popov(np.pi / 2) - 2) < 1e-12


def test_droplet_of_hu_and_larson():
    """H. Hu, R.G. Larson, J. Phys. Chem. B 106 (2002) 1334: R 1 mm, 40 degrees, humidity 0.4, D 26.1e-6 m2/s, saturated
    2.32e-2 kg/m3. Their fit gives 1.634e-9 kg/s, 2.3 % less than the exact f."""
    values = (40 * DEGREE, 1e-3, 26.1e-6, 0.6 * 2.32e-2)
    assert abs(theory.rate(*values) / 1.6720e-9 - 1) < 1e-4
    assert abs(theory.rate(*values) / 1.634e-9 - 1.023) < 1e-3
    assert abs(theory.volume(40 * DEGREE, 1e-3) / 0.5970e-9 - 1) < 1e-4
    assert abs(theory.height(40 * DEGREE, 1e-3) / 0.364e-3 - 1) < 1e-3
    # 383.0 s with 997 kg/m3
    life = theory.pinned_life(40 * DEGREE) * 997 * 1e-6 / (26.1e-6 * 0.6 * 2.32e-2)
    assert abs(life / 383.0 - 1) < 1e-3


@pytest.mark.parametrize('angle, pinned, constant', [
    (30, .10275, .14640), (40, .13958, .19458), (60, .22446, .29721), (80, .33844, .42126), (90, .41576, .5),
    (100, .51640, .59903), (120, .85623, .92365), (140, 1.74629, 1.77379)])
def test_lives(angle, pinned, constant):
    """To the digits of a table computed with another quadrature; 0.5 at 90 degrees is exact."""
    assert abs(theory.pinned_life(angle * DEGREE) / pinned - 1) < 5e-5
    assert abs(theory.constant_angle_life(angle * DEGREE) / constant - 1) < 5e-5


def test_pinned_volume_falls_with_the_rate():
    """rho dV/dt = -pi R D dc f, by differences."""
    t1, t2 = theory.pinned_time(1, 0.701), theory.pinned_time(1, 0.699)
    slope = (theory.volume(0.701, 1) - theory.volume(0.699, 1)) / (t2 - t1)
    assert abs(slope / (np.pi * theory.popov(0.7)) - 1) < 1e-5


@pytest.mark.parametrize('x, v', [(.1, .03759), (.3, .11524), (.5, .20235), (.7, .31796), (.9, .58449), (.95, .81712),
                                  (.99, 1.78508)])
def test_ring_velocity(x, v):
    """Digits of the table; and the mass balance of a height h = rest (1 - x^2) H that loses (1 - x^2)^(-1/2) H/4, as
    much as it shrinks: dh/dt + d(x h v)/dx/x + loss = 0."""
    assert abs(theory.ring_velocity(x, 1) - v) < 6e-6

    def flux(y):
        return y * (1 - y**2) * theory.ring_velocity(y, 1)
    step = 1e-6
    divergence = (flux(x + step) - flux(x - step)) / (2 * step) / x
    assert abs(-(1 - x**2) + divergence + (1 - x**2)**-0.5 / 4) < 1e-6


@pytest.mark.parametrize('t, share', [(.1, .0322), (.2, .0826), (.3, .1448), (.5, .3), (.7, .5), (.9, .7702),
                                      (.95, .8616)])
def test_ring_fraction(t, share):
    assert abs(theory.ring_fraction(t) - share) < 6e-5


@pytest.mark.parametrize('t', [0.1, 0.5, 0.9])
def test_ring_fraction_by_tracing(t):
    """Solute beyond x0, the share (1 - x0^2)^2 of a parabola, is at the rim when ln(1/rest) is the integral of
    dx/(v rest) from x0 to 1; with 1 - x^2 = q^2."""
    q0 = theory.ring_fraction(t)**0.25

    def time(q):
        x = np.sqrt(1 - q**2)
        return q / (x * theory.ring_velocity(x, 1))
    assert abs(theory.integral(time, 0, q0) / np.log(1 / (1 - t)) - 1) < 1e-10


def test_stefan_tube():
    """Water and ethanol at 298.15 K, dry end, 1 mm; x0 has four digits."""
    water = (101325, 298.15, 2.5e-5, 1e-3, 0.03128)
    ethanol = (101325, 298.15, 1.19e-5, 1e-3, 7870 / 101325)
    assert abs(theory.stefan_flux(*water) / 3.24778e-2 - 1) < 2e-4
    assert abs(theory.stefan_flux(*ethanol) / 3.93271e-2 - 1) < 1e-5
    for case, share in ((water, 0.98428), (ethanol, 0.96064)):
        assert abs(theory.stefan_flux(*case, stefan_flow=False) / theory.stefan_flux(*case) - share) < 1e-5
