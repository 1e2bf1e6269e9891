/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "seenVelocityModel.H"
#include "selectVariant.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::seenVelocityModel>
Foam::dew::seenVelocityModel::New(const dictionary& dict)
{
    return selectVariant<seenVelocityModel>
    (
        dict, "type", "seenVelocity"
    )(dict);
}
