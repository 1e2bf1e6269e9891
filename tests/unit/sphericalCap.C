/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// The cap of a drop: volume and angle against 80-digit numbers of the formula
// in cos and sin (reference/sphericalCap.py), where the code has none of them;
// distances against the sphere written out

#include <gtest/gtest.h>
#include "counterRandom.H"
#include "insertionRegion.H"
#include "mathematicalConstants.H"
#include "sphericalCap.H"
#include "StringStream.H"
#include "table.H"

using namespace Foam;
using namespace Foam::dew;
using constant::mathematical::pi;

TEST(sphericalCap, volumeAndAngle)
{
    const auto rows = readTable("sphericalCap.csv");
    ASSERT_EQ(rows.size(), 14u);
    for (const auto& row : rows)
    {
        const scalar theta = row[0], V = row[1];
        const scalar a = 25e-6;
        const sphericalCap cap(point(1, 2, 3), vector(0, 0, 2), a, theta);

        // The slope of V near pi, V ~ (pi - theta)^-3, makes more of round-off
        const scalar tolerance = 1e-14 + 1e-15/(pi - theta);
        EXPECT_NEAR(cap.volume()/(V*pow3(a)), 1, tolerance);
        EXPECT_NEAR(sphericalCap::angle(V*pow3(a), a)/theta, 1, 1e-14);
        EXPECT_NEAR(cap.angle()/theta, 1, 1e-14);
        EXPECT_NEAR
        (
            sphericalCap::contactRadius(V*pow3(a), theta)/a, 1, tolerance
        );
        EXPECT_NEAR(cap.radius()*std::sin(theta)/a, 1, tolerance);
        EXPECT_NEAR(cap.curvature()*cap.radius(), 1, 1e-14);
        EXPECT_NEAR(mag(cap.normal()), 1, 1e-15);
    }
}


TEST(sphericalCap, ofUnitVolume)
{
    // theta in degrees, a and h of V = 1: a table of sessile drops
    const scalar table[][3] =
    {
        {40, 1.18763, 0.43226}, {60, 0.99746, 0.57588},
        {90, 0.78159, 0.78159}, {120, 0.56854, 0.98475}
    };
    for (const auto& row : table)
    {
        const scalar theta = row[0]*pi/180;
        const scalar a = sphericalCap::contactRadius(1, theta);
        EXPECT_NEAR(a, row[1], 5.1e-6);
        const sphericalCap cap(Zero, vector(1, 0, 0), a, theta);
        EXPECT_NEAR(cap.height(), row[2], 5.1e-6);
    }
}


TEST(sphericalCap, distances)
{
    counterRandom random(7);
    for (const scalar theta : {0.4, 1.2, 1.5707963267948966, 2.2, 2.9})
    {
        const vector n(vector(0.3, -0.5, 0.7)/mag(vector(0.3, -0.5, 0.7)));
        const point b(0.2, 0.1, -0.4);
        const sphericalCap cap(b, n, 1.5, theta);
        const scalar R = 1.5/std::sin(theta);
        const point c(b - n*1.5/std::tan(theta));

        EXPECT_NEAR(mag(cap.centre() - c), 0, 1e-13*R);
        EXPECT_NEAR(cap.height(), R*(1 - std::cos(theta)), 1e-13*R);
        EXPECT_NEAR(cap.psi(c), R, 1e-13*R);
        EXPECT_NEAR(mag(cap.outward(c)), 1, 1e-13);

        point last(b);
        for (label i = 0; i < 100; i++)
        {
            point x;
            x.x() = 8*random.uniform() - 4;
            x.y() = 8*random.uniform() - 4;
            x.z() = 8*random.uniform() - 4;
            const scalar psi = R - mag(x - c);
            EXPECT_NEAR(cap.psi(x), psi, 1e-13*R);
            EXPECT_NEAR(mag(cap.outward(x) - (x - c)/mag(x - c)), 0, 1e-12);
            EXPECT_NEAR(mag(cap.foot(x) - c), R, 1e-13*R);

            // The part of a way inside: its ends are on the sphere or its own
            scalar t0, t1;
            const bool any = sphericalCap::inside
            (
                cap.power(last), cap.power(x), magSqr(x - last), t0, t1
            );
            const scalar nearest =
                ((c - last) & (x - last))/magSqr(x - last);
            const point middle
            (
                last + min(max(nearest, scalar(0)), scalar(1))*(x - last)
            );
            EXPECT_EQ(any, mag(middle - c) < R);
            if (any)
            {
                for (const scalar t : {t0, t1})
                {
                    const scalar d = mag(last + t*(x - last) - c);
                    EXPECT_TRUE
                    (
                        mag(d - R) < 1e-12*R || (d < R && (t == 0 || t == 1))
                    );
                }
                EXPECT_LT(t0, t1);
            }
            last = x;
        }
    }
}


TEST(sphericalCap, refuses)
{
    EXPECT_ANY_THROW(sphericalCap(Zero, vector(0, 0, 1), 0, 1));
    EXPECT_ANY_THROW(sphericalCap(Zero, vector(0, 0, 1), 1, 0));
    EXPECT_ANY_THROW(sphericalCap(Zero, vector(0, 0, 1), 1, pi));
    EXPECT_ANY_THROW(sphericalCap::angle(0, 1));
    EXPECT_ANY_THROW(sphericalCap::angle(1, -1));
    EXPECT_ANY_THROW(sphericalCap::contactRadius(-1, 1));
    EXPECT_ANY_THROW(sphericalCap::contactRadius(1, 0));
}


TEST(sphericalCap, region)
{
    // Volume by counting; whole spheres inside
    const auto read = [](const std::string& text)
    {
        return insertionRegion::New(dictionary(IStringStream(text)()));
    };
    const std::string place
    (
        "type sphericalCap; centre (1 2 3); axis (1 1 0); contactRadius 2;"
    );
    counterRandom random(5);
    for (const scalar degrees : {30, 90, 140})
    {
        const auto region =
            read(place + "contactAngle " + std::to_string(degrees) + ";");
        const scalar theta = degrees*pi/180;
        const vector n(vector(1, 1, 0)/std::sqrt(2.0));
        const scalar R = 2/std::sin(theta);
        const point b(1, 2, 3), c(b - n*2/std::tan(theta));
        const boundBox box(region->bounds());

        label inside = 0;
        const label tries = 40000;
        for (label i = 0; i < tries; i++)
        {
            // Also around the bounds
            point x;
            for (direction k = 0; k < 3; k++)
            {
                x[k] =
                    box.min()[k]
                  + (1.4*random.uniform() - 0.2)*box.span()[k];
            }
            const scalar r = 0.1;
            EXPECT_EQ
            (
                region->holds(x, r),
                ((x - b) & n) >= r && R - mag(x - c) >= r
            );
            const bool in = ((x - b) & n) >= 0 && mag(x - c) <= R;
            EXPECT_EQ(region->holds(x, 0), in);
            inside += in;
            EXPECT_TRUE(!in || box.contains(x));
        }

        // Five standard deviations
        const scalar share = scalar(inside)/tries;
        EXPECT_NEAR
        (
            share*pow3(1.4)*box.volume()/region->volume(),
            1,
            5*std::sqrt((1 - share)/(share*tries))
        );
    }

    EXPECT_ANY_THROW(read(place + "contactAngle 180;"));
    EXPECT_ANY_THROW(read(place + "contactAngle 0;"));
    EXPECT_ANY_THROW(read(place + "contactAngle 40; height 2;"));
    EXPECT_ANY_THROW(read(place));
}
