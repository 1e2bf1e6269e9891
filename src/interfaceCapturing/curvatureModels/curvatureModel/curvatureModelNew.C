/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "curvatureModel.H"
#include "selectVariant.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::curvatureModel> Foam::dew::curvatureModel::New
(
    const transportedSurface& surface,
    const dictionary& surfaceProperties
)
{
    const dictionary& dict =
        userEntry::optionalDict(surfaceProperties, "curvature");

    return selectVariant<curvatureModel>
    (
        dict, "type", "curvature model", "heightFunction"
    )
    (
        surface, dict
    );
}
