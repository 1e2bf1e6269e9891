#!/usr/bin/python3
"""Writes pairs.csv: the integral of the lubrication law over the gap, and the velocity after a step in it, from
numerical integration and root finding with 40 digits (mpmath)."""
import mpmath as mp

mp.mp.dps = 40
S_MIN, S_MAX = mp.mpf("1e-8"), mp.mpf("5e-5")


def slope(s):
    return 0 if s <= 0 or s >= S_MAX else 1 / max(s, S_MIN) - 1 / S_MAX


def integral(a, b):
    """Of the slope from a to b."""
    if a > b:
        return -integral(b, a)
    marks = sorted({a, b, *(p for p in (mp.mpf(0), S_MIN, 10 * S_MIN, 100 * S_MIN, S_MAX) if a < p < b)})
    return mp.quad(slope, marks)


def slowed(v, s, a, dt):
    low, high = min(v, mp.mpf(0)), max(v, mp.mpf(0))
    for _ in range(110):
        u = (low + high) / 2
        if u - v + a * integral(s, s + u * dt) > 0:
            high = u
        else:
            low = u
    return u


print("# s, v, a, dt, G(s) - G(sMax), v': sMin 1e-8, sMax 5e-5; python3 pairs.py")
for s, v, a, dt in [("3e-5", "-0.1", "0.01", "1e-6"), ("3e-5", "-0.1", "0.01", "1e-3"), ("1e-6", "-0.1", "0.01", "1e-6"),
                    ("1e-6", "0.1", "0.01", "1e-6"), ("1e-6", "-0.1", "10", "1e-3"), ("5e-9", "-0.02", "0.001", "1e-8"),
                    ("5e-9", "0.02", "0.001", "1e-5"), ("6e-5", "-0.3", "0.05", "1e-4"), ("-1e-8", "0.3", "0.05", "1e-4"),
                    ("2e-7", "-1", "1e-6", "1e-6"), ("4.9e-5", "1", "0.02", "1e-7")]:
    s, v, a, dt = (mp.mpf(float(t)) for t in (s, v, a, dt))
    row = (s, v, a, dt, -integral(s, S_MAX) if s < S_MAX else 0, slowed(v, s, a, dt))
    print(",".join(repr(float(x)) for x in row))
