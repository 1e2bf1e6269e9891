"""Walls of every shape and the cohesion of contacts, against closed forms. Restitution, friction and rolling between
particles and with planes are in tutorials/demFoam/collisions."""
import numpy as np
import pytest

from dewCase import Case, quoted

MATERIAL = {'youngsModulus': 1e9, 'poissonsRatio': 0.3, 'density': 2500.0}
E_STAR = 1e9 / (2 * (1 - 0.3**2))
R = 5e-4
E = 0.6
CONTACTS = {'normal': 'Hertz', 'tangential': 'history', 'default': {'restitution': E, 'friction': 0.0}}


def run(path, columns, end, walls=None, contacts=None, gravity=(0, 0, 0), **more):
    case = Case(path, upper=(1e-2,)*3, gravity=gravity, deltaT=end / 2, endTime=end, writeInterval=1,
                timePrecision=12)
    case.properties = {'engine': 'liggghts', 'materials': {'glass': MATERIAL}, 'contacts': contacts or CONTACTS,
                       'insertion': {'some': {'type': 'file', 'file': quoted('constant/particles.csv'),
                                              'material': 'glass'}},
                       'output': ('csv',), **more}
    if walls:
        case.properties['walls'] = walls
    case.particles(columns)
    case.mesh()
    return case


def result(case, end):
    done = case.run('demFoam')
    assert done.code == 0, done.output
    return case.table(end)[0], done.output


BOX = """solid box
facet normal 0 0 1
 outer loop
  vertex 0 0 1e-3
  vertex 1e-2 0 1e-3
  vertex 1e-2 1e-2 1e-3
 endloop
endfacet
facet normal 0 0 1
 outer loop
  vertex 0 0 1e-3
  vertex 1e-2 1e-2 1e-3
  vertex 0 1e-2 1e-3
 endloop
endfacet
endsolid box
"""

# Wall, a point on it, its normal at the point of impact, velocity of the particle
SHAPES = {
    'plane': ({'type': 'plane', 'point': (0, 0, 1e-3), 'normal': (0, 0, 1)}, (5e-3, 5e-3, 1e-3), (0, 0, 1)),
    'slanted plane': ({'type': 'plane', 'point': (5e-3, 5e-3, 5e-3), 'normal': (1, 2, 2)}, (5e-3, 5e-3, 5e-3),
                      (1/3, 2/3, 2/3)),
    'cylinder': ({'type': 'cylinder', 'point': (5e-3, 5e-3, 0), 'axis': (0, 0, 1), 'radius': 4e-3},
                 (9e-3, 5e-3, 5e-3), (-1, 0, 0)),
    'STL': ({'type': 'STL', 'file': quoted('constant/box.stl')}, (5.1e-3, 4e-3, 1e-3), (0, 0, 1)),
    'patch': ({'type': 'patch', 'patches': ('zMin',)}, (5e-3, 5e-3, 0), (0, 0, 1)),
    'patch as triangles': ({'type': 'patch', 'patches': ('zMin',),
                            'motion': {'type': 'linear', 'velocity': (0, 0, 0)}}, (5.1e-3, 4.2e-3, 0), (0, 0, 1)),
}


@pytest.mark.parametrize('shape', SHAPES)
def test_rebound_from_walls(tmp_path, shape):
    """Without friction the normal velocity is turned and multiplied by e (1 %, the collision is 30 sub-steps long),
    the tangential one stays (1e-6)."""
    wall, touch, normal = SHAPES[shape]
    n = np.array(normal, dtype=float)
    # Along a cylinder's axis: across it the normal would change on the way
    t = np.cross(n, (0.3, -0.5, 0.7)) if shape != 'cylinder' else np.array((0, 0, 0.6))
    v = -0.5 * n + 0.1 * t
    x = np.array(touch) + n * R * 1.2 - 0.1 * t * 0.2 * R / 0.5
    end = 1e-3
    case = run(tmp_path, {**dict(zip(('x', 'y', 'z'), x)), **dict(zip(('vx', 'vy', 'vz'), v)), 'd': 2 * R}, end,
               {'w': {**wall, 'material': 'glass'}})
    case.write_file('constant/box.stl', BOX)
    row, _ = result(case, end)
    after = np.array([row[k] for k in ('vx', 'vy', 'vz')])
    assert abs(after @ n / (0.5 * E) - 1) < 0.01
    assert np.abs(after - (after @ n) * n - 0.1 * t).max() < 1e-6

    # Where it is: touch after 0.2 R/0.5, contact as long as Hertz' 2.87 (m^2/(R E*^2 v))^0.2, way back; 1 % of R
    m = 2500 * 4 / 3 * np.pi * R**3
    contact = 2.87 * (m**2 / (R * E_STAR**2 * 0.5))**0.2
    way = (np.array([row[k] for k in 'xyz']) - touch) @ n
    assert abs(way - (R + 0.5 * E * (end - 0.2 * R / 0.5 - contact))) < 0.01 * R


def test_area_cohesion_holds_at_its_equilibrium(tmp_path):
    """Two spheres with cohesion k_c times contact area come to rest where 4/3 E* sqrt(R*) xi^1.5 = k_c A(xi), with A
    the circle in which they intersect; the closed form xi = (9/4) pi^2 k_c^2 R*/E*^2 holds to first order in xi/R."""
    k_c, Rs = 5e5, R / 2
    xi0 = 2.25 * np.pi**2 * k_c**2 * Rs / E_STAR**2

    def excess(xi):
        r = 2 * R - xi
        area = -np.pi / 4 * (r - 2 * R) * (r + 2 * R) * r * r / r**2
        return 4 / 3 * E_STAR * Rs**0.5 * xi**1.5 - k_c * area

    low, high = 0.1 * xi0, 10 * xi0
    for _ in range(200):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if excess(middle) < 0 else (low, middle)

    end = 2e-3
    case = run(tmp_path, {'x': [5e-3 - R, 5e-3 + R - 0.5 * xi0], 'y': 5e-3, 'z': 5e-3, 'd': 2 * R}, end,
               contacts={**CONTACTS, 'cohesion': 'area',
                         'default': {'restitution': 0.1, 'friction': 0.0, 'cohesionEnergyDensity': k_c}})
    done = case.run('demFoam')
    assert done.code == 0, done.output
    rows = case.table(end)
    xi = 2 * R - (rows['x'][1] - rows['x'][0])
    assert abs(xi / middle - 1) < 2e-3
    assert abs(xi / xi0 - 1) < 1e-2


def test_conduction_to_a_wall(tmp_path):
    """A sphere held at overlap xi on a wall at T_w: m cp dT/dt = h (T_w - T), h = 4 k k/(k + k) sqrt(A) with
    A = pi (R^2 - r^2), r the distance of the centre from the wall."""
    k, cp = 1e4, 500.0
    m = 2500 * 4 / 3 * np.pi * R**3
    r = R * (1 - 1e-3)
    h = 2 * k * np.sqrt(np.pi * (R**2 - r**2))
    end = 0.5 * m * cp / h
    case = run(tmp_path, {'x': 5e-3, 'y': 5e-3, 'z': r, 'd': 2 * R, 'T': 400.0}, end,
               {'floor': {'type': 'patch', 'patches': ('zMin',), 'material': 'glass', 'T': 300}}, heat=True,
               materials={'glass': {**MATERIAL, 'thermalConductivity': k, 'heatCapacity': cp}})
    # Strong drag holds it in place
    case.write_file('constant/testProperties', f'Sp {1e9 * m / end}; U (0 0 0);\n')
    done = case.run('testEngine')
    assert done.code == 0, done.output
    name = case.times()[-1]
    T = np.genfromtxt(case.path / name / 'engine.csv', delimiter=',', names=True)['T']
    assert abs(T - (300 + 100 * np.exp(-0.5))) < 0.2


@pytest.mark.parametrize('tangential, rolling', [('noHistory', 'none'), ('none', 'none'), ('history', 'epsd2'),
                                                 ('history', 'epsd'), ('history', 'cdt')])
def test_every_contact_model_runs_and_rolls_to_rest_or_not(tmp_path, tangential, rolling):
    """A ball thrown along a floor with friction mu and rolling friction mu_r: without tangential force it keeps its
    speed; with it, it slows down; with rolling friction it slows down further than 5/7 of the speed."""
    end, v0, g = 0.05, 0.1, 9.81
    pair = {'restitution': 0.3, 'friction': 0.3, 'rollingFriction': 0.2, 'rollingDamping': 0.3}
    case = run(tmp_path, {'x': 2e-3, 'y': 5e-3, 'z': R - 1e-9, 'd': 2 * R, 'vx': v0}, end,
               {'floor': {'type': 'patch', 'patches': ('zMin',), 'material': 'glass'}}, gravity=(0, 0, -g),
               contacts={'normal': 'Hertz', 'tangential': tangential, 'rolling': rolling, 'default': pair},
               materials={'glass': {**MATERIAL, 'youngsModulus': 1e7}})
    row, _ = result(case, end)
    if tangential == 'none':
        assert abs(row['vx'] - v0) < 1e-9
    elif rolling == 'none':
        # A spring without history is a dashpot: it still ends in rolling
        assert abs(row['vx'] / (5 / 7 * v0) - 1) < 0.01
        assert abs(row['wy'] * R / row['vx'] - 1) < 0.01
    else:
        assert row['vx'] < 0.9 * 5 / 7 * v0
