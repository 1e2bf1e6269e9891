/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "cylinderRegion.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace regions
{
    defineTypeName(cylinderRegion);
    addToRunTimeSelectionTable(insertionRegion, cylinderRegion, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::regions::cylinderRegion::cylinderRegion(const dictionary& dict)
:
    p1_(userEntry::point(dict, "point1", dimLength)),
    p2_(userEntry::point(dict, "point2", dimLength)),
    radius_(userEntry::positive(dict, "radius", dimLength))
{
    userEntry::onlyThese(dict, {"type", "point1", "point2", "radius"});

    if (!(mag(p2_ - p1_) > 0))
    {
        FatalIOErrorInFunction(dict)
            << "In " << dict.dictName() << " point1 and point2 are the same"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::boundBox Foam::dew::regions::cylinderRegion::bounds() const
{
    // Half-width of a disc in direction k is R sqrt(1 - n_k^2)
    const vector n((p2_ - p1_)/mag(p2_ - p1_));
    vector half;
    for (direction k = 0; k < vector::nComponents; k++)
    {
        half[k] = radius_*sqrt(max(1 - sqr(n[k]), scalar(0)));
    }

    return boundBox(min(p1_, p2_) - half, max(p1_, p2_) + half);
}


Foam::scalar Foam::dew::regions::cylinderRegion::volume() const
{
    return constant::mathematical::pi*sqr(radius_)*mag(p2_ - p1_);
}


bool Foam::dew::regions::cylinderRegion::holds(const point& x, const scalar r) const
{
    const vector n((p2_ - p1_)/mag(p2_ - p1_));
    const scalar along = (x - p1_) & n;

    return
        along >= r
     && mag(p2_ - p1_) - along >= r
     && mag(x - p1_ - along*n) + r <= radius_;
}
