/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Brownian motion and the spring of a surface: springResponse and the rest of
// Ornstein-Uhlenbeck against numbers computed with 120 decimal digits
// (reference/colloids.csv; python3 reference/colloids.py writes them), noise
// against the moments of its process, distances against spheres

#include <gtest/gtest.h>
#include "brownianMotion.H"
#include "surfaceSpring.H"
#include "table.H"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace Foam::dew;

TEST(surfaceSpring, responseAgainstHighPrecision)
{
    for (const auto& row : readTable("colloids.csv"))
    {
        const double h = row[0], q = row[1];
        const springResponse r(h, q);
        const std::string at
        (
            "h " + std::to_string(h) + " q " + std::to_string(q)
        );

        // Oscillations: of their amplitude, with the phase's round-off
        const double phase = 1 + std::sqrt(q);
        const double gone = q > h*h/4 ? std::exp(-h/2) : 0;
        const double tiny = 1e-14*phase*gone;
        EXPECT_NEAR
        (
            r.speed, row[2], 1e-13*std::fabs(row[2]) + tiny/phase
        ) << at;
        EXPECT_NEAR
        (
            r.keep, row[3], 1e-12*std::fabs(row[3]) + tiny*(1 + h/phase)
        ) << at;
        EXPECT_NEAR(r.force/row[4], 1, 1e-13 + tiny) << at;
    }
}

TEST(surfaceSpring, withoutSpringItIsTheRelaxation)
{
    for (const double h : {1e-9, 1e-3, 0.1, 1.0, 3.0, 1e3, 1e9})
    {
        const springResponse r(h, 0);
        EXPECT_NEAR(r.speed/phi1(h), 1, 1e-14) << h;
        EXPECT_NEAR(r.force/phi2(h), 1, 1e-13) << h;
        EXPECT_NEAR(r.keep, std::exp(-h), 1e-15 + 1e-14*std::exp(-h)) << h;
    }
}

TEST(surfaceSpring, distanceFromPlaneAndSphere)
{
    const double n[3] = {0.6, 0, 0.8};
    double m[3];

    const double y[3] = {1.2, -7, 1.6};
    EXPECT_NEAR(surfaceDistance(y, n, 0, m), 2, 1e-15);
    EXPECT_NEAR(m[0], 0.6, 1e-15);

    // Radius 5, convex and concave: the foot is at 5 n from the centre
    const double along[3] = {0, 1, 0};
    for (const double side : {1.0, -1.0})
    {
        for (const double distance : {0.3, -0.4})
        {
            double to[3];
            for (int k = 0; k < 3; k++)
            {
                to[k] = (5 + side*distance)*along[k] - side*5*n[k];
            }
            EXPECT_NEAR
            (
                surfaceDistance(to, n, side/5, m), distance, 1e-14
            );
            EXPECT_NEAR(m[1], side, 1e-14);
        }
    }
}

TEST(brownianMotion, restAgainstHighPrecision)
{
    for (const auto& row : readTable("colloids.csv"))
    {
        EXPECT_NEAR(ornsteinUhlenbeckRest(row[0])/row[5], 1, 2e-12) << row[0];
    }
    EXPECT_EQ(ornsteinUhlenbeckRest(0), 0);
}

TEST(brownianMotion, variancesOfTheProcess)
{
    // Gillespie (1996), eqs. (3.5): with c tau^2 = 2 kT/Sp in his symbols
    const double kT = 3, m = 0.7, dt = 0.2;
    for (const double h : {0.03, 0.4, 5.0, 700.0})
    {
        const double Sp = h*m/dt;
        const ornsteinUhlenbeck o(kT, m, Sp, dt);
        const double e = std::exp(-h), l = kT/m;

        EXPECT_NEAR(o.v*o.v/(l*(1 - e*e)), 1, 1e-13);
        EXPECT_NEAR(o.v*o.xv/(l*dt/h*(1 - e)*(1 - e)), 1, 1e-12);
        EXPECT_NEAR
        (
            (o.xv*o.xv + o.x*o.x)
           /(l*dt*dt/(h*h)*(2*h - 3 + 4*e - e*e)), 1, 1e-10
        );
    }

    // Without inertia, and without friction
    const ornsteinUhlenbeck heavy(kT, m, 1e9, dt);
    EXPECT_NEAR(std::hypot(heavy.xv, heavy.x)/diffusionStep(kT, 1e9, dt), 1, 1e-7);
    const ornsteinUhlenbeck free(kT, m, 0, dt);
    EXPECT_EQ(free.v, 0);
    EXPECT_EQ(free.xv, 0);
    EXPECT_EQ(free.x, 0);
}

TEST(brownianMotion, driftOfAVaryingFriction)
{
    // Moments of m v' = -(Sp + Sp' x) v + noise to first order in Sp', by
    // Heun's steps: w = <v x> from D (1 - exp(-t)), then <v>, then <x>;
    // m = Sp = kT = 1, D' = -Sp'
    for (const double h : {0.02, 0.7, 9.0})
    {
        const int n = 200000;
        const double dt = h/n, speed = -0.3;
        double v = 0, x = 0;
        for (int i = 0; i < n; i++)
        {
            const double a = -v + speed*(1 - std::exp(-i*dt));
            const double b =
                -(v + dt*a) + speed*(1 - std::exp(-(i + 1)*dt));
            x += dt*(v + 0.5*dt*a);
            v += 0.5*dt*(a + b);
        }
        const mobilityDrift drift(speed, h, h);
        EXPECT_NEAR(drift.dx/x, 1, 1e-6) << h;
        EXPECT_NEAR(drift.dv/v, 1, 1e-6) << h;
    }
}

TEST(brownianMotion, gaussiansAreNormalAndIndependent)
{
    // Standard errors of n samples: 1/sqrt(n), sqrt(2/n), sqrt(96/n); 4 of them
    const int n = 100000, m = 6;
    const ziggurat& z = ziggurat::instance();
    double sum[m] = {}, two[m][m] = {}, four[m] = {};
    double next = 0, other = 0;

    for (int i = 0; i < n; i++)
    {
        double g[m], later[m], neighbour[m];
        gaussians<m>(z, 1, 17, i, g);
        gaussians<m>(z, 1, 17, i + 1, later);
        gaussians<m>(z, 1, 18, i, neighbour);
        for (int a = 0; a < m; a++)
        {
            sum[a] += g[a];
            four[a] += std::pow(g[a], 4);
            for (int b = 0; b < m; b++)
            {
                two[a][b] += g[a]*g[b];
            }
        }
        next += g[0]*later[0];
        other += g[0]*neighbour[0];
    }

    for (int a = 0; a < m; a++)
    {
        EXPECT_NEAR(sum[a]/n, 0, 4/std::sqrt(n));
        EXPECT_NEAR(four[a]/n, 3, 4*std::sqrt(96.0/n));
        for (int b = 0; b < m; b++)
        {
            EXPECT_NEAR(two[a][b]/n, a == b, 4*std::sqrt(2.0/n));
        }
    }
    EXPECT_NEAR(next/n, 0, 4/std::sqrt(n));
    EXPECT_NEAR(other/n, 0, 4/std::sqrt(n));

    // The same for the same, others for another seed, step or particle; the
    // first do not depend on how many are drawn
    double a[3], b[8];
    gaussians<3>(z, 5, 2, 3, a);
    gaussians<8>(z, 5, 2, 3, b);
    EXPECT_EQ(a[2], b[2]);
    for (const auto& other : {std::array<uint64_t, 3>{6, 2, 3}, {5, 3, 3}, {5, 2, 4}, {5, 2, 3 + (1ull << 32)}})
    {
        gaussians<8>(z, other[0], uint32_t(other[1]), other[2], b);
        EXPECT_NE(a[2], b[2]);
    }
}

TEST(ziggurat, sharesOfTheNormalDistribution)
{
    // Counts in bins against erfc, four standard errors and a half for 60 bins;
    // the tail beyond 3.65 is drawn by another formula, 1300 of 5e6
    const ziggurat& z = ziggurat::instance();
    const int n = 5000000;
    std::vector<double> count(60, 0.0);
    for (int i = 0; i < n/4; i++)
    {
        double g[4];
        gaussians<4>(z, 3, 1, i, g);
        for (const double x : g)
        {
            const int bin = int(std::floor(x/0.15)) + 30;
            count[std::min(59, std::max(0, bin))] += 1;
        }
    }
    const auto below = [](const double x) { return 0.5*std::erfc(-x/std::sqrt(2.0)); };
    for (int bin = 0; bin < 60; bin++)
    {
        const double low = bin == 0 ? 0 : below(0.15*(bin - 30));
        const double high = bin == 59 ? 1 : below(0.15*(bin - 29));
        const double expected = n*(high - low);
        EXPECT_NEAR(count[bin], expected, 4.5*std::sqrt(expected) + 3) << bin;
    }
}
