/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleForce.H"
#include "selectVariant.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::particleForce>
Foam::dew::particleForce::New(const dictionary& dict)
{
    return selectVariant<particleForce>(dict, "type", "force")(dict);
}
