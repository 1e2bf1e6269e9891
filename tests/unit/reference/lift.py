#!/usr/bin/python3
"""Writes lift.csv: forces of a shear and of a spin on one sphere, and its torque, as published, with 50 digits.

Written with the radius a, as the papers have them: Saffman (1965), 6.46 mu a^2 V sqrt(G/nu), with the table of Mei
(1992), alpha = a G/V; Rubinow & Keller (1961), pi a^3 rho Omega V, with the lift coefficient of Oesterle & Bui Dinh
(1998), C_L = 0.45 + (2 Gamma - 0.45) exp(-0.05684 (2 Gamma Re)^0.4 Re^0.3) with Gamma = a Omega/V, F = C_L pi a^2 rho
V^2/2; Dennis et al. (1980), torque = M rho a^5 Omega^2/2, M = 16 pi/R or 6.45 R^-0.5 + 32.1/R with R = a^2 Omega/nu.

d, rho and mu are powers of two, so that Re is exact at the branch.
"""
from decimal import Decimal as D, getcontext

getcontext().prec = 50
PI = D('3.14159265358979323846264338327950288419716939937510')
DIAMETER, RHO, MU = D(2)**-10, D(1024), D(2)**-10
A, NU = DIAMETER / 2, MU / RHO


def saffman_mei(V, G):
    re, root = 2 * A * V / NU, (A * G / V).sqrt()
    high = D('0.3314') * root
    f = (1 - high) * (-re / 10).exp() + high if re <= 40 else D('0.0524') * (A * G / V * re).sqrt()
    return D('6.46') * MU * A**2 * V * (G / NU).sqrt() * f


def magnus(V, W):
    re, gamma = 2 * A * V / NU, A * W / V
    exponent = D('-0.05684') * (2 * gamma * re)**D('0.4') * re**D('0.3')
    cl = D('0.45') + (2 * gamma - D('0.45')) * exponent.exp()
    return cl * PI * A**2 * RHO * V**2 / 2


def torque(W):
    R = A**2 * W / NU
    low, high = 16 * PI / R, D('6.45') / R.sqrt() + D('32.1') / R
    return max(low, high) * RHO * A**5 * W**2 / 2


def main():
    with open('lift.csv', 'w') as out:
        out.write('# Lift of shear [N], of spin [N], torque [N m]: python3 lift.py, which says as published where\n'
                  '# d 2^-10 m, rho 2^10 kg/m3, mu 2^-10 Pa s; slip [m/s], vorticity, relative spin [1/s]\n')
        rows = [(re, b, rer) for re in ('1e-6', '0.1', '1', '10', '39.999', '40', '40.001', '60', '100')
                for b, rer in (('0.005', '1e-6'), ('0.1', '31.7'), ('0.4', '31.75'), ('0.2', '500'))]
        for re, b, rer in rows:
            V = float(D(re) * NU / DIAMETER)
            G, W = float(D(b) * 2 * D(V) / DIAMETER), float(D(rer) * NU / DIAMETER**2)
            values = [saffman_mei(D(V), D(G)), magnus(D(V), D(W)), torque(D(W))]
            out.write(f'{V!r},{G!r},{W!r},' + ','.join(repr(float(v)) for v in values) + '\n')


main()
