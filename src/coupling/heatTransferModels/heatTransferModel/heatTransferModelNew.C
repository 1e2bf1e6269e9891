/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "heatTransferModel.H"
#include "selectVariant.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::heatTransferModel>
Foam::dew::heatTransferModel::New(const dictionary& dict)
{
    return selectVariant<heatTransferModel>
    (
        dict, "type", "heatTransfer"
    )(dict);
}
