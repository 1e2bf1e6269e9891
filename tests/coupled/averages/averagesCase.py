"""What the tests of particleAverages share: a box of resting fluid that does nothing to the particles."""
import re

import numpy as np

from dewCase import quoted
from fluidCase import FluidCase

GLASS = {'youngsModulus': 5e6, 'poissonsRatio': 0.3, 'density': 2500.0, 'heatCapacity': 700.0,
         'thermalConductivity': 1.0}
HEAVY = {**GLASS, 'density': 7500.0}
CONTACTS = {'normal': 'Hertz', 'tangential': 'history', 'default': {'restitution': 0.7, 'friction': 0.3}}


def sphere(d):
    return np.pi / 6 * np.asarray(d)**3


def hertz(d1, d2, distance):
    """Repulsion of two spheres of GLASS without damping [N]. K. L. Johnson, Contact mechanics (1985), eq. 4.23."""
    modulus = GLASS['youngsModulus'] / (2 * (1 - GLASS['poissonsRatio']**2))
    radius = 0.5 * d1 * d2 / (d1 + d2)
    return 4 / 3 * modulus * np.sqrt(radius) * (0.5 * (d1 + d2) - distance)**1.5


def build(path, particles, fields, void='particleCentre', cyclic='xyz', average=None, walls=None, restitution=0.7,
          heat=False, ranks=1, materials=None, **control):
    """A case of cfdDemFoam with the function object phase; average: more entries of it."""
    entries = {'type': 'particleAverages', 'libs': '(dewFunctionObjects)', 'fields': fields,
               'writeControl': 'writeTime', **(average or {})}
    case = FluidCase(path, cyclic=cyclic,
                     **{'functions': {'phase': entries}, 'gravity': (0, 0, 0), 'writeFormat': 'ascii',
                        'writePrecision': 17, **control})
    case.particles(particles)
    case.properties = {
        'engine': 'liggghts', 'heat': heat, 'materials': materials or {'glass': GLASS, 'heavy': HEAVY},
        'contacts': {**CONTACTS, 'default': {'restitution': restitution, 'friction': 0.3}}, 'walls': walls or {},
        'insertion': {'all': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'glass'}},
        'output': ('csv',),
        'coupling': {'voidFraction': {'type': void}, 'momentum': 'none', 'forces': {}}}
    case.mesh()
    if ranks > 1:
        case.decompose(ranks)
    return case


def run(case, ranks=1):
    done = case.run('cfdDemFoam', ranks=ranks, timeout=120)
    assert done.code == 0, done.output
    return done.output


def cells(case, name, time=None, ranks=1):
    """Values of a field at a time (default: the last): cells in the order of the mesh, symmTensor as 6 columns."""
    folder = '.' if ranks == 1 else 'processor0'
    names = case.times(folder)
    chosen = names[-1] if time is None else next(n for n in names if np.isclose(float(n), time, rtol=1e-6, atol=0))
    if ranks > 1:
        values = joined(case, name, chosen, ranks)
    else:
        values = read(case.path / chosen / name)
    n = int(np.prod(case.cells))
    return values if len(values) == n else np.broadcast_to(values, (n,) + values.shape).squeeze()


def read(path):
    """Internal values of an ascii field of any rank."""
    text = path.read_text()
    uniform = re.search(r'internalField\s+uniform\s+(.*?);', text)
    if uniform:
        return np.array(uniform[1].strip('()').split(), dtype=float)
    kind, body = re.search(r'internalField\s+nonuniform\s+List<(\w+)>\s*\d+\s*\((.*?)\)\s*;', text, re.S).groups()
    values = np.array(body.replace('(', ' ').replace(')', ' ').split(), dtype=float)
    return values.reshape(-1, {'scalar': 1, 'vector': 3, 'symmTensor': 6}[kind]).squeeze()


def joined(case, name, time, ranks):
    parts, order = [], []
    for rank in range(ranks):
        folder = case.path / f'processor{rank}'
        text = (folder / 'constant/polyMesh/cellProcAddressing').read_text()
        order.append(np.array(re.search(r'\n\d+\s*\(([\d\s]*)\)', text)[1].split(), dtype=int))
        values = read(folder / time / name)
        parts.append(values if len(values) == len(order[-1])
                     else np.broadcast_to(values, (len(order[-1]),) + values.shape).squeeze())
    return np.concatenate(parts)[np.argsort(np.concatenate(order))]
