/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "voidFractionModel.H"
#include "selectVariant.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::voidFractionModel>
Foam::dew::voidFractionModel::New(const dictionary& dict)
{
    return selectVariant<voidFractionModel>
    (
        dict, "type", "voidFraction"
    )(dict);
}
