"""10,000 spheres fall and come to rest, beside the plain program liggghts with the same particles and laws: kinetic
energy within 1 % of its peak at all times, until it has fallen below 1 % of it. The chaotic paths differ, and demFoam
forgets the tangential spring of a contact that has ended at once (CHANGELOG.md); the energy must not."""
import re

import numpy as np

import bed
from dewCase import steps


def test_kinetic_energy_beside_the_plain_program(tmp_path):
    columns = bed.packed(tmp_path / 'packed')

    ours = bed.case(tmp_path / 'ours', columns, endTime=20000 * bed.DT)
    ours.mesh()
    done = ours.run('demFoam', timeout=300)
    assert done.code == 0, done.output
    log = steps(done.output)

    bed.write_plain(tmp_path / 'plain', columns, 'compute er all erotate/sphere\n'
                    'thermo_style custom step ke c_er\nthermo_modify norm no\nthermo 100\nrun 20000\n')
    text = bed.run_plain(tmp_path / 'plain')
    rows = np.array([[float(v) for v in m.groups()]
                     for m in re.finditer(r'^ +(\d+) +([-\d.e+]+) +([-\d.e+]+) *$', text, re.M)])
    plain = dict(zip(rows[:, 0].astype(int), rows[:, 1] + rows[:, 2]))

    energy = np.array([plain[100 * (i + 1)] for i in range(len(log))])
    peak = energy.max()
    active = np.nonzero(energy > 0.01 * peak)[0]
    assert active[-1] < len(log) - 1, 'has not come to rest'
    assert active[-1] > 20
    difference = np.abs(log['energy'] - energy)[:active[-1] + 1].max() / peak
    print(f'largest difference {100 * difference:.2f} % of the peak, rest at step {100 * active[-1]}')
    assert difference < 0.01
    assert log['particles'][-1] == bed.N
