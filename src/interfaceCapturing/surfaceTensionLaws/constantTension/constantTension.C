/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "constantTension.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace surfaceTensionLaws
{
    defineTypeName(constantTension);
    addToRunTimeSelectionTable(surfaceTensionLaw, constantTension, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::surfaceTensionLaws::constantTension::constantTension
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    surfaceTensionLaw(mesh),
    sigma_(read(dict))
{
    userEntry::onlyThese(dict, {"type", "sigma"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::surfaceTensionLaws::constantTension::read
(
    const dictionary& dict
)
{
    return userEntry::notNegative(dict, "sigma", dimForce/dimLength);
}
