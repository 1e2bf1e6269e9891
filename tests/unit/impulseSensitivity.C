/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// The sensitivity of a received impulse: limits, and shares set up by hand

#include <gtest/gtest.h>
#include "impulseSensitivity.H"

#include <cmath>

using namespace Foam::dew;

TEST(impulseSensitivity, limits)
{
    const double m = 3e-18;

    for (const double h : {1e-12, 1e-3, 1.0, 1e3, 1e9})
    {
        const double Sp = h*m/1e-7;
        EXPECT_NEAR
        (
            impulseSensitivity(m, Sp, 1e-7, 0)/(-m*std::expm1(-h)), 1, 1e-14
        );
        EXPECT_NEAR(impulseSensitivity(m, Sp, 1e-7, 1)/(m*h), 1, 1e-14);
        EXPECT_NEAR
        (
            impulseSensitivity(m, Sp, 1e-7, 0.25)
           /(m*(0.25*h - 0.75*std::expm1(-h))),
            1,
            1e-14
        );
    }
    EXPECT_EQ(impulseSensitivity(m, 0, 1e-7, 1), 0);
    EXPECT_EQ(impulseSensitivity(m, 0, 1e-7, 0), 0);
}

TEST(impulseSensitivity, heldShare)
{
    const double m = 2;
    const double rest[] = {0, 0, 0};
    const double J[] = {1, 0, 2}, G[] = {0, 0, -4};        // B = (1 0 -2)

    // At rest: all of it taken back
    EXPECT_EQ(heldShare(m, rest, rest, J, G), 1);

    // Free: m dv = B
    const double v0[] = {5, -3, 1}, v1[] = {5.5, -3, 0};
    EXPECT_EQ(heldShare(m, v0, v1, J, G), 0);

    // A third: D = 2 B/3, and something across it
    const double v2[] = {5 + 1.0/3 + 2, -3 + 7, 1 - 2.0/3 + 1};
    EXPECT_NEAR(heldShare(m, v0, v2, J, G), 1.0/3, 1e-14);

    // Pushed along by its neighbours, and thrown back by them
    const double v3[] = {7, -3, -3}, v4[] = {4, -3, 3};
    EXPECT_EQ(heldShare(m, v0, v3, J, G), 0);
    EXPECT_EQ(heldShare(m, v0, v4, J, G), 1);

    // At terminal velocity, fast: what is left of B and C is round-off
    const double fast[] = {0, 0, -1e3}, fast2[] = {0, 0, -1e3*(1 - 1e-15)};
    const double up[] = {0, 0, 4*(1 - 1e-13)};
    EXPECT_EQ(heldShare(m, fast, fast2, up, G), 0);

    // Nothing acts
    EXPECT_EQ(heldShare(m, rest, rest, rest, rest), 0);
}
