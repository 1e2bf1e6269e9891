#!/usr/bin/python3
"""Draw the spheres of the run, coloured by speed: spout.png, and the animation spout.gif. Usage: draw.py

Without Pillow there are frames/*.png instead of the animation. Needs numpy and matplotlib.
"""
import os
import sys

import matplotlib
matplotlib.use('Agg')
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.animation import PillowWriter
from matplotlib.collections import EllipseCollection

os.chdir(os.path.dirname(os.path.abspath(__file__)))

WIDTH, HEIGHT, JET = 90, 180, (40, 50)      # of the picture, and the slot [mm]
FASTEST = 1.0                               # of the colours [m/s]
SLOWER = 8                                  # the animation runs this many times slower than the spheres


def times():
    """Folders with spheres, in order of time."""
    found = [name for name in os.listdir('.') if name[0].isdigit() and os.path.isfile(f'{name}/particles.csv')]
    if not found:
        sys.exit('No results: run Allrun first')
    return sorted(found, key=float)


def spheres(name):
    with open(f'{name}/particles.csv') as stream:
        lines = [line for line in stream if not line.startswith('#')]
    return np.genfromtxt(lines, delimiter=',', names=True, dtype=None, encoding=None)


class Frame:
    """The box seen from the front. show(time) puts in its spheres, the nearest last."""

    def __init__(self, axes):
        axes.set(xlim=(-1.5, WIDTH + 1.5), ylim=(-5, HEIGHT), aspect='equal')
        axes.axis('off')
        axes.plot([0, 0, JET[0]], [HEIGHT, 0, 0], '-', color='0.3', lw=1.5)
        axes.plot([JET[1], WIDTH, WIDTH], [0, 0, HEIGHT], '-', color='0.3', lw=1.5)
        self.axes, self.balls = axes, None
        self.title = axes.text(WIDTH/2, HEIGHT - 2, '', ha='center', va='top', fontsize=11, color='0.2')
        self.arrow = axes.annotate('', (WIDTH/2, 0.5), (WIDTH/2, -5), arrowprops={'arrowstyle': '-|>', 'color': 'tab:red'})

    def show(self, name):
        s = spheres(name)
        s = s[np.argsort(-s['y'])]
        speed = np.sqrt(s['vx']**2 + s['vy']**2 + s['vz']**2)
        d = 1e3*s['d']
        if self.balls:
            self.balls.remove()
        self.balls = EllipseCollection(
            d, d, np.zeros(len(s)), units='x', offsets=1e3*np.column_stack([s['x'], s['z']]),
            transOffset=self.axes.transData, array=speed, cmap='viridis', edgecolors=(0, 0, 0, 0.45), linewidths=0.3)
        self.balls.set_clim(0, FASTEST)
        self.axes.add_collection(self.balls)
        self.title.set_text(f't = {float(name):.2f} s')
        self.arrow.set_visible(float(name) > 0.15)


def bar(figure, frames):
    figure.colorbar(frames[0].balls, ax=[f.axes for f in frames], shrink=0.6, pad=0.02, extend='max',
                    label='speed [m/s]')


def main():
    names = times()
    chosen = [min(names, key=lambda n: abs(float(n) - t)) for t in (0.15, 0.2, 0.3, float(names[-1]))]
    figure, axes = plt.subplots(1, 4, figsize=(12, 5.4), constrained_layout=True)
    frames = [Frame(a) for a in axes]
    for frame, name in zip(frames, chosen):
        frame.show(name)
    bar(figure, frames)
    figure.savefig('spout.png', dpi=130)

    figure, axes = plt.subplots(figsize=(4.4, 6.6), constrained_layout=True)
    frame = Frame(axes)
    frame.show(names[0])
    bar(figure, [frame])
    if PillowWriter.isAvailable():
        step = float(names[-1])/max(len(names), 1)
        writer = PillowWriter(fps=1/(SLOWER*step))
        with writer.saving(figure, 'spout.gif', dpi=80):
            for name in names:
                frame.show(name)
                writer.grab_frame()
    else:
        os.makedirs('frames', exist_ok=True)
        for k, name in enumerate(names):
            frame.show(name)
            figure.savefig(f'frames/{k:04d}.png', dpi=80)
        print('No Pillow (Debian package python3-pil): frames in frames/ instead of spout.gif')


if __name__ == '__main__':
    main()
