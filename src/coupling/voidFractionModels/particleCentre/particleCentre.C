/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleCentre.H"
#include "addToRunTimeSelectionTable.H"
#include "centreSupport.H"
#include "userEntry.H"
// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeNameAndDebug(particleCentre, 0);
    addToRunTimeSelectionTable(voidFractionModel, particleCentre, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleCentre::particleCentre(const dictionary& dict)
:
    voidFractionModel(dict)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::particleSupport> Foam::dew::particleCentre::support
(
    const polyMesh&
) const
{
    return autoPtr<particleSupport>(new centreSupport());
}
