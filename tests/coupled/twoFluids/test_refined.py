"""Particles that cross the surface of the water in a mesh that is refined around them: cells split and joined every step.

Liquid and the ledger are identities: round-off of sums. Restart: 1e-8, solvers end at 1e-14 of residuals.
Ranks: 1e-7, sums in another order, as mirrored cases (test_symmetry).
"""
import re

import numpy as np
import pytest

from test_twoFluids import falling, solve
from twoFluidCase import beyond_bounds, liquid_volumes, unbalanced

STEPS, DT = 8, 5e-4


def refined(path, **keywords):
    """27 spheres; no flux but phi is named in correctFluxes."""
    case = falling(path, sigma=0.072, **{'deltaT': DT, 'endTime': STEPS*DT, 'writeInterval': STEPS, 'tolerance': 1e-14, **keywords})
    case.mesh()
    case.write_dict('constant/dynamicMeshDict', {
        'dynamicFvMesh': 'rankIndependentRefineFvMesh', 'dynamicFvMeshLibs': '(dewRefinedMesh)', 'refineInterval': 1,
        'field': 'alphac', 'lowerRefineLevel': 0, 'upperRefineLevel': 0.995, 'unrefineLevel': 10, 'nBufferLayers': 1,
        'maxRefinement': 1, 'maxCells': 100000, 'correctFluxes': '((phi none))', 'dumpLevel': False})
    return case


@pytest.fixture(scope='module')
def whole(tmp_path_factory):
    """One rank, without a stop."""
    case = refined(tmp_path_factory.mktemp('refined'))
    return case, solve(case)


def test_balances(whole):
    """And no word about fluxes that a mesh cannot map."""
    case, output = whole
    for kind in ('Refined', 'Unrefined'):
        assert len(re.findall(f'^{kind} from', output, re.M)) > 1
    volumes = liquid_volumes(output)
    assert len(volumes) == STEPS and np.abs(volumes/volumes[0] - 1).max() < 1e-12
    assert beyond_bounds(output) < 1e-9
    assert unbalanced(output) < 1e-12
    assert np.abs(case.ledger().represented/(27*np.pi/6*1e-9) - 1).max() < 1e-12
    assert 'FOAM Warning' not in output


def same(one, other, tolerance=1e-8):
    """Spheres, over the fastest."""
    a, b = one.table(STEPS*DT), other.table(STEPS*DT)
    for name in ('vx', 'vy', 'vz'):
        assert np.abs(a[name] - b[name]).max() < tolerance*np.abs(a['vz']).max()


def test_two_ranks_do_as_one(whole, tmp_path):
    case = refined(tmp_path)
    case.decompose(2)
    output = solve(case, ranks=2)
    cells = '(?:Refined|Unrefined) from .*'
    assert re.findall(cells, output) == re.findall(cells, whole[1])
    same(whole[0], case, 1e-7)


def test_restart_goes_on(whole, tmp_path):
    """Half of the steps, a restart, the others."""
    case = refined(tmp_path, endTime=STEPS//2*DT, writeInterval=STEPS//2)
    solve(case)
    case.control['endTime'] = STEPS*DT
    case.write_dict('system/controlDict', case.control)
    solve(case)
    same(whole[0], case)
