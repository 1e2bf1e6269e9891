#!/usr/bin/python3
"""Draw water and spheres of the run withSpheres: damBreak.png and the animation damBreak.gif. Usage: draw.py

Without Pillow there are frames/*.png instead of the animation. Needs numpy and matplotlib.
"""
import os
import sys

import matplotlib

matplotlib.use('Agg')
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import EllipseCollection

sys.dont_write_bytecode = True
os.chdir(os.path.dirname(os.path.abspath(__file__)))
sys.path.insert(0, '.')
from case import A, H, NX, NZ, alpha, spheres, times

RUN = 'withSpheres'


def show(ax, time):
    ax.clear()
    ax.imshow(alpha(RUN, time), origin='lower', extent=(0, NX*H*1e3, 0, NZ*H*1e3), cmap='Blues', vmin=0, vmax=1.6,
              interpolation='bilinear')
    s = spheres(RUN, time)
    s = s[np.argsort(-s['y'])]
    speed = np.sqrt(s['vx']**2 + s['vy']**2 + s['vz']**2)
    balls = EllipseCollection(1e3*s['d'], 1e3*s['d'], np.zeros(len(s)), units='x', array=speed, cmap='autumn_r',
                              offsets=1e3*np.column_stack([s['x'], s['z']]), transOffset=ax.transData, edgecolors='k',
                              linewidths=0.2)
    balls.set_clim(0, 1)
    ax.add_collection(balls)
    ax.set(xlim=(0, NX*H*1e3), ylim=(0, NZ*H*1e3), aspect='equal', xlabel='x [mm]', ylabel='z [mm]',
           title=f't = {float(time):.2f} s')


names = [t for t in times(RUN) if os.path.exists(f'runs/{RUN}/{t}/particles.csv')]
fig, axes = plt.subplots(2, 2, figsize=(10, 6.4))
for ax, wanted in zip(axes.flat, (0.05, 0.15, 0.3, 0.6)):
    show(ax, min(names, key=lambda t: abs(float(t) - wanted)))
fig.tight_layout()
fig.savefig('damBreak.png', dpi=110)

fig, ax = plt.subplots(figsize=(6.4, 4.2))
try:
    from matplotlib.animation import PillowWriter
    writer = PillowWriter(fps=12)
    with writer.saving(fig, 'damBreak.gif', 55):
        for name in names:
            show(ax, name)
            writer.grab_frame()
except ImportError:
    os.makedirs('frames', exist_ok=True)
    for k, name in enumerate(names):
        show(ax, name)
        fig.savefig(f'frames/{k:03d}.png', dpi=90)
