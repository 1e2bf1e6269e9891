/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// phi1 and phi2 against numbers computed with 40 decimal digits
// (reference/phi.csv; python3 reference/phi.py writes them)

#include <gtest/gtest.h>
#include "exponentialRelaxation.H"
#include "table.H"

using namespace Foam::dew;

TEST(exponentialRelaxation, phiAgainstHighPrecision)
{
    for (const auto& row : readTable("phi.csv"))
    {
        const double h = row[0];

        // A few units in the last place
        EXPECT_NEAR(phi1(h)/row[1], 1, 2e-15) << "h = " << h;
        EXPECT_NEAR(phi2(h)/row[2], 1, 2e-14) << "h = " << h;
    }
}

TEST(exponentialRelaxation, limits)
{
    EXPECT_EQ(phi1(0), 1);
    EXPECT_EQ(phi2(0), 0.5);
    EXPECT_NEAR(phi1(1e8)*1e8, 1, 1e-15);
    EXPECT_NEAR(phi2(1e8)*1e8, 1, 1e-7);
}
