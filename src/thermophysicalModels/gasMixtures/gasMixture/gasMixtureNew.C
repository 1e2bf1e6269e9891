/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "gasMixture.H"
#include "IOdictionary.H"
#include "selectVariant.H"
#include "Time.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::gasMixture> Foam::dew::gasMixture::New
(
    const dictionary& dict,
    const liquidMixture& liquids
)
{
    return selectVariant<gasMixture>(dict, "type", "gas")(dict, liquids);
}


Foam::autoPtr<Foam::dew::gasMixture> Foam::dew::gasMixture::New
(
    const objectRegistry& registry,
    const liquidMixture& liquids
)
{
    return New
    (
        IOdictionary
        (
            IOobject
            (
                "gasProperties",
                registry.time().constant(),
                registry,
                IOobject::MUST_READ,
                IOobject::NO_WRITE,
                false
            )
        ),
        liquids
    );
}
