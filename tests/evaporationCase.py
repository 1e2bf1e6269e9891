"""Cases of interEvapDemFoam without particles: a drop on a wedge, or a film in a column.

    case = EvaporationCase(tmp_path, theta=60)              # a drop of 1 mm on a wedge of 2 degrees
    case = EvaporationCase(tmp_path, film=0.5e-3)           # or a film in a column
    case.change['energy'] = True
    case.prepare()
    case.go()
    table = case.ledger()
"""
import re

import numpy as np

from dewCase import Case, foam_dict, foam_value

HALF = np.radians(1)
RING = 2 * np.pi / np.sin(2 * HALF)
P0, RHO_GAS, WV, WC = 101325, 1.18, 18.0153, 28.9647
WATER = {'type': 'constant', 'name': 'water', 'W': WV, 'rho': 997, 'mu': 8.9e-4, 'Cp': 4181, 'kappa': 0.606,
         'hv': 2.442e6, 'sigma': 0.072, 'pSat': 3169}
BOILING_WATER = {**{k: v for k, v in WATER.items() if k != 'pSat'}, 'Tboil': 373.15, 'pBoil': P0}
CONSTANT_GAS = {'type': 'constant', 'p0': P0, 'Wc': WC, 'rho': RHO_GAS, 'D': 2.5e-5, 'Cp': 1006, 'kappa': 0.026,
                'mu': 1.8e-5}
IDEAL_GAS = {'type': 'idealGas', 'p0': P0, 'carrier': {'type': 'air'},
             'vapour': {'type': 'constant', 'Cp': 1900, 'kappa': 0.019, 'mu': 1e-5},
             'diffusivity': {'D0': 2.5e-5, 'Tref': 298.15, 'pRef': P0}}


def saturated(p_sat=3169, carrier=WC):
    """Mass fraction of water's vapour at saturation."""
    x = p_sat / P0
    return x * WV / (x * WV + (1 - x) * carrier)


class EvaporationCase(Case):
    """Water; patches substrate, outer, front and back, or substrate, outer and sides."""

    def __init__(self, path, theta=60, a=1e-3, n=8, film=None, line='pinned', **control):
        super().__init__(path, **{'application': 'interEvapDemFoam', 'endTime': 5, 'deltaT': 1, 'writeInterval': 1000,
                                  'writeFormat': 'ascii', 'writePrecision': 16, 'timePrecision': 12, **control})
        self.a, self.n, self.theta, self.film = a, n, theta, film
        self.motion = {'type': 'film', 'substrate': 'substrate', 'thickness': film} if film else {
            'type': 'quasiStatic', 'substrate': 'substrate', 'contactRadius': a, 'contactAngle': float(theta),
            'contactLine': {'type': line}}
        self.liquid, self.gas = dict(WATER), dict(CONSTANT_GAS)
        self.change = {'evaporation': {'type': 'diffusion'}, 'energy': False, 'gas': 'quasiSteady'}
        self.T, self.T_substrate, self.Y, self.Y_outer = 298.15, 298.15, 0.0, 0.0
        self.with_vapour, self.outer, self.outer_T, self.substrate_T = True, None, None, None
        self.tolerance = 1e-15
        self.turn = tuple              # of every position: the axis of the wedge is z
        self.properties = {'engine': 'none', 'coupling': {'voidFraction': {'type': 'none'}, 'momentum': 'none',
                                                          'forces': {}}}

    def write_block_mesh(self):
        if self.film:
            L = self.a
            self.write_dict('system/blockMeshDict', {
                'scale': 1, 'vertices': [(0, 0, 0), (L, 0, 0), (L, L, 0), (0, L, 0), (0, 0, 4 * L), (L, 0, 4 * L),
                                         (L, L, 4 * L), (0, L, 4 * L)],
                'blocks': f'(hex (0 1 2 3 4 5 6 7) (1 2 {4 * self.n}) simpleGrading (1 1 1))',
                'boundary': '(substrate {type wall; faces ((0 3 2 1));} outer {type patch; faces ((4 5 6 7));} '
                            'sides {type wall; faces ((0 4 7 3) (1 2 6 5) (0 1 5 4) (3 7 6 2));})'})
            return
        # Even cells around the drop, growing ones out to ten radii
        a, n = self.a, self.n
        inner = int(1.5 * n) + 1, int(np.ceil(n * np.tan(np.radians(self.theta) / 2))) + 2
        r, z = [0, inner[0] * a / n, 10 * a], [0, inner[1] * a / n, 10 * a]
        m = 12
        grow = [(max(8.0, 1.0 * n)), (max(8.0, 1.0 * n))]
        points, at = [], {}
        for i in range(3):
            for k in range(3):
                for s in (-1, 1):
                    if i == 0 and s == 1:
                        at[i, k, 1] = at[i, k, -1]
                        continue
                    at[i, k, s] = len(points)
                    points.append(self.turn((r[i] * np.cos(HALF), s * r[i] * np.sin(HALF), z[k])))

        def face(*corners):
            return '(' + ' '.join(str(at[c]) for c in corners) + ')'

        blocks = []
        for i in (0, 1):
            for k in (0, 1):
                corners = [(i + b, k + c, s) for c in (0, 1) for b, s in ((0, -1), (1, -1), (1, 1), (0, 1))]
                cells = ((inner[0], m)[i], 1, (inner[1], m)[k])
                grading = ((1, grow[0])[i], 1, (1, grow[1])[k])
                blocks.append(f'hex {face(*corners)} {foam_value(cells)} simpleGrading {foam_value(grading)}')

        def sides(s):
            return ' '.join(face((i, k, s), (i + 1, k, s), (i + 1, k + 1, s), (i, k + 1, s)) for i in (0, 1) for k in (0, 1))

        def level(k):
            return ' '.join(face((i, k, -1), (i + 1, k, -1), (i + 1, k, 1), (i, k, 1)) for i in (0, 1))

        rim = ' '.join(face((2, k, -1), (2, k, 1), (2, k + 1, 1), (2, k + 1, -1)) for k in (0, 1))
        boundary = {'substrate': {'type': 'wall', 'faces': f'({level(0)})'},
                    'outer': {'type': 'patch', 'faces': f'({level(2)} {rim})'},
                    'front': {'type': 'wedge', 'faces': f'({sides(-1)})'},
                    'back': {'type': 'wedge', 'faces': f'({sides(1)})'}}
        self.write_dict('system/blockMeshDict', {'scale': 1, 'vertices': points, 'blocks': f'({" ".join(blocks)})',
                                                 'boundary': f'({foam_dict(boundary)})'})

    def field_file(self, name, dimensions, value, substrate, outer, kind='volScalarField'):
        boundary = {'substrate': substrate, 'outer': outer}
        if self.film:
            still = name == 'U'
            boundary['sides'] = {'type': 'noSlip' if still else 'zeroGradient'}
        else:
            boundary.update(front={'type': 'wedge'}, back={'type': 'wedge'})
        if not (self.path / '0' / name).exists():
            self.write_dict(f'0/{name}', {'dimensions': dimensions, 'internalField': f'uniform {foam_value(value)}',
                                          'boundaryField': boundary}, kind)

    def write(self):
        super().write()
        self.write_dict('system/fvSchemes', {
            'ddtSchemes': {'default': 'Euler'}, 'gradSchemes': {'default': 'Gauss linear'},
            'divSchemes': {'default': 'none', 'div(phi,U)': 'Gauss upwind'},
            'laplacianSchemes': {'default': 'Gauss linear corrected'},
            'interpolationSchemes': {'default': 'linear'}, 'snGradSchemes': {'default': 'corrected'}})
        symmetric = {'solver': 'PCG', 'preconditioner': 'DIC', 'tolerance': self.tolerance, 'relTol': 0}
        other = {'solver': 'PBiCG', 'preconditioner': 'DILU', 'tolerance': self.tolerance, 'relTol': 0}
        self.write_dict('system/fvSolution', {
            'solvers': {'"(chi|pc).*"': symmetric, '"(Y.*|T|U).*"': other},
            'PIMPLE': {'nOuterCorrectors': 1, 'nCorrectors': 1},
            'gas': {'nCorrectors': 30, 'tolerance': 1e-11}})
        self.write_dict('constant/surfaceProperties', {'liquid': 'liquid', 'surfaceMotion': self.motion})
        self.write_dict('constant/phaseChangeProperties', self.change)
        self.write_dict('constant/liquidProperties', self.liquid)
        self.write_dict('constant/gasProperties', self.gas)
        same = {'type': 'zeroGradient'}
        self.field_file('T', '[0 0 0 1 0 0 0]', self.T,
                        self.substrate_T or {'type': 'fixedValue', 'value': f'uniform {self.T_substrate}'},
                        self.outer_T or {'type': 'fixedValue', 'value': f'uniform {self.T}'})
        self.field_file('U', '[0 1 -1 0 0 0 0]', (0, 0, 0), {'type': 'noSlip'}, same, 'volVectorField')
        self.field_file('alpha.liquid', '[0 0 0 0 0 0 0]', 0, same, same)
        if self.with_vapour:
            self.field_file('Y.liquid', '[0 0 0 0 0 0 0]', self.Y, same,
                            self.outer or {'type': 'fixedValue', 'value': f'uniform {self.Y_outer!r}'})

    def prepare(self):
        """Mesh, fields and the drop in them."""
        self.mesh()
        if not self.film:
            self._must('setSphericalCap')

    def decompose(self, ranks):
        """Across the drop."""
        self.write_dict('system/decomposeParDict', {
            'numberOfSubdomains': ranks, 'method': 'simple',
            'simpleCoeffs': {'n': (1, 1, ranks) if self.film else (ranks, 1, 1), 'delta': 1e-3}})
        self._must('decomposePar', '-force')

    def go(self, ranks=1, timeout=300):
        done = self.run('interEvapDemFoam', ranks=ranks, timeout=timeout)
        assert done.code == 0, done.output[-4000:]
        return done.output

    def message(self):
        """Of a run that must end with an error"""
        done = self.run('interEvapDemFoam')
        assert done.code != 0, done.output[-2000:]
        found = re.findall(r'FOAM FATAL.*?\n(.*?)(?:FOAM exiting|\n *From )', done.output, re.S)
        assert len(found) == 1, done.output[-3000:]
        return re.sub(r'\s+', ' ', found[0])

    def ledger(self, start='0'):
        """Every step, a structured array; the quantities are those of the whole drop."""
        path = self.path / 'postProcessing' / 'evaporation' / start / 'ledger.dat'
        names = [re.sub(r'\W.*', '', name) for name in path.read_text().splitlines()[0].split()[1:]]
        return np.rec.fromarrays(np.loadtxt(path, ndmin=2).T, names=names)

    def errors(self, output):
        """Of the balance, relative, of every step in a log"""
        return np.array(re.findall(r'^evaporated .*? error (\S+);', output, re.M), dtype=float)
