#!/usr/bin/python3
"""Writes forces.csv: drag on one particle from the laws as published, with 50 digits.

The laws of beds are taken per volume of bed, beta [kg/m3/s] in the momentum equation of model A, and divided among the
n = (1 - eps)/V particles in it; eps 1 is the limit, 1 - eps = 1e-90. Each row has its velocity from a Reynolds number.
"""
from decimal import Decimal, getcontext

getcontext().prec = 50
PI = Decimal('3.14159265358979323846264338327950288419716939937510')


def number(text):
    """What the test's program reads for this text."""
    return Decimal(float(text))


def cd_single(re):
    return 24 / re * (1 + Decimal('0.15') * re ** Decimal('0.687')) if re <= 1000 else Decimal('0.44')


def cd_dallavalle(re):
    return (Decimal('0.63') + Decimal('4.8') / re.sqrt()) ** 2


def beta_wen_yu(s, eps, d, rho, mu, u):
    return Decimal('0.75') * cd_single(eps * rho * u * d / mu) * eps * s / d * rho * u * eps ** Decimal('-2.65')


def beta_ergun(s, eps, d, rho, mu, u):
    return 150 * s * s * mu / (eps * d * d) + Decimal('1.75') * s * rho * u / d


def beta_gidaspow(s, eps, *flow):
    return (beta_ergun if eps < number('0.8') else beta_wen_yu)(s, eps, *flow)


def cd_haider_levenspiel(re):
    return 24 / re * (1 + Decimal('0.1806') * re ** Decimal('0.6459')) + Decimal('0.4251') / (1 + Decimal('6880.95') / re)


def beta_koch_hill(s, eps, d, rho, mu, u):
    f0 = 10 * s / eps ** 3
    if s < number('0.4'):
        f0 = ((1 + 3 * (s / 2).sqrt() + Decimal(135) / 64 * s * s.ln() + Decimal('16.14') * s)
              / (1 + Decimal('0.681') * s - Decimal('8.48') * s ** 2 + Decimal('8.16') * s ** 3))
    f3 = Decimal('0.0673') + Decimal('0.212') * s + Decimal('0.0232') / eps ** 5
    re_radius = rho * eps * u * (d / 2) / mu
    return 18 * mu * eps ** 2 * s / d ** 2 * (f0 + f3 * re_radius)


def beta_beetstra(s, eps, d, rho, mu, u):
    re = rho * eps * u * d / mu
    f = (10 * s / eps ** 2 + eps ** 2 * (1 + Decimal('1.5') * s.sqrt())
         + Decimal('0.413') * re / (24 * eps ** 2) * (1 / eps + 3 * eps * s + Decimal('8.4') * re ** Decimal('-0.343'))
         / (1 + 10 ** (3 * s) * re ** (-(1 + 4 * s) / 2)))
    return 18 * mu * eps * s / d ** 2 * f


def beta_tenneti(s, eps, d, rho, mu, u):
    """The force with the pressure gradient in it, all of which the n particles of a volume of bed bear; model A leaves
    the share s to the pressure."""
    re = rho * eps * u * d / mu
    f = ((1 + Decimal('0.15') * re ** Decimal('0.687')) / eps ** 3
         + Decimal('5.81') * s / eps ** 3 + Decimal('0.48') * s ** (Decimal(1) / 3) / eps ** 4
         + s ** 3 * re * (Decimal('0.95') + Decimal('0.61') * s ** 3 / eps ** 2))
    n = s / (PI / 6 * d ** 3)
    gradient = n * 3 * PI * mu * d * eps * u * f
    return (gradient - s * gradient) / u


def beta_darcy(s, eps, d, rho, mu, u):
    gradient = 180 * mu * s ** 2 / (d ** 2 * eps ** 3) * (eps * u)
    return (gradient - s * gradient) / u


def forces(eps, d, rho, mu, u):
    frontal = PI * (d / 2) ** 2
    volume = 4 * PI / 3 * (d / 2) ** 3
    re_single = rho * u * d / mu
    superficial = eps * u
    re = rho * superficial * d / mu
    chi = Decimal('3.7') - Decimal('0.65') * (-(Decimal('1.5') - re.log10()) ** 2 / 2).exp()

    yield 6 * PI * mu * (d / 2) * u
    yield cd_single(re_single) * frontal * rho * u * u / 2
    yield cd_dallavalle(re) * frontal * rho * superficial ** 2 / 2 * eps ** -chi
    solid = 1 - eps if eps < 1 else Decimal('1e-90')
    for beta in (beta_wen_yu, beta_ergun, beta_gidaspow, beta_koch_hill, beta_beetstra, beta_tenneti):
        yield beta(solid, eps, d, rho, mu, u) * u / (solid / volume)
    yield beta_darcy(solid, eps, d, rho, mu, u) * u / (solid / volume) if eps < 1 else Decimal(0)
    yield cd_dallavalle(re_single) * frontal * rho * u * u / 2
    yield cd_haider_levenspiel(re_single) * frontal * rho * u * u / 2


print('# Drag [N] as published (python3 forces.py): Stokes 1851, Schiller & Naumann 1933, Di Felice 1994, Wen & Yu 1966,')
print('# Ergun 1952, Gidaspow 1994, Koch & Hill 2001, Beetstra et al. 2007, Tenneti et al. 2011, Carman 1937, Dallavalle 1948,')
print('# Haider & Levenspiel 1989; those of beds from beta of a volume of bed, 50 digits')
print('# eps, d [m], rho [kg/m3], mu [Pa s], slip [m/s], Stokes, SchillerNaumann, DiFelice, WenYu, Ergun, Gidaspow,'
      ' KochHill, Beetstra, Tenneti, Darcy, Dallavalle, HaiderLevenspiel')

# Powers of two: Re is 1000 exactly, on the branch point
WATER = ('1e-3', '1000', '1e-3')
AIR = ('2e-4', '1.2', '1.8e-5')
EXACT = ('0.0009765625', '1', '0.0009765625')
rows = [(eps, *WATER, u) for eps in ('0.4', '0.6', '0.600001', '0.799999', '0.8', '0.800001', '0.95', '1')
        for u in ('1e-9', '1e-4', '0.03', '0.9', '5')]
rows += [(eps, *AIR, u) for eps in ('0.45', '0.79', '0.81', '0.99') for u in ('1e-3', '0.5', '20')]
rows += [('1', *EXACT, u) for u in ('999.9', '1000', '1000.1')]
rows += [('0.5', *EXACT, u) for u in ('999.9', '1000', '1000.1', '1999.9', '2000', '2000.1')]
for row in rows:
    print(','.join(row + tuple(repr(float(force)) for force in forces(*map(number, row)))))
