"""A bed of 10,000 spheres of 2 mm on a floor, periodic to the sides: the same particles for demFoam and for the plain
program liggghts, to compare results (tests/verification/settling) and speed (tests/benchmark)."""
import numpy as np

from dewCase import Case, changed, quoted, run_command

N = 10000
D = 2e-3
WIDTH, HEIGHT = 0.04, 0.15
DT = 1e-5
MATERIAL = {'youngsModulus': 1e7, 'poissonsRatio': 0.3, 'density': 2500.0}

PROPERTIES = {
    'engine': 'liggghts',
    'materials': {'glass': MATERIAL},
    'contacts': {'normal': 'Hertz', 'tangential': 'history', 'default': {'restitution': 0.5, 'friction': 0.5}},
    'walls': {'floor': {'type': 'patch', 'patches': ('zMin',), 'material': 'glass'}},
    'insertion': {'bed': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'glass'}},
    'skin': 0.3, 'timeStep': {'deltaT': DT}, 'output': ()}

# Everything but integrator and run, so that the binding's native input can read it, too
INPUT = """units si
atom_style granular
atom_modify map array
boundary p p f
newton off
communicate single vel yes
read_data {folder}/bed.data
neighbor 0.0003 bin
neigh_modify delay 0
fix m1 all property/global youngsModulus peratomtype 1e7
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
pair_style gran model hertz tangential history
pair_coeff * *
timestep 1e-5
fix floor all wall/gran model hertz tangential history primitive type 1 zplane 0.0
fix gravity all gravity 9.81 vector 0 0 -1
"""


def case(path, columns=None, **control):
    """A case of the bed; packed at random where no columns of particles are given."""
    bed = Case(path, upper=(WIDTH, WIDTH, HEIGHT), cells=(4, 4, 15), cyclic='xy',
               **{'deltaT': 100 * DT, 'endTime': 6000 * DT, 'writeInterval': 1000000, 'timePrecision': 12,
                  **control})
    bed.properties = dict(PROPERTIES)
    if columns is None:
        bed.properties = changed(PROPERTIES, {'insertion': {'bed': {
            'type': 'packed', 'material': 'glass', 'number': N, 'diameter': {'type': 'uniform', 'min': 0.94 * D,
                                                                           'max': 1.06 * D},
            'region': {'type': 'box', 'min': (0, 0, 0), 'max': (WIDTH, WIDTH, HEIGHT)}}}})
    else:
        bed.particles(columns)
    return bed


def columns_of(rows):
    return {k: rows[k] for k in ('x', 'y', 'z', 'd', 'vx', 'vy', 'vz', 'wx', 'wy', 'wz')}


def packed(path):
    """Columns of the particles placed at random: those of a run of one sub-step from rest, set at rest."""
    bed = case(path, deltaT=DT, endTime=DT, writeInterval=1)
    bed.properties['output'] = ('csv',)
    bed.mesh()
    done = bed.run('demFoam', timeout=120)
    assert done.code == 0, done.output
    columns = columns_of(bed.table(DT))
    for k in ('vx', 'vy', 'vz', 'wx', 'wy', 'wz'):
        columns[k] = 0 * columns[k]
    return columns


def settled(path, columns):
    """Columns of the bed after 16,000 sub-steps, at rest but for 1 % of the kinetic energy's peak."""
    bed = case(path, columns, endTime=16000 * DT, writeInterval=160)
    bed.properties['output'] = ('csv',)
    bed.mesh()
    done = bed.run('demFoam', timeout=300)
    assert done.code == 0, done.output
    return columns_of(bed.table(16000 * DT))


def write_plain(folder, columns, tail):
    """Input of the plain program: the bed, an integrator, and what follows."""
    folder.mkdir(parents=True, exist_ok=True)
    n = len(columns['x'])
    lines = ['bed', '', f'{n} atoms', '1 atom types', f'0 {WIDTH} xlo xhi', f'0 {WIDTH} ylo yhi',
             f'{-D} {HEIGHT + D} zlo zhi', '', 'Atoms', '']
    x, y, z = (np.mod(columns[k], WIDTH) if k != 'z' else columns[k] for k in 'xyz')
    lines += [f'{i + 1} 1 {columns["d"][i]!r} 2500 {x[i]!r} {y[i]!r} {z[i]!r}' for i in range(n)]
    lines += ['', 'Velocities', '']
    lines += [f'{i + 1} ' + ' '.join(repr(float(columns[k][i])) for k in ('vx', 'vy', 'vz', 'wx', 'wy', 'wz'))
              for i in range(n)]
    (folder / 'bed.data').write_text('\n'.join(lines) + '\n')
    (folder / 'in.common').write_text(INPUT.format(folder=folder))
    (folder / 'in.plain').write_text('include ' + str(folder / 'in.common') + '\nfix nve all nve/sphere\n' + tail)


def run_plain(folder, ranks=1, timeout=600):
    """The plain program on the folder's input; its log."""
    command = ('mpirun', '-np', ranks) if ranks > 1 else ()
    done = run_command((*command, 'liggghts', '-in', folder / 'in.plain', '-log', folder / 'log.plain'), folder, timeout)
    assert done.code == 0, done.output[-2000:]
    return (folder / 'log.plain').read_text()
