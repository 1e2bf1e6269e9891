"""Surface tension that varies: the pull along a flat surface and around a drop; ranks, mirrors and wrong input.

Two layers, each between a wall and the surface, with sigma = s0 + s1 cos(k x): without inertia the stream functions

    psi_j = f_j(eta) sin(k x),  f_j = c1 sinh(k eta) + c2 eta cosh(k eta) + c3 eta sinh(k eta),  u = d(psi)/dy

(eta from the wall, so that f_j = 0 there; of the four solutions of the biharmonic equation cosh(k eta) drops out by
this) with no slip at the wall, no flow through the surface, one velocity along it, and the jump of the shear stress,

    mu1 u1' - mu2 u2' = d(sigma)/dx,

give u. Surface tension is strong and s1 small: the surface stays flat, and inertia is small.
"""
import re

import numpy as np
import pytest

from dewCase import SIDES
from fluidCase import DIMENSIONS
from twoFluidCase import TwoFluidCase

WIDTH, HEIGHT, LEVEL = 2.0, 1.0, 0.45
K = 2*np.pi/WIDTH
MU, S0, S1 = (1.0, 0.25), 100.0, 0.1


def layer(h):
    """u = d(psi)/d(eta) as a function of eta with u(h) = 1, and its slope there."""
    # f(h) = 0, f'(0) = 0, f'(h) = 1
    s, c = np.sinh(K*h), np.cosh(K*h)
    rows = [[s, h*c, h*s], [K, 1, 0], [K*c, c + K*h*s, s + K*h*c]]
    a = np.linalg.solve(rows, [0, 0, 1])

    def u(y):
        s, c = np.sinh(K*y), np.cosh(K*y)
        return a[0]*K*c + a[1]*(c + K*y*s) + a[2]*(s + K*y*c)
    return u, a[0]*K**2*s + a[1]*(2*K*s + K**2*h*c) + a[2]*(2*K*c + K**2*h*s)


def exact(x, y):
    """u of both layers."""
    below, slope1 = layer(LEVEL)
    above, slope2 = layer(HEIGHT - LEVEL)
    # Both slopes are away from a wall; sigma' = -k s1 sin(k x) = U (mu1 slope1 + mu2 slope2) sin(k x)
    U = -K*S1/(MU[0]*slope1 + MU[1]*slope2)
    return U*np.sin(K*x)*np.where(y < LEVEL, below(np.minimum(y, LEVEL)), above(np.minimum(HEIGHT - y, HEIGHT - LEVEL))), U


def centres(n):
    return [v.ravel() for v in np.meshgrid((np.arange(2*n) + 0.5)/n, (np.arange(n) + 0.5)/n)]


class Alone(TwoFluidCase):
    """Without particles; a predictor for the viscous flow."""

    def write(self):
        super().write()
        (self.path/'constant/particleProperties').unlink()


def layers(path, n, **keywords):
    """Two layers in the x-z plane, 2n x n cells."""
    case = Alone(path, **{
        'level': LEVEL, 'upper': (WIDTH, 0.1, HEIGHT), 'cells': (2*n, 1, n), 'cyclic': 'xy', 'rho': (1.0, 1.0), 'mu': MU,
        'gravity': (0, 0, 0), 'endTime': 0.5, 'deltaT': 4e-3*16/n, 'writeInterval': 100000, 'writeFormat': 'ascii',
        'writePrecision': 12, 'tolerance': 1e-9, 'pressure_correctors': 2, **keywords})
    case.control.update(writeControl='runTime', writeInterval=case.control['endTime'])
    x, _ = centres(n)
    case.fields['T'] = np.cos(K*x)
    case.patches['U'] = {side: {'type': 'noSlip'} for side in ('zMin', 'zMax')}
    case.surface['surfaceTension'] = {'semiImplicit': True, 'sigma': {'type': 'linear', 'sigma0': S0, 'slope': S1}}
    return case


def solve(case, ranks=1, code=0):
    result = case.run('interDemFoam', ranks=ranks, timeout=400)
    assert (result.code == 0) == (code == 0), result.output[-3000:]
    return result.output


def error(path, n):
    """Of the velocity along the layers, root mean square over that of the surface."""
    case = layers(path, n)
    case.mesh()
    solve(case)
    u, U = exact(*centres(n))
    return np.sqrt(np.mean((case.field('U', 0.5)[:, 0] - u)**2))/abs(U)


def test_layers_driven_by_their_surface(tmp_path):
    e = error(tmp_path/'16', 16), error(tmp_path/'32', 32)
    print(e)
