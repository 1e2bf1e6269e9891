/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "convexPiece.H"
#include "face.H"
#include "polygonOrder.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::convexPiece::convexPiece(const boundBox& box)
:
    convexPiece()
{
    const pointField points(box.points());
    for (const Foam::face& f : boundBox::faces)
    {
        addFace(pointField(f.points(points)));
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::convexPiece::addLid
(
    DynamicList<point>& points,
    const vector& normal
)
{
    if (points.size() > 2)
    {
        polygonOrder(points, normal);
        addFace(points, normal);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::convexPiece::addFace(const UList<point>& x)
{
    vector S(Zero);
    for (label i = 2; i < x.size(); i++)
    {
        S += (x[i - 1] - x[0]) ^ (x[i] - x[0]);
    }
    const scalar magS = mag(S);
    if (magS > 0)
    {
        addFace(x, S/magS);
    }
}


void Foam::dew::convexPiece::addFace(const UList<point>& x, const vector& normal)
{
    corners_.append(x);
    start_.append(corners_.size());
    normal_.append(normal);
}


Foam::point Foam::dew::convexPiece::centre() const
{
    point sum(Zero);
    for (const point& x : corners_)
    {
        sum += x;
    }
    return sum/max(corners_.size(), 1);
}


Foam::scalar Foam::dew::convexPiece::radius(const point& c) const
{
    scalar sqrR = 0;
    for (const point& x : corners_)
    {
        sqrR = max(sqrR, magSqr(x - c));
    }
    return Foam::sqrt(sqrR);
}


Foam::scalar Foam::dew::convexPiece::volume() const
{
    const point apex(centre());
    scalar sum = 0;
    for (label facei = 0; facei < nFaces(); facei++)
    {
        const SubList<point> x(face(facei));
        const vector& n = normal_[facei];
        vector S(Zero);
        for (label i = 2; i < x.size(); i++)
        {
            S += (x[i - 1] - x[0]) ^ (x[i] - x[0]);
        }
        sum += (n & (x[0] - apex))*(n & S);
    }
    return sum/6;
}


bool Foam::dew::convexPiece::contains(const point& c) const
{
    for (label facei = 0; facei < nFaces(); facei++)
    {
        if ((normal_[facei] & (c - corners_[start_[facei]])) > 0)
        {
            return false;
        }
    }
    return true;
}


void Foam::dew::convexPiece::split
(
    const point& x,
    const vector& n,
    convexPiece& below,
    convexPiece& above
) const
{
    below = convexPiece();
    above = convexPiece();

    DynamicList<point> low, high, lid;
    for (label facei = 0; facei < nFaces(); facei++)
    {
        const SubList<point> f(face(facei));
        low.clear();
        high.clear();
        forAll(f, i)
        {
            const point& a = f[i];
            const point& b = f[f.fcIndex(i)];
            const scalar da = n & (a - x);
            const scalar db = n & (b - x);
            (da <= 0 ? low : high).append(a);
            if ((da <= 0) != (db <= 0))
            {
                // From the same end for both faces of the edge
                const point c
                (
                    da <= 0
                  ? a + da/(da - db)*(b - a)
                  : b + db/(db - da)*(a - b)
                );
                if (da != 0 && db != 0)
                {
                    low.append(c);
                }
                high.append(c);
                lid.append(c);
            }
        }
        if (low.size() > 2)
        {
            below.addFace(low, normal_[facei]);
        }
        if (high.size() > 2)
        {
            above.addFace(high, normal_[facei]);
        }
    }

    const vector m(normalised(n));
    below.addLid(lid, m);
    above.addLid(lid, -m);
}


void Foam::dew::convexPiece::halve
(
    convexPiece& below,
    convexPiece& above
) const
{
    const boundBox bounds(corners_, false);
    const vector span(bounds.span());
    vector n(Zero);
    n[span.x() >= cmptMax(span) ? 0 : span.y() >= cmptMax(span) ? 1 : 2] = 1;

    split(bounds.midpoint(), n, below, above);
}


void Foam::dew::convexPiece::section
(
    const point& x,
    const vector& n,
    DynamicList<point>& polygon
) const
{
    polygon.clear();
    for (label facei = 0; facei < nFaces(); facei++)
    {
        const SubList<point> f(face(facei));
        forAll(f, i)
        {
            const point& a = f[i];
            const point& b = f[f.fcIndex(i)];
            const scalar da = n & (a - x);
            const scalar db = n & (b - x);

            // The other way belongs to the other face of the edge
            if (da <= 0 && db > 0)
            {
                polygon.append(a + da/(da - db)*(b - a));
            }
        }
    }
    polygonOrder(polygon, n);
}
