/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "patchWall.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"
#include "polyMesh.H"
#include "processorPolyPatch.H"
#include "PstreamReduceOps.H"
#include "userEntry.H"
#include "wedgePolyPatch.H"
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
    particleWall(name, dict, mats, mesh),
    symmetry_(mesh),
    segments_(90)
{
    userEntry::onlyThese
    (
        dict, {"type", "patches", "material", "motion", "T", "segments"}
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

        const label literal =
            one.isPattern() ? -1 : mesh.boundaryMesh().findPatchID(one);
        if (literal >= 0 && isA<wedgePolyPatch>(mesh.boundaryMesh()[literal]))
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'patches' of wall " << name << " has " << one
                << ", a wedge patch: particles move through it, around the"
                << " axis" << nl << "Take it out of the list"
                << exit(FatalIOError);
        }
    }

    // A pattern may also match the cuts between ranks
    DynamicList<label> walls;
    for (const label patchi : patches_)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];
        if (!isA<wedgePolyPatch>(patch) && !isA<processorPolyPatch>(patch))
        {
            walls.append(patchi);
        }
    }
    patches_.transfer(walls);

    if (dict.found("segments"))
    {
        segments_ = userEntry::count(dict, "segments");
        if (!symmetry_.wedge() || segments_ < 8)
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'segments' of wall " << name << " is " << segments_
                << nl << "It is for wedge meshes, and at least 8; remove it,"
                << " or raise it" << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::walls::patchWall::revolve
(
    const face& f,
    DynamicList<point>& corners
) const
{
    // Its profile: the two places, of its points, that are farthest apart
    const auto place = [&](const label pointi)
    {
        const point& p = mesh_.points()[pointi];
        return vector(symmetry_.radius(p), symmetry_.height(p), 0);
    };
    vector a(place(f[0])), b(a);
    for (const label pointi : f)
    {
        const vector p(place(pointi));
        b = magSqr(p - a) > magSqr(b - a) ? p : b;
    }

    const scalar outer = max(a.x(), b.x());
    const scalar small = 1e-9*(outer + mag(b - a));
    if (outer < small)
    {
        return;
    }

    const auto at = [&](const vector& p, const label j)
    {
        const scalar phi =
            constant::mathematical::twoPi*(j % segments_)/segments_;
        return
            symmetry_.origin() + p.y()*symmetry_.axis()
          + p.x()
           *(cos(phi)*symmetry_.radial() + sin(phi)*symmetry_.azimuth());
    };
    const auto triangle = [&](const point& p, const point& q, const point& r)
    {
        corners.append(p);
        corners.append(q);
        corners.append(r);
    };

    // The engine does not take needles: triangles are cut where they are
    // longer than ten times their width
    const scalar width = 2*outer*sin(constant::mathematical::pi/segments_);
    const label n = 1 + label(mag(b - a)/(10*width));
    for (label k = 0; k < n; k++)
    {
        const vector low(a + (b - a)*k/n), high(a + (b - a)*(k + 1)/n);
        for (label j = 0; j < segments_; j++)
        {
            if (high.x() > small)
            {
                triangle(at(low, j), at(high, j), at(high, j + 1));
            }
            if (low.x() > small)
            {
                triangle(at(low, j), at(high, j + 1), at(low, j + 1));
            }
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
        if (symmetry_.wedge() && mag(symmetry_.axis()[k]) < 0.5)
        {
            continue;
        }

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

        // The end of a wedge is a triangle
        const scalar whole =
            (symmetry_.wedge() ? 0.5 : 1)
           *bb.span()[(k + 1)%3]*bb.span()[(k + 2)%3];
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
            if (symmetry_.wedge())
            {
                revolve(f, mine);
                continue;
            }

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
