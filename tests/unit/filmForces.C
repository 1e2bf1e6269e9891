/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Forces of the film between a particle and a liquid's surface: numbers by
// hand, F = -dU/dh by differences, drainage against the exponential law of a
// constant force and against small explicit steps

#include <gtest/gtest.h>
#include "filmForces.H"

using namespace Foam::dew;

TEST(filmForces, vanDerWaals)
{
    // H 1.2e-20 J, R 500 nm, 0.5 nm: 4.0 nN and 2e-18 J
    const filmForce f = filmVanDerWaals(1.2e-20, 5e-7, INFINITY, 4e-10, 5e-10);
    EXPECT_NEAR(f.F/-4e-9, 1, 1e-12);
    EXPECT_NEAR(f.U/-2e-18, 1, 1e-12);
    EXPECT_NEAR(filmVanDerWaals(-1.2e-20, 5e-7, 1, 5e-10, 1e-10).F/4e-9, 1, 1e-12);

    for (const double h : {-1.0, 0.4, 0.9, 1.1, 2.0, 6.9, 7.1})
    {
        const double e = 1e-5;
        EXPECT_NEAR
        (
            filmVanDerWaals(6, 2, 7, 1, h).F,
            (
                filmVanDerWaals(6, 2, 7, 1, h - e).U
              - filmVanDerWaals(6, 2, 7, 1, h + e).U
            )/(2*e), 1e-9
        ) << h;
    }
}

TEST(filmForces, hydrophobic)
{
    // K 1e-18 N m, 2 um, at 10 nm: -(1e-10 - 5e-13) N
    const filmForce f = filmHydrophobic(1e-18, 2e-6, 5e-10, 1e-8);
    EXPECT_NEAR(f.F/-9.95e-11, 1, 1e-12);
    EXPECT_NEAR(f.U/(1e-18*(std::log(0.005) + 0.995)), 1, 1e-12);
    EXPECT_NEAR(filmHydrophobic(1e-18, 2e-6, 1e-8, 0).F/-9.95e-11, 1, 1e-12);
    EXPECT_EQ(filmHydrophobic(1e-18, 2e-6, 5e-10, 2e-6).F, 0);
    EXPECT_EQ(filmHydrophobic(1e-18, 2e-6, 5e-10, 3e-6).U, 0);

    for (const double h : {-1.0, 0.4, 0.9, 1.1, 2.0, 6.9, 7.1})
    {
        const double e = 1e-5;
        EXPECT_NEAR
        (
            filmHydrophobic(3, 7, 1, h).F,
            (
                filmHydrophobic(3, 7, 1, h - e).U
              - filmHydrophobic(3, 7, 1, h + e).U
            )/(2*e), 1e-8
        ) << h;
    }
}

TEST(filmForces, coefficient)
{
    // 1/Rb = 1/2 - 1/6 = 1/3; 6 pi 0.1 9
    EXPECT_NEAR(filmRadius(2, 1.0/6), 3, 1e-14);
    EXPECT_NEAR(filmRadius(2, -0.5), 1, 1e-14);
    EXPECT_NEAR(filmCoefficient(0.1, 2, 1.0/6, 1), 16.964600329384882, 1e-13);
    EXPECT_NEAR(filmCoefficient(0.1, 2, 0, 0.25), 1.8849555921538759, 1e-14);
}

TEST(filmForces, drainageUnderAConstantForce)
{
    // Without other friction, far below hMax: h = h0 exp(F t/k)
    const double k = 2, F = -3, h0 = 1e-3, Sp = 1e-4;
    const lubricationGap wide{1e-12, 1e5};
    for (const double dt : {1e-3, 0.1, 1.0})
    {
        const double u = wide.slowed(F/Sp, h0, k/(Sp*dt), dt);
        EXPECT_NEAR((h0 + u*dt)/(h0*std::exp(F*dt/k)), 1, 1e-6) << dt;
    }

    // With friction and range: dh/dt = F/(Sp + k (1/h - 1/hMax)), one step
    // against 20000 of the midpoint rule
    const double mu = 1e-3, R = 5e-7, drag = 6*M_PI*mu*R;
    const double film = filmCoefficient(mu, R, 4e4, 0.25);
    const double push = -4e-12, dt = 1e-3;
    const lubricationGap gap{5e-10, 5e-8};
    const auto rate = [&](const double h)
    {
        return push/(drag + film*(h < 5e-8 ? 1/h - 1/5e-8 : 0));
    };
    double h = 4.9e-8;
    const int n = 20000;
    for (int i = 0; i < n; i++)
    {
        h += dt/n*rate(h + 0.5*dt/n*rate(h));
    }
    ASSERT_GT(h, 5e-10);
    ASSERT_LT(h, 2.5e-8);
    const double u = gap.slowed(push/drag, 4.9e-8, film/(drag*dt), dt);
    EXPECT_NEAR((4.9e-8 + u*dt)/h, 1, 1e-6);
}

TEST(filmForces, drainageIsStable)
{
    // 0.5 nm in water, step 1e-9 s, relaxation 4e-10 s or less: no turning
    // round, no gain of speed, whatever the step
    const double mu = 3e-4, R = 5e-7, m = 5.5e-16;
    const double k = filmCoefficient(mu, R, 0, 1);
    const lubricationGap gap{5e-10, 5e-8};
    for (const double dt : {1e-12, 1e-9, 1e-6, 1e-3})
    {
        for (const double h : {1e-10, 6e-10, 3e-8})
        {
            for (const double v : {-1e-2, 1e-2})
            {
                const double u = gap.slowed(v, h, k/m, dt);
                EXPECT_GE(u/v, 0);
                EXPECT_LT(u/v, 1);
                EXPECT_NEAR
                (
                    u, v - k/m*(gap.change(h, u*dt)), 1e-9*std::fabs(v)
                );
            }
        }
    }
}
