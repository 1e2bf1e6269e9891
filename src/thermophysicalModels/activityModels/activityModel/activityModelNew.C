/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "activityModel.H"
#include "selectVariant.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::activityModel> Foam::dew::activityModel::New
(
    const dictionary& dict,
    const liquidMixture& liquids
)
{
    return
        selectVariant<activityModel>(dict, "type", "activity")(dict, liquids);
}
