"""Films of water with particles, for interEvapDemFoam: a ColumnCase several cells wide, its sides cyclic.

    case = FilmCase(tmp_path, cells=20, length=1e-3, surface=0.5e-3, sides=3, endTime=1, deltaT=1e-2)
    case.spheres(positions, d, T=350, heatCapacity=500)     # and case.properties['coupling'] as it is to be
    case.mesh()
    output = case.go()

The film lies on the patch low, x is up; with closed=True also high is a wall, that lets no heat through.
"""
import numpy as np

from columnCase import ColumnCase
from dewCase import quoted
from fluidCase import FluidCase

LATERAL = {'yMin': '(0 1 5 4)', 'yMax': '(3 7 6 2)', 'zMin': '(0 3 2 1)', 'zMax': '(4 5 6 7)'}


class FilmCase(ColumnCase):
    def __init__(self, path, cells, length, surface, sides=2, closed=False, **control):
        super().__init__(path, cells, length, surface, gas_first=False, closed=closed, **control)
        self.sides = sides

    ledger = FluidCase.ledger
    evaporated = ColumnCase.ledger
    field = FluidCase.field
    joined_field = FluidCase.joined_field

    @property
    def area(self):
        return (self.sides*self.width)**2

    def write_block_mesh(self):
        L, w = self.length, self.sides*self.width
        high = 'wall' if self.closed else 'patch'
        boundary = f'(low {{type wall; faces ((0 4 7 3));}} high {{type {high}; faces ((1 2 6 5));}}'
        for name, face in LATERAL.items():
            other = name[0] + ('Max' if name.endswith('Min') else 'Min')
            boundary += f' {name} {{type cyclic; neighbourPatch {other}; faces ({face});}}'
        self.write_dict('system/blockMeshDict', {
            'scale': 1, 'vertices': [(0, 0, 0), (L, 0, 0), (L, w, 0), (0, w, 0), (0, 0, w), (L, 0, w), (L, w, w), (0, w, w)],
            'blocks': f'(hex (0 1 2 3 4 5 6 7) ({self.n} {self.sides} {self.sides}) simpleGrading (1 1 1))',
            'boundary': boundary + ')'})

    def values(self, value):
        v = value(self.centres) if callable(value) else np.broadcast_to(value, self.n)
        v = np.tile(v, self.sides**2)
        return f'nonuniform List<scalar> {len(v)}(' + ' '.join(repr(float(x)) for x in v) + ')'

    def field_file(self, name, dimensions, internal, low, high, kind='volScalarField'):
        self.write_dict(f'0/{name}', {'dimensions': dimensions, 'internalField': internal, 'boundaryField': {
            'low': low, 'high': high, **{side: {'type': 'cyclic'} for side in LATERAL}}}, kind)

    def write(self):
        super().write()
        self.write_dict('constant/surfaceProperties', {
            'liquid': 'water', 'surfaceMotion': {'type': 'isoAdvector'}, 'surfaceTension': {'sigma': 0},
            'curvature': {'type': 'gradAlpha'}})
        path = self.path/'system/fvSolution'
        text = path.read_text()
        if self.law['type'] == 'none':
            # In fluids at rest less than this is rounding
            text = text.replace('tolerance 1e-15', 'tolerance 1e-10', 1).replace('1e-11', '1e-9')
        path.write_text(text)

    def spheres(self, positions, d, engine='liggghts', density=2500.0, heatCapacity=500.0, coupling=None, T=None,
                modulus=1e4, **properties):
        x = np.atleast_2d(positions)
        self.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': d, **({} if T is None else {'T': T})})
        self.properties = {
            'engine': engine, 'heat': T is not None, 'output': ('csv',),
            'materials': {'glass': {'youngsModulus': modulus, 'poissonsRatio': 0.3, 'density': density,
                                    'heatCapacity': heatCapacity, 'thermalConductivity': 1}},
            'insertion': {'spheres': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'glass'}},
            'coupling': {'voidFraction': {'type': 'none'}, 'momentum': 'none', 'forces': {}, **(coupling or {})},
            **properties}
        if engine == 'liggghts':
            self.properties.update({
                'contacts': {'default': {'restitution': 0.5, 'friction': 0.4}},
                'walls': {'floor': {'type': 'patch', 'patches': ('low',), 'material': 'glass'}}})

    def pending_heat(self, time):
        """Of each particle, by number: what the last step of the fluid owes it [J]. Layout: particleRecord.H."""
        raw = (self.path/time/'uniform/particles/exchange').read_bytes()
        n, n_values = np.frombuffer(raw[16:32], dtype='<i8')
        rows = np.frombuffer(raw[32:-8], dtype=[('id', '<i8'), ('values', '<f8', n_values)])
        assert len(rows) == n
        return np.sort(rows, order='id')['values'][:, 3]

    def decompose(self, ranks):
        self.write_dict('system/decomposeParDict', {
            'numberOfSubdomains': ranks, 'method': 'simple', 'simpleCoeffs': {'n': (1, ranks, 1), 'delta': 1e-3}})
        self._must('decomposePar', '-force')
