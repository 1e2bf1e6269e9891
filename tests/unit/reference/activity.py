# Writes activity.csv and fugacity.csv: activity coefficients as derivatives of the excess Gibbs energy, and fugacity
# coefficients as derivatives of the residual Helmholtz energy, which is integrated from the equation of state. Derivatives
# by complex steps: none of the formulas of the code.
# Run: python3 activity.py
import cmath
import itertools


def lnGamma(gE, T, x):
    return [gE(T, [xj + (1e-30j if i == j else 0) for j, xj in enumerate(x)]).imag/1e-30 for i in range(len(x))]


# n GE/(R T) of amounts n. Parameters of acetone, methanol, water: made up, of the usual size
a = [[0, -112., 1200.], [900., 0, 400.], [5100., 1900., 0]]          # Wilson, J/mol
V = [74e-6, 40.7e-6, 18.07e-6]
Ru = 8.314462618


def wilson(T, n):
    total = sum(n)
    return -sum(ni*cmath.log(sum(nj*V[j]/V[i]*cmath.exp(-a[i][j]/(Ru*T)) for j, nj in enumerate(n))/total)
                for i, ni in enumerate(n))


A = [[0, .3, .1], [-.2, 0, -.7], [.6, 2.7, 0]]
B = [[0, 60., 320.], [110., 0, 170.], [400., -600., 0]]
alpha = [[0, .3, .53], [.3, 0, .3], [.53, .3, 0]]


def nrtl(T, n):
    def tau(i, j):
        return A[i][j] + B[i][j]/T

    def G(i, j):
        return cmath.exp(-alpha[i][j]*tau(i, j))
    r = range(3)
    return sum(n[i]*sum(tau(j, i)*G(j, i)*n[j] for j in r)/sum(G(k, i)*n[k] for k in r) for i in r)


# UNIFAC: CH3, CH3CO, CH3OH, H2O; Hansen et al. (1991). Excess energy of Staverman, Guggenheim and of the groups'
# UNIQUAC (Fredenslund et al. 1975, in the form of their appendix)
R = [.9011, 1.6724, 1.4311, .92]
Q = [.848, 1.488, 1.432, 1.4]
nu = [[1, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]
amn = [[0, 476.4, 697.2, 1318.], [26.76, 0, 108.7, 472.5], [16.51, 23.39, 0, -181.], [300., -195.4, 289.6, 0]]


def groupEnergy(T, N):
    surface = sum(Nk*Qk for Nk, Qk in zip(N, Q))
    return -sum(N[k]*Q[k]*cmath.log(sum(N[m]*Q[m]/surface*cmath.exp(-amn[m][k]/T) for m in range(4)))
                for k in range(4) if N[k] != 0)


def unifac(T, n):
    r = [sum(v*Rk for v, Rk in zip(nui, R)) for nui in nu]
    q = [sum(v*Qk for v, Qk in zip(nui, Q)) for nui in nu]
    total, volume, surface = sum(n), sum(map(lambda p, s: p*s, n, r)), sum(map(lambda p, s: p*s, n, q))
    combinatorial = sum(ni*cmath.log(ri*total/volume) + 5*qi*ni*cmath.log(qi*volume/(ri*surface))
                        for ni, ri, qi in zip(n, r, q))
    mixture = groupEnergy(T, [sum(ni*nui[k] for ni, nui in zip(n, nu)) for k in range(4)])
    return combinatorial + mixture - sum(ni*groupEnergy(T, nui) for ni, nui in zip(n, nu))


with open('activity.csv', 'w') as f:
    f.write('# lnGamma of acetone, methanol and water, written by activity.py\n'
            '# model (0 Wilson, 1 NRTL, 2 UNIFAC), T [K], x (3), lnGamma (3)\n')
    for (m, gE), T, x in itertools.product(enumerate((wilson, nrtl, unifac)), (300., 360.),
                                           ((.2, .3, .5), (.9, .05, .05), (1e-4, .5, .4999), (.05, .01, .94))):
        f.write(','.join('%.12g' % v for v in (m, T, *x, *lnGamma(gE, T, x))) + '\n')

# Peng-Robinson: ethanol and nitrogen, constants of the data bank
Tc, pc, w = (516.25, 126.1), (6.3835e6, 3.3944e6), (.6371, .0403)


def pressure(T, u, n):
    """u = 1/V"""
    k = [.37464 + 1.54226*wi - .26992*wi*wi for wi in w]
    ai = [.45724*(Ru*t)**2/p*(1 + ki*(1 - (T/t)**.5))**2 for t, p, ki in zip(Tc, pc, k)]
    a = sum(n[i]*n[j]*(ai[i]*ai[j])**.5 for i in (0, 1) for j in (0, 1))
    b = sum(ni*.07780*Ru*t/p for ni, t, p in zip(n, Tc, pc))
    return sum(n)*Ru*T*u/(1 - b*u) - a*u*u/(1 + 2*b*u - (b*u)**2)


def residual(T, u, n, steps=2000):
    """int_0^u (p/(R T) - n u)/u^2 du by Simpson's rule; the integrand at 0 is the second virial coefficient"""
    def f(s):
        s = s or 1e-3*u/steps
        return (pressure(T, s, n)/(Ru*T) - sum(n)*s)/s**2
    h = u/steps
    return h/3*sum((1 if i in (0, steps) else 4 if i % 2 else 2)*f(i*h) for i in range(steps + 1))


with open('fugacity.csv', 'w') as f:
    f.write('# ln phi of ethanol and nitrogen as a vapour, by the equation of Peng and Robinson, written by activity.py\n'
            '# T [K], p [Pa], y (2), lnPhi (2)\n')
    for T, p, y in itertools.product((350., 500.), (1e5, 4e5), ((1., 0.), (.5, .5), (.1, .9))):
        if T == 350 and p*y[0] > 1e5:
            continue
        low, high = 0, 3*p/(Ru*T)
        for i in range(200):
            u = (low + high)/2
            low, high = (u, high) if pressure(T, u, y) < p else (low, u)
        Z = p/(u*Ru*T)
        phi = [residual(T, u, [yj + (1e-30j if i == j else 0) for j, yj in enumerate(y)]).imag/1e-30
               - cmath.log(Z).real for i in (0, 1)]
        f.write(','.join('%.10g' % v for v in (T, p, *y, *phi)) + '\n')
