"""The boundary condition farField: around a sphere the steady field is yInf + (y0 - yInf) r0/r, wherever the domain ends.

Half a sphere on a plane of symmetry as a wedge of 5 degrees, solved by OpenFOAM's laplacianFoam. With 40, 80 and 160
cells over the radius the largest deviation is 19, 7 and 4e-4 of the range to 3 radii, 23, 8 and 4e-4 to 10 radii: what is
left is the wedge, whose sides are flat (1 - cos(2.5 degrees) is 9.5e-4).
"""
import re

import numpy as np
import pytest

from dewCase import Case, foam_dict, foam_value

R0, Y0, INFINITY = 1.0, 350.0, 300.0
HALF = np.radians(2.5)


class Hemisphere(Case):
    """The gas between two half spheres, of radii scale and outer*scale, about the z axis."""

    def __init__(self, path, outer, origin=(0, 0, 0), scale=1.0, far=None, n=1):
        super().__init__(path, application='laplacianFoam', startTime=0, endTime=1, deltaT=1, writeInterval=1,
                         writeFormat='ascii', writePrecision=12, libs='(dewPhaseChange)')
        self.outer, self.scale, self.n = outer, scale, n
        self.far = far or {'type': 'farField', 'infinity': f'uniform {INFINITY}',
                           'origin': tuple(scale * np.array(origin))}

    def write(self):
        super().write()
        self.write_dict('system/fvSchemes', {
            'ddtSchemes': {'default': 'steadyState'}, 'gradSchemes': {'default': 'Gauss linear'},
            'divSchemes': {'default': 'none'}, 'laplacianSchemes': {'default': 'Gauss linear corrected'},
            'interpolationSchemes': {'default': 'linear'}, 'snGradSchemes': {'default': 'corrected'}})
        self.write_dict('system/fvSolution', {
            'solvers': {'T': {'solver': 'PCG', 'preconditioner': 'DIC', 'tolerance': 1e-13, 'relTol': 0}},
            'SIMPLE': {'nNonOrthogonalCorrectors': 3}})
        self.write_dict('constant/transportProperties', {'DT': '[0 2 -1 0 0 0 0] 1'})
        self.write_dict('0/T', {
            'dimensions': '[0 0 0 1 0 0 0]', 'internalField': f'uniform {INFINITY}',
            'boundaryField': {
                'inner': {'type': 'fixedValue', 'value': f'uniform {Y0}'}, 'outer': self.far,
                'plane': {'type': 'zeroGradient'}, 'front': {'type': 'wedge'}, 'back': {'type': 'wedge'}}},
            'volScalarField')

    def write_block_mesh(self):
        def at(r, polar, side):
            return tuple(r * np.array((np.cos(polar) * np.cos(HALF), side * np.cos(polar) * np.sin(HALF),
                                       np.sin(polar))))

        r1 = R0 * self.outer
        vertices = [at(R0, 0, 1), at(r1, 0, 1), (0, 0, r1), (0, 0, R0), at(R0, 0, -1), at(r1, 0, -1)]
        arcs = ' '.join(f'arc {a} {b} {foam_value(at(r, np.pi / 4, side))}'
                        for a, b, r, side in ((0, 3, R0, 1), (4, 3, R0, -1), (1, 2, r1, 1), (5, 2, r1, -1)))
        patches = {'inner': ('patch', '(0 4 3 3)'), 'outer': ('patch', '(1 2 2 5)'), 'plane': ('patch', '(0 1 5 4)'),
                   'front': ('wedge', '(0 3 2 1)'), 'back': ('wedge', '(4 5 2 3)')}
        boundary = {name: {'type': kind, 'faces': f'({face})'} for name, (kind, face) in patches.items()}
        self.write_dict('system/blockMeshDict', {
            'scale': self.scale, 'vertices': vertices, 'edges': f'({arcs})',
            'blocks': f'(hex (0 1 2 3 4 5 2 3) ({40 * self.n} {20 * self.n} 1) simpleGrading ({self.outer} 1 1))',
            'boundary': f'({foam_dict(boundary)})'})

    def solve(self, ranks=1):
        self.mesh()
        if ranks > 1:
            self.write_dict('system/decomposeParDict', {
                'numberOfSubdomains': ranks, 'method': 'simple', 'simpleCoeffs': {'n': (1, 1, ranks), 'delta': 1e-3}})
            self._must('decomposePar')
        done = self.run('laplacianFoam', ranks=ranks)
        assert done.code == 0, done.output
        if ranks > 1:
            self._must('reconstructPar')

    def field(self, time=1):
        """Radius over R0 and value of the cells, and the text of the file."""
        self._must('postProcess', '-func', 'writeCellCentres', '-time', str(time))
        text = (self.path / str(time) / 'T').read_text()

        def numbers(name):
            body = (self.path / str(time) / name).read_text()
            return np.array(re.search(r'nonuniform List<\w+>\s*\d+\s*\(([^;]*?)\)\s*;', body)[1]
                            .replace('(', ' ').replace(')', ' ').split(), dtype=float)
        # A vertex at radius r is at r cos(2.5 degrees) in the middle plane
        centres = numbers('C').reshape(-1, 3) / (self.scale * np.array((np.cos(HALF), 1, 1)))
        return np.linalg.norm(centres, axis=1) / R0, numbers('T'), text


def error(case):
    """Largest deviation from the exact solution over its range."""
    r, y, _ = case.field()
    return np.abs((y - INFINITY) / (Y0 - INFINITY) - 1 / r).max()


@pytest.mark.parametrize('outer', [3, 10])
def test_field_is_that_of_an_unlimited_gas(tmp_path, outer):
    """Where the domain ends makes no difference; with the value at infinity given there, it makes 1/outer."""
    case = Hemisphere(tmp_path / 'far', outer, n=2)
    case.solve()
    assert error(case) < 1e-3

    fixed = Hemisphere(tmp_path / 'fixed', outer, far={'type': 'fixedValue', 'value': f'uniform {INFINITY}'}, n=2)
    fixed.solve()
    assert error(fixed) > 0.5 / outer


def test_micrometres_and_two_ranks(tmp_path):
    """At 1e-6 of the size, and cut in two, the field is the same."""
    fields = []
    for name, scale, ranks in (('one', 1.0, 1), ('small', 1e-6, 1), ('two', 1.0, 2)):
        case = Hemisphere(tmp_path / name, 3, scale=scale)
        case.solve(ranks)
        fields.append(case.field()[1])
    # The tolerance of the linear solver, 1e-13 of the residual's norm, and 12 digits in the file
    assert np.abs(fields[1] - fields[0]).max() < 1e-6
    assert np.abs(fields[2] - fields[0]).max() < 1e-6


def test_is_written_for_a_restart(tmp_path):
    """The next time has the entries, and the run goes on from them."""
    case = Hemisphere(tmp_path, 3)
    case.solve()
    _, before, text = case.field()
    entry = re.search(r'outer\s*\{.*?\}', text, re.S)[0]
    assert re.search(r'type\s+farField;', entry)
    assert re.search(r'infinity\s+uniform 300;', entry)
    assert re.search(r'origin\s+\(0 0 0\);', entry)
    assert re.search(r'value\s+nonuniform', entry)

    case.control['endTime'] = 2
    case.write_dict('system/controlDict', case.control)
    done = case.run('laplacianFoam')
    assert done.code == 0, done.output
    assert np.abs(case.field(2)[1] - before).max() < 1e-3


@pytest.mark.parametrize('far, words', [
    ({'type': 'farField', 'infinity': 'uniform 300', 'origin': (0, 0, 9)},
     ('farField of T on patch outer', '(0 0 9)', 'inside the domain')),
    ({'type': 'farField'}, ('infinity', '0/T')),
    ({'type': 'farField', 'infinity': 'uniform 300', 'origin': '(0 0)'}, ('origin', '0/T'))],
    ids=['outside', 'missing', 'origin'])
def test_refused(tmp_path, far, words):
    case = Hemisphere(tmp_path, 3, far=far)
    case.mesh()
    done = case.run('laplacianFoam')
    assert done.code != 0
    for word in words:
        assert word in done.output, done.output
