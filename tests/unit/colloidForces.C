/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Colloidal forces against the textbook form of each energy with 120 digits
// and integration (reference/colloidForces.csv, HamakerConstants.csv; python3
// reference/colloidForces.py writes them), F = -dU/dh by differences, values
// of Hamaker constants in Israelachvili's table and hand-calculated forces

#include <gtest/gtest.h>
#include "BornRepulsion.H"
#include "HamakerConstant.H"
#include "HamakerSpheres.H"
#include "LennardJonesWall.H"
#include "doubleLayer.H"
#include "hydrationForce.H"
#include "roughSurfaces.H"
#include "stericRepulsion.H"
#include "table.H"

#include <cmath>

using namespace Foam::dew;

namespace
{

// One row of the table at another gap, held below hMin
colloidForce law(const std::vector<double>& p, double h, double hMin)
{
    switch (int(p[0]))
    {
        case 1:
        {
            const HamakerSpheres H{p[1], hMin, p[4]};
            return p[3] > 0 ? H.spheres(h, p[2], p[3]) : H.plate(h, p[2]);
        }
        case 2:
        {
            const doubleLayer d{p[2], p[3], hMin};
            return p[1] > 0
              ? d.constantPotential(h, p[4], p[5], p[6])
              : d.constantCharge(h, p[4], p[5], p[6]);
        }
        case 3:
            return exponentialForce
            (
                h, superpositionEnergy(p[3], p[4], p[5], p[1], p[6]), p[2]
            );
        case 4:
            return BornRepulsion{p[1], p[2], hMin}(h, p[3]);
        case 5:
            return hydrationForce{p[1], p[2]}(h, p[3]);
        case 6:
            return LennardJonesWall{p[1], p[2], hMin, p[4] > 0}(h, p[3]);
        case 7:
            return stericRepulsion{p[1], p[2], p[3], hMin}(h, p[4]);
        default:
        {
            const HamakerSpheres H{p[3], p[2], 0};
            return roughSurfaces(p[1], p[2])
            (
                h, [&](const double g) { return H.plate(g, p[4]); }
            );
        }
    }
}

// Scale of the sum's terms where surfaces attract and repel at once: the
// difference itself is exact to round-off of these
double scale(const std::vector<double>& p, double h)
{
    if (p[0] == 6 && p[4] > 0)
    {
        return std::fabs(HamakerSpheres{p[1], 1e-13, 0}.plate(h, p[3]).U);
    }
    if (p[0] == 2)
    {
        const double x = std::exp(-p[3]*h);
        return M_PI*p[2]*p[4]*x*std::fabs(p[5]*p[6])
          + M_PI*p[2]*p[4]*(p[5]*p[5] + p[6]*p[6])*x*x/(1 + p[3]*h);
    }
    return 0;
}

const std::string at(const std::vector<double>& p)
{
    std::ostringstream os;
    for (const double v : p)
    {
        os << v << ' ';
    }
    return os.str();
}

} // End namespace

TEST(colloidForces, againstHighPrecision)
{
    const auto rows = readTable("colloidForces.csv");
    EXPECT_EQ(rows.size(), 209u);
    for (const auto& p : rows)
    {
        const double h = p[p.size() - 3], F = p[p.size() - 2], U = p.back();
        const colloidForce f = law(p, h, 1e-14);
        const double tolerance = p[0] == 8 ? 1e-12 : 1e-13;
        const double terms = scale(p, h);
        EXPECT_NEAR(f.F, F, tolerance*std::fabs(F) + 1e-14*terms/h) << at(p);
        EXPECT_NEAR(f.U, U, tolerance*std::fabs(U) + 1e-14*terms) << at(p);
    }
}

TEST(colloidForces, forceIsTheSlopeOfTheEnergy)
{
    for (const auto& p : readTable("colloidForces.csv"))
    {
        // Also where the law is held. Four-point differences: their error is
        // the fifth derivative's, of exp(-50) (50*1e-3)^4/30 = 2e-7, and
        // round-off of U
        const double h = p[p.size() - 3];
        for (const double hMin : {1e-14, 3*std::fabs(h)})
        {
            const double edge = p[0] == 7 ? std::fabs(2*p[3] - h)/3 : 1;
            const double d = std::min(1e-3*std::fabs(h), 0.01*edge);
            const double slope =
            (
                8*(law(p, h + d, hMin).U - law(p, h - d, hMin).U)
              - (law(p, h + 2*d, hMin).U - law(p, h - 2*d, hMin).U)
            )/(12*d);
            const colloidForce f = law(p, h, hMin);
            EXPECT_NEAR
            (
                -slope, f.F,
                1e-6*std::fabs(f.F) + 1e-12*(std::fabs(f.U) + scale(p, h))/d
            ) << at(p) << hMin;
        }
    }
}

TEST(colloidForces, heldBelowLeastGap)
{
    const HamakerSpheres H{1e-20, 5e-10, 0};
    const colloidForce least = H.plate(5e-10, 5e-7);
    for (const double h : {4e-10, 0.0, -1e-9})
    {
        const colloidForce f = H.plate(h, 5e-7);
        EXPECT_EQ(f.F, least.F);
        EXPECT_NEAR(f.U/(least.U + least.F*(5e-10 - h)), 1, 1e-15);
    }

    colloidForce sum{1, 2};
    sum += colloidForce{3, 4};
    EXPECT_EQ(sum.F, 4);
    EXPECT_EQ(sum.U, 6);
}

TEST(colloidForces, vanDerWaalsByHand)
{
    // A R/(12 h^2) at h << R; sphere and plate twice that of two spheres; and
    // 16 A R^6/(9 r^6) for spheres far apart: the sum over two point volumes
    const double A = 1e-20, R = 5e-7;
    const HamakerSpheres H{A, 1e-13, 0};
    EXPECT_NEAR(H.spheres(1e-12, R, R).F/-4.1666667e-4, 1, 1e-5);
    EXPECT_NEAR(H.plate(1e-12, R).F/H.spheres(1e-12, R, R).F, 2, 1e-5);
    const double r = 1000.0;
    EXPECT_NEAR
    (
        H.spheres(r - 2*R, R, R).U/(-16*A*std::pow(R/r, 6)/9), 1, 1e-8
    );

    // Gregory's factor at 5.32 h = lambda: 1 - ln 2
    const HamakerSpheres late{A, 1e-13, 5.32e-9};
    EXPECT_NEAR
    (
        late.plate(1e-9, R).U/H.plate(1e-9, R).U, 0.3068528194400547, 1e-14
    );
}

TEST(HamakerConstant, sumAgainstHighPrecision)
{
    for (const auto& p : readTable("HamakerConstants.csv"))
    {
        HamakerMedium m[3];
        for (int i = 0; i < 3; i++)
        {
            m[i] = {"", p[4*i], p[4*i + 1], p[4*i + 2], p[4*i + 3]};
        }
        EXPECT_NEAR
        (
            HamakerConstant(m[0], m[1], m[2], p[12])/p[13], 1, 1e-11
        ) << at(p);
    }
}

TEST(HamakerConstant, tableOfMedia)
{
    const auto medium = HamakerMedium::medium;
    EXPECT_EQ(medium("treacle"), nullptr);
    const HamakerMedium& air = *medium("air");

    // 300 K across air, in 1e-20 J: closed form by hand, and Israelachvili's
    // table 13.2, calculated by him with two digits from slightly other data
    const struct {const char* name; double closed, table;} known[] =
    {
        {"water", 3.73, 3.7}, {"octane", 4.53, 4.5}, {"silica", 5.92, 6.3},
        {"mica", 9.72, 10}, {"PTFE", 3.97, 3.8}, {"cyclohexane", 0, 5.2},
        {"benzene", 0, 5.0}, {"acetone", 0, 4.1}, {"ethanol", 0, 4.2},
        {"polystyrene", 0, 6.5}, {"alumina", 0, 14}
    };
    for (const auto& k : known)
    {
        const HamakerMedium& m = *medium(k.name);
        if (k.closed > 0)
        {
            EXPECT_NEAR
            (
                HamakerConstantClosed(m, m, air, 3e15, 300)*1e20,
                k.closed, 0.006
            ) << k.name;
        }
        HamakerMedium empty = air;
        empty.nuE = m.nuE;
        EXPECT_NEAR
        (
            HamakerConstant(m, m, empty, 300)*1e20, k.table, 0.07*k.table
        ) << k.name;
        EXPECT_NEAR
        (
            HamakerConstant(m, m, air, 300)
           /HamakerConstantClosed(m, m, air, m.nuE, 300), 1, 0.05
        ) << k.name;
    }

    // Across vacuum and water in 1e-20 J, P. Walstra, Physical Chemistry of
    // Foods (2003), table 12.2: half of the last digit printed
    const HamakerMedium& water = *medium("water");
    const HamakerMedium& latex = *medium("polystyrene");
    const HamakerMedium& ethanol = *medium("ethanol");
    EXPECT_NEAR(HamakerConstant(water, water, air, 300)*1e20, 3.7, 0.05);
    EXPECT_NEAR(HamakerConstant(ethanol, ethanol, air, 300)*1e20, 4.2, 0.05);
    EXPECT_NEAR(HamakerConstant(latex, latex, air, 300)*1e20, 6.5, 0.05);
    EXPECT_NEAR(HamakerConstant(latex, latex, water, 300)*1e20, 0.9, 0.05);

    // A medium does not act across itself; unlike sides of a denser one repel
    EXPECT_EQ(HamakerConstant(water, air, water, 300), 0);
    EXPECT_LT(HamakerConstant(*medium("silica"), air, water, 300), 0);
}

TEST(doubleLayer, setUpByHand)
{
    // 1 mM 1:1 in water of 25 C, epsR 78.3: 9.62 nm; 1/kappa = 5 nm with epsR
    // 80 at 298 K: 3.77 mM and at 373 K 4.72 mM
    EXPECT_NEAR(debyeLength(1, 78.4, 298.15)*1e9, 9.62, 0.01);
    EXPECT_NEAR(ionicStrength(5e-9, 80, 298), 3.77, 0.005);
    EXPECT_NEAR(ionicStrength(5e-9, 80, 373), 4.72, 0.005);
    const double length = debyeLength(3.3, 78.4, 298.15);
    EXPECT_NEAR(ionicStrength(length, 78.4, 298.15)/3.3, 1, 1e-14);
    EXPECT_NEAR(ionicStrengthOf(6.02214076e23, 2), 4, 1e-14);

    // 1000 charges per um^2 at 1/kappa = 5 nm: 1.131 mV
    const double eps = 80*colloidConstants::vacuum, q = 1.602176634e-4;
    EXPECT_NEAR(linearPotential(q, 2e8, eps)*1e3, 1.131, 1e-3);

    // Grahame: q^2 = 8 eps kT n sinh^2 with n = I NA, and there and back
    const double T = 298.15, phi = thermalPotential(T);
    const double kT = colloidConstants::boltzmann*T;
    const double n = ionicStrength(5e-9, 80, T)*colloidConstants::avogadro;
    EXPECT_NEAR(phi, 0.0256926, 1e-7);
    for (const double psi : {-0.1, 1e-6, 0.025, 0.2})
    {
        const double full = GrahameCharge(psi, 2e8, eps, phi);
        EXPECT_NEAR
        (
            full/(std::sqrt(8*eps*kT*n)*std::sinh(psi/(2*phi))), 1, 1e-13
        );
        EXPECT_NEAR(GrahamePotential(full, 2e8, eps, phi)/psi, 1, 1e-13);
    }
    EXPECT_NEAR
    (
        GrahamePotential(1e-6, 2e8, eps, phi)
       /linearPotential(1e-6, 2e8, eps), 1, 1e-7
    );

    // Two spheres of R: Yukawa from the number of ions is superposition
    const double R = 5e-7;
    EXPECT_NEAR
    (
        YukawaEnergy(R, 0.03, n, 2e8, kT, phi)
       /superpositionEnergy(DerjaguinRadius(R, R), 0.03, 0.03, eps, phi),
        1, 1e-13
    );
}

TEST(doubleLayer, forcesByHand)
{
    // R = 0.5 um each, 1 mM, 25 C, 25 mV, 1/kappa 9.62 nm
    const double R = 5e-7, psi = 0.025, phi = 1.380649e-23*298.15/1.602176634e-19;
    const double eps = 78.4*8.8541878128e-12, kappa = 1/9.62e-9;
    const double Rd = DerjaguinRadius(R, R);
    const doubleLayer layer{eps, kappa, 1e-12};
    const double U0 = superpositionEnergy(Rd, psi, psi, eps, phi);
    for (const double h : {1e-9, 1e-8})
    {
        const double x = std::exp(-kappa*h), t = std::tanh(psi/phi/4);
        EXPECT_NEAR
        (
            layer.constantPotential(h, Rd, psi, psi).F
           /(2*M_PI*eps*R*kappa*psi*psi*x/(1 + x)), 1, 1e-12
        );
        EXPECT_NEAR
        (
            exponentialForce(h, U0, kappa).F
           /(32*M_PI*eps*R*kappa*phi*phi*t*t*x), 1, 1e-12
        );
    }
    // The numbers as printed, with three and four digits
    EXPECT_NEAR(layer.constantPotential(1e-9, Rd, psi, psi).F, 6.72e-11, 3e-13);
    EXPECT_NEAR(layer.constantPotential(1e-8, Rd, psi, psi).F, 3.71e-11, 3e-13);
    EXPECT_NEAR(exponentialForce(1e-9, U0, kappa).F, 1.230e-10, 5e-13);
    EXPECT_NEAR(exponentialForce(1e-8, U0, kappa).F, 4.825e-11, 2e-13);

    // Constant charge above, constant potential below superposition
    const double p = 1e-3;
    const double V0 = superpositionEnergy(Rd, p, p, eps, phi);
    const double middle = exponentialForce(1e-9, V0, kappa).F;
    EXPECT_GT(layer.constantCharge(1e-9, Rd, p, p).F, middle);
    EXPECT_LT(layer.constantPotential(1e-9, Rd, p, p).F, middle);
}

TEST(LennardJonesWall, minimumAndPullOff)
{
    // Minimum at 0.567 s; -584 kT (373 K) and 5.87 nN for R 0.5 um, s 0.5 nm;
    // -291 kT and 1.47 nN for s 1 nm
    const double kT = 1.380649e-23*373;
    const struct {double s, depth, pull;} known[] =
    {
        {5e-10, -584, 5.87e-9}, {1e-9, -291, 1.47e-9}
    };
    for (const auto& k : known)
    {
        const LennardJonesWall wall{1.2e-20, k.s, 1e-11, true};
        double least = 0, pull = 0, where = 0;
        for (double D = 0.4*k.s; D < 2*k.s; D += 1e-4*k.s)
        {
            const colloidForce f = wall(D, 5e-7);
            where = f.U < least ? D : where;
            least = std::min(least, f.U);
            pull = std::min(pull, f.F);
        }
        EXPECT_NEAR(where/k.s, 0.567, 5e-4);
        EXPECT_NEAR(least/kT, k.depth, 0.6);
        EXPECT_NEAR(-pull, k.pull, 5e-12);
    }

    // Born's repulsion by Derjaguin where D << R
    const LennardJonesWall hard{1.2e-20, 5e-10, 1e-11, false};
    const BornRepulsion born{1.2e-20, 5e-10, 1e-11};
    EXPECT_NEAR(hard(3e-10, 1e-4).F/born(3e-10, 1e-4).F, 1, 1e-5);
    EXPECT_NEAR(hard(3e-10, 1e-4).U/born(3e-10, 1e-4).U, 1, 1e-5);
}

TEST(roughSurfaces, exponentialInClosedForm)
{
    // <exp(-kz)> = exp(k^2 s^2/2) of a Gaussian; no roughness: the law itself.
    // Cut at 9 s, this one loses what lies 9 - k s = 7 s out: 1.3e-12
    const double U0 = 1e-18, kappa = 2e8;
    const auto smooth = [&](double h) { return exponentialForce(h, U0, kappa); };
    for (const double s : {0.0, 1e-11, 1e-9, 1e-8})
    {
        const colloidForce f = roughSurfaces(s, 1e-10)(4e-9, smooth);
        const double U = smooth(4e-9).U*std::exp(0.5*kappa*kappa*s*s);
        EXPECT_NEAR(f.U/U, 1, 2e-12) << s;
        EXPECT_NEAR(f.F/(kappa*U), 1, 2e-12) << s;
    }
}
