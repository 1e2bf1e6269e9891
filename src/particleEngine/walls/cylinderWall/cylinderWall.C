/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "cylinderWall.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace walls
{
    defineTypeName(cylinderWall);
    addToRunTimeSelectionTable(particleWall, cylinderWall, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::walls::cylinderWall::cylinderWall
(
    const word& name,
    const dictionary& dict,
    const materials& mats,
    const polyMesh& mesh
)
:
    particleWall(name, dict, mats, mesh),
    point_(userEntry::point(dict, "point", dimLength)),
    axis_(userEntry::direction(dict, "axis")),
    radius_(userEntry::positive(dict, "radius", dimLength))
{
    userEntry::onlyThese
    (
        dict, {"type", "point", "axis", "radius", "material", "T"}
    );

    if (mag(cmptMax(cmptMag(axis_)) - 1) > 1e-12)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'axis' of wall " << name << " is " << axis_ << nl
            << "A cylinder lies along x, y or z; give others, and moving"
            << " ones, as STL"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::dew::wallShape>
Foam::dew::walls::cylinderWall::shapes() const
{
    wallShape result;
    result.what = wallShape::cylinder;
    result.position = point_;
    result.radius = radius_;

    for (direction k = 0; k < 3; k++)
    {
        if (mag(axis_[k]) > 0.5)
        {
            result.axis = k;
        }
    }

    return List<wallShape>(1, result);
}
