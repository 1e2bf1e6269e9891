/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "cellPlanes.H"
#include "cyclicPolyPatch.H"
#include "polyMesh.H"
#include "PstreamReduceOps.H"
#include "processorCyclicPolyPatch.H"
#include "syncTools.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Which of a face's two sides keeps the points on it: +1 the side from which
//  n points outward, -1 the other
Foam::scalar keeper(const Foam::vector& n)
{
    for (Foam::direction k = 0; k < 3; k++)
    {
        if (std::abs(n[k]) > 1e-6)
        {
            return n[k] > 0 ? 1 : -1;
        }
    }
    return 1;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::cellPlanes::cellPlanes(const polyMesh& mesh)
:
    mesh_(mesh),
    period_(GREAT),
    maxSteps_(0)
{
    correct();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::cellPlanes::findCrossings()
{
    const label nInternal = mesh_.nInternalFaces();
    const label nBoundary = mesh_.nFaces() - nInternal;

    // Cell, face, rank and face centre of the other side; as plain numbers,
    // which are not transformed on the way
    labelList cell(nBoundary), face(nBoundary);
    labelList rank(nBoundary, Pstream::myProcNo());
    List<scalar> centre[3];

    forAll(cell, i)
    {
        cell[i] = mesh_.faceOwner()[nInternal + i];
        face[i] = nInternal + i;
    }
    syncTools::swapBoundaryFaceList(mesh_, cell);
    syncTools::swapBoundaryFaceList(mesh_, face);
    syncTools::swapBoundaryFaceList(mesh_, rank);

    for (direction k = 0; k < 3; k++)
    {
        centre[k].setSize(nBoundary);
        forAll(centre[k], i)
        {
            centre[k][i] = mesh_.faceCentres()[nInternal + i][k];
        }
        syncTools::swapBoundaryFaceList(mesh_, centre[k]);
    }

    crossings_.setSize(nBoundary);
    crossings_ = crossing{-1, -1, -1, Zero};
    period_ = GREAT;

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        const bool cyclic =
            isA<cyclicPolyPatch>(patch) || isA<processorCyclicPolyPatch>(patch);

        if (!cyclic && !isA<processorPolyPatch>(patch))
        {
            continue;
        }

        forAll(patch, facei)
        {
            const label i = patch.start() + facei - nInternal;
            crossing& c = crossings_[i];
            c.rank = rank[i];
            c.cell = cell[i];
            c.face = face[i];

            if (cyclic)
            {
                c.shift =
                    vector(centre[0][i], centre[1][i], centre[2][i])
                  - patch.faceCentres()[facei];
                period_ = min(period_, mag(c.shift));
            }
        }
    }
    reduce(period_, minOp<scalar>());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::dew::cellPlanes::crossing& Foam::dew::cellPlanes::beyond
(
    const label facei
) const
{
    return crossings_[boundaryIndex(facei)];
}


Foam::label Foam::dew::cellPlanes::boundaryIndex(const label facei) const
{
    return facei - mesh_.nInternalFaces();
}


void Foam::dew::cellPlanes::correct()
{
    const label nCells = mesh_.nCells();
    const cellList& cells = mesh_.cells();
    const pointField& points = mesh_.points();
    const vectorField& Cf = mesh_.faceCentres();
    const vectorField& Sf = mesh_.faceAreas();

    findCrossings();

    start_.setSize(nCells + 1);
    start_[0] = 0;
    for (label celli = 0; celli < nCells; celli++)
    {
        start_[celli + 1] = start_[celli] + cells[celli].size();
    }
    planes_.setSize(start_[nCells]);

    for (label celli = 0; celli < nCells; celli++)
    {
        label k = start_[celli];

        for (const label facei : cells[celli])
        {
            facePlane& plane = planes_[k++];
            const scalar area = mag(Sf[facei]);
            const bool owner = mesh_.faceOwner()[facei] == celli;

            // A face without area separates nothing
            plane.n = area > VSMALL ? vector(Sf[facei]/area) : vector(Zero);
            plane.offset = plane.n & Cf[facei];

            plane.warp = 0;
            for (const label pointi : mesh_.faces()[facei])
            {
                const scalar above =
                    mag((plane.n & points[pointi]) - plane.offset);
                plane.warp = max(plane.warp, float(above));
            }
            if (plane.warp < 1e-9*std::sqrt(area))
            {
                plane.warp = 0;
            }

            // Nobody else takes what is on the outer boundary
            const bool outer =
                facei >= mesh_.nInternalFaces() && beyond(facei).rank < 0;

            plane.offset +=
                1e-9*std::sqrt(area)*(outer ? 1 : keeper(plane.n));
            if (!owner)
            {
                plane.n = -plane.n;
                plane.offset = -plane.offset;
            }

            plane.next =
                facei >= mesh_.nInternalFaces() ? -1 - facei
              : owner ? mesh_.faceNeighbour()[facei]
              : mesh_.faceOwner()[facei];
        }
    }

    maxSteps_ = 20 + 8*label(std::cbrt(scalar(nCells)));
}


Foam::label Foam::dew::cellPlanes::walk(const point& p, label& celli) const
{
    for (label step = 0; step < maxSteps_; step++)
    {
        scalar farthest[3] = {0, 0, 0};
        label through[3] = {-1, -1, -1};

        const label end = start_[celli + 1];
        for (label k = start_[celli]; k < end; k++)
        {
            const facePlane& plane = planes_[k];
            const scalar beyond = (plane.n & p) - plane.offset;

            if (beyond > 0)
            {
                // Inside the rank first, then to other ranks, then out
                const label next = plane.next;
                const int kind =
                    next >= 0 ? 0
                  : this->beyond(-1 - next).rank >= 0 ? 1 : 2;

                if (beyond > farthest[kind])
                {
                    farthest[kind] = beyond;
                    through[kind] = next >= 0 ? next : -1 - next;
                }
            }
        }

        if (farthest[0] > 0)
        {
            celli = through[0];
        }
        else if (farthest[1] > 0)
        {
            return through[1];
        }
        else
        {
            return farthest[2] > 0 ? through[2] : label(inside);
        }
    }

    return lost;
}


bool Foam::dew::cellPlanes::ambiguous
(
    const point& p,
    const label celli
) const
{
    for (label k = start_[celli]; k < start_[celli + 1]; k++)
    {
        const facePlane& plane = planes_[k];
        if (plane.warp > 0 && (plane.n & p) - plane.offset > -plane.warp)
        {
            return true;
        }
    }
    return false;
}


void Foam::dew::cellPlanes::cuts
(
    const point& p,
    const label celli,
    const scalar reach,
    DynamicList<cut>& near
) const
{
    near.clear();

    const label end = start_[celli + 1];
    for (label k = start_[celli]; k < end; k++)
    {
        const facePlane& plane = planes_[k];
        const scalar distance = plane.offset - (plane.n & p);

        if (distance < reach && plane.n != vector::zero)
        {
            near.append(cut{plane.n, distance});
        }
    }
}
