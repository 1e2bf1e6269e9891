"""The laws in cfdDemFoam: the pressure gradient each gives a fixed bed, and what is told of a law outside its range.

Bed equations are written here as published, with the superficial velocity and the whole of the pressure gradient, so
that models A and B must both give it.
"""
import re

import numpy as np
import pytest

from dewCase import quoted
from fluidCase import FluidCase

PI = np.pi
RHO, NU = 1.2, 1.5e-5
MU = RHO * NU
GLASS = {'glass': {'youngsModulus': 1e7, 'poissonsRatio': 0.3, 'density': 2500, 'heatCapacity': 700.0,
                   'thermalConductivity': 1.0}}
ASCII = {'writeFormat': 'ascii', 'writePrecision': 12}


# --- Pressure gradients [Pa/m] at superficial velocity U, void fraction e and diameter d

def schiller_naumann(re):
    return 24 / re * (1 + 0.15 * re**0.687) if re < 1000 else 0.44


def dallavalle(re):
    return (0.63 + 4.8 / np.sqrt(re))**2


def haider_levenspiel(re):
    return 24 / re * (1 + 0.1806 * re**0.6459) + 0.4251 / (1 + 6880.95 / re)


def single(cd):
    """Spheres that each have the drag of a lone one in the velocity U/e; with the pressure on them, 1/e of it."""
    def gradient(U, e, d):
        u = U / e
        return (1 - e) / (PI / 6 * d**3) * cd(u * d / NU) * PI / 4 * d**2 * RHO * u**2 / 2 / e
    return gradient


def cunningham(free_path):
    def gradient(U, e, d):
        slip = 1 + 2 * free_path / d * (1.257 + 0.4 * np.exp(-1.1 * d / (2 * free_path)))
        return 18 * MU * (1 - e) * U / (d**2 * e**2) / slip
    return gradient


def wen_yu(U, e, d):
    return 0.75 * (1 - e) * RHO * schiller_naumann(U * d / NU) * U**2 / d * e**-4.65


def di_felice(U, e, d):
    re = U * d / NU
    chi = 3.7 - 0.65 * np.exp(-(1.5 - np.log10(re))**2 / 2)
    return 0.75 * (1 - e) * RHO * dallavalle(re) * U**2 / (d * e) * e**-chi


def ergun(U, e, d):
    return 150 * (1 - e)**2 * MU * U / (e**3 * d**2) + 1.75 * (1 - e) * RHO * U**2 / (e**3 * d)


def carman(U, e, d):
    return 180 * (1 - e)**2 * MU * U / (e**3 * d**2)


def koch_hill(U, e, d):
    c = 1 - e
    f0 = 10 * c / e**3
    if c < 0.4:
        f0 = ((1 + 3 * np.sqrt(c / 2) + 135 / 64 * c * np.log(c) + 16.14 * c)
              / (1 + 0.681 * c - 8.48 * c**2 + 8.16 * c**3))
    re = U * d / 2 / NU
    return 18 * MU * c * U / d**2 * (f0 + (0.0673 + 0.212 * c + 0.0232 / e**5) * re)


def beetstra(U, e, d):
    c, re = 1 - e, U * d / NU
    f = (10 * c / e**2 + e**2 * (1 + 1.5 * np.sqrt(c)) + 0.413 * re / (24 * e**2)
         * (1 / e + 3 * e * c + 8.4 * re**-0.343) / (1 + 10**(3 * c) * re**-(0.5 + 2 * c)))
    return 18 * MU * c * U / d**2 * f / e


def tenneti(U, e, d):
    c, re = 1 - e, U * d / NU
    f = ((1 + 0.15 * re**0.687) / e**3 + 5.81 * c / e**3 + 0.48 * c**(1 / 3) / e**4
         + c**3 * re * (0.95 + 0.61 * c**3 / e**2))
    return 18 * MU * c * U / d**2 * f


LAWS = {
    'Stokes': ({}, single(lambda re: 24 / re)), 'SchillerNaumann': ({}, single(schiller_naumann)),
    'Dallavalle': ({}, single(dallavalle)), 'HaiderLevenspiel': ({}, single(haider_levenspiel)),
    'StokesCunningham': ({'meanFreePath': 1e-4}, cunningham(1e-4)),
    'WenYu': ({}, wen_yu), 'DiFelice': ({}, di_felice), 'Ergun': ({}, ergun), 'Gidaspow': ({}, ergun),
    'Darcy': ({}, carman), 'KochHill': ({}, koch_hill), 'Beetstra': ({}, beetstra), 'Tenneti': ({}, tenneti)}

# Cells, each with 8 spheres; superficial velocity: Re 10 of the larger spheres
H, U_IN = 1e-3, 0.3


def bed(path, solid):
    """A column of 2 x 2 x 6 cells full of spheres on a lattice, gas from below. Void fraction and velocity are the same
    everywhere, also at the ends."""
    d = H / 2 * (6 / PI * solid)**(1 / 3)
    case = FluidCase(path, rho=RHO, nu=NU, tolerance=1e-11, upper=(2 * H, 2 * H, 6 * H), cells=(2, 2, 6), cyclic='xy',
                     gravity=(0, 0, 0), deltaT=1e-3, endTime=6e-3, writeInterval=6, **ASCII)
    x = (np.array(list(np.ndindex(4, 4, 12))) + 0.5) * H / 2
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': d})
    U = f'(0 0 {U_IN / (1 - solid)!r})'
    case.fields['U'] = U
    case.patches = {'U': {'zMin': {'type': 'fixedValue', 'value': 'uniform ' + U},
                          'zMax': {'type': 'zeroGradient'}},
                    'p': {'zMax': {'type': 'fixedValue', 'value': 'uniform 0'}}}
    case.properties = {'engine': 'prescribed', 'materials': GLASS, 'output': (),
                       'insertion': {'bed': {'type': 'file', 'file': quoted('constant/particles.csv'),
                                             'material': 'glass'}}}
    case.write()
    case.write_dict('0/alphac', {
        'dimensions': '[0 0 0 0 0 0 0]', 'internalField': f'uniform {1 - solid!r}',
        'boundaryField': {'".*"': {'type': 'zeroGradient'}, '"[xy].*"': {'type': 'cyclic'}}}, 'volScalarField')
    case.write_block_mesh()
    mesh = case.path / 'system/blockMeshDict'
    mesh.write_text(re.sub(r'(zM\w+\s*\{\s*type) wall', r'\1 patch', mesh.read_text()))
    done = case.run('blockMesh')
    assert done.code == 0, done.output
    return case, d


@pytest.fixture(scope='module')
def beds(tmp_path_factory):
    return {solid: bed(tmp_path_factory.mktemp('bed'), solid) for solid in (0.45, 0.35, 0.15)}


@pytest.mark.parametrize('law, solid, model', [
    *((law, 0.45, model) for law in LAWS for model in 'AB'), ('KochHill', 0.35, 'A'), ('Gidaspow', 0.15, 'B')])
def test_pressure_gradient_of_a_bed(beds, tmp_path, law, solid, model):
    """Between the second and the fifth of six cells. 1e-4: the pressure of the start dies out over the steps, and the
    weakest drag, StokesCunningham's, is still 2e-5 off after the sixth. The last two are the other branch of their
    law."""
    entries, gradient = LAWS[law]
    if law == 'Gidaspow' and solid < 0.2:
        gradient = wen_yu
    case, d = beds[solid]
    case = case.copy(tmp_path / 'case')
    case.properties['coupling'] = case.coupling(law, 'particleCentre', pressure=model == 'A', model=model)
    case.properties['coupling']['forces']['drag'].update(entries)
    case.write()
    done = case.run('cfdDemFoam')
    assert done.code == 0, done.output
    time = case.times()[-1]
    assert np.abs(case.field('alphac', time) + solid - 1).max() < 1e-12
    p = RHO * case.field('p', time).reshape(6, 4).mean(axis=1)
    assert abs((p[1] - p[4]) / (3 * H) / gradient(U_IN, 1 - solid, d) - 1) < 1e-4


# --- Laws outside their range

def spheres_in_a_stream(path, law, heat, diameters):
    """Spheres at rest that do not disturb the gas around them, velocity 0.1 m/s, at temperature 300 K."""
    n = len(diameters)
    case = FluidCase(path, rho=RHO, nu=NU, upper=(n * 1e-3, 2e-3, 2e-3), cells=(n, 2, 2), cyclic='xyz',
                     gravity=(0, 0, 0), deltaT=1e-6, endTime=4e-6, writeInterval=2, timePrecision=12, **ASCII)
    case.particles({'x': (np.arange(n) + 0.4) * 1e-3, 'y': 0.4e-3, 'z': 0.6e-3, 'd': diameters, 'T': 300})
    case.fields = {'U': '(0.1 0 0)', 'p': '0', 'T': '310'}
    # Pr 0.75
    case.transport.update(Cp=1000, kappa=MU * 1000 / 0.75)
    case.properties = {'engine': 'prescribed', 'heat': True, 'materials': GLASS, 'output': (),
                       'insertion': {'some': {'type': 'file', 'file': quoted('constant/particles.csv'),
                                              'material': 'glass'}},
                       'coupling': case.coupling(law, 'none', pressure=False, momentum='none', heat='none',
                                                 heatTransfer={'type': heat})}
    case.mesh()
    return case


# Re = 0.1 d/1.5e-5
DIAMETERS = np.array([0.5, 0.9, 1.2, 1.3, 1.5, 2.0]) * 1.5e-4


@pytest.mark.parametrize('ranks', [1, 2])
def test_outside_of_a_range_is_told(tmp_path, ranks):
    """Re 0.5 to 2 and Pe 0.375 to 1.5. Stokes' law: 4 above Re 1; Acrivos' expansion: 4 above Re 1, 2 of them above
    Pe 1. Two reports, of two steps each and the first with the evaluation at the start, one line a law."""
    case = spheres_in_a_stream(tmp_path, 'Stokes', 'AcrivosTaylor', DIAMETERS)
    if ranks > 1:
        case.decompose(ranks)
    done = case.run('cfdDemFoam', ranks=ranks)
    assert done.code == 0, done.output
    told = re.findall(r'^Law (\w+) outside its range: (.*)$', done.output, re.M)
    assert told == [
        (law, f'4 particles, {n} evaluations since the last report; {how}') for n in (12, 8)
        for law, how in (('Stokes', 'Re up to 2 (0 to 1)'), ('AcrivosTaylor', 'Pe up to 1.5 (0 to 1); Re up to 2 (0 to 1)'))]


def test_void_fraction_outside_of_a_range(beds, tmp_path):
    """4 x 4 x 12 spheres at void fraction 0.85, where Ergun's equation ends at 0.6 and Re is 4: three times that in two steps and the start."""
    case, _ = beds[0.15]
    case = case.copy(tmp_path / 'case')
    case.properties['coupling'] = case.coupling('Ergun', 'particleCentre')
    case.control.update(endTime=2e-3, writeInterval=2)
    case.write()
    done = case.run('cfdDemFoam')
    assert done.code == 0, done.output
    told = re.findall(r'^Law (\w+) outside its range: (.*)$', done.output, re.M)
    assert told == [('Ergun', '192 particles, 576 evaluations since the last report; alphac up to 0.85 (0.35 to 0.6)')]


def test_nothing_is_told_inside(tmp_path):
    case = spheres_in_a_stream(tmp_path, 'SchillerNaumann', 'RanzMarshall', DIAMETERS)
    done = case.run('cfdDemFoam')
    assert done.code == 0, done.output
    assert 'outside its range' not in done.output
