"""Meshes that are not boxes of squares: prisms over triangles, hexahedra with moved corners, a wedge."""
import re

import numpy as np


def square_of_triangles(n, length, seed=1):
    """Points and triangles of a square, n x n pairs, corners inside moved and diagonals at random."""
    random = np.random.default_rng(seed)
    x, y = np.meshgrid(np.arange(n + 1.0), np.arange(n + 1.0))
    inside = (x > 0) & (x < n) & (y > 0) & (y < n)
    x += inside*random.uniform(-0.2, 0.2, x.shape)
    y += inside*random.uniform(-0.2, 0.2, y.shape)
    points = np.column_stack([x.ravel(), y.ravel()])*length/n
    triangles = []
    for j in range(n):
        for i in range(n):
            a = j*(n + 1) + i
            b, c, d = a + 1, a + n + 2, a + n + 1
            triangles += [(a, b, c), (a, c, d)] if random.uniform() < 0.5 else [(a, b, d), (b, c, d)]
    return points, np.array(triangles)


def write_prisms(path, points, triangles, depth):
    """The triangles, counter-clockwise, extruded along z by one cell: patches sides, zMin, zMax (empty)."""
    sides = {}
    for cell, t in enumerate(triangles):
        for a, b in zip(t, np.roll(t, -1)):
            sides.setdefault((min(a, b), max(a, b)), []).append((cell, a, b))
    n = len(points)
    inner = sorted((s[0][0], s[1][0], s[0][1], s[0][2]) for s in sides.values() if len(s) == 2)
    outer = [s[0] for s in sides.values() if len(s) == 1]
    faces = [(a, b, b + n, a + n) for _, _, a, b in inner]
    faces += [(a, b, b + n, a + n) for _, a, b in outer]
    faces += [tuple(t[::-1]) for t in triangles] + [tuple(t + n) for t in triangles]
    owner = [i[0] for i in inner] + [o[0] for o in outer] + 2*list(range(len(triangles)))
    z = np.repeat([0, depth], n)
    xyz = np.column_stack([np.tile(points, (2, 1)), z])

    folder = path / 'constant/polyMesh'
    folder.mkdir(parents=True)

    def write(name, kind, rows):
        head = f'FoamFile {{ version 2.0; format ascii; class {kind}; location "constant/polyMesh"; object {name}; }}\n'
        (folder / name).write_text(head + f'{len(rows)}\n(\n' + '\n'.join(rows) + '\n)\n')

    write('points', 'vectorField', [f'({a!r} {b!r} {c!r})' for a, b, c in xyz.tolist()])
    write('faces', 'faceList', [f'{len(f)}({" ".join(map(str, f))})' for f in faces])
    write('owner', 'labelList', [str(o) for o in owner])
    write('neighbour', 'labelList', [str(i[1]) for i in inner])
    start, patches = len(inner), []
    for name, kind, size in (('sides', 'wall', len(outer)), ('zMin', 'empty', len(triangles)),
                             ('zMax', 'empty', len(triangles))):
        patches.append(f'{name} {{ type {kind}; nFaces {size}; startFace {start}; }}')
        start += size
    write('boundary', 'polyBoundaryMesh', patches)


def shares_of_triangles(points, triangles, inside, m=24):
    """Share of each triangle where inside(x, y), by samples."""
    i, j = np.meshgrid(np.arange(m), np.arange(m))
    # Centres of the m^2 small triangles, of both kinds
    u = np.concatenate([((i + 1/3)/m)[i + j < m], ((i + 2/3)/m)[i + j < m - 1]])
    v = np.concatenate([((j + 1/3)/m)[i + j < m], ((j + 2/3)/m)[i + j < m - 1]])
    a, b, c = (points[triangles[:, k]][:, None, :] for k in range(3))
    x = a + (b - a)*u[None, :, None] + (c - a)*v[None, :, None]
    return inside(x[..., 0], x[..., 1]).mean(axis=1)


def areas_of_triangles(points, triangles):
    """Areas."""
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return 0.5*((b - a)[:, 0]*(c - a)[:, 1] - (b - a)[:, 1]*(c - a)[:, 0])


def move_corners(path, lower, upper, by, seed=2):
    """Move the points inside a box by up to so much: the faces of its cells are no longer flat."""
    name = path / 'constant/polyMesh/points'
    text = name.read_text()
    head, body = re.split(r'\n\d+\s*\n\(\n', text, maxsplit=1)
    rows = body[:body.rindex('\n)')].split('\n')
    x = np.array([row.strip('()').split() for row in rows if row.startswith('(')], dtype=float)
    inside = ((x > np.array(lower) + by) & (x < np.array(upper) - by)).all(axis=1)
    x += inside[:, None]*np.random.default_rng(seed).uniform(-by, by, x.shape)
    lines = '\n'.join(f'({a!r} {b!r} {c!r})' for a, b, c in x.tolist())
    name.write_text(f'{head}\n{len(x)}\n(\n{lines}\n)\n')


WEDGE = '''FoamFile {{ version 2.0; format ascii; class dictionary; object blockMeshDict; }}
scale {length};
vertices ((0 0 0) ({x} -{y} 0) ({x} {y} 0) (0 0 1) ({x} -{y} 1) ({x} {y} 1));
blocks (hex (0 1 2 0 3 4 5 3) ({n} 1 {n}) simpleGrading (1 1 1));
boundary
(
    front {{ type wedge; faces ((0 1 4 3)); }}
    back {{ type wedge; faces ((0 3 5 2)); }}
    outer {{ type patch; faces ((1 2 5 4)); }}
    bottom {{ type patch; faces ((0 2 1 0)); }}
    top {{ type patch; faces ((3 4 5 3)); }}
    axis {{ type empty; faces ((0 3 3 0)); }}
);
'''


def wedge(n, length):
    """A blockMeshDict of a wedge about z, of five degrees."""
    half = np.radians(2.5)
    return WEDGE.format(n=n, length=length, x=repr(float(np.cos(half))), y=repr(float(np.sin(half))))
