/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// A sphere in the surface: its cap against Archimedes' h^2 (3R - h)/(4R^3), the
// contact line against vectors of the tension there, slopes against
// differences, detachment against 1/2 pi d sigma (1 - cos(theta)) = 5.65e-8 N
// for d = 1 um, 0.072 N/m, 60 degrees; energies against the interfaces' areas

#include <gtest/gtest.h>
#include "sphereInSurface.H"

using namespace Foam::dew;

static const double pi = 3.14159265358979323846;

TEST(sphereInSurface, share)
{
    EXPECT_EQ(shareInLiquid(0), 0.5);
    EXPECT_EQ(shareInLiquid(-1.2), 1);
    EXPECT_EQ(shareInLiquid(3), 0);
    for (double z = -1; z <= 1; z += 0.125)
    {
        const double h = 1 - z;
        EXPECT_NEAR(shareInLiquid(z), h*h*(3 - h)/4, 1e-15) << z;
        EXPECT_NEAR(shareInLiquid(z) + shareInLiquid(-z), 1, 1e-15) << z;
    }
}

TEST(sphereInSurface, tensionAtTheContactLine)
{
    const double R = 2e-3, sigma = 0.05;
    for (const double theta : {0.0, 0.3, 1.0, pi/2, 2.5, pi})
    {
        for (double z = -0.96; z < 1; z += 0.12)
        {
            // Radius and normal at the line: the sphere's tangent into the
            // liquid, turned by theta towards its normal
            const double r = std::sqrt(1 - z*z), n = -z;
            const double up = -std::cos(theta)*r + std::sin(theta)*n;
            const contactLinePull pull(sigma, theta, R, z*R);
            EXPECT_NEAR(pull.force, 2*pi*r*R*sigma*up, 1e-12*R*sigma);

            const double e = 1e-6;
            const double slope =
                (
                    contactLinePull(sigma, theta, R, (z + e)*R).force
                  - contactLinePull(sigma, theta, R, (z - e)*R).force
                )/(2*e*R);
            EXPECT_NEAR(pull.stiffness, -slope, 1e-7*sigma) << z;
        }
    }
}

TEST(sphereInSurface, restAndEnds)
{
    const double R = 1e-4, sigma = 0.072;
    for (const double theta : {0.2, 1.0, 2.0, 3.0})
    {
        const contactLinePull rest(sigma, theta, R, -R*std::cos(theta));
        EXPECT_NEAR(rest.force, 0, 1e-15*sigma*R);
        EXPECT_NEAR(rest.stiffness, 2*pi*sigma, 1e-12*sigma);
    }
    for (const double z : {-1.0, 1.0, -5.0, 5.0})
    {
        EXPECT_EQ(contactLinePull(sigma, 1, R, z*R).force, 0);
        EXPECT_EQ(contactLinePull(sigma, 1, R, z*R).stiffness, 0);
    }
}

TEST(sphereInSurface, detachment)
{
    const double R = 5e-7, sigma = 0.072, theta = pi/3;
    double most = 0, least = 0;
    for (int i = 0; i <= 200000; i++)
    {
        const double F =
            contactLinePull(sigma, theta, R, R*(i/1e5 - 1)).force;
        most = std::fmax(most, F);
        least = std::fmin(least, F);
    }
    EXPECT_NEAR(most, 5.65e-8, 0.005e-8);
    EXPECT_NEAR(most/(pi*2*R*sigma*std::pow(std::sin(theta/2), 2)), 1, 1e-9);
    EXPECT_NEAR(-least/(pi*R*sigma*(1 + std::cos(theta))), 1, 1e-9);
}

TEST(sphereInSurface, work)
{
    const double R = 3e-5, sigma = 0.03, theta = 2.1;
    double sum = 0;
    const int n = 400000;
    for (int i = 0; i < n; i++)
    {
        const double z = 2*(i + 0.5)/n - 1;
        sum -= contactLinePull(sigma, theta, R, z*R).force*2*R/n;
        if (i == n/2 - 1)
        {
            EXPECT_NEAR
            (
                sum/(2*pi*R*R*sigma),
                std::cos(theta)*2/3 - std::sin(theta)/3, 1e-7
            );
        }
    }
    EXPECT_NEAR(sum/(8*pi/3*R*R*sigma*std::cos(theta)), 1, 1e-6);
}

// Work from rest to the nearer end, in the angle, where all is smooth
template<class Pull>
static double workOfDetachment
(
    const double sigma,
    const double theta,
    const double R
)
{
    const double end = theta < pi/2 ? 0 : pi;
    const int n = 20000;
    double work = 0;
    for (int i = 0; i < n; i++)
    {
        const double b = theta + (end - theta)*(i + 0.5)/n;
        work -=
            Pull(sigma, theta, R, -R*std::cos(b)).force
           *R*std::sin(b)*(end - theta)/n;
    }
    return work;
}

TEST(sphereInSurface, energyOfDetachment)
{
    const double R = 2e-7, sigma = 0.04;
    for (const double theta : {0.4, 1.2, pi/2, 2.0, 2.9})
    {
        const double E = detachmentEnergy(sigma, theta, R);
        const double plane =
            workOfDetachment<planeSurfacePull>(sigma, theta, R);
        const double line =
            workOfDetachment<contactLinePull>(sigma, theta, R);
        EXPECT_NEAR(plane/E, 1, 1e-8);
        EXPECT_NEAR(line/E, 2.0/3, 1e-8);
    }
}

TEST(sphereInSurface, energyOfThePlane)
{
    // Areas: dry part of the sphere times sigma cos(theta), less the disc cut
    // out of the surface
    const double R = 3, sigma = 0.5, theta = 1.1;
    const auto areas = [&](const double z)
    {
        return
            sigma*(2*pi*R*R*(1 + z)*std::cos(theta) - pi*R*R*(1 - z*z));
    };
    for (double z = -0.95; z < 1; z += 0.1)
    {
        const planeSurfacePull pull(sigma, theta, R, z*R);
        EXPECT_NEAR(pull.energy, areas(z) - areas(-std::cos(theta)), 1e-12);

        const double e = 1e-5;
        EXPECT_NEAR
        (
            pull.force, (areas(z - e) - areas(z + e))/(2*e*R), 1e-8
        );
        EXPECT_NEAR(pull.stiffness, 2*pi*sigma, 1e-14);
    }
    const planeSurfacePull in(sigma, theta, R, -4*R), out(sigma, theta, R, R);
    EXPECT_EQ(in.force, 0);
    EXPECT_EQ(out.stiffness, 0);
    EXPECT_NEAR(in.energy/detachmentEnergy(sigma, theta, R), 1, 1e-14);
}
