/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "planeWall.H"
#include "addToRunTimeSelectionTable.H"
#include "meshSymmetry.H"
#include "polyMesh.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace walls
{
    defineTypeName(planeWall);
    addToRunTimeSelectionTable(particleWall, planeWall, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::walls::planeWall::planeWall
(
    const word& name,
    const dictionary& dict,
    const materials& mats,
    const polyMesh& mesh
)
:
    particleWall(name, dict, mats, mesh),
    point_(userEntry::point(dict, "point", dimLength)),
    normal_(userEntry::direction(dict, "normal"))
{
    userEntry::onlyThese
    (
        dict, {"type", "point", "normal", "material", "motion", "T"}
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::dew::wallShape>
Foam::dew::walls::planeWall::shapes() const
{
    wallShape result;

    for (direction k = 0; k < 3 && !motion().moves(); k++)
    {
        if (mag(mag(normal_[k]) - 1) < 1e-12)
        {
            result.what = wallShape::plane;
            result.axis = k;
            result.position = point_;
            return List<wallShape>(1, result);
        }
    }

    // A square wider than the box, cut by its six sides one after another
    const boundBox bb(meshSymmetry(mesh_).bounds());
    // Any direction that is not the normal's
    vector any(Zero);
    any[mag(normal_.x()) < 0.6 ? 0 : 1] = 1;
    const vector e1(normalised(any ^ normal_));
    const vector e2(normal_ ^ e1);
    const scalar wide = 2*bb.mag() + mag(point_ - bb.midpoint());

    DynamicList<point> polygon;
    polygon.append(point_ - wide*e1 - wide*e2);
    polygon.append(point_ + wide*e1 - wide*e2);
    polygon.append(point_ + wide*e1 + wide*e2);
    polygon.append(point_ - wide*e1 + wide*e2);

    for (label side = 0; side < 6; side++)
    {
        const direction k = side/2;
        const scalar sign = side % 2 ? 1 : -1;
        const scalar limit = sign*(side % 2 ? bb.max() : bb.min())[k];
        DynamicList<point> inside;

        forAll(polygon, i)
        {
            const point& a = polygon[i];
            const point& b = polygon[polygon.fcIndex(i)];
            const scalar da = sign*a[k] - limit;
            const scalar db = sign*b[k] - limit;

            if (da <= 0)
            {
                inside.append(a);
            }
            if ((da < 0 && db > 0) || (da > 0 && db < 0))
            {
                inside.append(a + da/(da - db)*(b - a));
            }
        }
        polygon.transfer(inside);
    }

    if (polygon.size() < 3)
    {
        FatalIOErrorInFunction(dict_)
            << "Wall " << name_ << " does not meet the mesh, which spans "
            << bb << exit(FatalIOError);
    }

    for (label i = 2; i < polygon.size(); i++)
    {
        result.corners.append(polygon[0]);
        result.corners.append(polygon[i - 1]);
        result.corners.append(polygon[i]);
    }

    return List<wallShape>(1, result);
}
