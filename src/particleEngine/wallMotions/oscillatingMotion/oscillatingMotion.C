/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "oscillatingMotion.H"
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
    defineTypeName(oscillatingMotion);
    addToRunTimeSelectionTable(wallMotion, oscillatingMotion, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::wallMotions::oscillatingMotion::oscillatingMotion(const dictionary& dict)
:
    amplitude_(userEntry::point(dict, "amplitude", dimLength)),
    period_(userEntry::positive(dict, "period", dimTime))
{
    userEntry::onlyThese(dict, {"type", "amplitude", "period"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::boundBox Foam::dew::wallMotions::oscillatingMotion::swept
(
    const boundBox& bb,
    const scalar
) const
{
    const vector a(cmptMag(amplitude_));
    return boundBox(bb.min() - a, bb.max() + a);
}


std::string Foam::dew::wallMotions::oscillatingMotion::engineArguments
(
    const engineUnits& units
) const
{
    return
        "wiggle amplitude " + engineText(amplitude_/units.length)
      + " period " + engineText(period_/units.time);
}
