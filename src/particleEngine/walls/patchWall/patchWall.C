/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "patchWall.H"
#include "addToRunTimeSelectionTable.H"
#include "polyMesh.H"
#include "PstreamReduceOps.H"
#include "userEntry.H"
#include "wordRes.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace walls
{
    defineTypeName(patchWall);
    addToRunTimeSelectionTable(particleWall, patchWall, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::walls::patchWall::patchWall
(
    const word& name,
    const dictionary& dict,
    const materials& mats,
    const polyMesh& mesh
)
:
    particleWall(name, dict, mats, mesh)
{
    userEntry::onlyThese
    (
        dict, {"type", "patches", "material", "motion", "T"}
    );

    const wordRes select(dict.get<wordRes>("patches"));
    patches_ = mesh.boundaryMesh().patchSet(select, false).sortedToc();

    if (patches_.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'patches' of wall " << name << " is " << select
            << " and names no patch of the mesh" << nl
            << "Patches: " << flatOutput(mesh.boundaryMesh().names())
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::wallShape Foam::dew::walls::patchWall::shape() const
{
    const boundBox& bb = mesh_.bounds();
    const vector span(bb.span());

    // Does it cover one side of the bounding box, and nothing else?
    scalar area = 0;
    boundBox own(boundBox::invertedBox);
    for (const label patchi : patches_)
    {
        const polyPatch& patch = mesh_.boundaryMesh()[patchi];
        for (const face& f : patch)
        {
            area += f.mag(mesh_.points());
        }
        own.add(boundBox(patch.localPoints(), false));
    }
    reduce(area, sumOp<scalar>());
    own.reduce();

    wallShape result;
    const scalar small = 1e-6*mag(span);

    for (direction k = 0; k < 3 && !motion().moves(); k++)
    {
        const scalar side = span[(k + 1)%3]*span[(k + 2)%3];

        if (own.span()[k] < small && mag(area - side) < 1e-6*side)
        {
            result.what = wallShape::plane;
            result.axis = k;
            result.position = own.midpoint();
            return result;
        }
    }

    // Triangles of all ranks on the master
    List<DynamicList<point>> corners(Pstream::nProcs());
    DynamicList<point>& mine = corners[Pstream::myProcNo()];

    for (const label patchi : patches_)
    {
        for (const face& f : mesh_.boundaryMesh()[patchi])
        {
            faceList triangles(f.nTriangles());
            label n = 0;
            f.triangles(mesh_.points(), n, triangles);

            for (const face& t : triangles)
            {
                for (const label pointi : t)
                {
                    mine.append(mesh_.points()[pointi]);
                }
            }
        }
    }
    Pstream::gatherList(corners);

    if (Pstream::master())
    {
        for (const DynamicList<point>& part : corners)
        {
            result.corners.append(part);
        }
    }

    return result;
}
