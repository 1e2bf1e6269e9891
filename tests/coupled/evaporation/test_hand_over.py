"""A cap that has become too thin for its mesh goes on as a quasi-static one (handOver).

What evaporates and what is left are sums that go on: to round-off. The rate is that of the same cap in the same cells, but
for the place of the surface between them, which the shape has exactly and planes to (h/R)^2: 1.5 % at 8 cells a radius.
"""
import re

import numpy as np

from transportedCase import TransportedCase

RADIUS = 1e-3


def flat(path, cells, entries='', **keywords):
    """A cap of 30 degrees, .27 mm high, in cells of .125 mm; steps of the capillary limit of a weak tension."""
    path.mkdir(exist_ok=True)
    case = TransportedCase(path, theta=30, n=8, sigma=1e-4, **{'endTime': 4, 'deltaT': 4e-4, 'writeInterval': 1e9, **keywords})
    case.control.update(adjustTimeStep=True, maxCo=0.2, maxDeltaT=0.5, maxVolumeChange=0.02)
    case.mesh()
    properties = path/'constant/surfaceProperties'
    properties.write_text(properties.read_text() + f'\nhandOver {{ substrate substrate; contactRadius {RADIUS}; '
                          f'contactLine {{ type pinned; }} cells {cells}; {entries} }}\n')
    for name, old, new in (('fvSchemes', 'divSchemes\n{', 'divSchemes\n{\n    div(phi,U) Gauss upwind;'),
                           ('fvSolution', '(chi|', '(chi|pc|')):
        file = path/'system'/name
        assert old in file.read_text()
        file.write_text(file.read_text().replace(old, new))
    case._must('setLiquid')
    return case


def test_thin_cap_goes_on(tmp_path):
    case = flat(tmp_path/'cap', 2.14)
    output = case.go()
    assert output.count('The liquid is a cap') == 1
    errors = case.errors(output)
    rates = np.array(re.findall(r'; rate (\S+) kg/s', output), dtype=float)
    carried = output[:output.index('The liquid is a cap')].count('; rate ')
    assert 10 < carried < len(rates) - 3
    assert errors.max() < 1e-11
    assert abs(rates[carried]/rates[carried - 1] - 1) < 0.015
    # The whole drop, before and after
    volumes = [float(v) for v in re.findall(r'^drop: volume (\S+) m3', output, re.M)]
    evaporated = np.array(re.findall(r'^evaporated (\S+) kg', output, re.M), dtype=float)
    cap = np.pi*RADIUS**3*np.tan(np.pi/12)*(3 + np.tan(np.pi/12)**2)/6
    assert abs((cap - volumes[-1])*997/evaporated[-1] - 1) < 1e-3


def test_wrong_input(tmp_path):
    case = flat(tmp_path/'patch', 2.14)
    properties = case.path/'constant/surfaceProperties'
    text = properties.read_text()
    for old, new, words in (('substrate substrate;', 'substrate nowhere;', ('nowhere', 'substrate')),
                            (f'contactRadius {RADIUS}', 'contactRadius -1', ('contactRadius', '-1')),
                            ('contactLine { type pinned; }', '', ('contactLine',))):
        head, tail = text.split('handOver', 1)
        assert old in tail
        properties.write_text(head + 'handOver' + tail.replace(old, new))
        message = case.message()
        for word in words:
            assert word in message, message
