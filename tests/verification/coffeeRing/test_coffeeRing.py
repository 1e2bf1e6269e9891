"""Flow and ring of a thin drop with a pinned contact line that dries by diffusion, against lubrication theory.

Deegan et al., Phys. Rev. E 62 (2000) 756: with J ~ (1 - x^2)^(-1/2), x = r/R, and a parabolic profile the depth-averaged
velocity is R/(4 x (tf - t)) [(1 - x^2)^(-1/2) - (1 - x^2)], and the share of what was spread evenly in the drop that has
reached the contact line is [1 - (1 - t/tf)^(3/4)]^(4/3). Both are for a vanishing contact angle; 10 and 5 % are the
bounds of the comparison with a drop of 5 degrees (measured: 2 to 4 %, and -3.5 and -1 %).
"""
import numpy as np
import pytest

from evaporationCase import HALF, EvaporationCase
from fluidCase import read_field


class Drop:

    def __init__(self, path, theta=5, n=100):
        case = EvaporationCase(path, theta=theta, n=n, endTime=1e4, adjustTimeStep=True, maxVolumeChange=0.01, maxCo=1e9,
                               maxDeltaT=1e9, deltaT=0.05, writeControl='timeStep', writeInterval=5)
        case.change['evaporation'] = {'type': 'diffusion', 'stefanFlow': False}
        case.path.mkdir(exist_ok=True)
        case.tolerance = 1e-10
        case.prepare()
        case._must('postProcess', '-func', 'writeCellCentres', '-time', '0')
        case.go()
        self.R, self.times, self.u = case.a, [], []
        table = case.ledger()
        self.end = float(table.time[-1])
        C = read_field(case.path / '0/C')
        r, z = C[:, 0] / np.cos(HALF), C[:, 2]
        # Columns of the even cells within the drop
        self.x = np.unique(np.round(r[r < 1.0 * self.R] / self.R, 9))
        height = self.R / case.n
        for folder in sorted((f for f in case.path.iterdir() if f.name.replace('.', '').isdigit()),
                             key=lambda f: float(f.name)):
            if float(folder.name) == 0:
                continue
            U, alpha = read_field(folder / 'U'), read_field(folder / 'alpha.liquid')
            if len(alpha) == 1:                 # dry
                continue
            wet = (z < 12 * height) & (alpha > 0)
            column = np.searchsorted(self.x, np.round(r / self.R, 9))
            held = np.bincount(column[wet], alpha[wet], len(self.x) + 20)
            flow = np.bincount(column[wet], (alpha * U[:, 0])[wet], len(self.x) + 20)
            if (held[:len(self.x)] > 0).all():
                self.times.append(float(folder.name))
                self.u.append(flow[:len(self.x)] / held[:len(self.x)])
        self.times, self.u = np.array(self.times), np.array(self.u)

    def velocity(self, x, t):
        """Of tracers, R/s; beyond the last column with the square root of the theory"""
        k = np.clip(np.searchsorted(self.times, t), 1, len(self.times) - 1)
        w = np.clip((t - self.times[k - 1]) / (self.times[k] - self.times[k - 1]), 0, 1)
        u = (1 - w) * self.u[k - 1] + w * self.u[k]
        last = self.x[-1]
        inner = np.interp(x, np.append(0, self.x), np.append(0, u))
        return np.where(x < last, inner, u[-1] * np.sqrt((1 - last) / np.maximum(1 - x, 1e-6))) / self.R


@pytest.fixture(scope='module')
def drop(tmp_path_factory):
    return Drop(tmp_path_factory.mktemp('ring'))


@pytest.mark.parametrize('share', [0.1, 0.3, 0.5, 0.7])
def test_velocity(drop, share):
    """10 % for 0.2 < x < 0.9"""
    k = np.argmin(np.abs(drop.times - share * drop.end))
    x = drop.x[(drop.x > 0.2) & (drop.x < 0.9)]
    expected = drop.R / (4 * x * (drop.end - drop.times[k])) * ((1 - x**2)**-0.5 - (1 - x**2))
    measured = np.interp(x, drop.x, drop.u[k])
    assert np.abs(measured / expected - 1).max() < 0.1, measured / expected


def test_ring(drop):
    """Tracers that are spread evenly, in number by the height of the drop, and go with the depth-averaged velocity"""
    x = np.sqrt(np.linspace(0, 1, 2001)[1:] - 0.5 / 2000)
    h = np.sqrt(1 / np.sin(np.radians(5))**2 - x**2) - 1 / np.tan(np.radians(5))
    arrived, t = {}, 0.0
    for k in range(4000):
        dt = drop.end / 4000
        middle = np.minimum(x + 0.5 * dt * drop.velocity(x, t), 1)
        x = np.minimum(x + dt * drop.velocity(middle, t + 0.5 * dt), 1)
        t += dt
        arrived[round((k + 1) / 4000, 6)] = h[x >= 1].sum() / h.sum()
    for share, expected in ((0.5, 0.300), (0.9, 0.770)):
        assert abs(arrived[share] / expected - 1) < 0.05, (share, arrived[share])
