"""Input that cannot be meant ends with one error: the file or dictionary, the entry, its value and
what to do instead. It exits with a code, leaves finished times as they are, and does not hang on
two ranks. Particles that leave are counted.

A refusal is a change of a sound case (entries of particleProperties by path, None takes one out)
and the words its message must hold.
"""
import math
import pathlib
import re
import sys

import pytest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2]))
from dewCase import Case, changed, quoted, steps  # noqa: E402

CONTACT = {'restitution': 0.8, 'friction': 0.4}
SIDES = ('xMin', 'xMax', 'yMin', 'yMax', 'zMin', 'zMax')

SOUND = {
    'engine': 'liggghts',
    'materials': {
        'glass': {'youngsModulus': 5e6, 'poissonsRatio': 0.3, 'density': 2500.0},
        'steel': {'youngsModulus': 5e6, 'poissonsRatio': 0.3, 'density': 7800.0}},
    'contacts': {'normal': 'Hertz', 'tangential': 'history', 'default': CONTACT},
    'walls': {'sides': {'type': 'patch', 'patches': SIDES, 'material': 'steel'}},
    'insertion': {
        'pair': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'glass'}},
    'output': ('csv',)}

# One on each of two ranks
PAIR = {'x': (1e-3, 3e-3), 'y': 2e-3, 'z': 2e-3, 'd': 1e-3}

MONO = {'type': 'mono', 'value': 5e-4}
BOX = {'type': 'box', 'min': (0, 0, 0), 'max': (4e-3, 4e-3, 4e-3)}
PACKED = {'type': 'packed', 'material': 'glass', 'number': 10, 'diameter': MONO, 'region': BOX}
RATE = {'type': 'rate', 'material': 'glass', 'numberRate': 1e5, 'diameter': MONO, 'region': BOX}
SIZES = {'type': 'normal', 'mean': 5e-4, 'deviation': 1e-4, 'min': 3e-4, 'max': 7e-4}


def packed(**changes):
    """The sound case with a packed bed instead of the pair."""
    return {'insertion': {'bed': changed(PACKED, changes)}}


# By subject: changes of SOUND, words of the message
REFUSALS = {
    'engine unknown': (
        {'engine': 'ligghts'},
        ('particleProperties', 'Unknown engine', 'ligghts', 'liggghts', 'prescribed')),
    'engine missing': (
        {'engine': None}, ('particleProperties', "'engine'", 'Missing entry', 'liggghts')),
    'wall unknown': (
        {'walls/sides/type': 'patches'},
        ('particleProperties', 'walls', 'sides', 'Unknown wall', 'patches', 'cylinder', 'plane', 'STL')),
    'wall not a dictionary': (
        {'walls/floor': 'patch'}, ('particleProperties', 'walls', 'floor')),
    'walls not a dictionary': (
        {'walls': 'none'}, ('particleProperties', 'walls')),
    'insertion unknown': (
        {'insertion/pair/type': 'files'},
        ('particleProperties', 'insertion', 'pair', 'Unknown insertion', 'files', 'packed', 'rate')),
    'insertion not a dictionary': (
        {'insertion/bed': 'packed'}, ('particleProperties', 'insertion', 'bed')),
    'material not a dictionary': (
        {'materials/dust': 2500}, ('particleProperties', 'materials', 'dust')),
    'timeStep not a dictionary': (
        {'timeStep': 1e-6}, ('particleProperties', 'timeStep')),
    'insertion empty': (
        {'insertion/pair': None}, ('particleProperties', 'No particles', 'insertion')),
    'size distribution unknown': (
        packed(**{'diameter/type': 'gauss'}),
        ('particleProperties', 'diameter', 'Unknown', 'gauss', 'mono', 'normal', 'logNormal', 'uniform')),
    'region unknown': (
        packed(**{'region/type': 'cube'}),
        ('particleProperties', 'region', 'Unknown region', 'cube', 'box', 'cylinder', 'sphere', 'sphericalCap')),
    'motion unknown': (
        {'walls/sides/motion': {'type': 'linaer', 'velocity': (0, 0, 1)}},
        ('particleProperties', 'motion', 'Unknown', 'linaer', 'linear', 'oscillating', 'rotating', 'none')),
    'motion not a dictionary': (
        {'walls/sides/motion': 'linear'}, ('particleProperties', 'sides', 'motion')),
    'normal model unknown': (
        {'contacts/normal': 'hertzian'},
        ('particleProperties', 'contacts', 'Unknown normal', 'hertzian', 'Hertz', 'Hooke')),
    'tangential model unknown': (
        {'contacts/tangential': 'historic'},
        ('particleProperties', 'Unknown tangential', 'historic', 'history', 'noHistory', 'none')),
    'rolling model unknown': (
        {'contacts/rolling': 'epsd3'},
        ('particleProperties', 'Unknown rolling', 'epsd3', 'cdt', 'epsd', 'epsd2', 'none')),
    'cohesion model unknown': (
        {'contacts/cohesion': 'glue'},
        ('particleProperties', 'Unknown cohesion', 'glue', 'area', 'none')),
    'output format unknown': (
        {'output': ('cvs',)}, ('particleProperties', 'output', 'cvs', 'cloud', 'vtk', 'csv')),
    'material entry missing': (
        {'materials/glass/density': None},
        ('particleProperties', 'materials', 'glass', 'density', 'Add')),
    'material entry missing with heat': (
        {'heat': True},
        ('particleProperties', 'materials', 'glass', 'thermalConductivity', 'Add')),
    'materials missing': (
        {'materials': None}, ('particleProperties', 'materials', 'add')),
    'materials empty': (
        {'materials': {}}, ('particleProperties', 'No material', 'Give')),
    'pair of materials missing': (
        {'contacts/default': None, 'contacts/glass.glass': CONTACT},
        ('particleProperties', 'contacts', 'glass.steel', 'Add', 'default')),
    'coefficient missing': (
        {'contacts/default/friction': None},
        ('particleProperties', 'contacts', 'default', 'friction', 'Add')),
    'rolling coefficient missing': (
        {'contacts/rolling': 'cdt'},
        ('particleProperties', 'contacts', 'default', 'rollingFriction', 'Add')),
    'wall of unknown material': (
        {'walls/sides/material': 'stele'},
        ('particleProperties', 'walls', 'sides', 'material', 'stele', 'Known', 'glass', 'steel')),
    'insertion of unknown material': (
        {'insertion/pair/material': 'galss'},
        ('particleProperties', 'insertion', 'pair', 'material', 'galss', 'Known', 'glass', 'steel')),
    'dimensions of density': (
        {'materials/glass/density': '[1 -2 0 0 0 0 0] 2500'},
        ('particleProperties', 'glass', 'Wrong dimensions', 'density', '[1 -2 0 0 0 0 0]', 'Expected',
         '[1 -3 0 0 0 0 0]')),
    'dimensions of diameter': (
        packed(**{'diameter/value': '[0 0 1 0 0 0 0] 5e-4'}),
        ('particleProperties', 'diameter', 'Wrong dimensions', 'value', 'Expected', '[0 1 0 0 0 0 0]')),
    'density zero': (
        {'materials/glass/density': 0},
        ('particleProperties', 'glass', "'density'", 'is 0', 'greater than zero')),
    'density negative': (
        {'materials/glass/density': -2500},
        ('particleProperties', 'glass', "'density'", '-2500', 'greater than zero')),
    'density not a number': (
        {'materials/glass/density': 'heavy'},
        ('particleProperties', 'glass', "'density'", 'heavy', 'Not a number', 'Give')),
    'density NaN': (
        {'materials/glass/density': 'nan'},
        ('particleProperties', 'glass', "'density'", 'nan')),
    'density with a comma': (
        {'materials/glass/density': '2,500'},
        ('particleProperties', 'glass', "'density'", '500')),
    'density twice': (
        {'materials/glass/density': '2500 2600'},
        ('particleProperties', 'glass', "'density'", '2600')),
    'modulus zero': (
        {'materials/glass/youngsModulus': 0},
        ('particleProperties', 'glass', "'youngsModulus'", 'is 0', 'greater than zero')),
    'modulus negative': (
        {'materials/steel/youngsModulus': -5e6},
        ('particleProperties', 'steel', "'youngsModulus'", '-5', 'greater than zero')),
    'diameter zero': (
        packed(**{'diameter/value': 0}),
        ('particleProperties', 'diameter', "'value'", 'is 0', 'greater than zero')),
    'diameter negative': (
        packed(**{'diameter/value': -5e-4}),
        ('particleProperties', 'diameter', "'value'", '-0.0005', 'greater than zero')),
    'diameter range reversed': (
        packed(diameter={'type': 'uniform', 'min': 7e-4, 'max': 3e-4}),
        ('particleProperties', 'diameter', 'max', '0.0003', 'smaller than min', '0.0007')),
    'Poisson ratio too large': (
        {'materials/glass/poissonsRatio': 0.6},
        ('particleProperties', 'glass', "'poissonsRatio'", '0.6', 'between', '0.5')),
    'Poisson ratio below -1': (
        {'materials/glass/poissonsRatio': -1.5},
        ('particleProperties', 'glass', "'poissonsRatio'", '-1.5', 'between')),
    'Poisson ratio below the engine\'s': (
        {'materials/glass/poissonsRatio': -0.3},
        ('particleProperties', 'glass', "'poissonsRatio'", '-0.3')),
    'restitution below the engine\'s': (
        {'contacts/default/restitution': 0.01},
        ('particleProperties', 'default', "'restitution'", '0.01', '0.05')),
    'restitution zero': (
        {'contacts/default/restitution': 0},
        ('particleProperties', 'default', "'restitution'", 'is 0', 'greater than 0.05')),
    'restitution above one': (
        {'contacts/default/restitution': 1.2},
        ('particleProperties', 'default', "'restitution'", '1.2', 'not exceed 1')),
    'friction negative': (
        {'contacts/default/friction': -0.4},
        ('particleProperties', 'default', "'friction'", '-0.4', 'zero or greater')),
    'misspelt at the top': (
        {'overlapTolerence': 0.1},
        ('particleProperties', "'overlapTolerence'", 'Valid entries', 'overlapTolerance')),
    'misspelt in a material': (
        {'materials/glass/thermalConductvity': 1},
        ('particleProperties', 'glass', "'thermalConductvity'", 'Valid entries', 'thermalConductivity')),
    'misspelt in contacts': (
        {'contacts/tangental': 'none'},
        ('particleProperties', 'contacts', "'tangental'", 'Valid entries', 'tangential')),
    'misspelt pair': (
        {'contacts/glas.steel': CONTACT},
        ('particleProperties', 'contacts', 'glas.steel', 'glass', 'steel')),
    'misspelt in a pair': (
        {'contacts/default/rolingFriction': 0.1},
        ('particleProperties', 'default', "'rolingFriction'", 'Valid entries', 'rollingFriction')),
    'misspelt in a wall': (
        {'walls/sides/moton': {'type': 'linear', 'velocity': (0, 0, 1)}},
        ('particleProperties', 'sides', "'moton'", 'Valid entries', 'motion')),
    'misspelt in a motion': (
        {'walls/sides/motion': {'type': 'none', 'velosity': (0, 0, 1)}},
        ('particleProperties', 'motion', "'velosity'", 'Valid entries')),
    'misspelt in an insertion': (
        {'insertion/pair/velocty': (0, 0, 1)},
        ('particleProperties', 'pair', "'velocty'", 'Valid entries', 'velocity')),
    'misspelt in a size distribution': (
        packed(diameter=changed(SIZES, {'weigthing': 'mass'})),
        ('particleProperties', 'diameter', "'weigthing'", 'Valid entries', 'weighting')),
    'misspelt in a region': (
        packed(**{'region/centre': (0, 0, 0)}),
        ('particleProperties', 'region', "'centre'", 'Valid entries', 'min', 'max')),
    'misspelt in timeStep': (
        {'timeStep': {'fracton': 0.05}},
        ('particleProperties', 'timeStep', "'fracton'", 'Valid entries', 'fraction')),
    'region too small for the number': (
        packed(number=10000, maxAttempts=1000),
        ('particleProperties', 'insertion', 'bed', 'No room', 'of 10000', 'number', 'region')),
    'region smaller than a particle': (
        packed(**{'region/max': (4e-3, 4e-3, 4e-4)}),
        ('particleProperties', 'insertion', 'bed', 'No room', 'region')),
    'region outside the mesh': (
        packed(**{'region/min': (1e-2, 0, 0), 'region/max': (2e-2, 4e-3, 4e-3)}),
        ('particleProperties', 'bed', 'outside the mesh', 'Move', 'region')),
    'region upside down': (
        packed(**{'region/min': (0, 0, 4e-3), 'region/max': (4e-3, 4e-3, 0)}),
        ('particleProperties', 'region', 'max', 'not above min')),
    'number and porosity': (
        packed(porosity=0.9), ('particleProperties', 'bed', 'one of number and porosity')),
    'number negative': (
        packed(number=-10), ('particleProperties', 'bed', "'number'", '-10', 'greater than zero')),
    'number too large to count': (
        packed(number=1e12), ('particleProperties', 'bed', "'number'", '1e+12')),
    'rate negative': (
        {'insertion/inlet': changed(RATE, {'numberRate': -1e4})},
        ('particleProperties', 'inlet', "'numberRate'", '-10000', 'zero or greater')),
    'rate into a region outside the mesh': (
        {'insertion/inlet': changed(RATE, {'region/min': (1e-2, 0, 0), 'region/max': (2e-2, 4e-3, 4e-3)})},
        ('particleProperties', 'inlet', 'region', 'mesh spans')),
    'rate into a region partly outside the mesh': (
        {'insertion/inlet': changed(RATE, {'region/min': (3e-3, 0, 0), 'region/max': (6e-3, 4e-3, 4e-3)})},
        ('particleProperties', 'inlet', 'region', 'mesh spans')),
    'rate of number and mass': (
        {'insertion/inlet': changed(RATE, {'massRate': 1e-3})},
        ('particleProperties', 'inlet', 'one of numberRate and massRate')),
    'sub-step above the stability limit': (
        {'timeStep': {'deltaT': 1e-4}},
        ('particleProperties', '0.0001', 'above the stability limit', 'Lower timeStep.deltaT')),
    'sub-step fraction above the stability limit': (
        {'timeStep': {'fraction': 3}},
        ('particleProperties', 'above the stability limit', 'Lower', 'fraction', 'now 3')),
    'sub-step negative': (
        {'timeStep': {'deltaT': -1e-6}},
        ('particleProperties', 'timeStep', "'deltaT'", '-1e-06', 'greater than zero')),
    'time step not a multiple': (
        {'timeStep': {'deltaT': 3e-6}},
        ('0.0001', '3e-06', 'whole number', 'controlDict', 'timeStep.deltaT', 'particleProperties')),
    'time step below the sub-step': (
        {'timeStep': {'deltaT': 1.5e-5}},
        ('0.0001', '1.5e-05', 'whole number', 'controlDict', 'timeStep.deltaT')),
    'periodic against the mesh': (
        {'periodic': ('x',)},
        ('particleProperties', 'Cyclic mismatch', "'periodic'", '(x)', 'blockMeshDict')),
    'periodic axis unknown': (
        {'periodic': ('r',)}, ('particleProperties', "'periodic'", 'r', 'x, y and z')),
    'command unknown': (
        {'commands': (quoted('fx 1 all nonsense'),)},
        ('particleProperties', 'commands', 'fx 1 all nonsense', 'Unknown command')),
    'command with an unknown style': (
        {'commands': (quoted('fix 1 all nonsense'),)},
        ('particleProperties', 'commands', 'fix 1 all nonsense', 'Invalid fix style')),
    'command with illegal arguments': (
        {'commands': (quoted('fix 1 all addforce 1 2'),)},
        ('particleProperties', 'commands', 'fix 1 all addforce 1 2', 'llegal')),
    'command quit': (
        {'commands': (quoted('quit'),)}, ('particleProperties', 'commands', "'quit'", 'remove')),
    'native input missing': (
        {'materials': None, 'contacts': None, 'walls': None, 'insertion': None,
         'input': quoted('constant/in.nothing'), 'timeStep': {'deltaT': 1e-6}},
        ('particleProperties', "'input'", 'in.nothing', 'counts from the case')),
    'library missing': (
        {'library': quoted('libnothing.so')},
        ('particleProperties', "'library'", 'libnothing.so', 'Install', 'etc/bashrc')),
    'library wrong': (
        {'library': quoted('libm.so.6')},
        ('particleProperties', "'library'", 'libm.so.6', 'not the particle engine', 'Allwmake')),
    'STL file missing': (
        {'walls/drum': {'type': 'STL', 'file': quoted('constant/drum.stl'), 'material': 'steel'}},
        ('particleProperties', 'drum', "'file'", 'constant/drum.stl', 'counts from the case')),
    'patches name no patch': (
        {'walls/sides/patches': ('bottom',)},
        ('particleProperties', 'sides', "'patches'", 'bottom', 'no patch', 'zMin')),
    'one of the patches names no patch': (
        {'walls/sides/patches': ('zMax', 'bottom')},
        ('particleProperties', 'sides', "'patches'", 'bottom', 'no patch', 'zMin')),
    'table missing': (
        {'insertion/pair/file': quoted('constant/nothing.csv')},
        ('particleProperties', "'file'", 'nothing.csv', 'counts from the case')),
}

# By subject: changes of the columns of PAIR (None takes one out), words of the message
TABLES = {
    'outside the mesh': (
        {'x': (1e-3, 7e-3)},
        ('particleProperties', 'pair', '1 particles', 'outside the mesh', '0.007', 'Move')),
    'overlapping': (
        {'x': (1e-3, 1.9e-3)},
        ('particleProperties', 'pair', 'Particle 2', 'overlaps with particle 1', 'overlapTolerance',
         '0.05', 'Move')),
    'at the same place': (
        {'x': (1e-3, 1e-3)},
        ('particleProperties', 'pair', 'Particle 2', 'overlaps with particle 1', 'overlapTolerance')),
    'NaN': (
        {'y': (2e-3, 'nan')},
        ('particleProperties', 'particles.csv', 'line 3', 'nan', 'column y', 'Expected')),
    'infinite velocity': (
        {'vx': (0, '1e400')},
        ('particleProperties', 'particles.csv', 'line 3', '1e400', 'column vx', 'Expected')),
    'text for a number': (
        {'z': ('2e-3', '2,e')}, ('particleProperties', 'particles.csv', 'line 3', 'Expected')),
    'diameter zero': (
        {'d': (1e-3, 0)}, ('particleProperties', 'particles.csv', 'line 3', 'diameter 0', 'greater')),
    'diameter negative': (
        {'d': (-1e-3, 1e-3)},
        ('particleProperties', 'particles.csv', 'line 2', 'diameter -0.001', 'greater')),
    'unknown material': (
        {'material': ('glass', 'galss')},
        ('particleProperties', 'particles.csv', 'line 3', 'unknown material galss', 'glass', 'steel')),
    'unknown column': (
        {'diameter': 1e-3},
        ('particleProperties', 'particles.csv', 'line 1', 'unknown column diameter', 'Expected')),
    'without a particle': (
        {'x': (), 'y': (), 'z': (), 'd': ()},
        ('particleProperties', 'No particle in file', 'particles.csv')),
    'no column d': (
        {'d': None}, ('particleProperties', 'particles.csv', 'no column d', 'Expected')),
}

# One of each way to fail: on all ranks, on the first alone, in the engine, in the table
REFUSALS_ON_2_RANKS = (
    'engine unknown', 'wall of unknown material', 'region too small for the number',
    'time step not a multiple', 'command unknown', 'library missing', 'STL file missing',
    'misspelt in a pair', 'region outside the mesh', 'rate into a region partly outside the mesh')
TABLES_ON_2_RANKS = ('outside the mesh', 'overlapping', 'NaN')

# Two ways in which a user's number grows beyond all bounds between 0.0003 and 0.0004 s: a force of
# native commands after 60 sub-steps of 5.9e-6 s, and a shaken frame
OVERFLOWS = {
    'commands': {'commands': (quoted('variable boom equal 1e308*(step>60)*10'),
                              quoted('fix boom all addforce v_boom 0 0'))},
    'frame': {'frameAcceleration': 'table ((0 (0 0 0)) (3.5e-4 (0 0 0)) (4e-4 (1e299 0 0)))'}}


@pytest.fixture(scope='module')
def meshed(tmp_path_factory):
    """The sound case with its mesh, also cut in two."""
    case = Case(tmp_path_factory.mktemp('sound'))
    case.properties = SOUND
    case.particles(PAIR)
    case.mesh()
    case.decompose(2)
    return case


@pytest.fixture
def case(meshed, tmp_path):
    """A copy of the sound case."""
    return meshed.copy(tmp_path / 'case')


def message(case, result):
    """The error message alone, without the case's path, on one line."""
    text = result.output.replace(str(case.path), 'CASE')
    start = text.find('FATAL')
    return ' '.join(text[max(start, 0):].split())


def check_refused(case, result, words, ranks=1):
    """One clear error with these words, and a proper end."""
    output = result.output
    assert result.code != 0, f'accepted:\n{output}'
    assert result.code > 0, f'ended by signal {-result.code}:\n{output}'
    for crash in ('Segmentation', 'terminate called', 'Signal: ', '#0 ', 'Foam::error::printStack',
                  'core dumped', 'MPI_ERR', '*** An error occurred'):
        assert crash not in output, f'crashed:\n{output}'
    errors = len(re.findall('FATAL', output))
    assert errors == 1 if ranks == 1 else errors >= 1, f'{errors} errors:\n{output}'

    text = message(case, result)
    missing = [word for word in words if word not in text]
    assert not missing, f'no {missing} in:\n{text}'


# --- What is refused at the start

def test_sound(case):
    """Nothing is refused in the case that all others change."""
    result = case.run('demFoam')
    assert result.code == 0, result.output
    assert len(case.table(1e-3)) == 2


@pytest.mark.parametrize('subject', REFUSALS)
def test_properties_refused(case, subject):
    changes, words = REFUSALS[subject]
    case.properties = changed(SOUND, changes)
    case.write()
    check_refused(case, case.run('demFoam'), words)
    assert case.times() == []


@pytest.mark.parametrize('subject', REFUSALS_ON_2_RANKS)
def test_properties_refused_2_ranks(case, subject):
    changes, words = REFUSALS[subject]
    case.properties = changed(SOUND, changes)
    case.write()
    check_refused(case, case.run('demFoam', ranks=2), words, ranks=2)


@pytest.mark.parametrize('subject', TABLES)
def test_table_refused(case, subject):
    changes, words = TABLES[subject]
    case.particles(changed(PAIR, changes))
    check_refused(case, case.run('demFoam'), words)
    assert case.times() == []


@pytest.mark.parametrize('subject', TABLES_ON_2_RANKS)
def test_table_refused_2_ranks(case, subject):
    changes, words = TABLES[subject]
    case.particles(changed(PAIR, changes))
    check_refused(case, case.run('demFoam', ranks=2), words, ranks=2)


def test_overlap_within_tolerance_accepted(case):
    """5 % of the smaller radius is the default: 2 % is no error, and is one at a tolerance of 1 %."""
    case.particles(changed(PAIR, {'x': (1e-3, 1.99e-3)}))
    result = case.run('demFoam')
    assert result.code == 0, result.output

    case.properties = changed(SOUND, {'overlapTolerance': 0.01})
    case.control['startFrom'] = 'startTime'
    case.write()
    check_refused(case, case.run('demFoam'), ('overlaps', 'overlapTolerance', '0.01', 'Move'))


def test_overlap_of_two_insertions(case):
    """The second insertion meets a particle of the first, across two ranks' halves."""
    case.particles({'x': [2.1e-3], 'y': 2e-3, 'z': 2e-3, 'd': 5e-4}, 'constant/more.csv')
    case.particles(changed(PAIR, {'x': (1.9e-3, 3e-3)}))
    case.properties = changed(SOUND, {
        'insertion/more': {'type': 'file', 'file': quoted('constant/more.csv'), 'material': 'glass'}})
    case.write()
    words = ('more', 'Particle 3', 'overlaps', 'overlapTolerance', 'Move')
    check_refused(case, case.run('demFoam'), words)
    check_refused(case, case.run('demFoam', ranks=2), words, ranks=2)


def test_properties_missing(case):
    (case.path / 'constant/particleProperties').unlink()
    check_refused(case, case.run('demFoam'), ('cannot find file', 'constant/particleProperties'))
    check_refused(case, case.run('demFoam', ranks=2),
                  ('cannot find file', 'constant/particleProperties'), ranks=2)


def test_gravity_dimensions(case):
    case.write_dict('constant/g', {'dimensions': '[0 1 -1 0 0 0 0]', 'value': (0, 0, -9.81)},
                    'uniformDimensionedVectorField')
    check_refused(case, case.run('demFoam'), ('constant/g', 'imensions', '[0 1 -2 0 0 0 0]'))


def test_time_step_zero(case):
    case.control['deltaT'] = 0
    case.write()
    check_refused(case, case.run('demFoam'), ('deltaT', 'controlDict'))


@pytest.mark.parametrize('text', ['', 'this is no surface\n'], ids=['empty', 'garbage'])
def test_surface_file_unreadable(case, text):
    case.properties = changed(SOUND, {
        'walls/drum': {'type': 'STL', 'file': quoted('constant/drum.stl'), 'material': 'steel'}})
    case.write()
    case.write_file('constant/drum.stl', text)
    check_refused(case, case.run('demFoam'), ('drum', 'constant/drum.stl'))


@pytest.mark.parametrize('ranks', [1, 2])
def test_empty_start_accepted(case, ranks):
    """A domain without particles at the start, which fills at a rate, is no error."""
    case.properties = changed(SOUND, {'insertion': {'inlet': RATE}})
    case.write()
    result = case.run('demFoam', ranks=ranks)
    assert result.code == 0, result.output
    assert steps(result.output)['particles'][-1] == 100


# --- Cyclic meshes

def test_cyclic_mismatch_of_cyclic_mesh(tmp_path):
    """The mesh is cyclic along x, the entry says y."""
    case = Case(tmp_path / 'case', cyclic='x')
    case.properties = changed(SOUND, {'periodic': ('y',),
                                      'walls/sides/patches': ('yMin', 'yMax', 'zMin', 'zMax')})
    case.particles(PAIR)
    case.mesh()
    check_refused(case, case.run('demFoam'),
                  ('particleProperties', 'Cyclic mismatch', "'periodic'", '(y)', 'cyclic along',
                   'blockMeshDict'))


BLOCK_MESH = """
FoamFile {{ version 2.0; format ascii; class dictionary; object blockMeshDict; }}
scale 1e-3;
vertices ({vertices});
blocks ({blocks});
boundary
(
    left {{ type cyclic; neighbourPatch right; {transform} faces ({left}); }}
    right {{ type cyclic; neighbourPatch left; {transform} faces ({right}); }}
);
defaultPatch {{ name others; type wall; }}
"""


@pytest.mark.parametrize('shape, mesh, words', [
    # Two blocks side by side, the second half as high: the cyclic pair lies inside the bounding box
    ('step', {
        'vertices': '(0 0 0)(2 0 0)(2 2 0)(0 2 0)(0 0 4)(2 0 4)(2 2 4)(0 2 4)'
                    '(4 0 0)(4 2 0)(4 0 4)(4 2 4)(2 4 0)(0 4 0)(2 4 4)(0 4 4)',
        'blocks': 'hex (0 1 2 3 4 5 6 7) (2 2 4) simpleGrading (1 1 1)'
                  'hex (1 8 9 2 5 10 11 6) (2 2 4) simpleGrading (1 1 1)'
                  'hex (3 2 12 13 7 6 14 15) (2 2 4) simpleGrading (1 1 1)',
        'transform': '', 'left': '(1 8 10 5)', 'right': '(2 6 11 9)'},
     ('left', '0.002', '0.004', 'opposite')),
    # A quarter turn about the edge of the box
    ('rotation', {
        'vertices': '(0 0 0)(4 0 0)(4 4 0)(0 4 0)(0 0 4)(4 0 4)(4 4 4)(0 4 4)',
        'blocks': 'hex (0 1 2 3 4 5 6 7) (4 4 4) simpleGrading (1 1 1)',
        'transform': 'transform rotational; rotationAxis (0 0 1); rotationCentre (0 0 0);',
        'left': '(0 4 7 3)', 'right': '(0 1 5 4)'},
     ('left', 'opposite')),
    # Opposite sides, but only half of each
    ('part', {
        'vertices': '(0 0 0)(4 0 0)(4 2 0)(0 2 0)(0 0 4)(4 0 4)(4 2 4)(0 2 4)'
                    '(4 4 0)(0 4 0)(4 4 4)(0 4 4)',
        'blocks': 'hex (0 1 2 3 4 5 6 7) (4 2 4) simpleGrading (1 1 1)'
                  'hex (3 2 8 9 7 6 10 11) (4 2 4) simpleGrading (1 1 1)',
        'transform': '', 'left': '(0 4 7 3)', 'right': '(1 2 6 5)'},
     ('left', 'opposite')),
], ids=['step', 'rotation', 'part'])
def test_cyclic_not_between_opposite_faces(tmp_path, shape, mesh, words):
    case = Case(tmp_path / 'case')
    case.properties = changed(SOUND, {'walls/sides/patches': ('others',)})
    case.particles(changed(PAIR, {'x': (0.6e-3, 1.8e-3), 'y': 1.2e-3}))
    case.write()
    case.write_file('system/blockMeshDict', BLOCK_MESH.format(**mesh))
    made = case.run('blockMesh')
    assert made.code == 0, made.output
    check_refused(case, case.run('demFoam'), ('particleProperties', 'yclic', 'alls', *words))


# --- What goes wrong on the way

@pytest.mark.parametrize('ranks', [1, 2])
@pytest.mark.parametrize('overflow', OVERFLOWS)
def test_not_finite_in_the_engine(case, overflow, ranks):
    """The error names time, particle and position; the times written before it stay as they are."""
    case.properties = changed(SOUND, OVERFLOWS[overflow])
    case.control.update(writeInterval=1, endTime=3e-4)
    case.write()
    result = case.run('demFoam', ranks=ranks)
    assert result.code == 0, result.output
    before = case.digests()

    case.control.update(endTime=1e-3)
    case.write()
    result = case.run('demFoam', ranks=ranks)
    check_refused(case, result, ('Particle ', 'not finite', 'time 0.000', 'position', 'Look for'),
                  ranks)
    text = message(case, result)
    assert re.search(r'Particle [12]\b', text), text
    assert re.search(r'\(0\.00[13]\d* 0\.00[12]', text), f'no position in metres in:\n{text}'

    after = case.digests()
    assert {name: after.get(name) for name in before} == before
    assert case.times()[-1] in ('0.0003', '0.0004')
    assert len(case.table(3e-4)) == 2


@pytest.mark.parametrize('ranks', [1, 2])
@pytest.mark.parametrize('speed', [1e5, 1e200, 1e308])
def test_absurd_velocity(case, speed, ranks):
    """A particle too fast to be followed ends the run, or is counted among those that left."""
    case.particles({**PAIR, 'vx': (speed, 0)})
    result = case.run('demFoam', ranks=ranks)
    if result.code:
        check_refused(case, result, ('article', 'time'), ranks)
    else:
        assert 'left the domain: 1 particles' in result.output, result.output
        assert steps(result.output)['particles'][-1] == 1
        assert 'nan' not in result.output, result.output


@pytest.mark.parametrize('ranks', [1, 2])
@pytest.mark.parametrize('speed', [10, 500, 2000, 1e6, 1e200])
def test_fast_in_a_cyclic_box(tmp_path, speed, ranks):
    """A particle that crosses the cyclic box once or many times in a sub-step is kept, or is an
    error; it is not lost in silence. At 500 m/s it crosses three quarters of the box in one."""
    case = Case(tmp_path / 'case', cyclic='x')
    case.properties = changed(SOUND, {'walls/sides/patches': ('yMin', 'yMax', 'zMin', 'zMax')})
    case.particles({**PAIR, 'y': (1e-3, 3e-3), 'vx': (speed, 0)})
    case.mesh()
    case.decompose(2)
    result = case.run('demFoam', ranks=ranks)
    if result.code:
        check_refused(case, result, ('article', 'time'), ranks)
    else:
        assert set(steps(result.output)['particles']) == {2}, result.output
        x = case.table(1e-3)['x']
        assert (x >= 0).all() and (x <= 4e-3).all(), x


# --- Restarts

@pytest.fixture(scope='module')
def stopped(meshed, tmp_path_factory):
    """The sound case with restarts at 0.0001 and 0.0002, also on two ranks, to go on to 0.0004."""
    case = meshed.copy(tmp_path_factory.mktemp('stopped') / 'case')
    case.control.update(endTime=2e-4, writeInterval=1)
    case.write()
    for ranks in (1, 2):
        result = case.run('demFoam', ranks=ranks)
        assert result.code == 0, result.output
    case.control.update(endTime=4e-4)
    case.write()
    return case


def damage(path, kind):
    """Bytes changed, a part cut off, nothing left, or the file deleted."""
    data = path.read_bytes()
    middle = len(data)//2
    if kind == 'deleted':
        path.unlink()
    else:
        path.write_bytes({'changed': data[:middle] + bytes(b ^ 255 for b in data[middle:middle + 8])
                          + data[middle + 8:],
                          'half': data[:middle], 'quarter': data[:middle//2],
                          'end': data[:-20], 'empty': b''}[kind])


@pytest.mark.parametrize('ranks', [1, 2])
@pytest.mark.parametrize('name, kind', [
    ('liggghts.restart', 'changed'), ('liggghts.restart', 'half'), ('liggghts.restart', 'empty'),
    ('liggghts.restart', 'deleted'),
    ('engine', 'half'), ('engine', 'quarter'), ('engine', 'end'), ('engine', 'empty'),
    ('engine', 'deleted')])
def test_damaged_restart(stopped, tmp_path, name, kind, ranks):
    """The file is named, no other time is touched, and the run can go on from the time before."""
    case = stopped.copy(tmp_path / 'case')
    folder = '.' if ranks == 1 else 'processor0'
    damage(case.path / folder / '0.0002/uniform/particles' / name, kind)
    before = case.digests()

    result = case.run('demFoam', ranks=ranks)
    assert case.digests() == before
    check_refused(case, result, ('0.0002/uniform/particles/' + name, 'earlier time'), ranks)

    case.control.update(startFrom='startTime', startTime=1e-4)
    case.write()
    result = case.run('demFoam', ranks=ranks)
    assert result.code == 0, result.output
    assert len(case.table(4e-4)) == 2


def test_sound_restart(stopped, tmp_path):
    """The restart that the tests damage is sound, and going on leaves the earlier times alone."""
    case = stopped.copy(tmp_path / 'case')
    before = case.digests()
    result = case.run('demFoam')
    assert result.code == 0, result.output
    assert 'continued from the restart of time 0.0002' in result.output
    after = case.digests()
    assert {name: after.get(name) for name in before} == before


def test_restart_of_another_engine(stopped, tmp_path):
    case = stopped.copy(tmp_path / 'case')
    case.properties = changed(SOUND, {'engine': 'prescribed', 'contacts': None, 'walls': None})
    case.write()
    before = case.digests()
    result = case.run('demFoam')
    check_refused(case, result, ('0.0002/uniform/particles/engine', 'liggghts', 'prescribed'))
    assert case.digests() == before


def test_restart_with_another_sub_step(stopped, tmp_path):
    """The sub-step is kept in the restart: another one in timeStep is not ignored in silence."""
    case = stopped.copy(tmp_path / 'case')
    case.properties = changed(SOUND, {'timeStep': {'deltaT': 2e-6}})
    case.write()
    result = case.run('demFoam')
    if result.code:
        check_refused(case, result, ('timeStep', '2e-06'))
    else:
        used = steps(result.output)['subSteps']
        assert (used == 50).all() or 'timeStep' in result.output, result.output


def test_restart_with_another_material(stopped, tmp_path):
    """A material more than the restart knows is named, not a crash."""
    case = stopped.copy(tmp_path / 'case')
    case.properties = changed(SOUND, {'materials/dust': SOUND['materials']['glass']})
    case.write()
    before = case.digests()
    result = case.run('demFoam')
    check_refused(case, result, ('material', 'restart', '2', '3'))
    assert case.digests() == before


# --- Particles that leave

@pytest.mark.parametrize('ranks', [1, 2])
@pytest.mark.parametrize('speed', [3, 1000, 2e4])
def test_departed_particles_are_counted(case, speed, ranks):
    """Out through the open side, also many box lengths in a sub-step: with the right mass."""
    case.properties = changed(SOUND, {'walls/sides/patches': ('xMin', 'yMin', 'yMax', 'zMin', 'zMax')})
    case.particles({**PAIR, 'y': (1e-3, 3e-3), 'vx': (speed, 0)})
    case.control.update(endTime=3e-3)
    case.write()
    result = case.run('demFoam', ranks=ranks)
    assert result.code == 0, result.output

    left = re.findall(r'left the domain: (\d+) particles, (\S+) kg; in all (\d+)', result.output)
    assert len(left) == 1, result.output
    count, mass, total = left[0]
    assert (count, total) == ('1', '1')
    assert float(mass) == pytest.approx(2500*math.pi/6*1e-9, rel=1e-9)

    particles = steps(result.output)['particles']
    assert particles[-1] == 1 and set(particles) <= {1, 2}
    assert list(case.table(3e-3)['id']) == [2]


@pytest.mark.parametrize('ranks', [1, 2])
def test_departed_total_survives_a_restart(case, ranks):
    """The count since the start goes on in a continued run."""
    case.properties = changed(SOUND, {'walls/sides/patches': ('yMin', 'yMax', 'zMin', 'zMax')})
    case.particles({**PAIR, 'vx': (-5, 1)})
    case.control.update(endTime=1e-3)
    case.write()
    first = case.run('demFoam', ranks=ranks)
    assert 'in all 1' in first.output, first.output

    case.control.update(endTime=3e-3)
    case.write()
    second = case.run('demFoam', ranks=ranks)
    assert second.code == 0, second.output
    assert 'left the domain: 1 particles' in second.output, second.output
    assert 'in all 2' in second.output, second.output
    assert steps(second.output)['particles'][-1] == 0


@pytest.mark.parametrize('ranks', [1, 2])
def test_restart_without_particles(case, ranks):
    """A run goes on after the last particle has left."""
    case.properties = changed(SOUND, {'walls/sides/patches': ('yMin', 'yMax', 'zMin', 'zMax')})
    case.particles({**PAIR, 'vx': (-10, 10)})
    case.write()
    first = case.run('demFoam', ranks=ranks)
    assert first.code == 0, first.output
    assert steps(first.output)['particles'][-1] == 0

    case.control.update(endTime=2e-3)
    case.write()
    second = case.run('demFoam', ranks=ranks)
    assert second.code == 0, second.output
    assert len(steps(second.output)) == 10
