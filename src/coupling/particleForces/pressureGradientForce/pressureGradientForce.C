/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "pressureGradientForce.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace particleForces
{
    defineTypeName(pressureGradientForce);
    addToRunTimeSelectionTable(particleForce, pressureGradientForce, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleForces::pressureGradientForce::pressureGradientForce(const dictionary& dict)
:
    buoyancy_(dict.getOrDefault<Switch>("buoyancy", Switch(true)))
{
    userEntry::onlyThese(dict, {"type", "buoyancy"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::forceSuSp Foam::dew::particleForces::pressureGradientForce::force
(
    const particle& p,
    const carrier& c
) const
{
    const vector weight(buoyancy_ ? c.rho*c.g : vector::zero);

    return {-p.volume()*(c.gradp + weight), 0};
}
