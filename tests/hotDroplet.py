"""The hot drop with colloids of tutorials/interEvapDemFoam/sessileDroplet on a coarse mesh, for tests."""
import re
import shutil

from dewCase import ROOT

TUTORIAL = ROOT / 'tutorials/interEvapDemFoam/sessileDroplet'
A, R, CELLS, CORE, OUTER, GROWN = 25e-6, 0.5e-6, 12, 13, 8.0, 14


def growth():
    """Last cell over first of those outside the even part, so that the first is as large as an even one."""
    length, first = (OUTER - CORE / CELLS), 1 / CELLS
    low, high = 1.0001, 3.0
    for _ in range(100):
        q = 0.5 * (low + high)
        low, high = (q, high) if first * (q**GROWN - 1) / (q - 1) < length else (low, q)
    return q**(GROWN - 1)


def set_entry(path, name, value):
    text, n = re.subn(rf'(?m)^(\s*){name}(\s+)[^;]*;', rf'\g<1>{name}\g<2>{value};', path.read_text())
    assert n == 1, (path, name)
    path.write_text(text)


def case(path):
    for part in ('common', 'hot'):
        shutil.copytree(TUTORIAL / part, path, dirs_exist_ok=True)
    shutil.copytree(path / '0.orig', path / '0')
    mesh = path / 'system/mesh'
    for name, value in (('coreRadius', CORE / CELLS), ('coreHeight', CORE / CELLS), ('outer', OUTER),
                        ('coreRadial', CORE), ('coreAxial', CORE), ('outerRadial', GROWN), ('outerAxial', GROWN),
                        ('growthRadial', growth()), ('growthAxial', growth())):
        set_entry(mesh, name, value)
    set_entry(path / 'system/times', 'maxVolumeChange', 0.02)
    return path
