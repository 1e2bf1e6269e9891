"""What moving spheres lose in momentum is in the fluid's field of velocity, not only in the ledger."""
import numpy as np
import pytest

from dewCase import quoted
from fluidCase import FluidCase

WIDTH, D, RHO = 0.04, 3e-3, 1000


@pytest.mark.parametrize('grading', [1, 2])
def test_fluid_holds_what_spheres_lost(tmp_path, grading):
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
    case.write()
    case.write_block_mesh()
    mesh = case.path / 'system/blockMeshDict'
    mesh.write_text(mesh.read_text().replace('(1 1 1)', f'(1 1 {grading})'))
    assert case.run('blockMesh').code == 0
    done = case.run('cfdDemFoam')
    assert done.code == 0, done.output

    time = case.times()[-1]
    # Heights of the layers grow by the same factor, the last is grading times the first
    height = grading**(np.arange(4)/3)
    volume = np.repeat(height/height.sum()*WIDTH*(WIDTH/4)**2, 16)
    held = RHO*((volume*case.field('alphac', time))[:, None]*case.field('U', time)).sum(axis=0)
    ledger = case.ledger()
    lost = -np.array([ledger.lx.sum(), ledger.ly.sum(), ledger.lz.sum()])
    assert np.linalg.norm(lost) > 1e-4

    # What the outer iterations leave; 2.5e-3 where the force was not shared by the faces as it is by the cells, by 1/A or
    # by their volumes
    assert np.abs(held - lost).max() < 1e-8*np.linalg.norm(lost)
