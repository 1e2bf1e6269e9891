"""fvOptions with two fluids: sources of momentum, porosity, constraints; what no equation asks for is refused.

Two layers, water below air, that slide over each other without friction: each moves as its own density and viscosity say.
Expected: closed forms of one layer. Tolerances: of the pressure solver, and of nonlinear terms after some relaxation times.
"""
import re

import numpy as np
import pytest

from twoFluidCase import TwoFluidCase

RHO, MU = (1000.0, 1.2), (1e-3, 1.8e-5)
N = 8


class Layers(TwoFluidCase):
    """Water and air between slippery plates, cyclic along x and y, without particles."""

    def __init__(self, path, options, mu=MU, predictor='yes', zone='', **keywords):
        super().__init__(path, **{'level': 0.5e-2, 'upper': (1e-2, 1e-2, 1e-2), 'cells': (4, 1, N), 'cyclic': 'xy', 'mu': mu,
                                  'gravity': (0, 0, 0), 'deltaT': 1e-3, 'endTime': 0.02, 'writeFormat': 'ascii',
                                  'writePrecision': 16, 'writeInterval': 20, 'tolerance': 1e-13, **keywords})
        self.options = options
        self.predictor, self.zone = predictor, zone

    def write(self):
        super().write()
        (self.path/'constant/particleProperties').unlink()
        self.write_dict('system/fvOptions', self.options)
        path = self.path/'system/fvSolution'
        path.write_text(path.read_text().replace('PIMPLE\n{', f'PIMPLE\n{{\n    momentumPredictor {self.predictor};'))

    def write_block_mesh(self):
        super().write_block_mesh()
        path = self.path/'system/blockMeshDict'
        path.write_text(path.read_text().replace('6 7) (', f'6 7) {self.zone} ('))


def solved(case):
    """Velocities along x at the end: of the cells of water, of air."""
    case.mesh()
    result = case.run('interDemFoam')
    assert result.code == 0, result.output[-3000:]
    U = case.field('U', case.times()[-1])[:, 0].reshape(N, 4)
    return U[:N//2], U[N//2:], result.output


def force(Su, Sp=0, selection='all'):
    """A force of a volume [N/m3], and its part with U [N s/m4]."""
    return {'type': 'vectorSemiImplicitSource', 'selectionMode': selection, 'volumeMode': 'specific',
            'injectionRateSuSp': {'U': f'(({Su} 0 0) {Sp})'}}


def porosity(d, f, zone):
    """Darcy and Forchheimer, equal in all directions [1/m2, 1/m]."""
    return {'type': 'explicitPorositySource', 'explicitPorositySourceCoeffs': {
        'type': 'DarcyForchheimer', 'selectionMode': 'cellZone', 'cellZone': zone, 'd': (d, d, d), 'f': (f, f, f),
        'coordinateSystem': {'type': 'cartesian', 'origin': (0, 0, 0),
                             'rotation': {'type': 'axes', 'e1': (1, 0, 0), 'e2': (0, 1, 0)}}}}


FRICTIONLESS = (1e-30, 1e-30)


@pytest.mark.parametrize('predictor', ['yes', 'no'])
def test_force_accelerates_each_fluid_by_its_density(tmp_path, predictor):
    """U = s t/rho; without predictor three correctors leave out the cube of the Courant number of air, .07."""
    s = 10.0
    case = Layers(tmp_path, {'push': force(s)}, mu=FRICTIONLESS, predictor=predictor)
    water, air, _ = solved(case)
    assert np.abs(water/(s*0.02/RHO[0]) - 1).max() < 1e-9
    assert np.abs(air/(s*0.02/RHO[1]) - 1).max() < (1e-9 if predictor == 'yes' else 0.07**3)


def test_mean_velocity(tmp_path):
    """A force, equal for both, that makes the mean over all cells 1 m/s: 2/(1 + rho1/rho2) and rho1/rho2 times that."""
    case = Layers(tmp_path, {'push': {'type': 'meanVelocityForce', 'selectionMode': 'all', 'fields': '(U)',
                                      'Ubar': (1, 0, 0)}}, mu=FRICTIONLESS)
    water, air, _ = solved(case)
    ratio = RHO[0]/RHO[1]
    assert np.abs(water*(1 + ratio)/2 - 1).max() < 1e-9 and np.abs(air*(1 + 1/ratio)/2 - 1).max() < 1e-9


def test_porosity_has_density_and_viscosity_of_each_fluid(tmp_path):
    """s = mu d U + rho f U^2/2 after 20 relaxation times and more; cells beside the other fluid feel its friction."""
    s, d, f = 1e4, 1e9, 1e5
    case = Layers(tmp_path, {'push': force(s), 'bed': porosity(d, f, 'whole')}, zone='whole', endTime=0.04, writeInterval=40)
    water, air, _ = solved(case)
    for U, rho, mu in zip((water[:-1], air[1:]), RHO, MU):
        a, b = rho*f/2, mu*d
        assert np.abs(U/((np.sqrt(b*b + 4*a*s) - b)/(2*a)) - 1).max() < 1e-4


def test_part_of_the_mesh_is_porous(tmp_path):
    """Half of the length: s = mu d U/2. On the faces at the ends the mobility is the mean of both sides, so that the bed is
    shorter by less than a cell of eight (measured .66)."""
    s, d = 10.0, 1e11
    case = Layers(tmp_path, {'push': force(s), 'bed': porosity(d, 0, 'bed')}, cells=(16, 1, N), level=1.0)
    case.mesh()
    case.write_dict('system/topoSetDict', {'actions': '({name bed; type cellZoneSet; action new; source boxToCell;'
                                                      ' box (0.25e-2 -1 -1) (0.75e-2 1 1);})'})
    for command in ('topoSet', 'interDemFoam'):
        result = case.run(command)
        assert result.code == 0, result.output
    U = case.field('U', case.times()[-1])[:, 0].reshape(N, 16)[:, 6:10]
    assert np.abs(U/(2*s/MU[0]/d) - 1).max() < 1/8


def test_damping_has_the_density(tmp_path):
    """rho dU/dt = s - rho (U - UMax) U/h above UMax, h the root of the cell's volume, step by step as Euler has it; this
    constraint of OpenFOAM has no density of its own."""
    s, UMax, dt = 100.0, 1e-3, 1e-3
    case = Layers(tmp_path, {'push': force(s), 'brake': {'type': 'velocityDampingConstraint', 'selectionMode': 'all',
                                                         'UMax': UMax}}, mu=FRICTIONLESS)
    water, air, _ = solved(case)
    h = np.cbrt(np.prod(case.upper)/np.prod(case.cells))
    for U, rho in zip((water, air), RHO):
        u = 0.0
        for _ in range(20):
            u = (u + s*dt/rho)/(1 + dt*max(u - UMax, 0)/h)
        assert u < s*20*dt/rho*(1 - 1e-3)
        assert np.abs(U/u - 1).max() < 1e-9


LIQUID = {'type': 'scalarSemiImplicitSource', 'selectionMode': 'all', 'volumeMode': 'specific',
          'injectionRateSuSp': {'alpha.water': '(1 0)'}}
HELD = {'type': 'vectorFixedValueConstraint', 'selectionMode': 'all', 'fieldValues': {'U': (0, 0, 0)}}


@pytest.mark.parametrize('option, words', [(LIQUID, ('source', 'alpha.water', 'fvOptions', 'There are: 1(U)', 'active no')),
                                           (HELD, ('source', 'vectorFixedValueConstraint', 'U', 'explicitPorositySource'))])
def test_what_would_do_nothing_is_refused(tmp_path, option, words):
    """One message; switched off it may stay."""
    case = Layers(tmp_path/'on', {'source': option}, endTime=1e-3)
    case.mesh()
    result = case.run('interDemFoam')
    assert result.code != 0 and result.output.count('FOAM FATAL') == 1
    for word in words:
        assert word in result.output.split('FOAM FATAL')[1], word

    off = Layers(tmp_path/'off', {'source': {**option, 'active': 'no'}}, endTime=1e-3)
    off.mesh()
    assert off.run('interDemFoam').code == 0


@pytest.mark.parametrize('nu, predictor, told', [(1e-4, 'no', False), (1e-2, 'no', True), (1e-2, 'yes', False)])
def test_viscosity_without_predictor_is_told(tmp_path, nu, predictor, told):
    """The share of a change of U that the message says is left out is that of a run: water alone, pushed evenly;
    in the middle, where most faces lead to cells."""
    s = 10.0
    case = Layers(tmp_path, {'push': force(s)}, level=1.0, mu=(nu*RHO[0], nu*RHO[1]), predictor=predictor, endTime=1e-3,
                  writeInterval=1)
    water, air, output = solved(case)
    said = re.findall(r"up to (\S+) % of the changes of U are left out.*\n.*steps below", output)
    assert len(said) == told
    leftOut = 1 - np.append(water, air)/(s*1e-3/RHO[0])
    if told:
        assert abs(leftOut.max() - float(said[0])/100) < 1e-3
    else:
        assert leftOut.max() < 0.1
