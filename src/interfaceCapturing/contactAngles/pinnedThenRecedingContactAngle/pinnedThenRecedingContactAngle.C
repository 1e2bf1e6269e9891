/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "pinnedThenRecedingContactAngle.H"
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
    defineTypeName(pinnedThenRecedingContactAngle);
    addToRunTimeSelectionTable(contactAngle, pinnedThenRecedingContactAngle, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::contactAngleModels::pinnedThenRecedingContactAngle::pinnedThenRecedingContactAngle
(
    const dictionary& dict
)
:
    thetaR_(degToRad(userEntry::within(dict, "thetaR", 0, 180)))
{
    userEntry::onlyThese(dict, {"type", "thetaR"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::contactAngleModels::pinnedThenRecedingContactAngle::theta
(
    const contactLineState& state
) const
{
    return max(state.held, thetaR_);
}
