"""pairPotential: extremes of the energy and the sub-step against the closed forms of van der Waals and double-layer forces
(tests/colloidTheory.py), smooth and rough; its table, its picture, and what it refuses. Tolerances: six digits are printed,
the slope of the force is sampled (1 %)."""
import csv
import re

import numpy as np
import pytest

import colloidTheory
from dewCase import changed, foam_dict, run_command

K, E, NA, EPS0 = 1.380649e-23, 1.602176634e-19, 6.02214076e23, 8.8541878128e-12
T, EPS, RHO, A, PSI, D, MU = 298.15, 78.5 * EPS0, 2650.0, 1e-20, 25e-3, 1e-6, 1e-3
KAPPA = float(np.sqrt(2 * E**2 * NA / (EPS * K * T)))
MIN_GAP, CUT_OFF, ROUGH = 5e-10, 1e-7, 1e-9
SOFT = {'youngsModulus': 5e6, 'poissonsRatio': 0.3, 'density': RHO}
SOUND = {
    'materials': {'silica': SOFT, 'glass': SOFT}, 'contacts': {'tangential': 'none', 'default': {'restitution': 0.5}},
    'colloids': {'temperature': T, 'permittivity': 78.5, 'ionicStrength': 1, 'minGap': MIN_GAP, 'cutOff': CUT_OFF, 'forces': {
        'v': {'type': 'Hamaker', 'hamaker': A, 'silica.glass': {'hamaker': 2 * A}},
        'e': {'type': 'constantPotential', 'zeta': PSI}}}}


def run(path, *options, changes=None, code=0):
    (path / 'constant').mkdir(exist_ok=True)
    (path / 'constant/particleProperties').write_text(foam_dict(changed(SOUND, changes or {})) + '\n')
    done = run_command(['pairPotential', *options], path, 60)
    assert (done.code == 0) == (code == 0), done.output
    return done.output


def law_of(a, b=None, hamaker=A, s=0):
    def smooth(h):
        return tuple(v + e for v, e in zip(colloidTheory.hamaker(h, hamaker, a, b),
                                           colloidTheory.constant_potential(h, EPS, KAPPA, PSI, a, b)))
    return smooth if s == 0 else lambda h: colloidTheory.over_heights(smooth, h, s, MIN_GAP)


def zero_of_force(law, low, high):
    """Gap and energy, by bisection."""
    sign = law(low)[0] > 0
    assert sign != (law(high)[0] > 0)
    for _ in range(50):
        h = (low + high) / 2
        low, high = (h, high) if (law(h)[0] > 0) == sign else (low, h)
    return low, law(low)[1]


def check(output, name, law, low, high):
    found = [float(v) for v in re.search(name + r' at (\S+) m: (\S+) kT', output).groups()]
    h, U = zero_of_force(law, low, high)
    assert abs(found[0] / h - 1) < 1e-5 and abs(found[1] / (U / K / T) - 1) < 1e-5, (found, h, U / K / T)


@pytest.mark.parametrize('what, options, changes, law', [
    ('pair', (), {}, law_of(D/2, D/2)),
    ('sizes', ('-with', 4e-7), {}, law_of(D/2, 2e-7)),
    ('wall', ('-wall',), {}, law_of(D/2)),
    ('materials', ('-materials', '(silica glass)'), {}, law_of(D/2, D/2, 2*A)),
    ('rough', (), {'colloids/roughness': ROUGH / np.sqrt(2)}, law_of(D/2, D/2, A, ROUGH))], ids=lambda v: v if isinstance(
        v, str) else '')
def test_barrier_and_minima(tmp_path, what, options, changes, law):
    """Barrier and secondary minimum, place and height; the energy at the least gap, a minimum there."""
    output = run(tmp_path, '-d', D, *options, changes=changes)
    # Between these the forces of all cases change their sign once
    check(output, 'Barrier', law, 1e-9, 1e-8)
    check(output, 'Secondary minimum', law, 2e-8, 9e-8)
    least = re.search(r'Primary minimum at the least gap (\S+) m: (\S+) kT', output).groups()
    assert float(least[0]) == MIN_GAP and abs(float(least[1]) / (law(MIN_GAP)[1] / K / T) - 1) < 1e-5
    assert abs(float(re.search(r'Debye length (\S+) m', output).group(1)) * KAPPA - 1) < 1e-5


def test_without_barrier(tmp_path):
    output = run(tmp_path, '-d', D, changes={'colloids/forces/e/zeta': 1e-3})
    assert 'No barrier' in output and 'Barrier at' not in output and 'Primary minimum at the least gap' in output


@pytest.mark.parametrize('dynamics', [{}, {'type': 'overdamped', 'viscosity': MU}], ids=['inertial', 'overdamped'])
def test_sub_step(tmp_path, dynamics):
    """2 sqrt(m'/k) of the steepest force, m' = m/2 of a pair; without inertia 6 pi mu R/k of the steepest force that drives
    back, and 1 % of R by the largest attraction of either of a pair, longer here than its slope allows; the least of pairs and walls, of all materials."""
    output = run(tmp_path, '-d', D, changes={'dynamics': dynamics} if dynamics else {})
    R, h = D / 2, np.geomspace(MIN_GAP, CUT_OFF, 100001)
    expected = np.inf
    for b, n in ((R, 2), (None, 1)):
        F = law_of(R, b, 2*A)(h)[0]
        slope = np.gradient(F, h)
        if dynamics:
            limits = (6*np.pi*MU*R / max(-slope.min(), 1e-30), 0.01 * R * 6*np.pi*MU*R / (n * -F.min()))
        else:
            limits = (2 * np.sqrt(RHO * 4/3*np.pi * R**3 / (n * np.abs(slope).max())),)
        expected = min(expected, *limits)
    stable, proposed = (float(v) for v in re.search(r'stable below (\S+) s, proposed (\S+) s', output).groups())
    assert abs(stable / expected - 1) < 0.01
    assert abs(proposed / stable / (0.2 if dynamics else 0.1) - 1) < 1e-5


def test_table_and_picture(tmp_path):
    """Gaps from the least to the cut-off; PNG of its own kind of file."""
    output = run(tmp_path, '-d', D, '-rows', 50, '-csv', 'pair.csv', '-plot', 'pair.png')
    assert 'Wrote pair.png' in output.replace('"', '')
    picture = (tmp_path / 'pair.png').read_bytes()
    assert picture[:8] == b'\x89PNG\r\n\x1a\n' and len(picture) > 5000
    with open(tmp_path / 'pair.csv') as file:
        rows = list(csv.reader(file))
    assert rows[0] == ['h', 'U/kT', 'F'] and len(rows) == 51
    h, U, F = np.array(rows[1:], dtype=float).T
    assert abs(h[0] / MIN_GAP - 1) < 1e-8 and abs(h[-1] / CUT_OFF - 1) < 1e-8
    force, energy = law_of(D/2, D/2)(h)
    # Ten digits of a gap are written
    assert np.abs(F - force).max() < 1e-8 * np.abs(force).max()
    assert np.abs(U - energy / K / T).max() < 1e-8 * np.abs(energy / K / T).max()


@pytest.mark.parametrize('options, changes, words', [
    (('-d', 0), {}, ('-d', '0 m', 'above 0')),
    ((), {}, ('-d', 'above 0')),
    (('-d', D, '-with', -1e-6), {}, ('-with', '-1e-06', 'above 0')),
    (('-d', D, '-materials', '(silica steel)'), {}, ('steel', 'silica glass')),
    (('-d', D, '-materials', '(silica)'), {}, ('-materials', 'Give two')),
    (('-d', D, '-rows', 1), {}, ('-rows 1', '2 or more')),
    (('-d', D, '-plot', 'a.png'), {}, ('-plot', '-csv')),
    (('-d', D), {'colloids': None}, ("'colloids'", 'particleProperties')),
    (('-d', D), {'colloids/minGap': 0}, ("'minGap'", 'Give the least gap'))])
def test_refused(tmp_path, options, changes, words):
    output = run(tmp_path, *options, changes=changes, code=1)
    assert output.count('FOAM FATAL') == 1
    missing = [word for word in words if word not in output]
    assert not missing, (missing, output)


def test_no_case(tmp_path):
    done = run_command(['pairPotential', '-d', D], tmp_path, 60)
    assert done.code and 'particleProperties' in done.output and 'case directory' in done.output
