/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleWall.H"
#include "selectVariant.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(particleWall);
    defineRunTimeSelectionTable(particleWall, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleWall::particleWall
(
    const word& name,
    const dictionary& dict,
    const materials& mats,
    const polyMesh& mesh
)
:
    name_(name),
    dict_(dict),
    mesh_(mesh),
    material_(mats.index(dict, "material")),
    motion_(wallMotion::New(dict)),
    T_(userEntry::positiveOr(dict, "T", dimTemperature, -1))
{}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::particleWall> Foam::dew::particleWall::New
(
    const word& name,
    const dictionary& dict,
    const materials& mats,
    const polyMesh& mesh
)
{
    return selectVariant<particleWall>(dict, "type", "wall")(name, dict, mats, mesh);
}
