/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "liquidModel.H"
#include "IOdictionary.H"
#include "selectVariant.H"
#include "Time.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::liquidModel>
Foam::dew::liquidModel::New(const dictionary& dict)
{
    return selectVariant<liquidModel>(dict, "type", "liquid")(dict);
}


Foam::autoPtr<Foam::dew::liquidModel>
Foam::dew::liquidModel::New(const objectRegistry& registry)
{
    return New
    (
        IOdictionary
        (
            IOobject
            (
                "liquidProperties",
                registry.time().constant(),
                registry,
                IOobject::MUST_READ,
                IOobject::NO_WRITE,
                false
            )
        )
    );
}
