/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "pureGas.H"
#include "selectVariant.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::pureGas> Foam::dew::pureGas::New
(
    const dictionary& dict,
    const liquidModel& liquid
)
{
    return selectVariant<pureGas>(dict, "type", "gas")(dict, liquid);
}
