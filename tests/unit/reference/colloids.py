#!/usr/bin/python3
"""Writes colloids.csv: the damped spring s'' = B - h s' - q s over a unit of time, from 60-digit arithmetic.

Columns: h, q, s(1) and s'(1) for s'(0) = 1, B = 0, and s(1) for s'(0) = 0, B = 1, all with s(0) = 0; and
(2h - 4 tanh(h/2))/h^2. The solution is its power series, summed over short steps of time.
"""
from decimal import Decimal, getcontext

getcontext().prec = 120


def step(s, v, B, h, q, t):
    """Power series over a time t: s'' = B - h s' - q s."""
    before, now = s, v * t
    s, v = s + now, v
    for n in range(2, 400):
        following = ((B if n == 2 else 0) * t * t - h * t * (n - 1) * now - q * t * t * before) / (n * (n - 1))
        s, v = s + following, v + n * following / t
        before, now = now, following
    return s, v


def spring(v, B, h, q):
    parts = int(max(h, q.sqrt(), 1) / 8) + 1
    s = Decimal(0)
    for _ in range(parts):
        s, v = step(s, v, B, h, q, Decimal(1) / parts)
    return s, v


print("# h, q, s and s' of a unit of speed, s of a unit of force, (2h - 4 tanh(h/2))/h^2: python3 colloids.py")
for h_text in ("1e-6", "0.01", "0.049", "0.051", "1", "1.9", "2.1", "30", "300"):
    for q_text in ("1e-9", "1e-3", "0.5", "0.9025", "1.1025", "3", "225", "1e3", "22499", "22501", "1e5"):
        h, q = Decimal(float(h_text)), Decimal(float(q_text))
        s, v = spring(Decimal(1), Decimal(0), h, q)
        f, _ = spring(Decimal(0), Decimal(1), h, q)
        e = (-h).exp()
        rest = (2 * h - 4 * (1 - e) / (1 + e)) / h**2
        print(','.join(repr(float(x)) for x in (h, q, s, v, f, rest)))
