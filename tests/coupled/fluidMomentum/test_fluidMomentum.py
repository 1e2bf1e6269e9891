"""What moving spheres lose in momentum is in the fluid's field of velocity, not only in the ledger."""
import numpy as np

from dewCase import quoted
from fluidCase import FluidCase

WIDTH, D, RHO = 0.04, 3e-3, 1000


def test_fluid_holds_what_spheres_lost(tmp_path):
    # Model B in a cyclic box: the pressure gradient sums up to nothing. Sp and the void fraction differ from cell to cell
    case = FluidCase(tmp_path, upper=(WIDTH,)*3, cells=(4, 4, 4), cyclic='xyz', endTime=0.06, deltaT=3e-3, rho=RHO,
                     writeInterval=20, writeFormat='ascii', writePrecision=17, tolerance=1e-13, outer=4)
    case.properties = {
        'engine': 'prescribed', 'velocity': 'constant (0.1 0.2 0.2)', 'output': (),
        'materials': {'glass': {'youngsModulus': 1e7, 'poissonsRatio': 0.3, 'density': 2500}},
        'insertion': {'spheres': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'glass'}},
        'coupling': case.coupling('WenYu', pressure=False, model='B')}
    x = np.random.default_rng(1).permutation(512)[:200]
    case.particles({'x': (x % 8 + 0.5)*5e-3, 'y': (x // 8 % 8 + 0.5)*5e-3, 'z': (x // 64 + 0.5)*5e-3, 'd': D})
    case.mesh()
    done = case.run('cfdDemFoam')
    assert done.code == 0, done.output

    time = case.times()[-1]
    held = RHO*(case.field('alphac', time)[:, None]*case.field('U', time)).sum(axis=0)*(WIDTH/4)**3
    ledger = case.ledger()
    lost = -np.array([ledger.lx.sum(), ledger.ly.sum(), ledger.lz.sum()])
    assert np.linalg.norm(lost) > 1e-4

    # What the outer iterations leave; 2.5e-3 where the force was not shared by the faces as it is by the cells
    assert np.abs(held - lost).max() < 1e-8*np.linalg.norm(lost)
