/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sectionIntegral.H"

#include <algorithm>
#include <utility>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::scalar;

//- Gauss-Legendre points and weights on [-1, 1]
constexpr scalar x4[] = {0.3399810435848562648, 0.8611363115940525752};
constexpr scalar w4[] = {0.6521451548625461426, 0.3478548451374538574};
constexpr scalar x8[] =
{
    0.1834346424956498049, 0.5255324099163289858,
    0.7966664774136267396, 0.9602898564975362317
};
constexpr scalar w8[] =
{
    0.3626837833783619830, 0.3137066458778872873,
    0.2223810344533744705, 0.1012285362903762591
};

//- Of the volume of a piece
constexpr scalar exactness = 1e-11;

constexpr Foam::label maxDepth = 14;

//- Largest piece, of the radius of curvature
constexpr scalar largest = 0.3;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::sectionIntegral::sectionIntegral
(
    std::function<scalar(const point&)> f,
    const vector& along,
    const scalar radius
)
:
    f_(std::move(f)),
    along_(normalised(along)),
    radius_(radius),
    c_(Zero)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dew::sectionIntegral::root
(
    const point& p,
    const vector& d,
    scalar t0,
    scalar f0,
    scalar t1,
    scalar f1
) const
{
    // Secant that keeps the root between its ends
    for (label i = 0; i < 100 && mag(t1 - t0) > 1e-15; i++)
    {
        scalar t = (t0*f1 - t1*f0)/(f1 - f0);
        if (!(t > min(t0, t1) && t < max(t0, t1)))
        {
            return mag(f0) < mag(f1) ? t0 : t1;
        }
        const scalar f = f_(p + t*d);
        if (f == 0 || mag(t - t1) < 1e-16)
        {
            return t;
        }
        if ((f > 0) == (f1 > 0))
        {
            f0 *= f1/(f1 + f);
        }
        else
        {
            t0 = t1;
            f0 = f1;
        }
        t1 = t;
        f1 = f;
    }
    return t1;
}


Foam::label Foam::dew::sectionIntegral::roots
(
    const point& p,
    const point& q,
    scalar t[2]
) const
{
    const vector d(q - p);
    const scalar f0 = f_(p), f1 = f_(q);
    if ((f0 > 0) != (f1 > 0))
    {
        t[0] = root(p, d, 0, f0, 1, f1);
        return 1;
    }

    // Between ends of one sign: two roots, if the extremum has the other.
    // By the parabola through three points, once more around its vertex
    scalar middle = 0.5, half = 0.5;
    for (label i = 0; i < 3; i++)
    {
        const scalar fm = f_(p + middle*d);
        if ((fm > 0) != (f0 > 0))
        {
            t[0] = root(p, d, 0, f0, middle, fm);
            t[1] = root(p, d, middle, fm, 1, f1);
            return 2;
        }
        const scalar a = f_(p + (middle - half)*d);
        const scalar b = f_(p + (middle + half)*d);
        const scalar bend = a - 2*fm + b;
        const scalar shift = 0.5*half*(a - b)/(mag(bend) > 0 ? bend : VGREAT);
        if (mag(shift) >= half || (bend > 0) != (f0 > 0))
        {
            return 0;
        }
        middle += shift;
        half = min(0.1*half, min(middle, 1 - middle));
        if (!(half > 0))
        {
            return 0;
        }
    }
    return 0;
}


Foam::scalar Foam::dew::sectionIntegral::line(const scalar b) const
{
    // Where the line enters and leaves the polygon
    scalar low = GREAT, high = -GREAT;
    forAll(polygon_, i)
    {
        const vector p(polygon_[i] - c_);
        const vector q(polygon_[polygon_.fcIndex(i)] - c_);
        const scalar bp = p & b_, bq = q & b_;
        if ((bp <= b) != (bq <= b))
        {
            const scalar t = (b - bp)/(bq - bp);
            const scalar z = (p & z_) + t*((q - p) & z_);
            low = min(low, z);
            high = max(high, z);
        }
    }
    const scalar length = high - low;
    if (!(length > 0))
    {
        return 0;
    }

    const point p(c_ + ((polygon_[0] - c_) & a_)*a_ + b*b_ + low*z_);
    const vector d(length*z_);
    const scalar f0 = f_(p), f1 = f_(p + d);
    if ((f0 > 0) == (f1 > 0))
    {
        return f0 > 0 ? length : 0;
    }
    const scalar t = root(p, d, 0, f0, 1, f1);
    return length*(f0 > 0 ? t : 1 - t);
}


Foam::scalar Foam::dew::sectionIntegral::sectionArea
(
    const convexPiece& piece,
    const scalar a
)
{
    piece.section(c_ + a*a_, a_, polygon_);
    if (polygon_.size() < 3)
    {
        return 0;
    }

    DynamicList<scalar> breaks;
    forAll(polygon_, i)
    {
        const point& p = polygon_[i];
        const point& q = polygon_[polygon_.fcIndex(i)];
        breaks.append((p - c_) & b_);

        scalar t[2];
        const label n = roots(p, q, t);
        for (label k = 0; k < n; k++)
        {
            breaks.append((p + t[k]*(q - p) - c_) & b_);
        }
    }
    std::sort(breaks.begin(), breaks.end());

    scalar area = 0;
    for (label i = 1; i < breaks.size(); i++)
    {
        const scalar middle = 0.5*(breaks[i] + breaks[i - 1]);
        const scalar half = 0.5*(breaks[i] - breaks[i - 1]);
        if (!(half > 1e-15*(breaks.last() - breaks[0])))
        {
            continue;
        }
        for (label k = 0; k < 4; k++)
        {
            area +=
                half*w8[k]*(line(middle - half*x8[k]) + line(middle + half*x8[k]));
        }
    }
    return area;
}


Foam::scalar Foam::dew::sectionIntegral::gauss
(
    const convexPiece& piece,
    const scalar a0,
    const scalar a1
)
{
    const scalar middle = 0.5*(a0 + a1);
    const scalar half = 0.5*(a1 - a0);
    scalar sum = 0;
    for (label k = 0; k < 2; k++)
    {
        sum +=
            half*w4[k]
           *(
                sectionArea(piece, middle - half*x4[k])
              + sectionArea(piece, middle + half*x4[k])
            );
    }
    return sum;
}


Foam::scalar Foam::dew::sectionIntegral::adapt
(
    const convexPiece& piece,
    const scalar a0,
    const scalar a1,
    const scalar whole,
    const scalar tolerance,
    const label depth
)
{
    const scalar middle = 0.5*(a0 + a1);
    const scalar first = gauss(piece, a0, middle);
    const scalar second = gauss(piece, middle, a1);
    if (mag(first + second - whole) <= tolerance || depth == 0)
    {
        return first + second;
    }
    return
        adapt(piece, a0, middle, first, 0.5*tolerance, depth - 1)
      + adapt(piece, middle, a1, second, 0.5*tolerance, depth - 1);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::sectionIntegral::volume(const convexPiece& piece)
{
    const point c(piece.centre());
    const scalar r = piece.radius(c);
    const scalar f = f_(c);
    if (mag(f) >= r)
    {
        return f > 0 ? piece.volume() : 0;
    }
    if (r > largest*radius_)
    {
        convexPiece below, above;
        piece.halve(below, above);
        return volume(below) + volume(above);
    }

    c_ = c;
    a_ = along_;
    vector gradient(Zero);
    for (direction i = 0; i < 3; i++)
    {
        vector d(Zero);
        d[i] = 1e-3*r;
        gradient[i] = f_(c + d) - f_(c - d);
    }
    gradient -= (gradient & a_)*a_;
    z_ = normalised(gradient);
    b_ = z_ ^ a_;

    breaks_.clear();
    for (label facei = 0; facei < piece.nFaces(); facei++)
    {
        const SubList<point> x(piece.face(facei));
        forAll(x, i)
        {
            const point& p = x[i];
            const point& q = x[x.fcIndex(i)];
            breaks_.append((p - c_) & a_);

            scalar t[2];
            const label n = roots(p, q, t);
            for (label k = 0; k < n; k++)
            {
                breaks_.append((p + t[k]*(q - p) - c_) & a_);
            }
        }
    }
    std::sort(breaks_.begin(), breaks_.end());
    const DynamicList<scalar> at(breaks_);

    const scalar tolerance = exactness*piece.volume();
    const scalar span = at.last() - at[0];
    scalar sum = 0;
    for (label i = 1; i < at.size(); i++)
    {
        if (at[i] - at[i - 1] > 1e-12*span)
        {
            sum += adapt
            (
                piece, at[i - 1], at[i], gauss(piece, at[i - 1], at[i]),
                tolerance*(at[i] - at[i - 1])/span, maxDepth
            );
        }
    }
    return sum;
}
