/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// The Stefan tube: numbers by hand, and the flux through an integrated profile

#include <cmath>
#include <gtest/gtest.h>
#include "stefanFlux.H"

using namespace Foam;
using namespace Foam::dew;

namespace
{

const scalar p = 101325, T = 298.15, L = 1e-3;

} // End anonymous namespace


// N = p D/(Ru T L) ln(1/(1 - x0)) in double precision with Ru 8.314462618 and
// pSat 3169.9 Pa (IAPWS) and 7870 Pa (CRC Handbook), 18.015 and 46.069 g/mol
TEST(stefanFlux, tubeOfWaterAndEthanol)
{
    const scalar water =
        stefanFlux::flux
        (
            stefanFlux::moleConductance(p, T, 2.5e-5, L, 18.015e-3), 0,
            0.03128
        );
    // x0 has four digits: 1.6e-4
    EXPECT_NEAR(water/5.85087e-4, 1, 2e-4);
    EXPECT_NEAR(water/18.015e-3/3.24778e-2, 1, 2e-4);

    const scalar ethanol =
        stefanFlux::flux
        (
            stefanFlux::moleConductance(p, T, 1.19e-5, L, 46.069e-3), 0,
            7870/p
        );
    EXPECT_NEAR(ethanol/1.81176e-3, 1, 1e-5);
    EXPECT_NEAR(ethanol/46.069e-3/3.93271e-2, 1, 1e-5);
}


// The share that pure diffusion has: x0/ln(1/(1 - x0))
TEST(stefanFlux, FickIsLess)
{
    const scalar g = stefanFlux::moleConductance(p, T, 2.5e-5, L, 18.015e-3);
    EXPECT_NEAR
    (
        stefanFlux::fickFlux(g, 0, 0.03128)/stefanFlux::flux(g, 0, 0.03128),
        0.98428, 1e-5
    );
    EXPECT_NEAR
    (
        stefanFlux::fickFlux(g, 0, 7870/p)/stefanFlux::flux(g, 0, 7870/p),
        0.96064, 1e-5
    );
}


// From y = ys to far apart, both signs; with log1p no digit is lost
TEST(stefanFlux, smallDifferencesAndSigns)
{
    EXPECT_EQ(stefanFlux::flux(2, 0.3, 0.3), 0);

    // 0.3 and some 1e-12 more, d as it is stored: ln(1 + d/(0.7 - d)) is
    // d/0.7 to 1e-12; (1 - y)/(1 - ys) has lost four of its digits
    const scalar more = 0.3 + 1e-12, d = more - 0.3;
    EXPECT_NEAR(stefanFlux::flux(1, 0.3, more)*0.7/d, 1, 1e-11);
    EXPECT_NEAR(stefanFlux::flux(1, more, 0.3)*0.7/d, -1, 1e-11);

    EXPECT_LT(stefanFlux::flux(1, 0.9, 0.1), 0);
    EXPECT_NEAR(stefanFlux::flux(1, 0.9, 0.1), -std::log(9), 1e-15);
    EXPECT_NEAR(stefanFlux::flux(1, 0, 1 - 1e-9), 9*std::log(10), 1e-6);
    EXPECT_NEAR(stefanFlux::logArgument(0.1, 0.9), 9, 1e-14);
    EXPECT_LT(stefanFlux::logArgument(0.1, 1.1), 0);
}


TEST(stefanFlux, derivatives)
{
    const scalar g = 3, h = 1e-6;
    for (const scalar y : {0.0, 0.2, 0.7})
    {
        for (const scalar ys : {0.0, 0.5, 0.9})
        {
            EXPECT_NEAR
            (
                (
                    stefanFlux::flux(g, y + h, ys)
                  - stefanFlux::flux(g, y - h, ys)
                )/(2*h)/stefanFlux::dFluxdy(g, y), 1, 1e-8
            );
            EXPECT_NEAR
            (
                (
                    stefanFlux::flux(g, y, ys + h)
                  - stefanFlux::flux(g, y, ys - h)
                )/(2*h)/stefanFlux::dFluxdys(g, ys), 1, 1e-8
            );
        }
    }
}


// Ethanol in air, from Y 0.6 to 0: dY/dz = -N (1 - Y)/(rho(Y) D) integrated by
// Runge-Kutta over the film with N of the mole form must end at 0; with N of
// the mass form and the density of either end it does not
TEST(stefanFlux, massAndMoleForm)
{
    const scalar Wv = 46.069e-3, Wc = 28.9647e-3, D = 1.19e-5;
    const auto W = [=](const scalar Y) { return 1/(Y/Wv + (1 - Y)/Wc); };
    const auto rho = [=](const scalar Y)
    {
        return p*W(Y)/(8.314462618*T);
    };
    const auto end = [=](const scalar N)
    {
        const auto slope = [=](const scalar Y)
        {
            return -N*(1 - Y)/(rho(Y)*D);
        };
        scalar Y = 0.6;
        const scalar dz = L/1000;
        for (int i = 0; i < 1000; i++)
        {
            const scalar a = slope(Y), b = slope(Y + a*dz/2);
            const scalar c = slope(Y + b*dz/2), d = slope(Y + c*dz);
            Y += dz/6*(a + 2*b + 2*c + d);
        }
        return Y;
    };

    const scalar xs = 0.6*W(0.6)/Wv;
    const scalar N =
        stefanFlux::flux
        (
            stefanFlux::moleConductance(p, T, D, L, Wv), 0, xs
        );
    EXPECT_NEAR(end(N), 0, 1e-12);

    for (const scalar Y : {0.0, 0.6})
    {
        const scalar mass =
            stefanFlux::flux(stefanFlux::massConductance(rho(Y), D, L), 0, 0.6);
        EXPECT_GT(mag(end(mass)), 0.02);
    }

    // The density that makes the mass form right
    const scalar ln = std::log(1/(1 - xs));
    const scalar mean =
        p/(8.314462618*T)*Wv*ln/(ln + std::log(W(0.6)/W(0)));
    EXPECT_NEAR
    (
        stefanFlux::flux(stefanFlux::massConductance(mean, D, L), 0, 0.6)/N,
        1, 1e-14
    );
}
