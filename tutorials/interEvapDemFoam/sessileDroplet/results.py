"""What a run of sessileDroplet has left, for validate and pictures. Needs numpy."""
import glob
import os
import re

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
TIME = re.compile(r'\d+(\.\d+)?(e[-+]?\d+)?')

# Contact radius, radius of the particles [m], first contact angle [degrees], by case
CASES = {'hot': (25e-6, 0.5e-6, 90), 'control': (25e-6, 0.5e-6, 90), 'hot373': (25e-6, 0.5e-6, 90),
         'room': (1e-3, 10e-6, 40)}

# Columns of postProcessing/evaporation/<start>/ledger.dat and of postProcessing/deposit/<start>/deposit.dat
LEDGER = ['time', 'evaporated', 'stored', 'out', 'rate', 'T', 'U', 'volume', 'radius', 'angle', 'height']
DEPOSIT = ['time', 'particles', 'deposited', 'rim', 'rimDeposited', 'r', 'rDeposited']


def columns(path, names):
    return np.rec.fromarrays(np.loadtxt(path, ndmin=2)[:, :len(names)].T, names=names)


class Run:
    """A run below runs/, e.g. hot or control-seed3."""

    def __init__(self, name):
        self.name = name
        self.path = f'{HERE}/runs/{name}'
        self.case = name.split('-')[0]
        self.a, self.R, self.angle = CASES[self.case]
        self.ledger = columns(f'{self.path}/postProcessing/evaporation/0/ledger.dat', LEDGER)
        self.deposit = columns(f'{self.path}/postProcessing/deposit/0/deposit.dat', DEPOSIT)
        with open(f'{self.path}/log.interEvapDemFoam') as stream:
            self.log = stream.read()
        self.dried = 'The liquid has dried' in self.log
        self.life = self.ledger.time[-1]
        self.times = sorted((t for t in os.listdir(self.path) if TIME.fullmatch(t) and float(t) > 0
                             and os.path.exists(f'{self.path}/{t}/particles.csv')), key=float)

    def particles(self, time):
        """Table of a time directory; its x, y, z are those in space."""
        return np.genfromtxt(f'{self.path}/{time}/particles.csv', delimiter=',', names=True, dtype=None,
                             encoding=None)

    def height(self, time):
        """Of the cap [m]"""
        return np.interp(float(time), np.append(0, self.ledger.time),
                         np.append(self.a*np.tan(np.radians(self.angle)/2), self.ledger.height))

    def film(self, h, r):
        """Local height [m] of a cap of height h at radius r"""
        if h <= 0:
            return 0*r
        radius = (self.a**2 + h**2)/(2*h)
        return np.where(r < self.a, h - radius + np.sqrt(np.maximum(radius**2 - r**2, 0)), 0)

    def beyond(self, time):
        """How far the farthest centre is beyond the surface where the film is thicker than a particle, and the largest
        overlaps, with the substrate and of two particles; in radii of the particles"""
        p = self.particles(time)
        h = self.height(time)
        centres = np.array([p['x'], p['y'], p['z']]).T
        r = np.hypot(p['x'], p['y'])
        inner = self.film(h, r) > 2*self.R
        out = 0.0
        if h > 2*self.R and inner.any():
            radius = (self.a**2 + h**2)/(2*h)
            distance = np.sqrt(r**2 + (p['z'] - h + radius)**2) - radius
            out = max(distance[inner].max(), 0)
        apart = np.linalg.norm(centres[:, None] - centres[None], axis=2)
        np.fill_diagonal(apart, np.inf)
        return (out/self.R, max((self.R - p['z']).max(), 0)/self.R,
                max(2*self.R - apart.min(), 0)/self.R)

    def shares(self):
        """Wall clock [s] and what took it, from the last line of progress"""
        line = re.findall(r' wall (\S+) s \((.*?)\), (\S+) s simulated per s', self.log)[-1]
        return float(line[0]), line[1], float(line[2])


def all_runs():
    """Runs that are there, in the order of their cases"""
    names = [os.path.basename(path) for path in glob.glob(f'{HERE}/runs/*')
             if os.path.exists(f'{path}/log.interEvapDemFoam')]
    order = list(CASES)
    return [Run(name) for name in sorted(names, key=lambda n: (order.index(n.split('-')[0]), n))]
