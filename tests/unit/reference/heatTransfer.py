#!/usr/bin/python3
"""Writes heatTransfer.csv: Nusselt numbers as published, with 50 digits."""
from decimal import Decimal, getcontext

getcontext().prec = 50
THIRD = Decimal(1) / 3


def ranz_marshall(re, pr):
    return 2 + Decimal('0.6') * re.sqrt() * pr ** THIRD


def li_mason(re, pr, eps):
    voidage = eps ** Decimal('3.5')
    if re > 1500:
        return 2 + Decimal('0.000045') * voidage * re ** Decimal('1.8')
    if re > 200:
        return (2 + Decimal('0.5') * voidage * re.sqrt() * pr ** THIRD
                + Decimal('0.02') * voidage * re ** Decimal('0.8') * pr ** THIRD)
    return 2 + Decimal('0.6') * voidage * re.sqrt() * pr ** THIRD


def gunn(re, pr, eps):
    re = eps * re
    return ((7 - 10 * eps + 5 * eps ** 2) * (1 + Decimal('0.7') * re ** Decimal('0.2') * pr ** THIRD)
            + (Decimal('1.33') - Decimal('2.4') * eps + Decimal('1.2') * eps ** 2) * re ** Decimal('0.7') * pr ** THIRD)


def acrivos_taylor(re, pr):
    """Acrivos and Taylor's expansion for Pe < 1; beyond it the same polynomial."""
    pe = re * pr
    logarithm = pe.ln() if pe else 0
    return 2 + pe / 2 + pe ** 2 / 4 * logarithm + Decimal('0.03404') * pe ** 2 + pe ** 3 / 16 * logarithm


print('# Nusselt numbers as published (python3 heatTransfer.py), 50 digits: Ranz & Marshall 1952, Li & Mason 2000, n 3.5,')
print('# Gunn 1978, Acrivos & Taylor 1962')
print('# Re, Pr, eps, RanzMarshall, LiMason, Gunn, AcrivosTaylor')
for pr in '0.7165', '1.72', '70.1':
    for eps in '0.4436', '1':
        for re in '0', '1e-6', '1', '33.1', '199.999', '200', '200.001', '1384', '1500', '1500.001', '20000':
            given = [Decimal(float(text)) for text in (re, pr, eps)]
            print(f'{re},{pr},{eps},{float(ranz_marshall(*given[:2]))!r},{float(li_mason(*given))!r},'
                  f'{float(gunn(*given))!r},{float(acrivos_taylor(*given[:2]))!r}')
