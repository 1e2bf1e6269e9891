/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "SzyszkowskiTension.H"
#include "addToRunTimeSelectionTable.H"
#include "gasConstant.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace surfaceTensionLaws
{
    defineTypeName(SzyszkowskiTension);
    addToRunTimeSelectionTable(surfaceTensionLaw, SzyszkowskiTension, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::surfaceTensionLaws::SzyszkowskiTension::SzyszkowskiTension
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    surfaceTensionLaw(mesh, dict),
    sigma0_(userEntry::positive(dict, "sigma0", dimForce/dimLength)),
    pressure_
    (
        gasConstant
       *userEntry::positive(dict, "T", dimTemperature)
       *userEntry::positive(dict, "Gamma", dimMoles/dimArea)
    ),
    K_(userEntry::positive(dict, "K", dimless/field().dimensions()))
{
    userEntry::onlyThese
    (
        dict, {"type", "field", "sigma0", "T", "Gamma", "K"}
    );
}
