/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Dissipative particles: force against its formula by hand and the derivative
// of its energy, random numbers against the moments of the normal
// distribution, the thermostat against the stationary state and the limit of
// short steps

#include <gtest/gtest.h>
#include "dissipativeParticle.H"

using namespace Foam::dew;

TEST(dissipativeParticle, forceByHand)
{
    // a 25, r 0.6, rc 1: 10; w 0.4; -4.5 0.16 2 = -1.44;
    // sqrt(2 4.5/0.01) 0.4 0.5 = 6
    const dissipativePair p(25, 0.6, 1, 1);
    EXPECT_NEAR(p.F, 10, 1e-13);
    EXPECT_NEAR(p.U, 2, 1e-13);
    EXPECT_NEAR(p.force(4.5, 1, 2, 0.01, 0.5), 10 - 1.44 + 6, 1e-12);

    // s 1/2, rc 2, r 1.5: w 0.5; -4.5 0.25 2 = -2.25; 30 0.5 0.5 = 7.5
    const dissipativePair q(25, 1.5, 2, 0.5);
    EXPECT_NEAR(q.F, 6.25, 1e-13);
    EXPECT_NEAR(q.force(4.5, 1, 2, 0.01, 0.5), 6.25 - 2.25 + 7.5, 1e-12);

    for (const double r : {1.0, 1.2})
    {
        const dissipativePair far(25, r, 1, 0.5);
        EXPECT_EQ(far.U, 0);
        EXPECT_EQ(far.force(4.5, 1, 2, 0.01, 0.5), 0);
    }
    for (double r = 0.1; r < 3; r += 0.2)
    {
        const double e = 1e-5;
        const double slope =
            (
                dissipativePair(7, r + e, 3, 1).U
              - dissipativePair(7, r - e, 3, 1).U
            )/(2*e);
        EXPECT_NEAR(dissipativePair(7, r, 3, 1).F, -slope, 1e-9);
    }
}

TEST(dissipativeParticle, numbersOfThePair)
{
    EXPECT_EQ(pairGaussian(5, 3, 9, 7), pairGaussian(5, 9, 3, 7));
    EXPECT_EQ(pairGaussian(5, 3, 9, 1ull << 40), pairGaussian(5, 9, 3, 1ull << 40));
    const double one = pairGaussian(5, 3, 9, 7);
    EXPECT_NE(one, pairGaussian(6, 3, 9, 7));
    EXPECT_NE(one, pairGaussian(5 + (1ull << 33), 3, 9, 7));
    EXPECT_NE(one, pairGaussian(5, 4, 9, 7));
    EXPECT_NE(one, pairGaussian(5, 3, 10, 7));
    EXPECT_NE(one, pairGaussian(5, 3, 9, 8));
    EXPECT_NE(one, pairGaussian(5, 3, 9, 7 + (1ull << 32)));
}

TEST(dissipativeParticle, numbersAreNormalAndIndependent)
{
    // Four standard errors of n samples
    const int n = 200000;
    double one = 0, two = 0, three = 0, four = 0;
    double later = 0, neighbour = 0, shared = 0;
    for (int i = 0; i < n; i++)
    {
        const double g = pairGaussian(1, 17, 40, i);
        one += g;
        two += g*g;
        three += g*g*g;
        four += g*g*g*g;
        later += g*pairGaussian(1, 17, 40, i + 1);
        neighbour += g*pairGaussian(1, 17, 41, i);
        shared += g*pairGaussian(1, 40, 41, i);
    }
    EXPECT_NEAR(one/n, 0, 4/std::sqrt(n));
    EXPECT_NEAR(two/n, 1, 4*std::sqrt(2.0/n));
    EXPECT_NEAR(three/n, 0, 4*std::sqrt(15.0/n));
    EXPECT_NEAR(four/n, 3, 4*std::sqrt(96.0/n));
    EXPECT_NEAR(later/n, 0, 4/std::sqrt(n));
    EXPECT_NEAR(neighbour/n, 0, 4/std::sqrt(n));
    EXPECT_NEAR(shared/n, 0, 4/std::sqrt(n));
}

TEST(dissipativeParticle, thermostatIsExact)
{
    // Any two steps are one: means and variances
    const double kTmu = 3;
    for (const double k : {1e-9, 0.2, 2.0, 500.0})
    {
        const double one = pairThermostat(1, k, kTmu, 0);
        const double half = pairThermostat(1, k/2, kTmu, 0);
        EXPECT_NEAR(one, half*half, 1e-15);

        const double both = std::pow(pairThermostat(0, k, kTmu, 1), 2);
        const double part = std::pow(pairThermostat(0, k/2, kTmu, 1), 2);
        EXPECT_NEAR(both/(part*(1 + half*half)), 1, 1e-14);

        // Keeps kT/mu
        EXPECT_NEAR(one*one*kTmu + both, kTmu, 1e-14*kTmu);
    }

    // Short steps: the force's, with its noise
    const double gamma = 4.5, w = 0.3, mu = 0.5, kT = 2, dt = 1e-9;
    const dissipativePair pair(0, 0.7, 1, 1);
    const double next =
        pairThermostat(1.5, gamma*w*w*dt/mu, kT/mu, 0.8) - 1.5;
    EXPECT_NEAR(next/(pair.force(gamma, kT, 1.5, dt, 0.8)*dt/mu), 1, 1e-8);
}

TEST(dissipativeParticle, thermostatHoldsTheTemperature)
{
    // Correlation 0.9 per step: n (1 - 0.81)/(1 + 0.81) independent squares
    const int n = 400000;
    const double kdt = -std::log(0.9), kTmu = 0.7;
    double v = 10, sum = 0, square = 0, lag = 0;
    for (int i = -200; i < n; i++)
    {
        const double last = v;
        v = pairThermostat(v, kdt, kTmu, pairGaussian(3, 1, 2, i + 200));
        if (i >= 0)
        {
            sum += v;
            square += v*v;
            lag += v*last;
        }
    }
    const double error = 4*std::sqrt(2.0*1.81/(0.19*n));
    EXPECT_NEAR(sum/n/std::sqrt(kTmu), 0, 4*std::sqrt(19.0/n));
    EXPECT_NEAR(square/n/kTmu, 1, error);
    EXPECT_NEAR(lag/n/kTmu, 0.9, error);
}
