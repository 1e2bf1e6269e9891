/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "constantContactAngle.H"
#include "addToRunTimeSelectionTable.H"
#include "unitConversion.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace contactAngleModels
{
    defineTypeName(constantContactAngle);
    addToRunTimeSelectionTable(contactAngle, constantContactAngle, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::contactAngleModels::constantContactAngle::constantContactAngle
(
    const dictionary& dict
)
:
    theta_(degToRad(userEntry::within(dict, "theta", 0, 180)))
{
    userEntry::onlyThese(dict, {"type", "theta"});
}
