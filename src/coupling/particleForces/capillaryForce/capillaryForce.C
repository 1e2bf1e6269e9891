/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "capillaryForce.H"
#include "addToRunTimeSelectionTable.H"
#include "Enum.H"
#include "unitConversion.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace particleForces
{
    defineTypeName(capillaryForce);
    addToRunTimeSelectionTable(particleForce, capillaryForce, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleForces::capillaryForce::capillaryForce
(
    const dictionary& dict
)
:
    angle_(degToRad(userEntry::within(dict, "contactAngle", 0, 180))),
    plane_
    (
        Enum<bool>({{false, "contactLine"}, {true, "plane"}})
       .getOrDefault("pull", dict, false)
    )
{
    userEntry::onlyThese(dict, {"type", "contactAngle", "pull"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::forceSuSp Foam::dew::particleForces::capillaryForce::force
(
    const particle&,
    const carrier& c
) const
{
    forceSuSp f;
    f.surfaceTension = c.surface.sigma;
    f.contactAngle = angle_;
    f.planePull = plane_;
    return f;
}
