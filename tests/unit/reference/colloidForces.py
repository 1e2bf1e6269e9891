#!/usr/bin/python3
"""Writes colloidForces.csv (law, parameters ..., gap, F, U) and HamakerConstants.csv: colloidal forces from the textbook
form of each energy with 120 digits, F by numerical differentiation, brushes and rough surfaces by numerical
integration; Lifshitz' sum term by term (mpmath). R 1e-9 ... 1e-4 m, gaps near and far."""
import mpmath as mp

mp.mp.dps = 120
M = mp.mpf
PI = mp.pi


def hamaker(h, A, R1, R2, lam):
    """Of two spheres, R2 = 0: a plate."""
    if R2:
        p, q = h * (2 * R1 + 2 * R2 + h), (2 * R1 + h) * (2 * R2 + h)
        U = -A / 6 * (2 * R1 * R2 / p + 2 * R1 * R2 / q + mp.log(p / q))
    else:
        U = -A / 6 * (R1 / h + R1 / (h + 2 * R1) + mp.log(h / (h + 2 * R1)))
    if lam:
        U *= 1 - M("5.32") * h / lam * mp.log(1 + lam / (M("5.32") * h))
    return U


def layer(h, sign, eps, kappa, Rd, p1, p2):
    """Hogg, Healy, Fuerstenau (sign 1), Wiese, Healy (-1)."""
    x = mp.exp(-kappa * h)
    return PI * eps * Rd * (2 * p1 * p2 * mp.log((1 + x) / (1 - x)) + sign * (p1**2 + p2**2) * mp.log(1 - x * x))


def superposition(h, eps, kappa, Rd, p1, p2, phi):
    return 64 * PI * eps * Rd * phi**2 * mp.tanh(p1 / phi / 4) * mp.tanh(p2 / phi / 4) * mp.exp(-kappa * h)


def born(h, A, s, Rd):
    """The plates' energy per area A s^6/(360 pi h^8), integrated."""
    return A * s**6 / (360 * PI) * 2 * PI * Rd / 7 / h**7


def hydration(h, W0, length, Rd):
    return 2 * PI * Rd * length * W0 * mp.exp(-h / length)


def wall(D, A, s, R, full):
    U = A * s**6 / 7560 * ((6 * R - D) / D**7 + (D + 8 * R) / (D + 2 * R) ** 7)
    return U - (A / 6 * (2 * R * (D + R) / (D * (D + 2 * R)) + mp.log(D / (D + 2 * R))) if full else 0)


def steric(h, kT, s, L, Rd):
    """F and U from the pressure by integration."""
    def pressure(g):
        return kT / s**3 * ((2 * L / g) ** (M(9) / 4) - (g / (2 * L)) ** (M(3) / 4))
    ends = [h, min(2 * h, (h + 2 * L) / 2), 2 * L]
    return (2 * PI * Rd * mp.quad(pressure, ends), 2 * PI * Rd * mp.quad(lambda g: (g - h) * pressure(g), ends))


def rough(x, s, hmin, law):
    """F and U of U_smooth held below hmin, averaged."""
    fm, um = -mp.diff(law, hmin), law(hmin)

    def mean(f):
        marks = [x - 12 * s + k * s / 2 for k in range(49)]
        marks += [m for m in (hmin * 2**k for k in range(12)) if marks[0] < m < marks[-1]]
        return mp.quad(lambda h: f(h) * mp.exp(-(((h - x) / s) ** 2) / 2), sorted(marks)) / (s * mp.sqrt(2 * PI))

    def force(h):
        return fm if h < hmin else -mp.diff(law, h)
    return mean(force), mean(lambda h: um + fm * (hmin - h) if h < hmin else law(h))


def media():
    """Rows of 1, 2 and 3, T."""
    known = {"air": (1, 1, "3e15", 0), "water": (80, "1.333", "3e15", "1.9e10"), "octane": ("1.95", "1.387", "3e15", 0),
             "silica": ("3.8", "1.448", "3.2e15", 0), "polystyrene": ("2.55", "1.557", "2.3e15", 0)}
    for names, T in (("water water air", 300), ("silica silica water", 298), ("polystyrene air water", 293),
                     ("octane water air", 350), ("polystyrene polystyrene water", 373)):
        yield [[M(v) for v in known[n]] for n in names.split()], M(T)


def lifshitz(rows, T):
    kT, h = M("1.380649e-23") * T, M("6.62607015e-34")

    def term(k):
        nu = 2 * PI * k * kT / h

        def e(m):
            turn = 1 if k == 0 else (1 / (1 + nu / m[3]) if m[3] else 0)
            return 1 + (m[0] - m[1] ** 2) * turn + (m[1] ** 2 - 1) / (1 + (nu / m[2]) ** 2)
        e1, e2, e3 = (e(m) for m in rows)
        return (e1 - e3) / (e1 + e3) * (e2 - e3) / (e2 + e3)
    last = 20000
    total = term(0) / 2 + mp.fsum(term(k) for k in range(1, last + 1))
    total += mp.quad(lambda u: term((last + M("0.5")) / u) * (last + M("0.5")) / u**2, [0, 1])
    return M(3) / 2 * kT * total


def text(row):
    return ",".join(mp.nstr(M(v), 17) for v in row) + "\n"


def main():
    out = []

    def add(number, law, parameters, gaps):
        # What C++ reads: the nearest double
        parameters = [M(float(p)) for p in parameters]
        for h in (M(float(g)) for g in gaps):
            out.append([number, *parameters, h, -mp.diff(lambda g: law(g, *parameters), h, h=h * M("1e-40")),
                        law(h, *parameters)])

    gaps = ["1e-12", "1e-10", "1.7e-9", "1e-8", "3.3e-7", "1e-5", "1e-3"]
    for R1, R2 in (("5e-7", "5e-7"), ("1e-9", "1e-4"), ("2e-8", "3e-6"), ("5e-7", 0), ("1e-9", 0)):
        for lam in (0, "1e-7"):
            add(1, hamaker, ["1.2e-20", R1, R2, lam], gaps)
    eps = "7.0e-10"
    for p1, p2 in (("0.025", "0.025"), ("0.025", "0.01"), ("0.025", "-0.02"), ("-0.03", "-0.03"), ("0.02", 0)):
        for sign in (1, -1):
            add(2, layer, [sign, eps, "1e8", "2.5e-7", p1, p2], ["1e-13", "1e-10", "5e-9", "2e-8", "3e-7"])
        add(3, superposition, [eps, "1e8", "2.5e-7", p1, p2, "0.0257"], ["1e-10", "5e-9", "3e-7"])
    add(4, born, ["1e-20", "5e-10", "2.5e-7"], ["1e-10", "2.8e-10", "1e-8"])
    add(5, hydration, ["0.01", "6e-10", "2.5e-7"], ["1e-11", "1e-9", "3e-8"])
    for s, R in (("5e-10", "5e-7"), ("1e-9", "5e-7"), ("5e-10", "1e-9"), ("3e-10", "1e-4")):
        for full in (0, 1):
            add(6, wall, ["1.2e-20", s, R, full], ["1e-10", "2.8e-10", "1e-9", "1e-7", "1e-5", "1e-3"])

    mp.mp.dps = 50
    for x in ("1e-3", "0.05", "0.5", "0.79", "0.81", "0.99", "0.99999", "1.5"):
        p = [M(float(v)) for v in ("4.1e-21", "3e-9", "1e-8", "2.5e-7")]
        h = M(float(M(x) * 2 * p[2]))
        out.append([7, *p, h, *(steric(h, *p) if h < 2 * p[2] else (0, 0))])

    # With 30 digits mp.quad stops early: 4e-11 of U
    for s in ("1e-10", "2e-9", "2e-8"):
        for x in ("-1e-9", "1e-9", "5e-9", "1e-7"):
            p = [M(float(v)) for v in (s, "1.65e-10", "1e-20", "5e-7")]
            F, U = rough(M(float(x)), p[0], p[1], lambda h: hamaker(h, p[2], p[3], M(0), M(0)))
            out.append([8, *p, M(float(x)), F, U])

    with open("colloidForces.csv", "w") as f:
        f.write("# By colloidForces.py (mpmath). law: 1 Hamaker, 2 double layer, 3 superposition, 4 Born, 5 hydration,\n"
                "# 6 Lennard-Jones wall, 7 brushes, 8 van der Waals of a rough sphere and plate\n"
                "# law, parameters as the functions there ..., gap, F, U\n")
        f.writelines(text(r) for r in out)
    with open("HamakerConstants.csv", "w") as f:
        f.write("# By colloidForces.py (mpmath). epsR, n, nuE, nuRot of media 1, 2 and 3, T, A\n")
        for rows, T in media():
            rows = [[M(float(v)) for v in m] for m in rows]
            f.write(text([*rows[0], *rows[1], *rows[2], T, lifshitz(rows, T)]))


if __name__ == "__main__":
    main()
