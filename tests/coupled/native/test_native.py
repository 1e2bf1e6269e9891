"""The expert's ways: an input file of the engine instead of the generated set-up, and lines after it."""
import re

import numpy as np

import bed
from dewCase import Case, foam_dict, quoted


def small():
    """200 spheres that fall on the floor of the bed's box, with different velocities."""
    rng = np.random.default_rng(4)
    side = np.arange(10)
    x, y = (a.ravel() * 4e-3 + 2e-3 for a in np.meshgrid(side, side))
    n = 2 * x.size
    columns = {'x': np.tile(x, 2) + 2e-4 * rng.random(n), 'y': np.tile(y, 2) + 2e-4 * rng.random(n),
               'z': np.repeat([2e-3, 5e-3], x.size), 'd': bed.D * (0.94 + 0.12 * rng.random(n))}
    for k in ('vx', 'vy', 'vz', 'wx', 'wy', 'wz'):
        columns[k] = rng.normal(size=n) * (0.2 if k[0] == 'v' else 20)
    return columns


def test_native_input_is_the_plain_program(tmp_path):
    """The same input file in demFoam and in liggghts: the same particles after 2000 sub-steps with collisions, to
    1e-9. The shell in which ended contacts are noticed (CHANGELOG.md) is given to both."""
    columns = small()
    plain = tmp_path / 'plain'
    bed.write_plain(plain, columns, 'thermo_style custom step atoms ke\ndump end all custom 2000 ' + str(plain)
                    + '/end.* id x y z vx vy vz\ndump_modify end format "%d %.16g %.16g %.16g %.16g %.16g %.16g"\n'
                    'run 2000\n')
    common = plain / 'in.common'
    common.write_text(common.read_text().replace('delay 0', 'delay 0 contact_distance_factor 1.01'))
    bed.run_plain(plain)
    rows = [line.split() for line in (plain / 'end.2000').read_text().split('id x y z vx vy vz')[1].splitlines()]
    theirs = np.array(sorted([float(v) for v in row] for row in rows if row))

    case = bed.case(tmp_path / 'ours', columns, deltaT=200 * bed.DT, endTime=2000 * bed.DT, writeInterval=10)
    case.properties = {'engine': 'liggghts', 'input': quoted(common), 'timeStep': {'deltaT': bed.DT},
                       'output': ('csv',)}
    case.mesh()
    done = case.run('demFoam')
    assert done.code == 0, done.output
    ours = case.table(2000 * bed.DT)

    assert np.array_equal(ours['id'], theirs[:, 0])
    for k, name in enumerate(('x', 'y', 'z', 'vx', 'vy', 'vz')):
        difference = ours[name] - theirs[:, k + 1]
        if name in 'xy':
            difference -= bed.WIDTH * np.round(difference / bed.WIDTH)
        assert np.abs(difference).max() < 1e-9, name


def test_gravity_of_a_native_input_is_no_contact(tmp_path):
    """Particles that fall at their terminal velocity m g/Sp: their sensitivity is the free one."""
    h, t = 3.0, 100 * bed.DT
    m = 2500 * np.pi / 6 * bed.D**3
    zero = np.zeros(2)
    columns = {'x': np.array([0.01, 0.03]), 'y': zero + 0.02, 'z': zero + 0.1, 'd': zero + bed.D, 'vx': zero,
               'vy': zero, 'vz': zero - 9.81 * t / h, 'wx': zero, 'wy': zero, 'wz': zero}
    bed.write_plain(tmp_path / 'plain', columns, '')
    case = bed.case(tmp_path / 'ours', columns, deltaT=t, endTime=3 * t)
    case.properties = {'engine': 'liggghts', 'input': quoted(tmp_path / 'plain/in.common'),
                       'timeStep': {'deltaT': bed.DT}, 'output': ()}
    case.mesh()
    case.write_file('constant/testProperties', foam_dict({'Sp': h * m / t, 'U': (0, 0, 0)}) + '\n')
    done = case.run('testEngine')
    assert done.code == 0, done.output
    rows = np.genfromtxt(case.path / '0.003' / 'engine.csv', delimiter=',', names=True)
    assert np.abs(rows['vz'] * h / (9.81 * t) + 1).max() < 1e-9
    assert np.abs(rows['jsp'] / (-m * np.expm1(-h)) - 1).max() < 1e-9


def test_own_commands_follow_the_generated_ones(tmp_path):
    """A line of the user is in SI and takes effect: a particle that is pushed with a constant force."""
    force, d = 1e-6, 1e-3
    m = 2500 * np.pi / 6 * d**3
    case = Case(tmp_path, upper=(1e-2,)*3, gravity=(0, 0, 0), deltaT=1e-4, endTime=1e-3, writeInterval=10)
    case.properties = {**bed.PROPERTIES, 'output': ('csv',), 'timeStep': {'deltaT': 1e-6},
                       'commands': (quoted(f'fix push all addforce {force} 0 0'),)}
    del case.properties['walls']
    case.particles({'x': 5e-3, 'y': 5e-3, 'z': 5e-3, 'd': d})
    case.mesh()
    done = case.run('demFoam')
    assert done.code == 0, done.output
    assert abs(case.table(1e-3)['vx'][0] / (force / m * 1e-3) - 1) < 1e-9
    text = (case.path / 'dem' / 'in.particles').read_text()
    assert re.search(r'^fix push all addforce', text, re.M)
    assert 'One engine unit: 1 m, 1 kg, 1 s' in text
