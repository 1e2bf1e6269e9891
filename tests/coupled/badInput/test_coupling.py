"""Input of cfdDemFoam that cannot be meant ends with one error, as in test_badInput.py: file, entry, value and remedy;
no time is written and finished ones stay as they are; two ranks do not hang. What is no error is told: volume that
alphacMin refuses, particles that leave. A dry run writes nothing.
"""
import re
import struct

import numpy as np
import pytest

from dewCase import changed, quoted
from fluidCase import FluidCase

SIDES = ('xMin', 'xMax', 'yMin', 'yMax', 'zMin', 'zMax')
GLASS = {'youngsModulus': 5e6, 'poissonsRatio': 0.3, 'density': 2500.0}
THERMAL = {'heat': True, 'materials/glass/thermalConductivity': 1.0, 'materials/glass/heatCapacity': 700.0}
HEAT = {'coupling/heatTransfer': {'type': 'RanzMarshall'}}
FLUID_HEAT = {'Cp': 1000, 'kappa': 0.026}

SOUND = {
    'engine': 'liggghts', 'materials': {'glass': GLASS},
    'contacts': {'default': {'restitution': 0.8, 'friction': 0.4}},
    'walls': {'sides': {'type': 'patch', 'patches': SIDES, 'material': 'glass'}},
    'insertion': {'pair': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'glass'}},
    'output': ('csv',),
    'coupling': FluidCase.coupling('Gidaspow')}

# By subject: changes of SOUND, of transportProperties and of the fields, words of the message
REFUSALS = {
    'void fraction model unknown': (
        {'coupling/voidFraction/type': 'devided'}, {}, {},
        ('particleProperties', 'voidFraction', 'devided', 'divided', 'particleCentre', 'none')),
    'drag law unknown': (
        {'coupling/forces/drag/type': 'Gidapsow'}, {}, {},
        ('particleProperties', 'drag', 'Gidapsow', 'Gidaspow', 'DiFelice', 'Stokes')),
    'heat law unknown': (
        {**THERMAL, 'coupling/heatTransfer': {'type': 'Ranz'}}, FLUID_HEAT, {'T': '300'},
        ('particleProperties', 'heatTransfer', 'Ranz', 'RanzMarshall', 'LiMason')),
    'model unknown': (
        {'coupling/model': 'C'}, {}, {}, ('particleProperties', 'coupling', 'C', '(A B)')),
    'two drag laws': (
        {'coupling/forces/second': {'type': 'WenYu'}}, {}, {},
        ('particleProperties', 'second drag law WenYu', 'Gidaspow', 'forces', 'Remove')),
    'a law twice': (
        {'coupling/forces/again': {'type': 'pressureGradientForce'}}, {}, {},
        ('particleProperties', 'second law pressureGradientForce', 'again', 'Remove')),
    'a law without effect in model B': (
        {'coupling/model': 'B', 'coupling/forces/pressure/buoyancy': False}, {}, {},
        ('particleProperties', 'pressureGradientForce', 'does nothing in model B', 'Remove', 'buoyancy on', 'model A')),
    'StokesCunningham without a mean free path': (
        {'coupling/forces/drag/type': 'StokesCunningham'}, {}, {},
        ('particleProperties', 'drag', "'meanFreePath'")),
    'a second fluid': (
        {'fluid': {'viscosity': 1e-3, 'density': 1000}}, {}, {},
        ('particleProperties', "'fluid'", 'demFoam', 'Remove')),
    'momentum scheme unknown': (
        {'coupling/momentum': 'implicit'}, {}, {},
        ('particleProperties', 'coupling', 'implicit', 'semiImplicit', 'explicit', 'none')),
    'heat scheme unknown': (
        {**THERMAL, **HEAT, 'coupling/heat': 'explicit'}, FLUID_HEAT, {'T': '300'},
        ('particleProperties', 'coupling', 'explicit', 'semiImplicit', 'none')),
    'interpolation unknown': (
        {'coupling/interpolation': 'cubic'}, {}, {},
        ('particleProperties', 'coupling', 'cubic', 'linear', 'cell')),
    'fluid at rest that feels particles': (
        {'coupling/carrierVelocity': False}, {}, {},
        ('particleProperties', 'carrierVelocity', 'momentum none')),
    'misspelt in coupling': (
        {'coupling/alphaMin': 0.3}, {}, {},
        ('particleProperties', 'coupling', "'alphaMin'", 'Valid entries', 'alphacMin')),
    'misspelt in voidFraction': (
        {'coupling/voidFraction/typ': 'divided'}, {}, {},
        ('particleProperties', 'voidFraction', "'typ'", 'Valid entries', 'type')),
    'divided into no parts': (
        {'coupling/voidFraction/points': 0}, {}, {}, ('particleProperties', 'voidFraction', "'points'", '0')),
    'Gaussian without a width': (
        {'coupling/voidFraction': {'type': 'Gaussian'}}, {}, {},
        ('particleProperties', 'voidFraction', "'width'", "'diameters'")),
    # 4 x 2 mm in a mesh of 4 mm
    'Gaussian wider than the mesh': (
        {'coupling/voidFraction': {'type': 'Gaussian', 'width': 2e-3}}, {}, {},
        ('particleProperties', 'voidFraction', "'width' 0.002", '0.008 m', 'below 0.001', 'larger mesh')),
    'bigParticle smaller than itself': (
        {'coupling/voidFraction': {'type': 'bigParticle', 'scale': 0.5}}, {}, {},
        ('particleProperties', 'voidFraction', "'scale'", '0.5')),
    'bigParticle wider than the mesh': (
        {'coupling/voidFraction': {'type': 'bigParticle', 'scale': 20}}, {}, {},
        ('particleProperties', 'voidFraction', "'scale' 20", '0.0065 m', 'smaller')),
    'misspelt in a law': (
        {'coupling/forces/pressure/bouyancy': True}, {}, {},
        ('particleProperties', 'pressure', "'bouyancy'", 'Valid entries', 'buoyancy')),
    'law not a dictionary': (
        {'coupling/forces/drag': 'Gidaspow'}, {}, {}, ('particleProperties', 'forces', 'drag')),
    'coupling missing': (
        {'coupling': None}, {}, {}, ('particleProperties', "'coupling'")),
    'voidFraction missing': (
        {'coupling/voidFraction': None}, {}, {}, ('particleProperties', 'coupling', "'voidFraction'")),
    'forces missing': (
        {'coupling/forces': None}, {}, {}, ('particleProperties', 'coupling', "'forces'")),
    'alphacMin zero': (
        {'coupling/alphacMin': 0}, {}, {}, ('particleProperties', 'coupling', "'alphacMin'", 'is 0')),
    'alphacMin above one': (
        {'coupling/alphacMin': 1.5}, {}, {}, ('particleProperties', 'coupling', "'alphacMin'", '1.5')),
    'rho missing': (
        {}, {'rho': None}, {}, ('transportProperties', "'rho'", 'Add')),
    'rho negative': (
        {}, {'rho': -1.2}, {}, ('transportProperties', "'rho'", '-1.2', 'greater than zero')),
    'heatTransfer without heat': (
        HEAT, FLUID_HEAT, {'T': '300'},
        ('particleProperties', "'heatTransfer'", 'heat on', 'remove')),
    'heat without heatTransfer': (
        {'coupling/heat': 'none'}, {}, {}, ('particleProperties', "'heat'", "'heatTransfer'", 'remove')),
    'heatTransfer without T': (
        {**THERMAL, **HEAT}, FLUID_HEAT, {},
        ('particleProperties', "'heatTransfer'", 'field T', 'Cp', 'kappa')),
    'Cp missing': (
        {**THERMAL, **HEAT}, {'kappa': 0.026}, {'T': '300'}, ('transportProperties', "'Cp'", 'Add')),
    'kappa missing': (
        {**THERMAL, **HEAT}, {'Cp': 1000}, {'T': '300'}, ('transportProperties', "'kappa'", 'Add')),
    'explicit above its limit': (
        {'coupling/momentum': 'explicit', 'coupling/forces/drag/type': 'Stokes',
         'materials/glass/density': 2500.0}, {'nu': '[0 2 -1 0 0 0 0] 1'}, {},
        ('time step 0.0001', 'explicit', 'cell', 'deltaT', 'controlDict', 'semiImplicit', 'particleProperties')),
}
ON_2_RANKS = ('void fraction model unknown', 'two drag laws', 'misspelt in coupling', 'rho missing', 'heatTransfer without T',
              'explicit above its limit')


def fluid(path, **keywords):
    case = FluidCase(path, rho=1.2, nu=1.5e-5, upper=(4e-3,)*3, cells=(4, 4, 4), deltaT=1e-4,
                     **{'endTime': 5e-4, 'writeInterval': 5, **keywords})
    case.properties = changed(SOUND, {})
    case.particles({'x': (1.3e-3, 2.7e-3), 'y': 1.6e-3, 'z': 2.4e-3, 'd': 6e-4})
    return case


def message(output):
    start = output.find('FATAL')
    return ' '.join(output[max(start, 0):].split())


def check_refused(result, words, ranks=1):
    """One clear error with these words, and a proper end."""
    output = result.output
    assert result.code > 0, f'code {result.code}:\n{output}'
    for crash in ('Segmentation', 'terminate called', 'Signal: ', '#0 ', 'core dumped', 'MPI_ERR'):
        assert crash not in output, f'crashed:\n{output}'
    errors = len(re.findall('FATAL', output))
    assert errors == 1 if ranks == 1 else errors >= 1, f'{errors} errors:\n{output}'
    missing = [word for word in words if word not in message(output)]
    assert not missing, f'no {missing} in:\n{message(output)}'


@pytest.fixture(scope='module')
def meshed(tmp_path_factory):
    case = fluid(tmp_path_factory.mktemp('sound'))
    case.mesh()
    case.decompose(2)
    return case


@pytest.fixture
def case(meshed, tmp_path):
    return meshed.copy(tmp_path / 'case')


def apply(case, subject):
    properties, transport, fields, words = REFUSALS[subject]
    case.properties = changed(SOUND, properties)
    case.transport = changed(case.transport, transport)
    case.fields.update(fields)
    case.write()
    return words


@pytest.mark.parametrize('subject', REFUSALS)
def test_coupling_refused(case, subject):
    words = apply(case, subject)
    check_refused(case.run('cfdDemFoam'), words)
    assert case.times() == []


@pytest.mark.parametrize('subject', ON_2_RANKS)
def test_coupling_refused_2_ranks(case, subject):
    words = apply(case, subject)
    check_refused(case.run('cfdDemFoam', ranks=2), words, ranks=2)
    assert case.times('processor0') == []


@pytest.mark.parametrize('ranks', [1, 2])
def test_particle_too_large_for_its_cell(case, ranks):
    """1.2 mm in cells of 1 mm: pi/6 1.2^3 = 0.9048 of one cell, all of it with particleCentre; divided takes it."""
    case.particles({'x': (1.5e-3,), 'y': 1.5e-3, 'z': 1.5e-3, 'd': 1.2e-3})
    case.properties['coupling']['voidFraction']['type'] = 'particleCentre'
    case.write()
    check_refused(case.run('cfdDemFoam', ranks=ranks),
                  ('particleProperties', 'coupling', 'particleCentre', '0.9047', 'cell', '(0.0015 0.0015 0.0015)',
                   'alphacMin', 'coarser mesh', 'divided'), ranks)
    case.properties['coupling']['voidFraction']['type'] = 'divided'
    case.write()
    done = case.run('cfdDemFoam', ranks=ranks)
    assert done.code == 0, done.output


# --- Values that are not finite

def binary_velocity(case, bad_cell, value):
    """0/U in binary with a value in one cell."""
    case.write()
    text = (case.path / '0/U').read_text().replace('format ascii', 'format binary')
    U = np.zeros((64, 3))
    U[bad_cell] = value
    head, tail = re.split(r'internalField uniform [^;]*;', text)
    (case.path / '0/U').write_bytes(head.encode() + b'internalField nonuniform List<vector> 64\n('
                                    + struct.pack('<192d', *U.ravel()) + b');' + tail.encode())


@pytest.mark.parametrize('ranks', [1, 2])
def test_nan_in_the_start_field(case, ranks):
    """NaN in U of cell 21 = (1, 1, 1), at (1.5 1.5 1.5) mm."""
    binary_velocity(case, 21, (0, float('nan'), 0))
    if ranks > 1:
        # decomposePar stumbles over it: FOAM_SIGFPE off
        done = case.run('env', 'FOAM_SIGFPE=false', 'decomposePar', '-force')
        assert done.code == 0, done.output
    check_refused(case.run('cfdDemFoam', ranks=ranks),
                  ('Field U', 'not finite', 'cell', '(0.0015 0.0015 0.0015)', 'time 0', 'nan', 'time step',
                   'boundary'), ranks)
    assert case.times() == []


def test_fluid_that_overflows(case):
    """A wall that moves at 1e200 m/s from 0.25 ms on: the time written before stays as it is."""
    case.patches = {'U': {'zMax': {'type': 'uniformFixedValue', 'uniformValue':
                                   'table ((0 (0 0 0)) (2.5e-4 (0 0 0)) (2.6e-4 (1e200 0 0)) (1 (1e200 0 0)))'}}}
    case.control.update(writeInterval=2)
    case.write()
    done = case.run('cfdDemFoam')
    assert done.code > 0, f'code {done.code}:\n{done.output}'
    assert case.times() == ['0.0002']
    assert 'not finite' in message(done.output), message(done.output)


# --- What is told

def test_clipped_volume_is_in_the_ledger(case):
    """8 spheres of 0.48 mm fill 0.463 of one cell, alphacMin 0.7 takes 0.3 of it: the rest is in the column clipped,
    held - represented, to 1e-12, and the log has the cell."""
    x = 1e-3 + 1e-3 * (np.array(list(np.ndindex(2, 2, 2))) + 0.5) / 2
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': 4.8e-4})
    case.properties = changed(SOUND, {'coupling/alphacMin': 0.7, 'coupling/forces/drag/type': 'Stokes'})
    case.gravity = (0, 0, 0)
    case.write()
    done = case.run('cfdDemFoam')
    assert done.code == 0, done.output
    rows = case.ledger()
    held = 8 * np.pi / 6 * 4.8e-4**3
    assert np.abs(rows['held'] / held - 1).max() < 1e-13
    assert np.abs(rows['represented'] / 3e-10 - 1).max() < 1e-12
    assert np.abs((rows['held'] - rows['represented'] - rows['clipped']) / held).max() < 1e-12
    found = re.search(r'clipped by alphacMin: (\S+) m3 of particles \((\S+) of all\); most in cell (\d+) at \((.*?)\),'
                      r' alphac (\S+)', done.output)
    assert found, done.output
    assert int(found[3]) == 21 and found[4] == '0.0015 0.0015 0.0015'
    assert abs(float(found[1]) - (held - 3e-10)) < 1e-3 * held
    assert abs(float(found[5]) - (1 - held / 1e-9)) < 1e-3


@pytest.mark.parametrize('ranks', [1, 2])
def test_particles_that_leave_are_counted(case, ranks):
    """Two at 5 m/s towards an open side 1.3 and 2.7 mm away: one is outside after 3 steps of 0.1 ms, both after 6. The
    engine forgets them when it next sorts, within a step; until then they are told to be outside the mesh."""
    case.particles({'x': (1.3e-3, 2.7e-3), 'y': 1.6e-3, 'z': 2.4e-3, 'd': 6e-4, 'vx': 5})
    case.patches = {'U': {s: {'type': 'zeroGradient'} for s in ('xMin', 'xMax')},
                    'p': {s: {'type': 'fixedValue', 'value': 'uniform 0'} for s in ('xMin', 'xMax')}}
    case.properties = changed(SOUND, {'walls/sides/patches': SIDES[2:]})
    case.control.update(endTime=8e-4, writeInterval=8)
    case.write()
    if ranks > 1:
        case.decompose(ranks)
    done = case.run('cfdDemFoam', ranks=ranks)
    assert done.code == 0, done.output
    n = [int(v) for v in re.findall(r'  particles (\d+)  ', done.output)]
    rows = case.ledger()
    assert np.array_equal(n - rows['outside'], [2, 2, 1, 1, 1, 0, 0, 0])
    assert n == [2, 2, 2, 1, 1, 1, 0, 0]
    assert len(re.findall(r'outside the mesh, without fluid: 1 particles', done.output)) == 2
    assert re.findall(r'left the domain: (\d+) particles, \S+ kg; in all (\d+)', done.output) == [('1', '1'), ('1', '2')]
    volume = np.pi / 6 * 6e-4**3
    assert np.abs(rows['represented'] - volume * np.array([2, 2, 1, 1, 1, 0, 0, 0])).max() < 1e-12 * volume
    assert np.abs(rows['held'] - volume * np.array(n)).max() < 1e-12 * volume


@pytest.mark.parametrize('model, pressure, told', [
    ('A', True, None), ('B', False, None),
    ('A', False, 'model A without pressureGradientForce'),
    ('B', True, 'model B with pressureGradientForce')])
def test_who_carries_the_pressure_gradient(case, model, pressure, told):
    """What could be meant runs, with a warning."""
    case.properties['coupling'] = case.coupling('Gidaspow', pressure=pressure, model=model)
    case.control.update(endTime=1e-4)
    case.write()
    done = case.run('cfdDemFoam')
    assert done.code == 0, done.output
    warnings = [line for line in done.output.splitlines() if 'pressureGradientForce' in line]
    assert len(warnings) == (told is not None) and all('WARNING: ' + told in line for line in warnings), warnings


# --- Restart and dry run

@pytest.mark.parametrize('ranks', [1, 2])
@pytest.mark.parametrize('damage', ['cut', 'changed', 'missing'])
def test_damaged_exchange_restart(case, damage, ranks):
    case.control.update(endTime=2e-4, writeInterval=2)
    case.write()
    done = case.run('cfdDemFoam', ranks=ranks)
    assert done.code == 0, done.output
    path = case.path / ('.' if ranks == 1 else 'processor0') / '0.0002/uniform/particles/exchange'
    raw = bytearray(path.read_bytes())
    if damage == 'cut':
        raw = raw[:-20]
    else:
        raw[50] ^= 1
    path.write_bytes(raw)
    if damage == 'missing':
        path.unlink()
    before = case.digests()
    case.control.update(endTime=4e-4)
    case.write()
    check_refused(case.run('cfdDemFoam', ranks=ranks), ('uniform/particles/exchange',), ranks)
    after = case.digests()
    assert {k: after.get(k) for k in before if not k.startswith('0/')} == \
        {k: v for k, v in before.items() if not k.startswith('0/')}
    assert case.times('.' if ranks == 1 else 'processor0') == ['0.0002']


@pytest.mark.parametrize('ranks', [1, 2])
def test_dry_run_checks_and_writes_nothing(case, ranks):
    """The table has the limits of the case: Courant 0.2 m/s 1e-4 s/1 mm = 0.02, 0.6 of a cell's width, 0.113 of a cell
    (pi/6 0.6^3)."""
    case.fields['U'] = '(0 0.2 0)'
    case.patches['U'] = {s: {'type': 'slip'} for s in SIDES}
    case.properties['coupling']['voidFraction']['type'] = 'particleCentre'
    case.write()
    case.decompose(2)
    before = case.digests()
    done = case.run('cfdDemFoam', '-dry-run', ranks=ranks)
    assert done.code == 0, done.output
    for text in ('Check of the set-up', 'sub-step over stability limit', 'time step over relaxation time',
                 'End of the dry run'):
        assert text in done.output, done.output
    assert re.search(r'particle diameter over cell width +0\.6 +WARNING', done.output), done.output
    assert re.search(r'share of a cell one particle fills +0\.113 +ok', done.output), done.output
    assert re.search(r'Courant number +0\.02 +ok', done.output), done.output
    assert case.digests() == before
    assert case.times() == [] and case.times('processor0') == []
