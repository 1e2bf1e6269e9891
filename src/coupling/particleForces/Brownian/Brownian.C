/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "Brownian.H"
#include "addToRunTimeSelectionTable.H"
#include "colloidConstants.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace particleForces
{
    defineTypeName(Brownian);
    addToRunTimeSelectionTable(particleForce, Brownian, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleForces::Brownian::Brownian(const dictionary& dict)
:
    T_
    (
        dict.found("T")
      ? userEntry::positive(dict, "T", dimTemperature)
      : 0
    )
{
    userEntry::onlyThese(dict, {"type", "T"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::forceSuSp Foam::dew::particleForces::Brownian::force
(
    const particle&,
    const carrier& c
) const
{
    forceSuSp f;
    f.kT = colloidConstants::boltzmann*(T_ > 0 ? T_ : c.T);
    return f;
}
