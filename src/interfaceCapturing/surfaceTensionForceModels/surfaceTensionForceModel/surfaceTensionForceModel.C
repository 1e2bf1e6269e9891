/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "surfaceTensionForceModel.H"
#include "selectVariant.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(surfaceTensionForceModel);
    defineRunTimeSelectionTable(surfaceTensionForceModel, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::surfaceTensionForceModel>
Foam::dew::surfaceTensionForceModel::New
(
    const transportedSurface& surface,
    const dictionary& dict
)
{
    return selectVariant<surfaceTensionForceModel>
    (
        dict, "type", "surface tension force", "CSF"
    )
    (
        surface, dict
    );
}
