/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "hysteresisContactAngle.H"
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
    defineTypeName(hysteresisContactAngle);
    addToRunTimeSelectionTable(contactAngle, hysteresisContactAngle, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::contactAngleModels::hysteresisContactAngle::hysteresisContactAngle
(
    const dictionary& dict
)
:
    thetaA_(degToRad(userEntry::within(dict, "thetaA", 0, 180))),
    thetaR_
    (
        degToRad
        (
            userEntry::within(dict, "thetaR", 0, dict.get<scalar>("thetaA"))
        )
    )
{
    userEntry::onlyThese(dict, {"type", "thetaA", "thetaR"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::contactAngleModels::hysteresisContactAngle::theta
(
    const contactLineState& state
) const
{
    return min(max(state.held, thetaR_), thetaA_);
}
