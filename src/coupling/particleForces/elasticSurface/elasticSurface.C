/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "elasticSurface.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace particleForces
{
    defineTypeName(elasticSurface);
    addToRunTimeSelectionTable(particleForce, elasticSurface, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleForces::elasticSurface::elasticSurface(const dictionary& dict)
:
    stiffness_(userEntry::positive(dict, "stiffness", dimForce/dimLength))
{
    userEntry::onlyThese(dict, {"type", "stiffness"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::forceSuSp Foam::dew::particleForces::elasticSurface::force
(
    const particle&,
    const carrier&
) const
{
    forceSuSp f;
    f.surfaceK = stiffness_;
    return f;
}
