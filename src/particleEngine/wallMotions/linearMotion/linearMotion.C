/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "linearMotion.H"
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
    defineTypeName(linearMotion);
    addToRunTimeSelectionTable(wallMotion, linearMotion, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::wallMotions::linearMotion::linearMotion(const dictionary& dict)
:
    velocity_(userEntry::point(dict, "velocity", dimVelocity))
{
    userEntry::onlyThese(dict, {"type", "velocity"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::boundBox Foam::dew::wallMotions::linearMotion::swept
(
    const boundBox& bb,
    const scalar t
) const
{
    boundBox result(bb);
    result.add(boundBox(bb.min() + t*velocity_, bb.max() + t*velocity_));
    return result;
}


std::string Foam::dew::wallMotions::linearMotion::engineArguments
(
    const engineUnits& units
) const
{
    return "linear " + engineText(velocity_/units.velocity());
}
