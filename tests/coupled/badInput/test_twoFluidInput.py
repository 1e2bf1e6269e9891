"""What a user gets wrong in a case of two fluids: one message that names the file, the entry, what is there and what to do."""
import re

import pytest

from dewCase import changed
from twoFluidCase import TwoFluidCase


class Small(TwoFluidCase):
    """Some cells, without particles."""

    def __init__(self, path):
        super().__init__(path, level=2e-3, cells=(2, 2, 4), endTime=1e-4)

    def write(self):
        super().write()
        (self.path/'constant/particleProperties').unlink()


def surface(**entries):
    def change(case):
        case.surface = changed(case.surface, {k.replace('__', '/'): v for k, v in entries.items()})
    return change


def transport(**entries):
    def change(case):
        case.transport = changed(case.transport, {k.replace('__', '/'): v for k, v in entries.items()})
    return change


def without(name):
    return lambda case: case.path.joinpath(name).unlink()


def edited(name, old, new):
    def change(case):
        path = case.path/name
        assert old in path.read_text()
        path.write_text(path.read_text().replace(old, new))
    return change


BEFORE = {
    'liquid': (surface(liquid='oil'), ('0/alpha.oil', 'surfaceProperties', 'setLiquid', "'liquid'")),
    'no liquid': (surface(liquid=None), ("'liquid'", 'surfaceProperties')),
    'motion': (surface(surfaceMotion__type='VOF'), ('VOF', 'isoAdvector', 'surfaceProperties.surfaceMotion')),
    'no type': (surface(surfaceMotion={}), ("'type'", 'surfaceMotion', 'isoAdvector')),
    'curvature': (surface(curvature={'type': 'heights'}), ('heights', 'heightFunction', 'surfaceProperties.curvature')),
    'no sigma': (surface(surfaceTension={}), ("'sigma'", 'surfaceTension', 'SI')),
    'sigma': (surface(surfaceTension__sigma='[1 0 -1 0 0 0 0] 0.07'), ('sigma', 'surfaceTension', '[1 0 -1', '[1 0 -2')),
    'angles': (surface(contactAngles={'xMin': 60}), ('xMin', 'contactAngles', 'not a dictionary')),
    'unknown': (surface(contactAngle=60), ("'contactAngle'", 'contactAngles')),
    'viscosity': (transport(water__nu=-1e-6), ('viscosity of water', 'transportProperties', '-1e-06', 'positive')),
    'density': (transport(air__rho=0), ('rho', 'air', '0')),
    'fluid': (transport(air=None), ("'air'", 'transportProperties'))}

AFTER = {
    'surfaceProperties': (without('constant/surfaceProperties'), ('constant/surfaceProperties', 'tutorial')),
    'alpha': (without('0/alpha.water'), ('0/alpha.water', 'setLiquid')),
    'p_rgh': (without('0/p_rgh'), ('0/p_rgh', 'Add it')),
    'U': (edited('0/U', '[0 1 -1 0 0 0 0]', '[0 2 -1 0 0 0 0]'), ('0/U', '[0 2 -1', '[0 1 -1')),
    'pressure': (edited('0/p_rgh', '[1 -1 -2 0 0 0 0]', '[0 2 -2 0 0 0 0]'), ('0/p_rgh', '[0 2 -2', '[1 -1 -2')),
    'g': (edited('constant/g', '[0 1 -2 0 0 0 0]', '[0 0 -2 0 0 0 0]'), ('constant/g', '[0 0 -2', '[0 1 -2')),
    'reference': (edited('system/fvSolution', 'pRefCell', 'pRef'), ('pRefCell', 'fvSolution.PIMPLE')),
    'solver': (edited('system/fvSolution', '"p.*"', '"q.*"'), ("'p_rgh'", 'fvSolution.solvers'))}


@pytest.mark.parametrize('subject', [*BEFORE, *AFTER])
def test_one_message(tmp_path, subject):
    change, words = {**BEFORE, **AFTER}[subject]
    case = Small(tmp_path)
    if subject in BEFORE:
        change(case)
    case.mesh()
    if subject in AFTER:
        change(case)
    result = case.run('interDemFoam')
    assert result.code == 1 and not case.times()
    assert len(re.findall('FOAM FATAL', result.output)) == 1, result.output
    message = result.output.split('FOAM FATAL')[1]
    for word in words:
        assert word in message, message


def test_third_fluid_refused(tmp_path):
    """Entry fluid of particleProperties, which is for particles alone."""
    case = TwoFluidCase(tmp_path, level=2e-3, cells=(2, 2, 4), endTime=1e-4)
    case.properties = {
        'engine': 'liggghts', 'fluid': {'viscosity': 1e-3, 'density': 1000},
        'materials': {'glass': {'youngsModulus': 5e6, 'poissonsRatio': 0.3, 'density': 2500}},
        'contacts': {'tangential': 'none', 'default': {'restitution': 0.8}}, 'coupling': case.coupling('Stokes'),
        'insertion': {'one': {'type': 'file', 'file': '"constant/particles.csv"', 'material': 'glass'}}}
    case.particles({'x': 1e-3, 'y': 1e-3, 'z': 1e-3, 'd': 1e-4})
    case.mesh()
    result = case.run('interDemFoam')
    assert result.code == 1 and result.output.count('FOAM FATAL') == 1 and not case.times()
    message = result.output.split('FOAM FATAL')[1]
    assert all(word in message for word in ("'fluid'", 'demFoam', 'Remove')), message


def test_forgotten_liquid_is_told(tmp_path):
    """Without setLiquid the run goes on, for liquid may flow in."""
    case = Small(tmp_path)
    case.fields['alpha.water'] = '0'
    case.mesh()
    result = case.run('interDemFoam')
    assert result.code == 0
    assert re.search('There is no liquid: the field .*0/alpha.water', result.output) and 'setLiquid' in result.output
