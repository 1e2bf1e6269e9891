/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Mobility beside a wall: Brenner's series with 60 digits, and along the wall
// Stokeslets before it (reference/wallMobility.csv; python3 wallMobility.py
// writes it), limits far and near. Slip: reference/slip.csv

#include <gtest/gtest.h>
#include "slipCorrection.H"
#include "table.H"
#include "wallMobility.H"

using namespace Foam::dew;

TEST(wallMobility, seriesOfBrenner)
{
    for (const auto& row : readTable("wallMobility.csv"))
    {
        EXPECT_NEAR(BrennerMobility(row[0], 1)/row[1], 1, 1e-12) << row[0];
        EXPECT_NEAR(BrennerMobility(3e-7*row[0], 3e-7)/row[1], 1, 1e-12);
    }

    // Far, with x = R/(h + R): 1 - 9/8 x + 1/2 x^3 - 135/256 x^4 (Happel and
    // Brenner); near: R/h - ln(h/R)/5 + 0.97128, Cox and Brenner (1967)
    const double x = 1/(1 + 500.0);
    EXPECT_NEAR
    (
        BrennerMobility(500, 1),
        1 - 9*x/8 + x*x*x*(0.5 - 135*x/256), 1e-13
    );
    for (const double y : {1e-4, 1e-6})
    {
        EXPECT_NEAR
        (
            1/BrennerMobility(y, 1), 1/y - std::log(y)/5 + 0.97128,
            1e-5 - y*std::log(y)
        );
    }
}

TEST(wallMobility, rationalLawsAgainstTheExact)
{
    for (const auto& row : readTable("wallMobility.csv"))
    {
        const wallMobility M(2*row[0], 2);
        EXPECT_NEAR(M.normal/row[1], 1, 0.0072) << row[0];
        EXPECT_NEAR(2*M.normalSlope/row[2], 1, 0.03) << row[0];
        EXPECT_NEAR(M.parallel/row[3], 1, 0.004) << row[0];
    }

    double most = 0;
    for (double y = 1e-6; y < 1e4; y *= 1.05)
    {
        const wallMobility M(y, 1);
        most = std::fmax
        (
            most, std::fabs(M.normal/BrennerMobility(y, 1) - 1)
        );
        EXPECT_NEAR(M.mean(), (M.normal + 2*M.parallel)/3, 1e-15);
    }
    EXPECT_NEAR(most, 0.0071, 0.0001);
}

TEST(wallMobility, alongTheWallFarFromIt)
{
    // Faxen (1923)
    for (const double y : {3.0, 10.0, 100.0})
    {
        const double x = 1/(1 + y), xx = x*x;
        const double far =
            1 - 9*x/16 + x*xx/8 - 45*xx*xx/256 - x*xx*xx/16;
        EXPECT_NEAR(wallMobility(y, 1).parallel/far, 1, 0.003) << y;
    }
}

TEST(wallMobility, alongTheWallNearIt)
{
    // Goldman, Cox and Brenner (1967): force and torque of translation and
    // rotation; a free sphere has no torque
    for (const double y : {1e-8, 1e-6, 1e-4, 1e-3})
    {
        const double l = -std::log(y);
        const double force = 8*l/15 + 0.9588, turn = 0.4*l + 0.3817;
        const double both = 0.1*l - 0.1895;
        const double near = 1/(force - 4*both*both/(3*turn));
        EXPECT_NEAR(wallMobility(y, 1).parallel/near, 1, 0.004) << y;
    }
}

TEST(wallMobility, slopes)
{
    const double R = 5e-7;
    for (double y = 1e-3; y < 30; y *= 2)
    {
        const double h = y*R, e = 1e-4*h;
        const wallMobility M(h, R), less(h - e, R), more(h + e, R);
        EXPECT_NEAR
        (
            (more.normal - less.normal)/(2*e)/M.normalSlope, 1, 1e-7
        ) << y;
        EXPECT_NEAR
        (
            (more.parallel - less.parallel)/(2*e)/M.parallelSlope, 1, 1e-7
        ) << y;
    }
}

TEST(slipCorrection, factorAndPath)
{
    for (const auto& row : readTable("slip.csv"))
    {
        EXPECT_NEAR(CunninghamFactor(row[1], row[0]/2)/row[2], 1, 1e-14);
    }
    EXPECT_EQ(CunninghamFactor(0, 1e-6), 1);

    // Air at 20 C, 101325 Pa: 65 nm (66.35 nm with 1.81e-5 Pa s at 293.15 K)
    const double kT = 1.380649e-23*293.15, m = 28.97e-3/6.02214076e23;
    EXPECT_NEAR(meanFreePath(1.81e-5, 101325, kT, m), 6.5e-8, 0.15e-8);
}
