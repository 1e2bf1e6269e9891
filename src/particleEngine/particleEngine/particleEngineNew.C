/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleEngine.H"
#include "polyMesh.H"
#include "selectVariant.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::IOobject propertiesOf(const Foam::polyMesh& mesh)
{
    return Foam::IOobject
    (
        "particleProperties",
        mesh.time().constant(),
        mesh.time(),
        Foam::IOobject::MUST_READ,
        Foam::IOobject::NO_WRITE,
        false
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::particleEngine>
Foam::dew::particleEngine::New(const polyMesh& mesh)
{
    const IOdictionary dict(propertiesOf(mesh));

    return selectVariant<particleEngine>(dict, "engine", "engine")(mesh, dict);
}


Foam::autoPtr<Foam::dew::particleEngine>
Foam::dew::particleEngine::NewIfPresent(const polyMesh& mesh)
{
    IOobject io(propertiesOf(mesh));

    if (io.typeHeaderOk<IOdictionary>(true))
    {
        return New(mesh);
    }

    Info<< "No particles: there is no file constant/particleProperties" << endl;

    dictionary none(io.objectPath());
    none.add("engine", word("none"));
    dictionary coupling("coupling");
    coupling.add("momentum", word("none"));
    coupling.add("forces", dictionary());
    dictionary voidFraction("voidFraction");
    voidFraction.add("type", word("none"));
    coupling.add("voidFraction", voidFraction);
    none.add("coupling", coupling);

    return selectVariant<particleEngine>(none, "engine", "engine")(mesh, none);
}
