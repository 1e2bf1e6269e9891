/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Laws of pairs: lubrication against integration with 40 digits
// (reference/pairs.csv; python3 reference/pairs.py writes it), conduction
// against geometry, and numbers of the papers' formulas computed elsewhere

#include <gtest/gtest.h>
#include "BatchelorOBrienConduction.H"
#include "contactConduction.H"
#include "impactHeat.H"
#include "lubrication.H"
#include "table.H"

#include <cmath>

using namespace Foam::dew;

namespace
{
    const lubricationGap law{1e-8, 5e-5};
}

TEST(lubrication, stepAgainstHighPrecision)
{
    for (const auto& row : readTable("pairs.csv"))
    {
        const double s = row[0], v = row[1], a = row[2], dt = row[3];
        EXPECT_NEAR(law.integral(s), row[4], 1e-14*(1 + std::fabs(row[4])));
        EXPECT_NEAR(law.slowed(v, s, a, dt)/row[5], 1, 1e-12) << s << ' ' << v;
    }
}

TEST(lubrication, limitsOfTheGap)
{
    // 6 pi mu r*^2 for two equal spheres: r* = R/2
    EXPECT_NEAR(lubricationCoefficient(1e-3, 5e-4)/4.71238898e-9, 1, 1e-9);

    EXPECT_EQ(law.slope(5e-5), 0);
    EXPECT_NEAR(law.slope(5e-5*(1 - 1e-9))*5e-5, 1e-9, 1e-14);
    EXPECT_NEAR(law.slope(1e-9), 1e8 - 2e4, 1e-6);
    EXPECT_EQ(law.slope(0), 0);
    EXPECT_EQ(law.slope(-1e-9), 0);

    // One law on either side of sMin and sMax, and of the series
    for (const double s : {1e-8, 5e-5, 3e-7})
    {
        EXPECT_NEAR
        (
            law.change(s*(1 - 1e-6), 2e-6*s),
            law.integral(s*(1 + 1e-6)) - law.integral(s*(1 - 1e-6)), 1e-14
        );
    }
    EXPECT_NEAR(law.change(1e-6, 1e-16)/(1e-16*law.slope(1e-6)), 1, 1e-9);

    // Nothing outside, and no reversal however thick the fluid
    EXPECT_EQ(law.slowed(-0.1, 6e-5, 1, 1e-6), -0.1);
    EXPECT_EQ(law.slowed(0, 1e-6, 1, 1e-6), 0);
    for (const double a : {1e-9, 1.0, 1e9})
    {
        const double v = law.slowed(-0.1, 1e-6, a, 1e-3);
        EXPECT_LE(v, 0);
        EXPECT_GE(v, -0.1);
    }
}

TEST(contactConduction, circleOfIntersection)
{
    // The radius of the circle by Pythagoras, from its distance to a centre
    for (const double R2 : {1.0, 0.3, 7.0})
    {
        const double r = 1 + R2 - 0.01;
        const double d = (r*r + 1 - R2*R2)/(2*r);
        EXPECT_NEAR(contactArea(1, R2, r)/(M_PI*(1 - d*d)), 1, 1e-12);
        EXPECT_EQ(contactArea(1, R2, r), contactArea(R2, 1, r));
    }
    EXPECT_NEAR(contactArea(1, 0.3, 0.5), M_PI*0.09, 1e-15);
    EXPECT_NEAR(wallContactArea(1, 0.9)/(0.19*M_PI), 1, 1e-14);
    EXPECT_NEAR(wallContactArea(1, -2), M_PI, 1e-15);

    // Equal bodies: 2 k sqrt(A); an insulator
    EXPECT_NEAR(contactConductance(50, 50, 4e-8), 2*50*2e-4, 1e-15);
    EXPECT_NEAR(contactConductance(10, 40, 1), 32, 1e-14);
    EXPECT_EQ(contactConductance(0, 50, 1), 0);
    EXPECT_EQ(contactConductance(0, 0, 1), 0);
}

TEST(BatchelorOBrienConduction, numbers)
{
    // Kf 0.6, two spheres of K 240: Kp 120, Kp/Kf 200, a 1e-3:
    // pi 0.6 1e-3 ln(4e4) = 0.0199742 W/K (ln(4e4) = 10.596635)
    const double ratio = conductivityRatio(240, 240, 0.6);
    EXPECT_NEAR(ratio, 200, 1e-12);
    EXPECT_NEAR
    (
        BatchelorOBrienConductance(0.6, ratio, 1e-3)/0.0199742, 1, 2e-6
    );
    EXPECT_NEAR(conductivityRatio(60, 30, 0.5), 40, 1e-12);
}

TEST(impactHeat, coefficientOfZhou)
{
    // The polynomials, evaluated to four digits beforehand: x, then Fo, C
    const double Fo[] = {0, 0.1, 0.5, 1, 5, 10};
    const double C[3][6] =
    {
        {0.9011, 0.9215, 0.9984, 1.0859, 1.610, 2.076},
        {0.8857, 0.9002, 0.9569, 1.0256, 1.5069, 2.0000},
        {0.8763, 0.8870, 0.9297, 0.9829, 1.4003, 1.9039}
    };
    for (int i = 0; i < 3; i++)
    {
        for (int j = 0; j < 6; j++)
        {
            EXPECT_NEAR
            (
                impactCoefficient(1 - 0.2*i, Fo[j]), C[i][j], 6e-4*(j > 3) + 6e-5
            );
        }
    }
}

TEST(impactHeat, heatOfAnImpact)
{
    // A sphere of 1 mm radius, density 8500, on a plane, E* 65.934 GPa, 1 m/s:
    // delta 3.032e-6 m, t 8.91e-6 s, A = pi 3.032e-9 m2. With rho cp 3.5e6 and
    // k 120: Fo = 120 8.91e-6/(3.5e6 3.032e-9) = 0.10076, C = 0.9217,
    // Q = C A sqrt(t) sqrt(3.5e6 120)/2 = 2.685e-7 J/K
    const thermalBody b{120, 3.5e6};
    const double m = 8500*4.0/3*M_PI*1e-9;
    const double Q = impactHeat(b, b, m, 1e-3, 65.934e9, 1);
    EXPECT_NEAR(Q/2.685e-7, 1, 1e-3);

    // Fo -> 0: the 0.87 of Sun and Chen is within 4 % of C = 0.9011
    const thermalBody poor{1e-6, 3.5e6};
    const double A = M_PI*1e-3*3.032e-6;
    EXPECT_NEAR
    (
        impactHeat(poor, poor, m, 1e-3, 65.934e9, 1)
       /(A*std::sqrt(8.914e-6)*std::sqrt(3.5)/2), 0.9011, 1e-3
    );

    // Either order; no impact, an insulator
    const thermalBody other{15, 4.1e6};
    EXPECT_EQ
    (
        impactHeat(b, other, m, 1e-3, 65.934e9, 1),
        impactHeat(other, b, m, 1e-3, 65.934e9, 1)
    );
    EXPECT_EQ(impactHeat(b, b, m, 1e-3, 65.934e9, 0), 0);
    EXPECT_EQ(impactHeat(b, {0, 1e6}, m, 1e-3, 65.934e9, 1), 0);
}
