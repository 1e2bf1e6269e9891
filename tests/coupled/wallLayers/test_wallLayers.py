"""The gas that grains see beside a wall where it sticks: among grains its layer is thinner than a cell."""
from math import expm1, pi, sinh, sqrt

import numpy as np
import pytest

from dewCase import quoted
from fluidCase import FluidCase

WIDTH, CELLS, U = 4e-3, 4, 0.5
RHO, NU, RHO_P, DT = 1.2, 1.5e-5, 1000, 1e-5

# Least squares of leastSquaresGrad give a wall twice the weight of a neighbour, where there is no slope
WEIGHT = 2/3


def first_step(path, d, v, **coupling):
    """Change of velocity in one step of grains at rest to each other, two along each side of a cell, over that of
    grains in the middle; and the distance of each from the middle of its cell, from the wall on."""
    case = FluidCase(path, rho=RHO, nu=NU, upper=(WIDTH,)*3, cells=(CELLS,)*3, cyclic='yz', deltaT=DT, endTime=DT,
                     writeInterval=1, gravity=(0, 0, 0))
    place = (np.array(list(np.ndindex(8, 8, 8))) + 0.5)*WIDTH/8
    case.particles({'x': place[:, 0], 'y': place[:, 1], 'z': place[:, 2], 'd': d, 'vy': v})
    case.fields['U'] = f'(0 {U} 0)'
    case.properties = {
        'engine': 'liggghts', 'materials': {'glass': {'youngsModulus': 5e6, 'poissonsRatio': 0.3, 'density': RHO_P}},
        'contacts': {'normal': 'Hertz', 'tangential': 'history', 'default': {'restitution': 0.7, 'friction': 0.3}},
        'insertion': {'some': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'glass'}},
        'output': ('csv',), 'coupling': case.coupling('Stokes', pressure=False, **coupling)}
    case.mesh()
    done = case.run('cfdDemFoam')
    assert done.code == 0, done.output
    rows = case.table(DT)
    h = WIDTH/CELLS/2
    return rows['vy'] - v, (rows['x'] % (2*h) - h)/h, rows['x'] < 2*h, np.abs(rows['x'] - WIDTH/2) < 2*h


@pytest.mark.parametrize('d', [4.5e-4, 1e-4, 2e-5])
def test_layer_among_grains_at_rest(tmp_path, d):
    """mu u'' = R u beside the wall, u = Uoo (1 - exp(-x/l)), gives the slope half way from the wall to the cell that holds U. l
    of the Stokes limit of van der Hoef, Beetstra and Kuipers, J. Fluid Mech. 528 (2005). 1e-4: grains have moved by some
    nm."""
    dv, off, wall, middle = first_step(tmp_path, d, 0)
    phi = 8*pi/6*d**3/(WIDTH/CELLS)**3
    eps = 1 - phi
    x = WIDTH/CELLS/2*sqrt(18*phi/d**2*(10*phi/eps + eps**3*(1 + 1.5*sqrt(phi)))/eps)
    seen = 1 + WEIGHT*off[wall]*(x/2)/sinh(x/2)
    inner = dv[middle].mean()
    assert np.ptp(dv[middle]) < 1e-9*inner
    assert np.abs(dv[wall]/inner - seen).max() < 1e-4
    assert (np.ptp(seen) < 0.06) == (d > 4e-4)


@pytest.mark.parametrize('d, momentum', [(1e-4, 'semiImplicit'), (1e-4, 'none')])
def test_whole_slope_of_what_grains_share_or_cannot_hold(tmp_path, d, momentum):
    """Grains that move as the fluid does, and grains that the fluid does not feel, leave the line to the wall."""
    v = U if momentum == 'semiImplicit' else 0
    dv, off, wall, middle = first_step(tmp_path, d, v, momentum=momentum)
    tau = RHO_P*d**2/(18*RHO*NU)
    gain = -expm1(-DT/tau)
    assert np.abs(dv[middle] - (U - v)*gain).max() < 1e-9*U
    assert np.abs(dv[wall] - (U - v + WEIGHT*U*off[wall])*gain).max() < 1e-4*U*gain
