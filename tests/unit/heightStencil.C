/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Curvature from mean heights of surfaces given by formulas, in units of a
// column: on those of even curvature what Gauss' rule of four points leaves,
// on others no more error than by the quadratics alone. Expected: div n of the
// implicit surface. Heights by 48 x 48 points per column

#include <gtest/gtest.h>
#include "heightStencil.H"

#include <cmath>
#include <functional>

using namespace Foam;
using namespace Foam::dew;

namespace
{

using heightOf = std::function<scalar(scalar, scalar)>;

//- From, to of the columns along an axis: the cell, below, above
struct columns
{
    scalar x[3][2];

    columns(const scalar below, const scalar own, const scalar above)
    :
        x
        {
            {-0.5*own, 0.5*own},
            {-0.5*own - below, -0.5*own},
            {0.5*own, 0.5*own + above}
        }
    {}
};

scalar mean
(
    const heightOf& z, const scalar a[2], const scalar b[2], const bool flat
)
{
    constexpr label n = 48;
    scalar sum = 0;
    for (label i = 0; i < n; i++)
    {
        for (label j = 0; j < (flat ? 1 : n); j++)
        {
            sum +=
                z
                (
                    a[0] + (i + 0.5)/n*(a[1] - a[0]),
                    flat ? 0 : b[0] + (j + 0.5)/n*(b[1] - b[0])
                );
        }
    }
    return sum/(flat ? n : n*n);
}

struct result
{
    scalar rough, K;
    bool found;
};

//- Of the surface z(a, b); one axis if flat
result curvature
(
    const heightOf& z, const bool flat,
    const columns& a = {1, 1, 1}, const columns& b = {1, 1, 1}
)
{
    heightStencil stencil;
    stencil.nAxes = flat ? 1 : 2;
    stencil.ring = false;
    const columns* of[2] = {&a, &b};
    for (label axis = 0; axis < stencil.nAxes; axis++)
    {
        const auto& x = of[axis]->x;
        stencil.setCell(axis, x[0][1] - x[0][0], 0);
        stencil.setBeside(axis, 0, x[1][1] - x[1][0]);
        stencil.setBeside(axis, 1, x[2][1] - x[2][0]);
    }

    heightStencil::values v;
    for (label side = 0; side < 3; side++)
    {
        v.line[0][side] = mean(z, a.x[side], b.x[0], flat);
        if (!flat)
        {
            v.line[1][side] = mean(z, a.x[0], b.x[side], flat);
            for (label sidea = 0; side > 0 && sidea < 3; sidea++)
            {
                v.beyond[side - 1][sidea] =
                    mean(z, a.x[sidea], b.x[side], flat);
            }
        }
    }

    result r;
    heightStencil::derivatives d(stencil.finite(v));
    r.rough = stencil.curvature(d, 0);
    r.found = stencil.refine(d);
    r.K = stencil.curvature(d, 0);
    return r;
}

//- x.D.x = 1 with the matrix D = e_i e_i/r_i^2, its upper half over the position p
struct quadric
{
    vector e[3];
    scalar q[3];
    vector p;

    //- Radii along two directions across tilt, and along it; 0: a cylinder
    quadric(const vector& tilt, const scalar r0, const scalar r1, const scalar r2)
    {
        e[2] = tilt/mag(tilt);
        e[0] = vector(1, 0.3, 0) ^ e[2];
        e[0] /= mag(e[0]);
        e[1] = e[2] ^ e[0];
        q[0] = 1/sqr(r0);
        q[1] = 1/sqr(r1);
        q[2] = r2 > 0 ? 1/sqr(r2) : 0;
    }

    vector times(const vector& x) const
    {
        vector sum(Zero);
        for (label i = 0; i < 3; i++)
        {
            sum += q[i]*(x & e[i])*e[i];
        }
        return sum;
    }

    scalar height(const scalar a, const scalar b) const
    {
        const vector x(p.x() + a, p.y() + b, 0);
        const vector z(0, 0, 1);
        const scalar A = z & times(z);
        const scalar B = x & times(z);
        const scalar C = (x & times(x)) - 1;
        return (-B + std::sqrt(sqr(B) - A*C))/A;
    }

    scalar curvature() const
    {
        const vector x(p.x(), p.y(), height(0, 0));
        const vector g(times(x));
        return (q[0] + q[1] + q[2])/mag(g) - (g & times(g))/pow3(mag(g));
    }

    //- Errors by quadratics and in all, relative to K
    result errors(const bool flat) const
    {
        result r
        (
            ::curvature
            (
                [&](const scalar a, const scalar b) { return height(a, b); },
                flat
            )
        );
        r.rough = r.rough/curvature() - 1;
        r.K = r.K/curvature() - 1;
        return r;
    }
};

//- Largest error by quadratics, and in all, over points up to `within` of the
//  middle
result largest(quadric shape, const bool flat, const scalar within)
{
    result most{0, 0, true};
    constexpr label n = 5;
    for (label i = 0; i < n; i++)
    {
        for (label j = 0; j < (flat ? 1 : n); j++)
        {
            shape.p = vector
            (
                within*(2*(i + 0.37)/n - 1),
                flat ? 0 : within*(2*(j + 0.61)/n - 1),
                0
            );
            const result r(shape.errors(flat));
            most.rough = max(most.rough, mag(r.rough));
            most.K = max(most.K, mag(r.K));
            most.found = most.found && r.found;
        }
    }
    return most;
}

} // End anonymous namespace


TEST(heightStencil, circlesAreExact)
{
    for (const scalar R : {6.4, 12.8, 25.0})
    {
        const result r(largest(quadric({0, 1, 0}, R, R, 0), true, 0.7*R));
        EXPECT_TRUE(r.found);
        EXPECT_LT(r.K, 5e-5);
        EXPECT_GT(r.rough, 0.375/sqr(R));
    }
}


TEST(heightStencil, spheresAreExact)
{
    for (const scalar R : {6.4, 12.8})
    {
        const result r(largest(quadric({0, 1, 0}, R, R, R), false, 0.5*R));
        EXPECT_TRUE(r.found);
        EXPECT_LT(r.K, 5e-5);
    }
}


TEST(heightStencil, cylindersAreExact)
{
    for (const vector& tilt : {vector(0, 1, 0), vector(1, 0.6, 0.3)})
    {
        const result r(largest(quadric(tilt, 8, 8, 0), false, 4));
        EXPECT_TRUE(r.found);
        EXPECT_LT(r.K, 5e-5);
    }
}


TEST(heightStencil, unevenWidths)
{
    const scalar R = 8;
    const auto z = [&](const scalar a, const scalar b)
    {
        return std::sqrt(sqr(R) - sqr(a + 3) - sqr(b - 2));
    };
    const result r(curvature(z, false, {0.7, 1, 1.4}, {1.3, 1.1, 0.8}));
    EXPECT_NEAR(r.K*R/2, 1, 5e-5);
}


// Ellipses have no even curvature, and their least radius is below 8: no worse
// than by quadratics up to the ratio 1.5 of their axes (1.00), much better near
// the circle (0.34 and 0.66 measured)
TEST(heightStencil, ellipses)
{
    const scalar limits[] = {0.4, 0.75, 1.05};
    label i = 0;
    for (const scalar ratio : {1.1, 1.25, 1.5})
    {
        scalar rough = 0, all = 0;
        for (const bool flat : {true, false})
        {
            const scalar A = flat ? 8*ratio : 8;
            const scalar B = flat ? 8 : 8*ratio;
            quadric e({0, 1, 0}, 1, 1, 0);
            e.e[0] = vector(1, 0, 0);
            e.e[1] = vector(0, 0, 1);
            e.q[0] = 1/sqr(A);
            e.q[1] = 1/sqr(B);
            for (scalar x = 0; x < sqr(A)/std::sqrt(sqr(A) + sqr(B)); x += 0.25)
            {
                e.p = vector(x, 0, 0);
                const result r(e.errors(true));
                rough += sqr(r.rough*e.curvature());
                all += sqr(r.K*e.curvature());
            }
        }
        EXPECT_LT(std::sqrt(all/rough), limits[i++]);
    }
}


TEST(heightStencil, ellipsoids)
{
    for (const scalar ratio : {0.8, 1.25})
    {
        const quadric shape({0.4, 0.3, 1}, 8, 8, 8*ratio);
        const result r(largest(shape, false, 3));
        EXPECT_LT(r.K, r.rough);
    }
}


// Waves of cos(k x): the means over a column and the difference of three take
// (sin(k/2)/(k/2))^3 of the curvature; the rest is 3/8 K^2 of a crest that is
// no circle
TEST(heightStencil, waves)
{
    const scalar k = 2*M_PI/16;
    const scalar share = pow3(std::sin(0.5*k)/(0.5*k));
    for (const scalar steepness : {1e-3, 0.3})
    {
        const scalar A = steepness/k;
        const scalar K = A*sqr(k);
        const result crest
        (
            curvature([&](scalar a, scalar) { return A*std::cos(k*a); }, true)
        );
        EXPECT_NEAR(crest.rough/K, share, 1e-4);
        EXPECT_NEAR(crest.K/K, share - 0.375*sqr(K), 1e-3);
    }
}


// z = a b/L over (a0, b0), where K = 2 a0 b0/(L N)^3
TEST(heightStencil, saddle)
{
    const scalar L = 10, a0 = 2, b0 = 3;
    const result saddle
    (
        curvature([&](scalar a, scalar b) { return (a + a0)*(b + b0)/L; }, false)
    );
    const scalar N = std::sqrt(1 + (sqr(a0) + sqr(b0))/sqr(L));
    const scalar K = 2*a0*b0/pow3(L*N);
    EXPECT_NEAR(saddle.rough/K, 1, 1e-6);
    EXPECT_NEAR(saddle.K/K, 1, 0.05);
}
