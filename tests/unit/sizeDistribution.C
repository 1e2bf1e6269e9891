/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Drawn diameters against the moments of the truncated distributions

#include <gtest/gtest.h>
#include "IStringStream.H"
#include "sizeDistribution.H"

using namespace Foam;
using namespace Foam::dew;

namespace
{

scalar meanOf(const char* text, const int power = 1, const int n = 20000)
{
    IStringStream is(text);
    const dictionary dict(is);
    const autoPtr<sizeDistribution> D(sizeDistribution::New(dict));
    counterRandom random(5);

    scalar sum = 0;
    for (int i = 0; i < n; i++)
    {
        const scalar d = D->sample(random);
        EXPECT_GE(d, D->min());
        EXPECT_LE(d, D->max());
        sum += ::pow(d, power);
    }
    return sum/n;
}

} // End anonymous namespace


TEST(sizeDistribution, inverseNormalIsInverse)
{
    for (const scalar z : {-8.0, -5.0, -1.0, -0.01, 0.0, 0.3, 2.0, 5.0})
    {
        EXPECT_NEAR(inverseNormal(cumulativeNormal(z)), z, 1e-9*(1 + mag(z)));
    }

    // Abramowitz & Stegun, table 26.5: Q(x) = 0.025 at 1.95996 39845 40054
    EXPECT_NEAR(inverseNormal(0.975), 1.95996398454005, 1e-13);
}


TEST(sizeDistribution, mono)
{
    EXPECT_EQ(meanOf("type mono; value 2e-4;", 1, 1), 2e-4);
}


TEST(sizeDistribution, uniformMeanAndVariance)
{
    // Mean 2, variance 1/3 of U(1, 3); four standard errors
    const char* text = "type uniform; min 1; max 3;";
    const scalar mean = meanOf(text);
    EXPECT_NEAR(mean, 2, 4*::sqrt(1.0/3/20000));
    EXPECT_NEAR(meanOf(text, 2) - sqr(mean), 1.0/3, 0.01);
}


TEST(sizeDistribution, truncatedNormal)
{
    // On [mean - s, mean + 2 s]: mean + s (phi(-1) - phi(2))/(Phi(2) - Phi(-1))
    // phi(1) = 0.2419707245, phi(2) = 0.0539909665,
    // Phi(2) - Phi(-1) = 0.8185946141 (tables of the normal distribution)
    const scalar expected = 10 + (0.2419707245 - 0.0539909665)/0.8185946141;
    EXPECT_NEAR
    (
        meanOf("type normal; mean 10; deviation 1; min 9; max 12;"),
        expected,
        4*0.75/::sqrt(20000.0)
    );
}


TEST(sizeDistribution, logNormalMedian)
{
    // Nearly untruncated: mean of ln-normal is median exp(s^2/2)
    EXPECT_NEAR
    (
        meanOf("type logNormal; median 1; deviation 0.2; min 0.2; max 5;"),
        ::exp(0.02),
        4*0.206/::sqrt(20000.0)
    );
}


TEST(sizeDistribution, massWeighting)
{
    // Mass uniform on [1, 2]: number density ~ d^-3, number mean
    // (1 - 1/2)/((1 - 1/4)/2) = 4/3
    EXPECT_NEAR
    (
        meanOf("type uniform; min 1; max 2; weighting mass;"),
        4.0/3,
        4*0.26/::sqrt(20000.0)
    );
}


TEST(sizeDistribution, errors)
{
    EXPECT_ANY_THROW(meanOf("type gamma; value 1;"));
    EXPECT_ANY_THROW(meanOf("type mono; value -1;"));
    EXPECT_ANY_THROW(meanOf("type uniform; min 2; max 1;"));
    EXPECT_ANY_THROW
    (
        meanOf("type normal; mean 1; deviation 0.01; min 5; max 6;")
    );
}
