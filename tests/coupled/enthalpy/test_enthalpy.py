"""What hot moving spheres give is in the fluid: the void fraction changes in every step, and continuity with it."""
import numpy as np

from dewCase import quoted
from fluidCase import FluidCase

WIDTH, D, RHO, CP, T_FLUID = 0.04, 3e-3, 1000, 4180, 300


def test_fluid_holds_what_spheres_gave(tmp_path):
    case = FluidCase(tmp_path, upper=(WIDTH,)*3, cells=(4, 4, 4), cyclic='xyz', endTime=0.06, deltaT=3e-3,
                     writeInterval=20, writeFormat='ascii', writePrecision=17, tolerance=1e-13)
    case.convection = 'Gauss upwind'
    case.fields['T'] = str(T_FLUID)
    case.transport.update(Cp=CP, kappa=0.6)
    case.properties = {
        'engine': 'prescribed', 'heat': True, 'velocity': 'constant (0.1 0.2 0.2)', 'output': (),
        'materials': {'glass': {'youngsModulus': 1e7, 'poissonsRatio': 0.3, 'density': 2500, 'heatCapacity': 800,
                                'thermalConductivity': 1}},
        'insertion': {'spheres': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'glass',
                                  'T': 400}},
        'coupling': {'voidFraction': {'type': 'particleCentre'}, 'momentum': 'none', 'forces': {},
                     'heatTransfer': {'type': 'RanzMarshall'}}}
    x = np.random.default_rng(1).permutation(512)[:300]
    case.particles({'x': (x % 8 + 0.5)*5e-3, 'y': (x // 8 % 8 + 0.5)*5e-3, 'z': (x // 64 + 0.5)*5e-3, 'd': D})
    case.mesh()
    done = case.run('cfdDemFoam')
    assert done.code == 0, done.output

    time = case.times()[-1]
    alphac, T = case.field('alphac', time), case.field('T', time)
    assert abs((1 - alphac).sum()*(WIDTH/4)**3 - 300*np.pi/6*D**3) < 1e-10*WIDTH**3
    held = RHO*CP*(alphac*(T - T_FLUID)).sum()*(WIDTH/4)**3
    given = -case.ledger().heatLost.sum()
    assert given > 100

    # 20 steps of equations solved to 1e-13, and digits of T/(T - T_FLUID); with T solved before continuity 1e-3
    assert abs(held/given - 1) < 1e-10
