#!/usr/bin/python3
"""Writes sphericalCap.csv: V/a^3 = pi (2 - 3 cos + cos^3)/(3 sin^3) from 80-digit arithmetic."""
from decimal import Decimal, getcontext

getcontext().prec = 80
PI = Decimal("3.14159265358979323846264338327950288419716939937510582097494459230781640628620899")


def sin_cos(x):
    """By their series."""
    term, sums, n = Decimal(1), [Decimal(0), Decimal(0)], 0
    while abs(term) > Decimal("1e-85"):
        sums[n % 2] += term if n % 4 < 2 else -term
        n += 1
        term *= x / n
    return sums[1], sums[0]


print("# theta [rad], V/a^3: python3 sphericalCap.py, decimal arithmetic with 80 digits")
for text in ("1e-6", "1e-4", "0.01", "0.1", "0.3", "0.7", "1", "1.3", "1.5707963", "1.8", "2.3", "2.9", "3.1", "3.1315"):
    theta = Decimal(float(text))
    s, c = sin_cos(theta)
    print(f"{float(text)!r},{float(PI * (2 - 3 * c + c**3) / (3 * s**3))!r}")
