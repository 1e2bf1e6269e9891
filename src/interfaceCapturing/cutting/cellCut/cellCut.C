/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "cellCut.H"
#include "polygonCut.H"
#include "polyMesh.H"
#include "symmTensor.H"

#include <algorithm>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Faces less flat than this, of their size, become triangles
constexpr Foam::scalar flatness = 1e-10;

//- Of shares
constexpr Foam::scalar exactness = 1e-14;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::cellCut::cellCut(const polyMesh& mesh)
:
    mesh_(mesh),
    centre_(Zero),
    volume_(0),
    apex_(Zero),
    S_(Zero)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::label Foam::dew::cellCut::vertex(const label source, const point& x)
{
    forAll(source_, i)
    {
        if (source_[i] == source)
        {
            return i;
        }
    }
    source_.append(source);
    x_.append(x - centre_);
    return x_.size() - 1;
}


void Foam::dew::cellCut::addPiece(const label start)
{
    piece p;
    p.start = start;
    p.size = corners_.size() - start;

    const point& first = x_[corners_[start]];
    point middle(first);
    vector S(Zero);
    for (label i = 1; i < p.size; i++)
    {
        const point& x = x_[corners_[start + i]];
        middle += x;
        S += 0.5*((x_[corners_[start + i - 1]] - first) ^ (x - first));
    }
    middle /= p.size;

    p.area = mag(S);
    if (p.area == 0)
    {
        corners_.setSize(start);
        return;
    }
    p.m = S/p.area;
    p.h = middle & p.m;
    pieces_.append(p);
    volume_ += p.h*p.area/3;
}


Foam::scalar Foam::dew::cellCut::below(const piece& p, const scalar level)
{
    label nBelow = 0;
    for (label i = 0; i < p.size; i++)
    {
        nBelow += f_[corners_[p.start + i]] <= level;
    }
    if (nBelow == 0 || nBelow == p.size)
    {
        return nBelow ? p.area : 0;
    }

    bool first = true;
    point start(Zero);
    const vector twiceArea
    (
        polygonCut
        (
            p.size,
            [&](const label i) -> const point& { return x_[corners_[p.start + i]]; },
            [&](const label i) { return f_[corners_[p.start + i]]; },
            level,
            [&](const point& x, const bool up)
            {
                if (up)
                {
                    segments_.append(segment{x, x});
                }
                else if (first)
                {
                    start = x;
                    first = false;
                }
                else
                {
                    segments_.last().q = x;
                }
            }
        )
    );
    segments_.last().q = start;

    return 0.5*(twiceArea & p.m);
}


Foam::scalar Foam::dew::cellCut::shareBelow(const scalar level)
{
    segments_.clear();
    S_ = Zero;
    scalar cones = 0;
    for (const piece& p : pieces_)
    {
        const scalar area = below(p, level);
        cones += p.h*area;
        S_ -= area*p.m;
    }

    apex_ = Zero;
    if (segments_.size())
    {
        for (const segment& s : segments_)
        {
            apex_ += s.p + s.q;
        }
        apex_ /= 2*segments_.size();
    }

    return (cones + (apex_ & S_))/(3*volume_);
}


Foam::scalar Foam::dew::cellCut::root
(
    const scalar share,
    const scalar y0, const scalar y1, const scalar y2, const scalar y3
)
{
    // y0 + t (a + t (b + t c))
    const scalar a = 0.5*(-11*y0 + 18*y1 - 9*y2 + 2*y3);
    const scalar b = 0.5*(18*y0 - 45*y1 + 36*y2 - 9*y3);
    const scalar c = 0.5*(-9*y0 + 27*y1 - 27*y2 + 9*y3);

    scalar low = 0, high = 1;
    scalar t = y3 > y0 ? (share - y0)/(y3 - y0) : 0.5;
    for (label i = 0; i < 60; i++)
    {
        const scalar y = y0 - share + t*(a + t*(b + t*c));
        (y < 0 ? low : high) = t;
        const scalar slope = a + t*(2*b + t*3*c);
        scalar next = slope > 0 ? t - y/slope : low;
        if (!(next > low && next < high))
        {
            next = 0.5*(low + high);
        }
        if (mag(next - t) < 1e-16)
        {
            return next;
        }
        t = next;
    }
    return t;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::cellCut::set(const label celli)
{
    centre_ = mesh_.cellCentres()[celli];
    x_.clear();
    source_.clear();
    corners_.clear();
    pieces_.clear();
    volume_ = 0;

    const pointField& points = mesh_.points();

    for (const label facei : mesh_.cells()[celli])
    {
        const face& f = mesh_.faces()[facei];
        const bool outward = mesh_.faceOwner()[facei] == celli;
        const point& middle = mesh_.faceCentres()[facei];
        const vector& Sf = mesh_.faceAreas()[facei];
        const scalar magSf = mag(Sf);

        scalar warp = 0;
        for (const label pointi : f)
        {
            warp = max(warp, mag((points[pointi] - middle) & Sf));
        }

        const label n = f.size();
        const label start = corners_.size();
        if (n == 3 || warp <= flatness*magSf*Foam::sqrt(magSf))
        {
            for (label i = 0; i < n; i++)
            {
                const label pointi = f[outward ? i : n - 1 - i];
                corners_.append(vertex(pointi, points[pointi]));
            }
            addPiece(start);
            continue;
        }

        const label apex = vertex(-1 - facei, middle);
        for (label i = 0; i < n; i++)
        {
            const label a = f[outward ? i : n - 1 - i];
            const label j = i + 1 < n ? i + 1 : 0;
            const label b = f[outward ? j : n - 1 - j];
            const label at = corners_.size();
            corners_.append(apex);
            corners_.append(vertex(a, points[a]));
            corners_.append(vertex(b, points[b]));
            addPiece(at);
        }
    }
}


void Foam::dew::cellCut::function(const UList<scalar>& atPoints)
{
    f_.setSize(x_.size());
    forAll(x_, i)
    {
        if (source_[i] >= 0)
        {
            f_[i] = atPoints[source_[i]];
            continue;
        }
        const face& corners = mesh_.faces()[-1 - source_[i]];
        f_[i] = 0;
        for (const label pointi : corners)
        {
            f_[i] += atPoints[pointi];
        }
        f_[i] /= corners.size();
    }
}


void Foam::dew::cellCut::function(const vector& n)
{
    f_.setSize(x_.size());
    forAll(x_, i)
    {
        f_[i] = n & x_[i];
    }
}


Foam::vector Foam::dew::cellCut::gradient() const
{
    const Vector<label>& directions = mesh_.geometricD();
    const scalar n = x_.size();
    point middle(Zero);
    scalar mean = 0;
    forAll(x_, i)
    {
        middle += x_[i]/n;
        mean += f_[i]/n;
    }

    symmTensor M(Zero);
    vector b(Zero);
    forAll(x_, i)
    {
        vector d(x_[i] - middle);
        for (direction k = 0; k < vector::nComponents; k++)
        {
            d[k] = directions[k] < 0 ? 0 : d[k];
        }
        M += sqr(d);
        b += d*(f_[i] - mean);
    }
    const scalar size = tr(M);
    const symmTensor unit
    (
        directions.x() < 0, 0, 0, directions.y() < 0, 0, directions.z() < 0
    );
    return (inv(M/size + unit) & b)/size;
}


Foam::scalar Foam::dew::cellCut::cut(const scalar share)
{
    sorted_ = f_;
    std::sort(sorted_.begin(), sorted_.end());

    // Between which corners
    label low = 0, high = sorted_.size() - 1;
    scalar shareLow = 0, shareHigh = 1;
    while (high - low > 1)
    {
        const label middle = (low + high)/2;
        const scalar y = shareBelow(sorted_[middle]);
        if (y < share)
        {
            low = middle;
            shareLow = y;
        }
        else
        {
            high = middle;
            shareHigh = y;
        }
    }

    const scalar f = sorted_[low];
    const scalar df = sorted_[high] - f;
    const scalar third = shareBelow(f + df/3);
    const scalar twoThirds = shareBelow(f + df*2/3);
    scalar t = root(share, shareLow, third, twoThirds, shareHigh);
    scalar y = shareBelow(f + df*t);

    // What rounding has left
    scalar tOld = share < third ? 0 : share < twoThirds ? 1.0/3 : 2.0/3;
    scalar yOld = share < third ? shareLow : share < twoThirds ? third : twoThirds;
    for (label i = 0; i < 5 && mag(y - share) > exactness && y != yOld; i++)
    {
        const scalar next = t + (share - y)*(t - tOld)/(y - yOld);
        if (!(next >= 0 && next <= 1) || next == t)
        {
            break;
        }
        tOld = t;
        yOld = y;
        t = next;
        y = shareBelow(f + df*t);
    }

    return y;
}


Foam::scalar Foam::dew::cellCut::cutPlane
(
    const vector& n,
    const scalar share,
    const point& near
)
{
    function(n);

    // Newton's rule: the area of the cut is the derivative of the volume
    scalar level = n & (near - centre_);
    for (label i = 0; i < 5; i++)
    {
        const scalar y = shareBelow(level);
        if (mag(y - share) <= exactness)
        {
            return y;
        }
        const scalar area = S_ & n;
        if (segments_.empty() || area <= 0)
        {
            break;
        }
        level += (share - y)*volume_/area;
    }
    return cut(share);
}


Foam::scalar Foam::dew::cellCut::share(const point& x, const vector& n)
{
    function(n);
    return shareBelow(n & (x - centre_));
}


Foam::point Foam::dew::cellCut::centre() const
{
    const vector n(normalised(S_));
    scalar area = 0;
    vector moment(Zero);
    for (const segment& s : segments_)
    {
        const vector p(s.p - apex_);
        const vector q(s.q - apex_);
        const scalar a = (q ^ p) & n;
        area += a;
        moment += a*(p + q);
    }
    return centre_ + (area > 0 ? apex_ + moment/(3*area) : apex_);
}


Foam::symmTensor Foam::dew::cellCut::spread() const
{
    const vector n(normalised(S_));
    const vector toApex(centre_ + apex_ - centre());
    scalar area = 0;
    symmTensor moment(Zero);
    for (const segment& s : segments_)
    {
        const vector p(s.p - apex_);
        const vector q(s.q - apex_);
        const scalar a = (q ^ p) & n;
        area += a;

        // Mean over a triangle
        const vector x(toApex + p), y(toApex + q);
        moment += a*(sqr(toApex) + sqr(x) + sqr(y) + sqr(toApex + x + y));
    }
    return area > 0 ? moment/(12*area) : moment;
}
