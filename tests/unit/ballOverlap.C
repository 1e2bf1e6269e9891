/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Overlap of a ball with a polyhedron: half-spaces, edges, corners and
// tetrahedra against quadrature (reference/ballOverlap.py), and parts of a ball
// that must add up to it; points that stand for a particle

#include <gtest/gtest.h>
#include "ballPolyhedron.H"
#include "counterRandom.H"
#include "divided.H"
#include "mathematicalConstants.H"
#include "table.H"

#include <algorithm>

using namespace Foam;
using namespace Foam::dew;
using constant::mathematical::pi;

namespace
{

using polygon = std::vector<point>;

//- A convex polyhedron, its faces counter-clockwise from outside
struct solid
{
    std::vector<polygon> faces;

    explicit solid(const scalar h)
    {
        for (label k = 0; k < 3; k++)
        {
            for (const scalar side : {-h, h})
            {
                const scalar u[4] = {-h, h, h, -h}, v[4] = {-h, -h, h, h};
                polygon f(4);
                for (label i = 0; i < 4; i++)
                {
                    f[side > 0 ? i : 3 - i][k] = side;
                    f[side > 0 ? i : 3 - i][(k + 1) % 3] = u[i];
                    f[side > 0 ? i : 3 - i][(k + 2) % 3] = v[i];
                }
                faces.push_back(f);
            }
        }
    }

    //- Keep n.x < d
    void clip(const vector& n, const scalar d)
    {
        std::vector<polygon> kept;
        polygon cut;
        for (const polygon& f : faces)
        {
            polygon g;
            for (std::size_t i = 0; i < f.size(); i++)
            {
                const point& a = f[i];
                const point& b = f[(i + 1) % f.size()];
                const scalar sa = (n & a) - d, sb = (n & b) - d;
                if (sa <= 0)
                {
                    g.push_back(a);
                }
                if ((sa < 0 && sb > 0) || (sa > 0 && sb < 0))
                {
                    // From the same end on both faces of the edge
                    const point p
                    (
                        sa < 0 ? a + sa/(sa - sb)*(b - a)
                      : b + sb/(sb - sa)*(a - b)
                    );
                    g.push_back(p);
                    cut.push_back(p);
                }
                else if (sa == 0)
                {
                    cut.push_back(a);
                }
            }
            if (g.size() > 2)
            {
                kept.push_back(g);
            }
        }
        faces = kept;

        // Around their middle, each once
        point middle(Zero);
        for (const point& p : cut)
        {
            middle += p/scalar(cut.size());
        }
        const vector u(normalised(n^vector(0.3, -0.5, 0.8)));
        const vector v((n^u)/mag(n));
        const auto angle = [&](const point& p)
        {
            return std::atan2(v & (p - middle), u & (p - middle));
        };
        std::sort
        (
            cut.begin(), cut.end(),
            [&](const point& a, const point& b) { return angle(a) < angle(b); }
        );
        polygon cap;
        for (const point& p : cut)
        {
            if (cap.empty() || mag(p - cap.back()) > 1e-12)
            {
                cap.push_back(p);
            }
        }
        if (cap.size() > 2)
        {
            faces.push_back(cap);
        }
    }

    //- In a ball of radius R about c, all scaled by R
    scalar overlap(const point& c, const scalar R) const
    {
        const sphericalCap ball(c, vector(0, 0, 1), R, 0.5*pi);
        ballPolyhedron part;
        part.begin(ball);
        bool inside = faces.size() > 3;
        for (const polygon& f : faces)
        {
            vector n(Zero);
            std::vector<point> x;
            for (std::size_t i = 0; i < f.size(); i++)
            {
                n += (f[i] - f[0])^(f[(i + 1) % f.size()] - f[0]);
                x.push_back(c + R*f[i]);
            }
            n /= mag(n);
            inside = inside && (n & f[0]) > 0;
            EXPECT_LE(f.size(), std::size_t(ballPolyhedron::maxCorners));
            part.add(x.data(), x.size(), n);
        }
        return part.volume([&]() { return inside; })/pow3(R);
    }
};

} // End anonymous namespace


TEST(ballOverlap, halfSpacesAgainstQuadrature)
{
    const auto rows = readTable("ballOverlap.csv");
    ASSERT_EQ(rows.size(), 34u);
    for (const auto& row : rows)
    {
        solid body(3);
        for (std::size_t i = 1; i < row.size(); i += 4)
        {
            body.clip(vector(row[i], row[i + 1], row[i + 2]), row[i + 3]);
        }

        // 11 digits of the quadrature; of balls of 1e-6 m at 1e-3 m 10 are left
        EXPECT_NEAR(body.overlap(Zero, 1), row[0], 1e-10) << row[4];
        EXPECT_NEAR(body.overlap(point(1e-3, -2e-3, 5e-4), 1e-6), row[0], 1e-9);
        EXPECT_NEAR(body.overlap(point(100, 20, 3), 1e3), row[0], 1e-10);
    }
}


TEST(ballOverlap, corners)
{
    // Closed forms: an eighth; all; nothing; a cap pi h^2 (3 - h)/3
    solid eighth(3);
    eighth.clip(vector(1, 0, 0), 0);
    eighth.clip(vector(0, 1, 0), 0);
    eighth.clip(vector(0, 0, 1), 0);
    EXPECT_NEAR(eighth.overlap(Zero, 1), pi/6, 1e-14);
    EXPECT_NEAR(solid(3).overlap(Zero, 1), 4*pi/3, 1e-14);
    EXPECT_NEAR(solid(1).overlap(Zero, 1), 4*pi/3, 1e-14);
    EXPECT_NEAR(solid(0.5).overlap(Zero, 1), 1, 1e-14);
    EXPECT_NEAR(solid(0.9).overlap(Zero, 1), 4*pi/3 - 6*pi*0.01*2.9/3, 1e-13);

    solid away(3);
    away.clip(vector(1, 0, 0), -1.5);
    EXPECT_EQ(away.overlap(Zero, 1), 0);
}


TEST(ballOverlap, partsAddUp)
{
    // Random planes cut the ball into eight; circles that almost touch, too
    counterRandom random(11);
    for (label i = 0; i < 300; i++)
    {
        vector n[3];
        scalar d[3];
        for (label k = 0; k < 3; k++)
        {
            const auto draw = [&]()
            {
                return random.uniform() - 0.5;
            };
            n[k] = normalised(vector(draw(), draw(), draw()));
            d[k] = i % 5 == 0 ? (k - 1)*(1 - 1e-9) : 1.8*draw();
        }

        scalar sum = 0;
        for (label part = 0; part < 8; part++)
        {
            solid body(3);
            for (label k = 0; k < 3 && body.faces.size(); k++)
            {
                const scalar side = part & (1 << k) ? -1 : 1;
                body.clip(side*n[k], side*d[k]);
            }
            const scalar v = body.overlap(Zero, 1);
            EXPECT_GE(v, 0);
            sum += v;
        }
        EXPECT_NEAR(sum, 4*pi/3, 1e-12) << i;
    }
}


TEST(divided, anyNumberOfPoints)
{
    for (const label n : {1, 2, 3, 7, 8, 29, 30, 100, 101, 1000, 5001})
    {
        const List<vector> points(divided::spirals(n));
        ASSERT_EQ(points.size(), n);
        vector centre(Zero);
        scalar square = 0, most = 0;
        for (const vector& p : points)
        {
            centre += p/n;
            square += magSqr(p)/n;
            most = max(most, mag(p));
        }
        EXPECT_NEAR(mag(centre), 0, 1e-15);
        EXPECT_LT(most, 1);

        // Mean square of a ball's points is 3/5; less by the parts' own size
        if (n >= 100)
        {
            EXPECT_NEAR(square, 0.6, 1/std::cbrt(scalar(n*n)));
        }

        // No half-space has more or less than a part of the points too much:
        // a ball's share is (2 - 3 t + t^3)/4 beyond t
        for (label k = 0; k < 3 && n >= 100; k++)
        {
            for (const scalar t : {-0.6, -0.2, 0.1, 0.5})
            {
                scalar beyond = 0;
                for (const vector& p : points)
                {
                    beyond += scalar(p[k] > t)/n;
                }
                EXPECT_NEAR
                (
                    beyond, (2 - 3*t + t*t*t)/4, 1/std::cbrt(scalar(n))
                );
            }
        }
    }
}
