/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "rotatingMotion.H"
#include "addToRunTimeSelectionTable.H"
#include "engineText.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace wallMotions
{
    defineTypeName(rotatingMotion);
    addToRunTimeSelectionTable(wallMotion, rotatingMotion, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::wallMotions::rotatingMotion::rotatingMotion(const dictionary& dict)
:
    origin_(userEntry::point(dict, "origin", dimLength)),
    axis_(userEntry::direction(dict, "axis")),
    period_(userEntry::positive(dict, "period", dimTime))
{
    userEntry::onlyThese(dict, {"type", "origin", "axis", "period"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::boundBox Foam::dew::wallMotions::rotatingMotion::swept
(
    const boundBox& bb,
    const scalar
) const
{
    // The sphere about the origin that holds the box holds all its turns
    scalar r = 0;
    const tmp<pointField> corners(bb.points());
    for (const point& p : corners())
    {
        r = max(r, mag(p - origin_));
    }
    return boundBox(origin_ - r*vector::one, origin_ + r*vector::one);
}


std::string Foam::dew::wallMotions::rotatingMotion::engineArguments
(
    const engineUnits& units
) const
{
    return
        "rotate origin " + engineText(origin_/units.length)
      + " axis " + engineText(axis_)
      + " period " + engineText(period_/units.time);
}
