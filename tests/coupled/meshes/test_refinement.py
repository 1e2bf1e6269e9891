"""Cells that are split and joined around particles on their way (rankIndependentRefineFvMesh, dynamicRefineFvMesh).

Expected values: balances, and what a mesh that does not change gives. Tolerances: sums of N numbers are good to some
N ulp.
"""
import re

import numpy as np
import pytest

from dewCase import quoted
from fluidCase import FluidCase
from test_exchange import CONTACTS, GLASS, sphere, vectors

ASCII = {'writeFormat': 'ascii', 'writePrecision': 17}
L = 0.02
MODELS = {'divided': {'type': 'divided'}, 'particleCentre': {'type': 'particleCentre'},
          'trilinear': {'type': 'trilinear'}, 'Gaussian': {'type': 'Gaussian', 'width': 1.2e-3},
          'exactOverlap': {'type': 'exactOverlap'}, 'bigParticle': {'type': 'bigParticle', 'scale': 1.5}}


def refined(path, void='divided', n=24, cells=4, seed=3, field='alphac', limits=(0, 0.995), coupling=None, d=8e-4,
            mesh='dynamicRefineFvMesh', **control):
    """Grains of 0.8 mm that fall and drift in a box of water, whose cells are split in 8 where particles are."""
    case = FluidCase(path, upper=(L,)*3, cells=(cells,)*3, tolerance=1e-12, outer=2,
                     **{'deltaT': 2e-3, 'endTime': 0.04, 'writeInterval': 20, **ASCII, **control})
    case.properties = {
        'engine': 'liggghts', 'output': ('csv',), 'materials': {'glass': GLASS}, 'contacts': CONTACTS,
        'walls': {'all': {'type': 'patch', 'patches': '(".*")', 'material': 'glass'}},
        'insertion': {'some': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'glass'}},
        'coupling': {**case.coupling('SchillerNaumann'), 'voidFraction': MODELS[void], **(coupling or {})}}
    rng = np.random.default_rng(seed)
    x = (rng.permutation(512)[:n, None] // [1, 8, 64] % 8 + 0.5) * L / 8 * [0.45, 1, 0.6] + [0, 0, 0.3*L]
    v = [0.2, 0, -0.1] + rng.uniform(-0.05, 0.05, (n, 3))
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': d, 'vx': v[:, 0], 'vy': v[:, 1],
                    'vz': v[:, 2]})
    case.mesh()
    case.write_dict('constant/dynamicMeshDict', {
        'dynamicFvMesh': mesh, 'refineInterval': 1, 'field': field, 'lowerRefineLevel': limits[0],
        'upperRefineLevel': limits[1], 'unrefineLevel': 10, 'nBufferLayers': 1, 'maxRefinement': 1, 'maxCells': 100000,
        'correctFluxes': '((phi none))', 'dumpLevel': False})
    return case


def run(case, ranks=1):
    if ranks > 1:
        case.decompose(ranks)
    done = case.run('cfdDemFoam', ranks=ranks, timeout=200)
    assert done.code == 0, done.output[-3000:]
    return done


def check(case, done, n=24, d=8e-4):
    """The mesh became finer and coarser; nothing of volume, number, or momentum was lost in any step."""
    assert 'Refined from' in done.output and 'Unrefined from' in done.output
    assert 'user-provided flux mapping' not in done.output
    ledger = case.ledger()
    assert np.all(ledger.outside == 0) and np.all(ledger.clipped == 0)
    assert np.abs(ledger.held/(n*sphere(d)) - 1).max() < 1e-12
    assert np.abs(ledger.represented/ledger.held - 1).max() < 1e-10
    received = np.stack([ledger.rx, ledger.ry, ledger.rz])
    lost = np.stack([ledger.lx, ledger.ly, ledger.lz])
    assert (np.linalg.norm(received - lost, axis=0)/ledger.scale).max() < 1e-10
    assert len(case.table(case.control['endTime'])) == n


@pytest.mark.parametrize('void', MODELS)
def test_nothing_is_lost(tmp_path, void):
    # Spread over 8 cells of 5 mm, particles take less of each
    case = refined(tmp_path, void, limits=(0, 0.998 if void in ('trilinear', 'bigParticle') else 0.995))
    check(case, run(case))


@pytest.mark.parametrize('entries', [{'smoothing': {'type': 'diffusion', 'length': 2e-3}}, {'alphacTime': 5e-3},
                                     {'model': 'B'}], ids=['smoothing', 'delay', 'B'])
def test_nothing_is_lost_with(tmp_path, entries):
    """Delayed, alphac is mapped with the mesh: what it shows stays that of all particles."""
    case = refined(tmp_path, coupling=entries)
    check(case, run(case))


def test_two_ranks(tmp_path):
    """The same cells are split and joined at every step, and particles agree to what the fluid's solvers leave: 1e-12 of
    their residuals, with room for its growth (4e-11 of 0.1 m/s measured)."""
    tables, changes = [], []
    for ranks in (1, 2):
        case = refined(tmp_path / str(ranks), mesh='rankIndependentRefineFvMesh', endTime=0.02, writeInterval=10)
        done = run(case, ranks)
        changes.append(re.findall(r'efined from \d+ to \d+', done.output))
        assert np.abs(case.ledger().represented/case.ledger().held - 1).max() < 1e-10
        tables.append(case.table(0.02))
    assert len(changes[0]) > 5 and changes[0] == changes[1]
    assert np.abs(vectors(tables[0]) - vectors(tables[1])).max() < 1e-8


@pytest.mark.parametrize('void', ['divided', 'Gaussian'])
def test_fluid_at_rest_stays_at_rest(tmp_path, void):
    """Spheres at rest, without weight and force: the new cells know where they are, at both time levels of alphac."""
    case = refined(tmp_path, void, gravity=(0, 0, 0), endTime=6e-3, writeInterval=3)
    case.properties.update(engine='prescribed', coupling={**case.properties['coupling'], 'momentum': 'none'})
    for entry in ('walls', 'contacts'):
        del case.properties[entry]
    case.write()
    done = run(case)
    assert 'Refined from' in done.output
    assert np.abs(case.field('U', case.times()[-1])).max() < 1e-12


def test_restart_of_a_refined_mesh(tmp_path):
    """It goes on as if it had not stopped: to the tolerance of the fluid's solvers, 1e-12, with room for its growth."""
    whole = refined(tmp_path / 'whole', writeInterval=10)
    run(whole)
    part = refined(tmp_path / 'part', writeInterval=10, endTime=0.02)
    run(part)
    part.control['endTime'] = 0.04
    part.write_dict('system/controlDict', part.control)
    run(part)
    a, b = whole.table(0.04), part.table(0.04)
    assert np.abs(vectors(a) - vectors(b)).max() < 1e-10
