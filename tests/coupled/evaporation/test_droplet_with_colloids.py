"""A hot drop with 312 colloids: ranks, restart, nobody in the gas at the start, results that ParaView can read.

The reference is the same case on one rank without interruption. What differs between ranks is what the linear solvers leave,
1e-9 of the scale of their matrix; 30 steps carry no colloid further than 0.2 um.
"""
import re

import numpy as np
import pytest

from dewCase import run_command
from hotDroplet import A, case, set_entry

END, MIDDLE = 6e-5, 3e-5


def prepared(path, end=END):
    case(path)
    set_entry(path / 'system/times', 'endTime', end)
    set_entry(path / 'system/times', 'writeInterval', MIDDLE)
    for command in (['blockMesh'], ['setSphericalCap'], ['setFields']):
        done = run_command(command, path, 60)
        assert done.code == 0, done.output[-2000:]
    return path


def go(path, ranks=1):
    command = ['interEvapDemFoam']
    if ranks > 1:
        set_entry(path / 'system/decomposeParDict', 'numberOfSubdomains', ranks)
        done = run_command(['decomposePar', '-force'], path, 60)
        assert done.code == 0, done.output[-2000:]
        command = ['mpirun', '--allow-run-as-root', '--oversubscribe', '-np', str(ranks)] + command + ['-parallel']
    done = run_command(command, path, 300)
    assert done.code == 0, done.output[-3000:]
    return done.output


def folder(path, time):
    """Of a time, and its name"""
    names = [f for f in path.iterdir() if re.fullmatch(r'[0-9.e-]+', f.name)]
    return next(f for f in names if np.isclose(float(f.name), time, rtol=0.02, atol=0))


def colloids(path, time=END):
    """Positions by number"""
    columns, *rows = (line.split(',') for line in (folder(path, time) / 'particles.csv').read_text().splitlines())
    rows = sorted(rows, key=lambda row: int(row[columns.index('id')]))
    return np.array([[float(row[columns.index(name)]) for name in 'xyz'] for row in rows])


def volume(path, start='0'):
    return np.loadtxt(path / f'postProcessing/evaporation/{start}/ledger.dat')[-1, 7]


@pytest.fixture(scope='module')
def reference(tmp_path_factory):
    path = prepared(tmp_path_factory.mktemp('drop') / 'reference')
    go(path)
    return path


def test_the_flow_carries_them(reference):
    """The colloids are where they were, and moved: by Brownian motion, D = kT/(6 pi mu R) of 1.7e-12 m2/s, and by the flow"""
    x0, x = colloids(reference, MIDDLE), colloids(reference)
    assert len(x) == 312 and (np.linalg.norm(x, axis=1) < A).all() and (x[:, 2] > 0.4e-6).all()
    moved = np.linalg.norm(x - x0, axis=1)
    assert 5e-9 < np.median(moved) < 1e-6


def test_two_ranks(reference, tmp_path):
    path = prepared(tmp_path / 'ranks')
    go(path, 2)
    assert np.abs(colloids(path) - colloids(reference)).max() < 1e-10
    assert abs(volume(path) / volume(reference) - 1) < 1e-7


def test_restart(reference, tmp_path):
    """Stopped in the middle, and on from there: also the steps go on as they were"""
    path = prepared(tmp_path / 'restart', MIDDLE)
    go(path)
    set_entry(path / 'system/times', 'endTime', END)
    set_entry(path / 'system/controlDict', 'startFrom', 'latestTime')
    go(path)
    assert np.abs(colloids(path) - colloids(reference)).max() < 1e-12
    assert abs(volume(path, folder(path, MIDDLE).name) / volume(reference) - 1) < 1e-9


def test_in_the_gas(tmp_path):
    path = prepared(tmp_path / 'gas')
    set_entry(path / 'constant/colloids', 'contactRadius', '30e-6')
    done = run_command(['interEvapDemFoam'], path, 60)
    assert done.code != 0
    for word in ('in the gas at the start', 'one is number', 'sphericalCap', 'constant/'):
        assert word in done.output
