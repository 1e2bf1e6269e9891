/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "pinnedContactAngle.H"
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
    defineTypeName(pinnedContactAngle);
    addToRunTimeSelectionTable(contactAngle, pinnedContactAngle, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::contactAngleModels::pinnedContactAngle::pinnedContactAngle
(
    const dictionary& dict
)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::contactAngleModels::pinnedContactAngle::theta
(
    const contactLineState& state
) const
{
    return state.held;
}
