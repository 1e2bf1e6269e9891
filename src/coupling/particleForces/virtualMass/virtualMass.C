/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "virtualMass.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace particleForces
{
    defineTypeName(virtualMass);
    addToRunTimeSelectionTable(particleForce, virtualMass, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleForces::virtualMass::virtualMass(const dictionary& dict)
:
    Ca_
    (
        dict.found("coefficient")
      ? userEntry::within(dict, "coefficient", 0, GREAT)
      : 0.5
    )
{
    userEntry::onlyThese(dict, {"type", "coefficient"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::forceSuSp Foam::dew::particleForces::virtualMass::force
(
    const particle& p,
    const carrier& c
) const
{
    forceSuSp f;
    f.addedMass = Ca_*c.rho*p.volume();
    f.Su = f.addedMass*c.motion.DUDt;
    return f;
}
