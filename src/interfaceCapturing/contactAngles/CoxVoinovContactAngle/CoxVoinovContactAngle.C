/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "CoxVoinovContactAngle.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"
#include "unitConversion.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace contactAngleModels
{
    defineTypeName(CoxVoinovContactAngle);
    addToRunTimeSelectionTable(contactAngle, CoxVoinovContactAngle, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::contactAngleModels::CoxVoinovContactAngle::CoxVoinovContactAngle
(
    const dictionary& dict
)
:
    theta_(degToRad(userEntry::within(dict, "theta", 0, 135))),
    lengths_
    (
        Foam::log
        (
            userEntry::positive(dict, "L", dimLength)
           /userEntry::positive(dict, "lambda", dimLength)
        )
    )
{
    if (lengths_ <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "L is not more than lambda in " << dict.dictName() << nl
            << "L is the length at which the angle is seen, such as a cell;"
            << " lambda the slip length, some nm" << exit(FatalIOError);
    }
    userEntry::onlyThese(dict, {"type", "theta", "L", "lambda"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::contactAngleModels::CoxVoinovContactAngle::theta
(
    const contactLineState& state
) const
{
    const scalar Ca = state.mu*state.speed/max(state.sigma, VSMALL);
    const scalar cube = pow3(theta_) + 9*Ca*lengths_;

    return min(Foam::cbrt(max(cube, scalar(0))), constant::mathematical::pi);
}
