#!/usr/bin/python3
"""Writes slip.csv: Cunningham's factor with the coefficients of Davies (1945), with 50 digits."""
from decimal import Decimal, getcontext

getcontext().prec = 50

print('# Cunningham factor, Davies 1945 (python3 slip.py): 1 + (2 lambda/d) (1.257 + 0.4 exp(-1.1 d/(2 lambda)))')
print('# d [m], lambda [m], Cc')
for text in ('1e-9', '1e-8', '1e-7', '1e-6', '1e-5', '1e-4'):
    d, path = Decimal(float(text)), Decimal(float('6.6e-8'))
    slip = 2 * path / d * (Decimal('1.257') + Decimal('0.4') * (Decimal('-1.1') * d / (2 * path)).exp())
    print(f'{text},6.6e-8,{float(1 + slip)!r}')
