/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Capillary attraction in a film: contact line, force and energy with 40 digits
// (reference/immersionForce.csv; python3 immersionForce.py writes it), limits

#include <gtest/gtest.h>
#include "immersionForce.H"
#include "table.H"

using namespace Foam::dew;

TEST(immersionForce, againstHighPrecision)
{
    const double sigma = 0.072;
    for (const auto& row : readTable("immersionForce.csv"))
    {
        const double R = row[0], theta = row[1], q = row[3];
        const immersedContactLine line(R, theta, row[2], q);
        EXPECT_NEAR(line.b/row[4], 1, 1e-13);
        EXPECT_NEAR(line.Q/row[5], 1, 1e-12);

        const immersionForce f(sigma, row[5], row[5], q, row[6]);
        EXPECT_NEAR(f.F/(sigma*row[7]), 1, 1e-12) << row[6];
        EXPECT_NEAR(f.U/(sigma*row[8]), 1, 1e-12) << row[6];
    }
}

TEST(immersionForce, lineOfASphere)
{
    // On its sphere, with its slope; at rest where the film meets it so
    const double R = 1e-6, theta = 0.9;
    const immersedContactLine line(R, theta, 1.1e-6, 370);
    EXPECT_NEAR(std::hypot(line.b - R, line.r)/R, 1, 1e-14);
    EXPECT_NEAR(line.Q, line.r*std::sin(line.psi), 1e-20);
    EXPECT_GT(line.b, 1.1e-6);
    EXPECT_LT(line.b, R*(1 + std::cos(theta)));

    const immersedContactLine rest(R, theta, R*(1 + std::cos(theta)), 370);
    EXPECT_NEAR(rest.Q/R, 0, 1e-14);
    EXPECT_LT(immersedContactLine(R, theta, 1.9e-6, 370).Q, 0);
}

TEST(immersionForce, derivativeSignAndLimit)
{
    const double q = 370;
    for (const double L : {1e-6, 1e-4, 3e-3, 2e-2})
    {
        const double e = 1e-5*L;
        const immersionForce f(0.05, 1e-7, 2e-7, q, L);
        const double slope =
            (
                immersionForce(0.05, 1e-7, 2e-7, q, L + e).U
              - immersionForce(0.05, 1e-7, 2e-7, q, L - e).U
            )/(2*e);
        EXPECT_NEAR(f.F/-slope, 1, 1e-7) << L;
        EXPECT_LT(f.F, 0);
        EXPECT_GT(immersionForce(0.05, -1e-7, 2e-7, q, L).F, 0);
    }

    // Near: -2 pi sigma Q1 Q2/L, as charges in two dimensions
    EXPECT_NEAR
    (
        immersionForce(0.05, 1e-7, 2e-7, q, 1e-6).F/(-2*M_PI*0.05*2e-14/1e-6),
        1, 1e-6
    );
    EXPECT_EQ(immersionForce(0.05, 1e-7, 1e-7, q, 10).F, 0);
    EXPECT_NEAR(capillaryLength(0.072, 1000, 9.81), 2.709e-3, 1e-6);
}
