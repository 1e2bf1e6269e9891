/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "KistlerContactAngle.H"
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
    defineTypeName(KistlerContactAngle);
    addToRunTimeSelectionTable(contactAngle, KistlerContactAngle, dictionary);
}
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using Foam::scalar;

scalar Hoffman(const scalar x)
{
    if (x <= 0)
    {
        return 0;
    }
    const scalar y =
        5.16*std::pow(x/(1 + 1.31*std::pow(x, 0.99)), 0.706);

    return std::acos(1 - 2*std::tanh(y));
}


//- By halving: Hoffman grows with x
scalar inverse(const scalar theta)
{
    scalar low = 0;
    scalar high = 1;
    while (Hoffman(high) < theta && high < 1e6)
    {
        high *= 2;
    }
    for (int i = 0; i < 100; i++)
    {
        const scalar x = 0.5*(low + high);
        (Hoffman(x) < theta ? low : high) = x;
    }
    return 0.5*(low + high);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::contactAngleModels::KistlerContactAngle::KistlerContactAngle
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
    ),
    xA_(inverse(thetaA_)),
    xR_(inverse(thetaR_))
{
    userEntry::onlyThese(dict, {"type", "thetaA", "thetaR"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::contactAngleModels::KistlerContactAngle::theta
(
    const contactLineState& state
) const
{
    const scalar Ca = state.mu*state.speed/max(state.sigma, VSMALL);

    return Hoffman((Ca > 0 ? xA_ : xR_) + Ca);
}
