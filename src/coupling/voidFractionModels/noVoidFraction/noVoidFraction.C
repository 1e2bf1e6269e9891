/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "noVoidFraction.H"
#include "addToRunTimeSelectionTable.H"
#include "centreSupport.H"
#include "userEntry.H"
// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeNameAndDebug(noVoidFraction, 0);
    addToRunTimeSelectionTable(voidFractionModel, noVoidFraction, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::noVoidFraction::noVoidFraction(const dictionary& dict)
:
    voidFractionModel(dict)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::particleSupport> Foam::dew::noVoidFraction::support
(
    const polyMesh&
) const
{
    return autoPtr<particleSupport>(new centreSupport());
}
