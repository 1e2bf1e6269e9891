/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "heightStencil.H"
#include "evenSurface.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Means of 1, x, x^2 from x0 to x1, of a ring around x = -r if r > 0
vector means(const scalar x0, const scalar x1, const scalar r)
{
    const scalar i0 = x1 - x0;
    const scalar i1 = 0.5*(sqr(x1) - sqr(x0));
    const scalar i2 = (pow3(x1) - pow3(x0))/3;
    if (r <= 0)
    {
        return vector(1, i1/i0, i2/i0);
    }
    const scalar i3 = 0.25*(pow4(x1) - pow4(x0));
    const scalar m0 = r*i0 + i1;
    return vector(1, (r*i1 + i2)/m0, (r*i2 + i3)/m0);
}


//- Points and weights of Gauss on (-1/2, 1/2)
constexpr label nGauss = 4;
constexpr scalar gaussAt[nGauss] =
    {-0.4305681557970263, -0.1699905217924281,
      0.1699905217924281,  0.4305681557970263};
constexpr scalar gaussWeight[nGauss] =
    {0.1739274225687269, 0.3260725774312731,
     0.3260725774312731, 0.1739274225687269};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::dew::heightStencil::model
(
    const derivatives& d,
    values& v
) const
{
    const evenSurface surface(d);
    const scalar s = d.h < 0 ? -1 : 1;

    // Mean over a column
    const auto mean = [&](const label i, const label j, scalar& m)
    {
        const scalar a0 = x_[0][i][0];
        const scalar wa = x_[0][i][1] - a0;
        const scalar b0 = nAxes == 2 ? x_[1][j][0] : 0;
        const scalar wb = nAxes == 2 ? x_[1][j][1] - b0 : 0;
        scalar sum = 0;
        scalar weights = 0;
        for (label ga = 0; ga < nGauss; ga++)
        {
            const scalar a = a0 + wa*(0.5 + gaussAt[ga]);
            const scalar weight =
                gaussWeight[ga]*(radius_[0] > 0 ? radius_[0] + a : 1);
            weights += weight;
            for (label gb = 0; gb < (nAxes == 2 ? nGauss : 1); gb++)
            {
                const scalar b = b0 + wb*(0.5 + gaussAt[gb]);
                scalar w;
                if (!surface.find(a, b, w))
                {
                    return false;
                }
                const scalar z = surface.height(a, b, w);
                sum +=
                    weight*(nAxes == 2 ? gaussWeight[gb] : 1)
                   *(ring ? s*sqr(d.h + z) : z);
            }
        }
        m = sum/weights;
        return true;
    };
    const auto slope = [&]
    (
        const label which, const scalar a, const scalar b, scalar& v
    )
    {
        scalar w, slopes[3];
        if (!surface.find(a, b, w))
        {
            return false;
        }
        surface.slopes(a, b, w, slopes);
        v = slopes[which];
        if (ring)
        {
            v *= 2*mag(d.h + surface.height(a, b, w));
        }
        return true;
    };

    for (label axis = 0; axis < nAxes; axis++)
    {
        for (label side = -1; side < 2; side++)
        {
            scalar& value = v.line[axis][1 + side];
            const bool atWall = side >= 0 && wall[axis][side];
            const scalar x = atWall ? at[axis][side] : 0;
            if
            (
               !(
                    atWall ? slope(axis, axis ? 0 : x, axis ? x : 0, value)
                  : axis ? mean(0, 1 + side, value)
                  : mean(1 + side, 0, value)
                )
            )
            {
                return false;
            }
        }
    }
    for (label sideb = 0; sideb < 2 && nAxes == 2; sideb++)
    {
        if (wall[1][sideb])
        {
            if (!slope(2, 0, at[1][sideb], v.beyond[sideb][0]))
            {
                return false;
            }
            continue;
        }
        v.beyond[sideb][0] = v.line[1][1 + sideb];
        const scalar b = 0.5*(x_[1][1 + sideb][0] + x_[1][1 + sideb][1]);
        for (label sidea = 0; sidea < 2; sidea++)
        {
            scalar& value = v.beyond[sideb][1 + sidea];
            if
            (
               !(
                    wall[0][sidea] ? slope(0, at[0][sidea], b, value)
                  : mean(1 + sidea, 1 + sideb, value)
                )
            )
            {
                return false;
            }
        }
    }
    return true;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::heightStencil::setCell
(
    const label axis,
    const scalar width,
    const scalar radius
)
{
    x_[axis][0][0] = -0.5*width;
    x_[axis][0][1] = 0.5*width;
    radius_[axis] = radius;
    r_[axis][0] = means(-0.5*width, 0.5*width, radius);
}


void Foam::dew::heightStencil::setBeside
(
    const label axis,
    const label side,
    const scalar width
)
{
    scalar* x = x_[axis][1 + side];
    x[0] = side ? x_[axis][0][1] : x_[axis][0][0] - width;
    x[1] = x[0] + width;
    wall[axis][side] = false;
    at[axis][side] = 0.5*(x[0] + x[1]);
    r_[axis][1 + side] = means(x[0], x[1], radius_[axis]);
}


void Foam::dew::heightStencil::setWall(const label axis, const label side)
{
    const scalar x = x_[axis][0][side];
    wall[axis][side] = true;
    at[axis][side] = x;
    r_[axis][1 + side] = vector(0, 1, 2*x);
}


Foam::vector Foam::dew::heightStencil::quadratic
(
    const label axis,
    const scalar v[3]
) const
{
    const vector* r = r_[axis];
    return
        (
            v[0]*(r[1] ^ r[2]) + v[1]*(r[2] ^ r[0]) + v[2]*(r[0] ^ r[1])
        )/(r[0] & (r[1] ^ r[2]));
}


Foam::dew::heightStencil::derivatives
Foam::dew::heightStencil::finite(const values& v) const
{
    const vector a(quadratic(0, v.line[0]));
    if (nAxes == 1)
    {
        if (!ring)
        {
            return {a.x(), a.y(), 0, 2*a.z(), 0, 0};
        }
        // Of the radius, from those of its square
        const scalar s = a.x() < 0 ? -1 : 1;
        const scalar R = Foam::sqrt(mag(a.x()));
        const scalar slope = 0.5*a.y()/R;
        return {s*R, slope, 0, (a.z() - s*sqr(slope))/R, 0, 0};
    }
    const vector b(quadratic(1, v.line[1]));

    // Derivative along b of the slopes along a
    scalar slopes[3] = {a.y(), 0, 0};
    for (label side = 0; side < 2; side++)
    {
        slopes[1 + side] =
            wall[1][side] ? v.beyond[side][0] : quadratic(0, v.beyond[side]).y();
    }
    return {a.x(), a.y(), b.y(), 2*a.z(), quadratic(1, slopes).y(), 2*b.z()};
}


bool Foam::dew::heightStencil::refine
(
    derivatives& d
) const
{
    // Each takes one digit or more: rounding decides nothing at the end
    constexpr label nPasses = 12;
    bool converged = false;
    const surfaceBend first(d);
    surfaceBend at(first);
    derivatives found(d);
    values v;

    for (label pass = 0; pass < nPasses; pass++)
    {
        if (found.h*d.h < 0)
        {
            return false;
        }
        if (!model(found, v))
        {
            // It ends before the last column: quadratics are too steep there
            at.flatten(0.95);
            at.set(found);
            continue;
        }
        const derivatives fd(finite(v));
        const surfaceBend of(fd);
        found.h += d.h - fd.h;

        const scalar change = at.add(first, of);
        if (sqr(at.nua) + sqr(at.nub) >= 1)
        {
            return false;
        }
        at.set(found);
        converged = change <= 1e-6*at.size();
        if (change <= 1e-10*at.size())
        {
            break;
        }
    }
    if (converged)
    {
        d = found;
    }
    return converged;
}


Foam::scalar Foam::dew::heightStencil::curvature
(
    const derivatives& d,
    const scalar radius
) const
{
    const scalar N = Foam::sqrt(1 + sqr(d.a) + sqr(d.b));
    const scalar bend =
       -(
            (1 + sqr(d.b))*d.aa - 2*d.a*d.b*d.ab + (1 + sqr(d.a))*d.bb
        )/pow3(N);
    return
        ring ? bend + 1/(d.h*N)
      : radius > 0 ? bend - d.a/(radius*N)
      : bend;
}
