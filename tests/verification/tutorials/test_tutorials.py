"""Every tutorial runs in a fresh copy from its Allrun, and its validate is content; a wrong dictionary is noticed."""
import shutil

import pytest

from dewCase import ROOT, run_command

TUTORIALS = ROOT / 'tutorials'


def fresh(path, name):
    # Without what earlier runs have left
    shutil.copytree(TUTORIALS / name, path, ignore=shutil.ignore_patterns('R[0-9]*', '[0-9]*', '*.png', '__pycache__'))
    return path


@pytest.mark.parametrize('name', ['demFoam/collisions', pytest.param('demFoam/packing', marks=pytest.mark.slow)])
def test_runs_and_validates(tmp_path, name):
    case = fresh(tmp_path / 'case', name)
    done = run_command(['./Allrun'], case, 1200)
    assert done.code == 0, done.output[-3000:]
    done = run_command(['./validate'], case, 120)
    assert done.code == 0 and done.output.rstrip().endswith('PASS'), done.output
    done = run_command(['./Allclean'], case, 60)
    assert done.code == 0, done.output


def test_validate_notices_a_wrong_restitution(tmp_path):
    case = fresh(tmp_path / 'case', 'demFoam/collisions')
    path = case / 'common' / 'constant' / 'collisions'
    text = path.read_text()
    assert 'restitution     0.75' in text
    path.write_text(text.replace('restitution     0.75', 'restitution     0.70'))
    done = run_command(['./Allrun', '20um'], case, 300)
    assert done.code == 0, done.output[-3000:]
    done = run_command(['./validate'], case, 120)
    assert done.code != 0 and 'FAIL' in done.output.splitlines()[-1]
