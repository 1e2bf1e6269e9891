/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sphereRegion.H"
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
    defineTypeName(sphereRegion);
    addToRunTimeSelectionTable(insertionRegion, sphereRegion, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::regions::sphereRegion::sphereRegion(const dictionary& dict)
:
    centre_(userEntry::point(dict, "centre", dimLength)),
    radius_(userEntry::positive(dict, "radius", dimLength))
{
    userEntry::onlyThese(dict, {"type", "centre", "radius"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::boundBox Foam::dew::regions::sphereRegion::bounds() const
{
    return boundBox
    (
        centre_ - radius_*vector::one,
        centre_ + radius_*vector::one
    );
}


Foam::scalar Foam::dew::regions::sphereRegion::volume() const
{
    return 4.0/3.0*constant::mathematical::pi*pow3(radius_);
}


bool Foam::dew::regions::sphereRegion::holds(const point& x, const scalar r) const
{
    return mag(x - centre_) + r <= radius_;
}
