/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "viscousStressForce.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace particleForces
{
    defineTypeName(viscousStressForce);
    addToRunTimeSelectionTable(particleForce, viscousStressForce, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleForces::viscousStressForce::viscousStressForce
(
    const dictionary& dict
)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::forceSuSp Foam::dew::particleForces::viscousStressForce::force
(
    const particle& p,
    const carrier& c
) const
{
    forceSuSp f;
    f.Su = p.volume()*c.motion.divTau;
    return f;
}
