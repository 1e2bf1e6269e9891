"""The boundary condition substrateLayer under a film of water that does not evaporate, beside closed forms.

Two half-infinite bodies in contact (Carslaw & Jaeger, section 2.15): the temperature of the contact is
(e1 T1 + e2 T2)/(e1 + e2), e = (kappa rho Cp)^(1/2), at all times. A steady layer: resistances in a row.
"""
import re

import numpy as np
import pytest

from evaporationCase import WATER, EvaporationCase

GLASS = {'rho': 2500.0, 'Cp': 840.0, 'kappa': 1.0}
T_WATER, T_SOLID, FILM = 298.15, 318.15, 0.5e-3


class FilmOnSolid(EvaporationCase):
    def __init__(self, path, layer, n=64, T_outer=None, **control):
        super().__init__(path, a=1e-3, n=n, film=FILM, **control)
        self.change.update(evaporation={'type': 'none'}, energy=True)
        self.with_vapour = False
        self.substrate_T = {'type': 'substrateLayer', **GLASS, 'value': f'uniform {T_WATER}', **layer}
        self.outer_T = {'type': 'fixedValue', 'value': f'uniform {T_outer or T_WATER}'}

    def wall(self, time):
        text = (self.path / str(time) / 'T').read_text()
        patch = re.search(r'substrate\s*\{(.*?)\n    \}', text, re.S)[1]
        return float(re.search(r'\bvalue\s+(?:nonuniform List<scalar>\s*\d+\s*\(\s*|uniform )([\d.e+-]+)', patch)[1])


def test_contact_of_two_bodies(tmp_path):
    """The temperature of the contact, by 0.5 % of the difference, over ten times in time; in the fluid's equation
    without a lag: the first step is as good."""
    case = FilmOnSolid(tmp_path, {'thickness': 1e-3, 'nCells': 100, 'Tstart': T_SOLID, 'below': {'type': 'insulated'}},
                       endTime=0.05, deltaT=5e-4, writeInterval=10)
    case.prepare()
    case.go()
    e1 = np.sqrt(WATER['kappa'] * WATER['rho'] * WATER['Cp'])
    e2 = np.sqrt(GLASS['kappa'] * GLASS['rho'] * GLASS['Cp'])
    exact = (e1 * T_WATER + e2 * T_SOLID) / (e1 + e2)
    for time in ('0.005', '0.01', '0.05'):
        assert case.wall(time) == pytest.approx(exact, abs=0.005 * (T_SOLID - T_WATER)), time


def test_steady_resistances(tmp_path):
    """Solid, film and gas in a row, to 1e-6 of the difference."""
    case = FilmOnSolid(tmp_path, {'thickness': 0.5e-3, 'below': {'type': 'temperature', 'T': T_SOLID}}, n=4,
                       endTime=4000, deltaT=1000, writeInterval=4)
    case.prepare()
    case.go()
    parts = 0.5e-3 / GLASS['kappa'], FILM / WATER['kappa'], 3.5e-3 / 0.026
    exact = T_SOLID - (T_SOLID - T_WATER) * parts[0] / sum(parts)
    assert case.wall(4000) == pytest.approx(exact, abs=1e-6 * (T_SOLID - T_WATER))


def test_restart(tmp_path):
    """In two parts as in one: the layer is written with the field."""
    layer = {'thickness': 1e-3, 'nCells': 10, 'Tstart': T_SOLID, 'below': {'type': 'insulated'}}
    case = FilmOnSolid(tmp_path, layer, n=16, endTime=0.04, deltaT=1e-3, writeInterval=20)
    case.prepare()
    case.go()
    whole = case.wall('0.04')
    again = FilmOnSolid(tmp_path, layer, n=16, startFrom='startTime', startTime=0.02, endTime=0.04, deltaT=1e-3, writeInterval=20)
    again.write_dict('system/controlDict', again.control)
    again.go()
    assert again.wall('0.04') == pytest.approx(whole, abs=1e-8)


@pytest.mark.parametrize('change, words', [
    ({'thickness': 0}, ('thickness', '0/T')), ({'kappa': -1}, ('kappa',)), ({'nCells': 0}, ('nCells',)),
    ({'below': {'type': 'cold'}}, ('cold', 'insulated', 'temperature')),
    ({'below': {'type': 'temperature'}}, ('T',)), ({'below': {'type': 'insulated', 'T': 300}}, ('T', 'below'))],
    ids=['thickness', 'kappa', 'nCells', 'kind', 'missing', 'unread'])
def test_refused(tmp_path, change, words):
    case = FilmOnSolid(tmp_path, {'thickness': 1e-3, 'below': {'type': 'insulated'}, **change}, n=4)
    case.prepare()
    text = case.message()
    for word in words:
        assert word in text, text
