/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "gravity.H"
#include "dimensionedVector.H"
#include "polyMesh.H"
#include "Time.H"
#include "uniformDimensionedFields.H"

// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::vector Foam::dew::gravity(const polyMesh& mesh)
{
    const uniformDimensionedVectorField g
    (
        IOobject
        (
            "g",
            mesh.time().constant(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        ),
        dimensionedVector("g", dimAcceleration, Zero)
    );

    if (g.dimensions() != dimAcceleration)
    {
        FatalErrorInFunction
            << "Wrong dimensions in file " << g.objectPath() << ": "
            << g.dimensions() << nl << "Expected: " << dimAcceleration
            << exit(FatalError);
    }

    return g.value();
}
