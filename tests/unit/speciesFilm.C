/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Several vapours through a film: one conductance, and profiles integrated

#include <gtest/gtest.h>
#include "speciesFilm.H"
#include "stefanFlux.H"

using namespace Foam;
using namespace Foam::dew;


// Of one conductance the flow of all is that of one vapour of all fractions
TEST(speciesFilm, equalConductances)
{
    const scalarField g(3, 0.02), y({0.05, 0.0, 0.3}), ys({0.2, 0.1, 0.25});
    const scalar n = speciesFilm::total(g, y, ys);
    EXPECT_NEAR(n/stefanFlux::flux(0.02, 0.35, 0.55), 1, 1e-14);
    EXPECT_NEAR
    (
        speciesFilm::total(scalarField(1, 0.02), scalarField(1, 0.1),
            scalarField(1, 0.9))
       /stefanFlux::flux(0.02, 0.1, 0.9), 1, 1e-14
    );
}


// Along the film n_i = n y_i - g_i dy_i/ds, from the surface by the steps of
// Runge and Kutta, 1000 of order four. The signs differ, and one is none
TEST(speciesFilm, profilesIntegrated)
{
    for (const scalar far : {0.0, 0.1, 0.6})
    {
        const scalarField g({0.01, 0.03, 0.002});
        const scalarField y({far, 0.2, 0.01}), ys({0.3, 0.1, 0.01});
        const scalar n = speciesFilm::total(g, y, ys);
        scalar sum = 0;
        forAll(g, i)
        {
            const scalar ni = speciesFilm::flux(g[i], y[i], ys[i], n);
            sum += ni;
            const auto slope = [&](const scalar Y)
            {
                return (n*Y - ni)/g[i];
            };
            const scalar h = 1e-3;
            scalar Y = ys[i];
            for (label step = 0; step < 1000; step++)
            {
                const scalar a = slope(Y), b = slope(Y + 0.5*h*a);
                const scalar c = slope(Y + 0.5*h*b), d = slope(Y + h*c);
                Y += h/6*(a + 2*b + 2*c + d);
            }
            EXPECT_NEAR(Y, y[i], 1e-11);
        }
        EXPECT_NEAR(sum, n, 1e-15);
        // F' by differences
        const auto F = [&](const scalar total)
        {
            scalar rest = -total;
            forAll(g, i)
            {
                rest += speciesFilm::flux(g[i], y[i], ys[i], total);
            }
            return rest;
        };
        const scalar h = 1e-7;
        EXPECT_NEAR
        (
            (F(n + h) - F(n - h))/(2*h)/speciesFilm::slope(g, y, ys, n), 1, 1e-6
        );
    }
}


// The gradients of the film for those at the surface, by hand: j = 0.003 and
// 0.0006 kg/m2/s, n = 0.0036/0.6, n_i = j_i + n y_si, of the third nothing; and one
// alone
TEST(speciesFilm, gradientsOfTheFilm)
{
    const scalarField g({0.01, 0.03, 0.02});
    const scalarField y({0.0, 0.08, 0.0}), ys({0.3, 0.1, 0.0});
    const scalar n = speciesFilm::total(g, y, ys, true);
    EXPECT_NEAR(n, 0.006, 1e-16);
    EXPECT_NEAR(speciesFilm::flux(0.01, 0, 0.3, n, true), 0.0048, 1e-16);
    EXPECT_NEAR(speciesFilm::flux(0.03, 0.08, 0.1, n, true), 0.0012, 1e-16);
    EXPECT_NEAR(speciesFilm::slope(g, y, ys, n, true), -0.6, 1e-15);
    EXPECT_NEAR(stefanFlux::surfaceFlux(0.01, 0.1, 0.6), 0.0125, 1e-16);
    const scalar h = 1e-6;
    EXPECT_NEAR
    (
        (
            stefanFlux::surfaceFlux(0.01, 0.1, 0.6 + h)
          - stefanFlux::surfaceFlux(0.01, 0.1, 0.6 - h)
        )/(2*h),
        stefanFlux::dSurfaceFluxdys(0.01, 0.1, 0.6), 1e-10
    );
}
