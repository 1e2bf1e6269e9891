/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "distanceModel.H"
#include "selectVariant.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::distanceModel> Foam::dew::distanceModel::New
(
    const transportedSurface& surface,
    const dictionary& surfaceProperties
)
{
    const dictionary& dict =
        userEntry::optionalDict(surfaceProperties, "distance");

    return selectVariant<distanceModel>
    (
        dict, "type", "distance model", "reconstructed"
    )
    (
        surface, dict
    );
}
