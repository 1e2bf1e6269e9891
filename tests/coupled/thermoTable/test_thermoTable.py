"""thermoTable: what it prints and writes, of species by name and of the mixtures of a case, and what it refuses."""
import csv
import importlib.util

import pytest

from dewCase import environment, run_command

LIQUIDS = """
liquids { ethanol { type library; } water { type library; } }
equilibrium { activity { type vanLaar; ethanol-water { A12 1.6798; A21 0.9227; } } }
"""

GAS = """
type idealGas;
p0 101325;
carrier { type mixture; x { N2 0.79; O2 0.21; } }
vapours { water { type steam; } }
diffusivity { type Fuller; }
"""


def table(case, *options):
    """Rows of the table as dictionaries"""
    done = run_command(['thermoTable', *options, '-csv', 'table.csv'], case, 60)
    assert done.code == 0, done.output[-2000:]
    with open(case / 'table.csv') as f:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(f)], done.output


@pytest.fixture
def case(tmp_path):
    (tmp_path / 'constant').mkdir()
    (tmp_path / 'constant' / 'liquidProperties').write_text(LIQUIDS)
    (tmp_path / 'constant' / 'gasProperties').write_text(GAS)
    return tmp_path


def test_liquid_by_name(tmp_path):
    """Ethanol: NIST WebBook, 112.4 J/mol/K at 298.15 K; boiling at 351.4 K"""
    rows, printed = table(tmp_path, '-liquid', 'ethanol', '-T', '(298.15 351.4 2)')
    assert [row['T'] for row in rows] == pytest.approx([298.15, 351.4])
    assert rows[0]['Cp'] == pytest.approx(112.4/46.069e-3, rel=0.01)
    assert rows[1]['pSat'] == pytest.approx(101325, rel=0.01)
    assert list(rows[0]) == ['T', 'rho', 'mu', 'Cp', 'kappa', 'hv', 'sigma', 'pSat']
    assert 'pSat' in printed and 'extrapolated' not in printed


def test_one_property_out_of_range(tmp_path):
    rows, printed = table(tmp_path, '-liquid', 'water', '-T', '260', '-property', 'sigma')
    assert list(rows[0]) == ['T', 'sigma']
    assert 'extrapolated' in printed and '273.16' in printed


def test_gas_by_name(tmp_path):
    """Nitrogen at 300 K: Incropera & DeWitt, table A.4"""
    rows, _ = table(tmp_path, '-gas', 'N2', '-T', '300')
    assert rows[0]['mu'] == pytest.approx(178.2e-7, rel=0.02)
    assert rows[0]['kappa'] == pytest.approx(25.9e-3, rel=0.03)


def test_equilibrium(case):
    """By van Laar's equation and NSRDS pressures: 356.42 K and 0.533 over x = 0.2, an independent calculation"""
    rows, _ = table(case, '-VLE', '-across', '6')
    assert [row['x.ethanol'] for row in rows] == pytest.approx([0, .2, .4, .6, .8, 1])
    assert rows[1]['Tboil'] == pytest.approx(356.42, abs=0.006)
    assert rows[1]['y.ethanol'] == pytest.approx(0.533, abs=0.0006)
    assert rows[1]['y.ethanol'] + rows[1]['y.water'] == pytest.approx(1)


def test_mixtures(case):
    rows, _ = table(case, '-phase', 'liquid', '-x', '(0.25 0.75)')
    assert rows[0]['gamma.ethanol'] > 1.5 and rows[0]['D.water'] > 1e-10

    # Ideal gas: p W/(R T) by hand
    rows, _ = table(case, '-phase', 'gas', '-x', '(0.05 0.02)', '-T', '300')
    W = 0.05*46.069e-3 + 0.02*18.015e-3 + 0.93*(0.79*28.0134e-3 + 0.21*31.9988e-3)
    assert rows[0]['rho'] == pytest.approx(101325*W/(8.314462618*300), rel=1e-6)


def test_picture(tmp_path, monkeypatch):
    # Another interpreter that comes first in PATH must not be taken
    other = tmp_path / 'bin' / 'python3'
    other.parent.mkdir()
    other.write_text('#!/bin/sh\nexit 1\n')
    other.chmod(0o755)
    monkeypatch.setitem(environment(), 'PATH', f'{other.parent}:{environment()["PATH"]}')
    _, printed = table(tmp_path, '-liquid', 'water', '-T', '(280 360 5)', '-plot', 'table.png')
    if importlib.util.find_spec('matplotlib'):
        assert (tmp_path / 'table.png').stat().st_size > 1000
    else:
        assert 'No picture' in printed


def test_list(tmp_path):
    done = run_command(['thermoTable', '-list'], tmp_path, 60)
    assert done.code == 0
    for name in ('C2H5OH ethanol', 'CO2', 'NRTL', 'CH3CO'):
        assert name in done.output


@pytest.mark.parametrize('options, words', [
    (['-liquid', 'mercury'], ('mercury', 'C2H5OH')),
    (['-gas', 'xenon'], ('xenon', 'N2')),
    (['-liquid', 'water', '-property', 'colour'], ('colour', 'sigma')),
    (['-liquid', 'water', '-T', '700'], ('700 K', '647')),
    (['-liquid', 'water', '-T', '(300 280 5)'], ('(from to rows)',)),
    (['-liquid', 'water', '-plot', 'a.png'], ('-csv',)),
    (['-phase', 'solid'], ('solid', 'liquid or gas')),
    (['-phase', 'liquid', '-x', '(0.5 0.2)'], ('sum 1',)),
    (['-phase', 'gas', '-x', '(0.9 0.2)'], ('the carrier is the rest',)),
    (['-phase', 'gas', '-across', '5'], ('two liquids',)),
])
def test_refused(case, options, words):
    done = run_command(['thermoTable', *options], case, 60)
    assert done.code != 0
    for word in words:
        assert word in done.output


def test_no_case(tmp_path):
    done = run_command(['thermoTable'], tmp_path, 60)
    assert done.code != 0 and 'liquidProperties' in done.output and '-liquid or -gas' in done.output
