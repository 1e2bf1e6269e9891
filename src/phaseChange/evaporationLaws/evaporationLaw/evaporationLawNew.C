/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "evaporationLaw.H"
#include "selectVariant.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::evaporationLaw>
Foam::dew::evaporationLaw::New
(
    const dictionary& dict,
    const liquidMixture& liquids,
    const gasMixture& gas
)
{
    return selectVariant<evaporationLaw>
    (
        dict, "type", "evaporation"
    )(dict, liquids, gas);
}


// ************************************************************************* //
