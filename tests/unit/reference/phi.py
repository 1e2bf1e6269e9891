#!/usr/bin/python3
"""Writes phi.csv: phi1(h) = (1 - exp(-h))/h and phi2(h) = (h - 1 + exp(-h))/h^2 from 60-digit arithmetic."""
from decimal import Decimal, getcontext

getcontext().prec = 60

print("# h, phi1(h), phi2(h): python3 phi.py, decimal arithmetic with 60 digits")
for text in ("1e-12", "1e-8", "1e-5", "1e-4", "1e-3", "0.01", "0.03", "0.049", "0.05", "0.051", "0.1", "0.3", "1", "2",
             "5", "10", "30", "100", "1000"):
    h = Decimal(float(text))
    e = (-h).exp()
    print(f"{float(text)!r},{float((1 - e) / h)!r},{float((h - 1 + e) / h**2)!r}")
