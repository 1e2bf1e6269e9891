/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "gasModel.H"
#include "IOdictionary.H"
#include "selectVariant.H"
#include "Time.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::gasModel> Foam::dew::gasModel::New
(
    const dictionary& dict,
    const liquidModel& liquid
)
{
    return selectVariant<gasModel>(dict, "type", "gas")(dict, liquid);
}


Foam::autoPtr<Foam::dew::gasModel> Foam::dew::gasModel::New
(
    const objectRegistry& registry,
    const liquidModel& liquid
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
        liquid
    );
}
