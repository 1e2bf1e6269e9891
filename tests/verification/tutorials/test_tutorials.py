"""Every tutorial runs in a fresh copy from its Allrun, and its validate is content; a wrong dictionary is noticed."""
import shutil

import pytest

from dewCase import ROOT, run_command

TUTORIALS = ROOT / 'tutorials'


def left(folder, names):
    """What earlier runs have left"""
    patterns = ['R[0-9]*', '[0-9]*', '*.png', '__pycache__', 'runs', 'run']
    if folder.endswith('Bed'):
        patterns += ['VTK', 'dem', 'postProcessing', 'log.*', 'frames', '*.gif']
    if folder.endswith('damBreakWithParticles'):
        patterns += ['frames', '*.gif']
    if folder.endswith('Bed/constant'):
        patterns += ['polyMesh']
    if folder.endswith('ErgunBed'):
        patterns += ['Ergun', 'DiFelice', 'WenYu']
    if folder.endswith('settlingSphere'):
        patterns += ['oneWay', 'twoWay', 'corrected']
    return shutil.ignore_patterns(*patterns)(folder, names) - {'0.orig'}


def fresh(path, name):
    shutil.copytree(TUTORIALS / name, path, ignore=left)
    return path


@pytest.mark.parametrize('name', ['demFoam/collisions', 'demFoam/brownianDiffusion', 'demFoam/dlvoPair',
                                  'demFoam/colloidAtSurface',
                                  pytest.param('demFoam/dryingFilm2D', marks=pytest.mark.slow),
                                  pytest.param('demFoam/dissipativeParticles', marks=pytest.mark.slow),
                                  pytest.param('demFoam/sedimentationEquilibrium', marks=pytest.mark.slow),
                                  pytest.param('demFoam/stabilityRatio', marks=pytest.mark.slow),
                                  pytest.param('demFoam/fractalAggregation', marks=pytest.mark.slow),
                                  pytest.param('demFoam/packing', marks=pytest.mark.slow),
                                  pytest.param('cfdDemFoam/ErgunBed', marks=pytest.mark.slow),
                                  pytest.param('cfdDemFoam/Goldschmidt', marks=pytest.mark.slow),
                                  pytest.param('cfdDemFoam/liquidFluidisedBed', marks=pytest.mark.slow),
                                  pytest.param('cfdDemFoam/spoutedBed', marks=pytest.mark.slow),
                                  'cfdDemFoam/settlingSphere', 'cfdDemFoam/hotSphere', 'cfdDemFoam/voidFraction',
                                  'cfdDemFoam/sphereInWater',
                                  'cfdDemFoam/packedBedHeat', 'cfdDemFoam/hinderedSettling',
                                  'interDemFoam/particlesThroughSurface',
                                  pytest.param('interDemFoam/floatingSpheres', marks=pytest.mark.slow),
                                  pytest.param('interDemFoam/damBreakWithParticles', marks=pytest.mark.slow),
                                  pytest.param('interDemFoam/staticDroplet', marks=pytest.mark.slow),
                                  pytest.param('interDemFoam/capillaryWave', marks=pytest.mark.slow),
                                  pytest.param('interDemFoam/capillaryRise', marks=pytest.mark.slow),
                                  pytest.param('interDemFoam/sessileShape', marks=pytest.mark.slow),
                                  pytest.param('interDemFoam/pinnedDrop', marks=pytest.mark.slow),
                                  pytest.param('interDemFoam/thermocapillaryDrop', marks=pytest.mark.slow),
                                  'interDemFoam/risingBubble', 'interEvapDemFoam/stefanTube', 'interEvapDemFoam/sessileLifetime',
                                  'interEvapDemFoam/stefanProblem', 'interEvapDemFoam/suckingInterface',
                                  'interEvapDemFoam/closedBox',
                                  pytest.param('interEvapDemFoam/ethanolWaterDroplet', marks=pytest.mark.slow),
                                  pytest.param('interEvapDemFoam/evaporatingFilm', marks=pytest.mark.slow),
                                  pytest.param('interEvapDemFoam/filmWithParticles', marks=pytest.mark.slow),
                                  pytest.param('interEvapDemFoam/sessileRates', marks=pytest.mark.slow),
                                  pytest.param('interEvapDemFoam/suspendedDroplet', marks=pytest.mark.slow),
                                  pytest.param('interEvapDemFoam/sessileDroplet', marks=pytest.mark.slow)])
def test_runs_and_validates(tmp_path, name):
    case = fresh(tmp_path / 'case', name)
    done = run_command(['./Allrun'], case, 1200)
    assert done.code == 0, done.output[-3000:]
    done = run_command(['./validate'], case, 120)
    assert done.code == 0 and done.output.rstrip().endswith('PASS'), done.output
    done = run_command(['./Allclean'], case, 60)
    assert done.code == 0, done.output


def test_narrow_film(tmp_path):
    """The shortest of the films of dryingFilm2D."""
    case = fresh(tmp_path / 'case', 'demFoam/dryingFilm2D')
    for command in ('./Allrun narrow', './validate'):
        done = run_command(command.split(), case, 300)
        assert done.code == 0, done.output
    assert done.output.rstrip().endswith('PASS')


@pytest.mark.parametrize('name, end, begun, particles', [('liquidFluidisedBed', '9', '0.02', 1500),
                                                         ('spoutedBed', '0.8', '0.002', 3200)],
                         ids=['liquidFluidisedBed', 'spoutedBed'])
def test_begins(tmp_path, name, end, begun, particles):
    """Ten steps of what takes minutes: all particles, and a validate that is not content with it."""
    case = fresh(tmp_path / 'case', f'cfdDemFoam/{name}')
    path = case / 'system' / 'controlDict'
    text = path.read_text()
    for key, value in (('endTime', end), ('writeInterval', None)):
        line = next(row for row in text.splitlines() if row.startswith(f'{key} '))
        assert value is None or line.split()[1] == f'{value};'
        text = text.replace(line, f'{key} {begun};')
    path.write_text(text)
    done = run_command(['./Allrun'], case, 300)
    assert done.code == 0, done.output[-3000:]
    assert f'particles {particles} ' in (case / 'log.cfdDemFoam').read_text()
    done = run_command(['./validate'], case, 60)
    assert done.code != 0 and 'too early' in done.output and done.output.rstrip().endswith('FAIL'), done.output
    done = run_command(['./Allclean'], case, 60)
    assert done.code == 0 and not list(case.glob('log.*')) + list(case.glob('*.png')), done.output


def notices(path, name, file, right, wrong, *only, timeout=300):
    """A wrong entry: the case runs, and its validate is not content."""
    case = fresh(path / 'case', name)
    text = (case / file).read_text()
    assert right in text
    (case / file).write_text(text.replace(right, wrong))
    done = run_command(['./Allrun', *only], case, timeout)
    assert done.code == 0, done.output[-3000:]
    done = run_command(['./validate'], case, 120)
    assert done.code != 0 and 'FAIL' in done.output.splitlines()[-1], done.output


def test_validate_notices_a_wrong_restitution(tmp_path):
    notices(tmp_path, 'demFoam/collisions', 'common/constant/collisions', 'restitution     0.75', 'restitution     0.70', '20um')


@pytest.mark.slow
@pytest.mark.parametrize('name, file, right, wrong, only', [
    # Spheres heavier by 6 %, of what the water leaves
    ('sedimentationEquilibrium', 'common/constant/particleProperties', 'density         2000', 'density         2060', ''),
    # Charges that reach further
    ('stabilityRatio', 'common/constant/particleProperties', 'debyeLength     20e-9', 'debyeLength     24e-9', '2kT'),
    # Diffusion faster by a fifth
    ('fractalAggregation', 'common/constant/particleProperties', 'temperature     298.15;\n}', 'temperature     360;\n}', '1')],
    ids=['sedimentationEquilibrium', 'stabilityRatio', 'fractalAggregation'])
def test_validate_notices_a_wrong_colloid(tmp_path, name, file, right, wrong, only):
    notices(tmp_path, f'demFoam/{name}', file, right, wrong, *only.split(), timeout=900)


@pytest.mark.parametrize('name, file, right, wrong', [
    # Drag too small by 2 %
    ('settlingSphere', 'common/constant/transportProperties', 'nu              1e-5', 'nu              0.98e-5'),
    # The air conducts 2 % better
    ('hotSphere', 'common/constant/transportProperties', 'kappa           0.026', 'kappa           0.0265'),
    # Spheres that move faster than they should
    ('voidFraction', 'common/constant/particleProperties', '(0.1 0.2 0.2)', '(0.1 0.2 0.21)'),
    # Spheres heavier by 3 %
    ('hinderedSettling', 'common/constant/particleProperties', 'density         2000', 'density         2030'),
    # Gas that flows faster by a tenth
    ('packedBedHeat', 'bed/0.orig/U', 'uniform (0 0 1)', 'uniform (0 0 1.1)')],
    ids=['settlingSphere', 'hotSphere', 'voidFraction', 'hinderedSettling', 'packedBedHeat'])
def test_validate_notices_a_wrong_dictionary(tmp_path, name, file, right, wrong):
    only = {'settlingSphere': 'SchillerNaumann', 'hotSphere': 'still', 'voidFraction': 'particleCentre',
            'hinderedSettling': 'WenYu-0.1', 'packedBedHeat': '2'}[name]
    notices(tmp_path, f'cfdDemFoam/{name}', file, right, wrong, only)


@pytest.mark.parametrize('name, file, right, wrong, only', [
    # Half a per cent less vapour
    ('stefanTube', 'common/constant/liquidProperties', 'pSat            3169.446', 'pSat            3154', 'water'),
    # Vapour that diffuses 1.5 % faster
    ('sessileLifetime', 'common/constant/gasProperties', '2.61e-5', '2.65e-5', 'rate-90-20'),
    ('sessileRates', 'common/constant/gasProperties', '2.61e-5', '2.65e-5', 'quasiStatic-90-20'),
    # Gas that conducts 2 % better
    ('stefanProblem', 'common/constant/gasProperties', 'kappa           0.025', 'kappa           0.0255', 'cells50'),
    # Liquid that conducts 2 % better
    ('suckingInterface', 'common/constant/liquidProperties', 'kappa           0.671', 'kappa           0.685', 'cells200'),
    # A hundred-thousandth less vapour
    ('closedBox', 'water/constant/liquidProperties', 'pSat            31201', 'pSat            31200.7', 'water'),
    # Ethanol less active in little of it
    ('ethanolWaterDroplet', 'activity/vanLaar', 'A12 1.6798', 'A12 1.55', 'first-vanLaar-0.1')],
    ids=['stefanTube', 'sessileLifetime', 'sessileRates', 'stefanProblem', 'suckingInterface', 'closedBox', 'ethanolWaterDroplet'])
def test_validate_notices_a_wrong_vapour(tmp_path, name, file, right, wrong, only):
    notices(tmp_path, f'interEvapDemFoam/{name}', file, right, wrong, only)


@pytest.mark.parametrize('name, file, right, wrong, only', [
    # Surface tension smaller by a hundredth: the curvature is given, and the jump 1 % less
    ('staticDroplet', 'prescribed/constant/surfaceProperties', 'sigma 0.07274', 'sigma 0.072', 'prescribed'),
    # A wave that is slower by 2 %
    ('capillaryWave', 'explicit32/constant/surfaceProperties', 'sigma 1;', 'sigma 0.96;', 'explicit32'),
    # A bubble in a fluid of 10 % more viscosity
    ('risingBubble', 'case1-40/constant/transportProperties', 'nu 0.01; rho 1000', 'nu 0.011; rho 1000', 'case1-40')],
    ids=['staticDroplet', 'capillaryWave', 'risingBubble'])
def test_validate_notices_a_wrong_fluid(tmp_path, name, file, right, wrong, only):
    notices(tmp_path, f'interDemFoam/{name}', file, right, wrong, only)
