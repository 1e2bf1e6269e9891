"""Cyclic, plane (empty) and wedge meshes, with every void fraction model, smoothed and not: volume and symmetry."""
import numpy as np
import pytest

from test_axisymmetric import H, R, WedgeCase
from test_refinement import MODELS
from dewCase import SIDES, quoted
from fluidCase import FluidCase
from test_exchange import CONTACTS, GLASS

ASCII = {'writeFormat': 'ascii', 'writePrecision': 17}
SMOOTH = {'plain': {}, 'smoothed': {'smoothing': {'type': 'diffusion', 'length': 1.5e-3}}}


class PlaneCase(FluidCase):
    """A box with one cell and empty patches along z."""

    def write_block_mesh(self):
        super().write_block_mesh()
        path = self.path / 'system/blockMeshDict'
        head, *sides = path.read_text().split('type wall;')
        path.write_text(head + ''.join(('type empty;' if before.rstrip().endswith(('zMin\n    {', 'zMax\n    {')) or
                                        'zM' in before.split('}')[-1] else 'type wall;') + after
                                       for before, after in zip([head, *sides], sides)))

    def write_field(self, name, value):
        self.patches[name] = {'zMin': {'type': 'empty'}, 'zMax': {'type': 'empty'}}
        super().write_field(name, value)


def held(case, x, void, smooth, d=6e-4):
    """One step of spheres that go slowly through a fluid: the ledger's volumes and momentum; alphac."""
    case.control.update(deltaT=1e-3, endTime=2e-3, writeInterval=2, **ASCII)
    case.properties = {
        'engine': 'liggghts', 'output': (), 'materials': {'glass': GLASS}, 'contacts': CONTACTS,
        'insertion': {'some': {'type': 'file', 'file': quoted('constant/particles.csv'), 'material': 'glass'}},
        'coupling': {**case.coupling('SchillerNaumann'), 'voidFraction': MODELS[void], **SMOOTH[smooth]}}
    case.particles({'x': x[:, 0], 'y': x[:, 1], 'z': x[:, 2], 'd': d, 'vx': 0.0, 'vy': 0.0, 'vz': 0.0})
    case.mesh()
    done = case.run('cfdDemFoam')
    assert done.code == 0, done.output[-2500:]
    ledger = case.ledger()
    assert len(ledger) == 2 and np.all(ledger.clipped == 0) and np.all(ledger.outside == 0)
    assert np.abs(ledger.represented/ledger.held - 1).max() < 1e-10
    assert np.abs(ledger.held/(len(x)*np.pi/6*d**3) - 1).max() < 1e-12
    received, lost = (np.stack([ledger[k + c] for c in 'xyz']) for k in 'rl')
    assert (np.linalg.norm(received - lost, axis=0)/ledger.scale).max() < 1e-8
    return case.field('alphac', case.times()[-1])


@pytest.mark.parametrize('smooth', SMOOTH)
@pytest.mark.parametrize('void', MODELS)
def test_plane(tmp_path, void, smooth):
    """Three spheres, one at an edge; mirrored about x = L/2 as they are."""
    case = PlaneCase(tmp_path, upper=(8e-3, 6e-3, 8e-4), cells=(8, 6, 1), gravity=(0, -9.81, 0))
    alphac = held(case, np.array([[4e-3, 3.2e-3, 4e-4], [2.3e-3, 1.6e-3, 4e-4], [5.7e-3, 1.6e-3, 4e-4]]), void, smooth)
    field = alphac.reshape(6, 8)
    assert field.min() < 0.999
    # Of points on a face one side has all: no mirror
    if void not in ('particleCentre', 'divided'):
        # What the fluid's solvers leave moves the spheres
        assert np.abs(field - field[:, ::-1]).max() < 1e-6


@pytest.mark.parametrize('smooth', SMOOTH)
@pytest.mark.parametrize('void', MODELS)
def test_cyclic(tmp_path, void, smooth):
    """A sphere just inside each face of a cyclic pair, and its copy half a period on: the same alphac there."""
    case = FluidCase(tmp_path, upper=(10e-3,)*3, cells=(8,)*3, cyclic='xyz', tolerance=1e-12)
    x = np.array([[1e-4, 9.8e-3, 2.3e-3], [5.1e-3, 9.8e-3, 2.3e-3]])
    field = held(case, x, void, smooth).reshape(8, 8, 8)
    assert field.min() < 0.999
    assert np.abs(field - np.roll(field, 4, axis=2)).max() < 1e-8


@pytest.mark.parametrize('smooth', SMOOTH)
@pytest.mark.parametrize('void', [m for m in MODELS if m != 'exactOverlap'])
def test_wedge(tmp_path, void, smooth):
    """Spheres in all of space, one on the axis: what the whole ring represents."""
    case = WedgeCase(tmp_path)
    a = np.arange(6) * 1.1
    x = np.stack([0.7 * a / a.max() * R * np.cos(a), 0.7 * a / a.max() * R * np.sin(a), 0.5 * H + 3e-4 * a], axis=1)
    held(case, x, void, smooth)
