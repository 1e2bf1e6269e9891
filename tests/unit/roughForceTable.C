/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Tables of averages over rough surfaces against the averages themselves
// (roughSurfaces, which colloidForces.C holds against integrals with 60
// digits), for one size and for others, and F = -dU/dh by differences

#include <gtest/gtest.h>
#include "BornRepulsion.H"
#include "doubleLayer.H"
#include "HamakerSpheres.H"
#include "roughForceTable.H"

#include <cmath>

using namespace Foam::dew;

namespace
{

constexpr double hMin = 3e-10, hMax = 6e-8, none = INFINITY;

// Laws of all kinds: exact in size or not, retarded, short and long
struct terms
{
    HamakerSpheres vanDerWaals{1e-20, hMin, 1e-7};
    doubleLayer charges{7e-10, 1e8, hMin};
    BornRepulsion shells{1e-20, 4e-10, hMin};

    std::vector<colloidForce> all(double h, double R1, double R2) const
    {
        const double Rd = 1/(1/R1 + 1/R2);
        return
        {
            vanDerWaals.between(h, R1, 1/R2),
            charges.constantPotential(h, Rd, 0.025, 0.02),
            shells(h, Rd)
        };
    }

    colloidForce operator()(double h, double R1, double R2) const
    {
        colloidForce sum{0, 0};
        for (const colloidForce& f : all(h, R1, R2))
        {
            sum += f;
        }
        return sum;
    }

    // Largest of the averaged forces
    double scale(const roughSurfaces& rough, double h, double R1, double R2)
    const
    {
        double most = 0;
        for (int k = 0; k < 3; k++)
        {
            most = std::max(most, std::fabs(rough(h, [&](const double g)
            {
                return all(g, R1, R2)[k];
            }).F));
        }
        return most;
    }
};

} // End namespace

TEST(roughForceTable, againstTheAverage)
{
    const terms law;
    const double cases[2][3] = {{0.05*hMin, 5e-8, 1e-5}, {1e-9, 2.5e-8, 1e-4}};
    for (const auto& c : cases)
    {
        const double s = c[0], R = c[1];
        const roughSurfaces rough(s, hMin);
        for (const bool wall : {false, true})
        {
            const roughForceTable table(s, hMin, hMax, R, wall, law);
            for (const double m1 : {1.0, 1.37, 33.0})
            {
                for (const double m2 : {1.0, 5.0, 400.0})
                {
                    const double R1 = m1*R, R2 = wall ? none : m2*R;
                    const double tolerance = m1 > 1 || m2 > 1 ? c[2] : 5e-7;
                    for (double h = hMin; h < hMax; h *= 1.31)
                    {
                        const colloidForce f = table(h, R1, R2);
                        const colloidForce exact = rough
                        (
                            h, [&](double g) { return law(g, R1, R2); }
                        );
                        const double scale = law.scale(rough, h, R1, R2);
                        EXPECT_NEAR(f.F, exact.F, tolerance*scale)
                            << s << ' ' << R1 << ' ' << R2 << ' ' << h;
                        EXPECT_NEAR(f.U, exact.U, 3*tolerance*scale*h)
                            << s << ' ' << R1 << ' ' << R2 << ' ' << h;
                    }
                }
            }
        }
    }
}

TEST(roughForceTable, forceIsTheSlopeOfTheEnergy)
{
    const terms law;
    const roughForceTable table(1e-9, hMin, hMax, 1e-7, false, law);
    const roughSurfaces rough(1e-9, hMin);
    for (const double R2 : {1e-7, 4e-7})
    {
        for (double h = 1.01*hMin; h < 0.9*hMax; h *= 1.031)
        {
            // Round-off of U over the step; the sum of forces has zeros
            const double d = 1e-4*h;
            const double slope =
                (table(h + d, 1e-7, R2).U - table(h - d, 1e-7, R2).U)/(2*d);
            const colloidForce f = table(h, 1e-7, R2);
            EXPECT_NEAR
            (
                -slope, f.F, 1e-6*law.scale(rough, h, 1e-7, R2)
            ) << h;
        }
    }
}
