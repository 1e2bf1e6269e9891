/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "faceCut.H"
#include "polygonCut.H"
#include "polyMesh.H"

#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::faceCut::faceCut(const polyMesh& mesh)
:
    mesh_(mesh),
    n_(Zero),
    area_(0)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dew::faceCut::share(const scalar level) const
{
    label nBelow = 0;
    for (const scalar f : f_)
    {
        nBelow += f <= level;
    }
    if (nBelow == 0 || nBelow == f_.size())
    {
        return nBelow ? 1 : 0;
    }

    const vector twiceArea
    (
        polygonCut
        (
            x_.size(),
            [&](const label i) -> const point& { return x_[i]; },
            [&](const label i) { return f_[i]; },
            level,
            [](const point&, const bool) {}
        )
    );
    return max(min(0.5*(twiceArea & n_)/area_, scalar(1)), scalar(0));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::faceCut::meanShare
(
    const label facei,
    const point& x,
    const vector& n,
    const scalar travel
)
{
    const face& f = mesh_.faces()[facei];
    const pointField& points = mesh_.points();
    x_.setSize(f.size());
    f_.setSize(f.size());
    forAll(f, i)
    {
        x_[i] = points[f[i]] - x;
        f_[i] = x_[i] & n;
    }

    const scalar low = min(travel, scalar(0));
    const scalar high = max(travel, scalar(0));
    if (max(f_) <= low)
    {
        return 1;
    }
    if (min(f_) > high)
    {
        return 0;
    }

    area_ = mag(mesh_.faceAreas()[facei]);
    n_ = mesh_.faceAreas()[facei]/area_;

    if (low == high)
    {
        return share(low);
    }

    sorted_ = f_;
    std::sort(sorted_.begin(), sorted_.end());
    sorted_.append(high);

    // At the points of Gauss' rule, from the middle of a unit interval
    static const scalar gauss = 0.5/Foam::sqrt(3.0);

    scalar mean = 0;
    scalar from = low;
    for (const scalar corner : sorted_)
    {
        const scalar to = min(corner, high);
        if (to > from)
        {
            const scalar middle = 0.5*(from + to);
            const scalar width = to - from;
            mean +=
                0.5*width
               *(share(middle - gauss*width) + share(middle + gauss*width));
            from = to;
        }
    }
    return mean/(high - low);
}
