/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "surfaceShape.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(surfaceShape);
}
}

const char* const Foam::dew::surfaceShape::solvers =
    "They are quasiStatic and film";


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::surfaceShape::surfaceShape
(
    const fvMesh& mesh,
    const dictionary& surfaceProperties
)
:
    surfaceMotion(mesh, surfaceProperties),
    alphaf_
    (
        IOobject
        (
            IOobject::groupName("alphaf", liquidName_),
            mesh.time().timeName(),
            mesh
        ),
        mesh,
        dimless
    )
{}
