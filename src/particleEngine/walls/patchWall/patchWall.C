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

    for (const wordRe& one : select)
    {
        if (mesh.boundaryMesh().patchSet(wordRes(1, one), false).empty())
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'patches' of wall " << name << " has " << one
                << ", which names no patch of the mesh" << nl
                << "Patches: " << flatOutput(mesh.boundaryMesh().names())
                << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::dew::wallShape>
Foam::dew::walls::patchWall::shapes() const
{
    const boundBox& bb = mesh_.bounds();
    const scalar small = 1e-6*bb.mag();

    // A side of the bounding box that is covered as a whole is a plane
    const auto onSide = [&](const polyPatch& patch, const label facei, const label side)
    {
        const direction k = side/2;
        const scalar limit = (side % 2 ? bb.max() : bb.min())[k];

        for (const label pointi : patch[facei])
        {
            if (mag(mesh_.points()[pointi][k] - limit) > small)
            {
                return false;
            }
        }
        return true;
    };

    List<wallShape> result;
    boolList covered(6, false);

    for (label side = 0; side < 6 && !motion().moves(); side++)
    {
        const direction k = side/2;

        scalar area = 0;
        for (const label patchi : patches_)
        {
            const polyPatch& patch = mesh_.boundaryMesh()[patchi];
            forAll(patch, facei)
            {
                if (onSide(patch, facei, side))
                {
                    area += patch[facei].mag(mesh_.points());
                }
            }
        }
        reduce(area, sumOp<scalar>());

        const scalar whole = bb.span()[(k + 1)%3]*bb.span()[(k + 2)%3];
        covered[side] = mag(area - whole) < 1e-6*whole;

        if (covered[side])
        {
            wallShape plane;
            plane.what = wallShape::plane;
            plane.axis = k;
            plane.position = side % 2 ? bb.max() : bb.min();
            result.append(plane);
        }
    }

    // Triangles of the other faces, of all ranks, on the master
    List<DynamicList<point>> corners(Pstream::nProcs());
    DynamicList<point>& mine = corners[Pstream::myProcNo()];

    for (const label patchi : patches_)
    {
        const polyPatch& patch = mesh_.boundaryMesh()[patchi];
        forAll(patch, facei)
        {
            bool done = false;
            for (label side = 0; side < 6; side++)
            {
                done = done || (covered[side] && onSide(patch, facei, side));
            }
            if (done)
            {
                continue;
            }

            const face& f = patch[facei];
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
    const bool rest = returnReduce(mine.size(), sumOp<label>());
    Pstream::gatherList(corners);

    if (rest)
    {
        wallShape triangles;
        if (Pstream::master())
        {
            for (const DynamicList<point>& part : corners)
            {
                triangles.corners.append(part);
            }
        }
        result.append(triangles);
    }

    return result;
}
