/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sphericalCapRegion.H"
#include "addToRunTimeSelectionTable.H"
#include "unitConversion.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace regions
{
    defineTypeName(sphericalCapRegion);
    addToRunTimeSelectionTable(insertionRegion, sphericalCapRegion, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::regions::sphericalCapRegion::sphericalCapRegion
(
    const dictionary& dict
)
:
    cap_
    (
        userEntry::point(dict, "centre", dimLength),
        userEntry::direction(dict, "axis"),
        userEntry::positive(dict, "contactRadius", dimLength),
        degToRad(userEntry::within(dict, "contactAngle", 0.01, 179))
    )
{
    userEntry::onlyThese
    (
        dict, {"type", "centre", "axis", "contactRadius", "contactAngle"}
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::boundBox Foam::dew::regions::sphericalCapRegion::bounds() const
{
    // The cylinder around it: from the base to the apex, as wide as the base,
    // or as the sphere where this bulges over the base
    const vector& n = cap_.normal();
    const scalar widest =
        cap_.depth() < 0 ? cap_.radius() : cap_.contactRadius();
    vector half;
    for (direction k = 0; k < vector::nComponents; k++)
    {
        half[k] = widest*sqrt(max(1 - sqr(n[k]), scalar(0)));
    }
    const point apex(cap_.base() + cap_.height()*n);
    return boundBox
    (
        min(cap_.base(), apex) - half,
        max(cap_.base(), apex) + half
    );
}


bool Foam::dew::regions::sphericalCapRegion::holds
(
    const point& x,
    const scalar r
) const
{
    return ((x - cap_.base()) & cap_.normal()) >= r && cap_.psi(x) >= r;
}
