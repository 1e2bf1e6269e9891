"""Cases for the tests, written from Python values.

    case = Case(tmp_path, upper=(0.01, 0.01, 0.01), cells=(5, 5, 5), cyclic='x')
    case.properties = {'engine': 'liggghts', 'materials': {...}, ...}
    case.particles({'x': [1e-3, 3e-3], 'y': 2e-3, 'z': 2e-3, 'd': 1e-3})
    case.mesh()
    result = case.run('demFoam')             # or: case.decompose(2); case.run('demFoam', ranks=2)
    assert result.code == 0, result.output
    x = case.table(1e-3)['x']                # with 'output': ('csv',) in properties

The mesh is a box. Its patches are called xMin, xMax, yMin, yMax, zMin and zMax.
"""
import copy
import functools
import hashlib
import os
import pathlib
import re
import shutil
import signal
import subprocess
from typing import NamedTuple

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent

# The faces of blockMesh's first block on each side of the box
SIDES = {'xMin': '(0 4 7 3)', 'xMax': '(1 2 6 5)', 'yMin': '(0 1 5 4)', 'yMax': '(3 7 6 2)',
         'zMin': '(0 3 2 1)', 'zMax': '(4 5 6 7)'}

TIME = re.compile(r'\d+(\.\d+)?(e[-+]?\d+)?')
STEP = re.compile(r'^Time = (\S+)  particles (\d+)  sub-steps (\d+)  kinetic energy (\S+) J', re.M)


class Result(NamedTuple):
    """What a command left: its exit code, and standard output and error together."""
    code: int
    output: str


def quoted(text):
    """A string or file name for a dictionary: other strings are written as they are."""
    return f'"{text}"'


def foam_value(value):
    """A Python value in OpenFOAM's syntax."""
    if isinstance(value, bool):
        return 'on' if value else 'off'
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    if isinstance(value, (list, tuple, np.ndarray)):
        return '(' + ' '.join(foam_value(v) for v in value) + ')'
    return str(value)


def foam_dict(entries, indent=''):
    """A Python dict in OpenFOAM's syntax, without the outer braces."""
    lines = []
    for key, value in entries.items():
        if isinstance(value, dict):
            lines += [f'{indent}{key}', indent + '{', foam_dict(value, indent + '    '), indent + '}']
        else:
            lines.append(f'{indent}{key} {foam_value(value)};')
    return '\n'.join(lines)


def changed(entries, changes):
    """A copy of nested dicts with the entries at some paths ('walls/floor/type') replaced, added, or
    taken out (None)."""
    result = copy.deepcopy(entries)
    for path, value in changes.items():
        *folders, key = path.split('/')
        inner = result
        for folder in folders:
            inner = inner.setdefault(folder, {})
        if value is None:
            del inner[key]
        else:
            inner[key] = value
    return result


@functools.lru_cache(maxsize=None)
def environment():
    """The environment that etc/bashrc makes."""
    text = subprocess.run(['bash', '-c', '. etc/bashrc && env -0'], cwd=ROOT, check=True,
                          stdout=subprocess.PIPE).stdout.decode()
    return dict(entry.split('=', 1) for entry in text.split('\0') if '=' in entry)


def run_command(command, folder, timeout):
    """Run a command in a folder; a command that does not end in time is a failure."""
    process = subprocess.Popen([str(word) for word in command], cwd=folder,
                               env={**environment(), 'PWD': str(folder)}, start_new_session=True,
                               stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                               stderr=subprocess.STDOUT)
    try:
        output, _ = process.communicate(timeout=timeout)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        output, _ = process.communicate()
        raise AssertionError(f'{command} still ran after {timeout} s:\n'
                             + output.decode(errors='replace')) from None
    return Result(process.returncode, output.decode(errors='replace'))


class Case:
    """A case of demFoam. Change control, properties and the files; then mesh(), then run()."""

    def __init__(self, path, lower=(0, 0, 0), upper=(4e-3, 4e-3, 4e-3), cells=(4, 4, 4), cyclic='',
                 gravity=(0, 0, -9.81), **control):
        """A box from lower to upper [m], cyclic along axes such as 'xy'; control is entries of
        controlDict that differ from the default."""
        self.path = pathlib.Path(path)
        self.lower, self.upper, self.cells, self.cyclic = lower, upper, cells, cyclic
        self.gravity = gravity
        self.properties = {}
        self.control = {
            'application': 'demFoam', 'startFrom': 'latestTime', 'startTime': 0,
            'stopAt': 'endTime', 'endTime': 1e-3, 'deltaT': 1e-4, 'writeControl': 'timeStep',
            'writeInterval': 10, 'purgeWrite': 0, 'writeFormat': 'binary', 'writePrecision': 12,
            'timeFormat': 'general', 'timePrecision': 9, 'runTimeModifiable': False, **control}

    # --- Files

    def write_file(self, name, text):
        """A file of the case."""
        path = self.path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)

    def write_dict(self, name, entries, kind='dictionary'):
        """A dictionary of the case from a Python dict."""
        header = {'version': '2.0', 'format': 'ascii', 'class': kind, 'object': name.split('/')[-1]}
        self.write_file(name, foam_dict({'FoamFile': header, **entries}) + '\n')

    def write(self):
        """All dictionaries but those of the mesh."""
        self.write_dict('system/controlDict', self.control)
        self.write_dict('system/fvSchemes', {name + 'Schemes': {'default': 'none'} for name in (
            'ddt', 'grad', 'div', 'laplacian', 'interpolation', 'snGrad')})
        self.write_dict('system/fvSolution', {})
        self.write_dict('constant/g', {'dimensions': '[0 1 -2 0 0 0 0]', 'value': self.gravity},
                        'uniformDimensionedVectorField')
        self.write_dict('constant/particleProperties', self.properties)

    def write_block_mesh(self):
        """The box as blockMeshDict."""
        corners = [[(self.lower, self.upper)[bit][k] for k, bit in enumerate(bits)]
                   for bits in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
                                (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))]
        boundary = {}
        for name, face in SIDES.items():
            boundary[name] = {'type': 'wall', 'faces': f'({face})'}
            if name[0] in self.cyclic:
                other = name[0] + ('Max' if name.endswith('Min') else 'Min')
                boundary[name].update(type='cyclic', neighbourPatch=other)
        self.write_dict('system/blockMeshDict', {
            'scale': 1, 'vertices': corners,
            'blocks': f'(hex (0 1 2 3 4 5 6 7) {foam_value(self.cells)} simpleGrading (1 1 1))',
            'boundary': f'({foam_dict(boundary)})'})

    def particles(self, columns, name='constant/particles.csv'):
        """A table for insertion type file, from columns by name; single values are repeated."""
        names = list(columns)
        rows = zip(*np.broadcast_arrays(*(np.atleast_1d(np.asarray(columns[n], dtype=object)) for n in names)))
        lines = [','.join(names)] + [','.join(str(v) for v in row) for row in rows]
        self.write_file(name, '\n'.join(lines) + '\n')

    def copy(self, path):
        """The case with all its files in another folder."""
        other = copy.deepcopy(self)
        other.path = pathlib.Path(path)
        shutil.copytree(self.path, other.path, dirs_exist_ok=True)
        return other

    # --- Commands

    def run(self, *command, ranks=1, timeout=60):
        """Run an application in the case, on some ranks; timeout [s]."""
        if ranks > 1:
            command = ('mpirun', '-np', ranks, *command, '-parallel')
        return run_command(command, self.path, timeout)

    def refuses(self, words, *command):
        """Run a command that must end with one error message, which holds all these words."""
        done = self.run(*command)
        assert done.code != 0 and done.output.count('FOAM FATAL') == 1, done.output
        for word in words:
            assert word in ' '.join(done.output.split()), done.output

    def _must(self, *command):
        result = self.run(*command)
        assert result.code == 0, result.output

    def mesh(self):
        """Write the dictionaries and make the mesh."""
        self.write()
        self.write_block_mesh()
        self._must('blockMesh')

    def decompose(self, ranks):
        """Cut the mesh along x, for a run on some ranks."""
        self.write_dict('system/decomposeParDict', {
            'numberOfSubdomains': ranks, 'method': 'simple',
            'simpleCoeffs': {'n': (ranks, 1, 1), 'delta': 1e-3}})
        self._must('decomposePar', '-force')

    # --- Results

    def times(self, folder='.'):
        """Time directories of the case (or of processor0), but for 0, in order."""
        names = [p.name for p in (self.path / folder).iterdir() if p.is_dir()]
        return sorted((n for n in names if TIME.fullmatch(n) and float(n) > 0), key=float)

    def table(self, time):
        """Particles at a time, a structured array sorted by id; columns as in particles.csv."""
        name = next(n for n in self.times() if np.isclose(float(n), time, rtol=1e-6, atol=0))
        columns, *rows = (line.split(',') for line
                          in (self.path / name / 'particles.csv').read_text().splitlines())
        kinds = {'id': int, 'material': 'U32'}
        return np.sort(np.array([tuple(row) for row in rows],
                                dtype=[(c, kinds.get(c, float)) for c in columns]), order='id')

    def digests(self):
        """Checksum of every file in every time directory, also of the processors, by its name."""
        folders = [p for pattern in ('*', 'processor*/*') for p in self.path.glob(pattern)
                   if p.is_dir() and TIME.fullmatch(p.name)]
        return {str(f.relative_to(self.path)): hashlib.sha256(f.read_bytes()).hexdigest()
                for folder in folders for f in sorted(folder.rglob('*')) if f.is_file()}


def steps(output):
    """The steps a log tells of: structured array of time, particles, subSteps, energy [J]."""
    return np.array([(float(t), int(n), int(s), float(e)) for t, n, s, e in STEP.findall(output)],
                    dtype=[('time', float), ('particles', int), ('subSteps', int), ('energy', float)])
