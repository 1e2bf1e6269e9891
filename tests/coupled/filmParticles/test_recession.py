"""Particles in a film that evaporates: the surface goes past none of them, and the gas that is made carries none away.

The rate is given (fixedFlux), so that the surface is at L0 - J t/rho. Gas and liquid have densities 20 and 958 kg/m3:
the gas leaves 48 times as fast as the surface recedes.
"""
import numpy as np
import pytest

from columnCase import BOILING
from filmCase import FilmCase

R, L0, J, CELL = 5e-6, 0.2e-3, 0.1, 20e-6
SPEED = J/BOILING['rho']
START = L0 - np.array([2e-6, 60e-6, 185e-6])      # in the surface, below it, near the floor


@pytest.fixture(scope='module')
def receded(tmp_path_factory):
    """By 104 um, five cells."""
    case = FilmCase(tmp_path_factory.mktemp('film'), 20, 0.4e-3, L0, endTime=1.0, deltaT=2.5e-3, writeInterval=10)
    case.law, case.energy, case.gas['rho'] = {'type': 'fixedFlux', 'flux': J}, False, 20.0
    w = case.sides*case.width
    x = [(z, s*w, 0.4*w) for z, s in zip(START, (0.2, 0.55, 0.9))]
    case.spheres(x, 2*R, density=BOILING['rho'], modulus=1e3, timeStep={'fraction': 0.2}, coupling={'forces': {
        'drag': {'type': 'Stokes'}, 'pressure': {'type': 'pressureGradientForce'},
        'surface': {'type': 'elasticSurface', 'stiffness': 1e-4}}})
    case.mesh()
    case.go()
    return case


def test_stay_in_the_liquid(receded):
    """Where they were till the surface comes, then with it, a tenth of a radius above it at most (measured 0.07) and the
    way of the surface in a step; in the cell beside the surface they give way by 0.2 R."""
    reached = 0
    for name in receded.times():
        t = float(name)
        surface = L0 - SPEED*t
        x = receded.table(t)['x']
        expected = np.minimum(START, surface)
        assert (x - expected).max() < 0.1*R + SPEED*2.5e-3, t
        assert (expected - x).max() < 0.3*R, t
        reached = np.sum(expected < START)
    assert reached == 2


def test_surface_is_where_it_must_be(receded):
    """The volume of the liquid, and with it the surface that particles see; what is on its way is of one step."""
    table = receded.evaporated()
    assert np.abs(table.volume/receded.area - (L0 - SPEED*(table.time - 2.5e-3))).max() < 1e-7*L0
