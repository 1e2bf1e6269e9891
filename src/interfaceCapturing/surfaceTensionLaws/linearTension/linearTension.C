/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "linearTension.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace surfaceTensionLaws
{
    defineTypeName(linearTension);
    addToRunTimeSelectionTable(surfaceTensionLaw, linearTension, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::surfaceTensionLaws::linearTension::linearTension
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    surfaceTensionLaw(mesh, dict),
    sigma0_(userEntry::positive(dict, "sigma0", dimForce/dimLength)),
    value0_
    (
        dict.found("value0")
      ? userEntry::number(dict, "value0", field().dimensions())
      : 0
    ),
    slope_
    (
        userEntry::number
        (
            dict, "slope", dimForce/dimLength/field().dimensions()
        )
    )
{
    userEntry::onlyThese(dict, {"type", "field", "sigma0", "value0", "slope"});
}
