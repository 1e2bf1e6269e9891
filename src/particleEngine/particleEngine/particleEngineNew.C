/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleEngine.H"
#include "polyMesh.H"
#include "selectVariant.H"
#include "Time.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::particleEngine>
Foam::dew::particleEngine::New(const polyMesh& mesh)
{
    const IOdictionary dict
    (
        IOobject
        (
            "particleProperties",
            mesh.time().constant(),
            mesh.time(),
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );

    return selectVariant<particleEngine>(dict, "engine", "engine")(mesh, dict);
}
