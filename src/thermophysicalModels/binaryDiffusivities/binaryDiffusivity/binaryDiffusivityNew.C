/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "carrierDiffusivity.H"
#include "selectVariant.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::binaryDiffusivity>
Foam::dew::binaryDiffusivity::New
(
    const dictionary& dict,
    const pureGas::part& a,
    const pureGas::part& b
)
{
    return
        selectVariant<binaryDiffusivity>(dict, "type", "diffusivity", "given")
        (
            dict, a, b
        );
}


Foam::autoPtr<Foam::dew::binaryDiffusivity>
Foam::dew::binaryDiffusivity::New
(
    const dictionary& dict,
    const pureGas::part& vapour,
    const List<pureGas::part>& carrier
)
{
    // A given number is that in the whole carrier
    if (carrier.size() == 1 || !dict.found("type"))
    {
        return New(dict, vapour, carrier[0]);
    }
    return autoPtr<binaryDiffusivity>
    (
        new carrierDiffusivity(dict, vapour, carrier)
    );
}
