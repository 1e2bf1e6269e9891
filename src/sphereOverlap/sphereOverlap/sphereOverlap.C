/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sphereOverlap.H"
#include "bitSet.H"
#include "DynamicList.H"
#include "fvMesh.H"
#include "processorPolyPatch.H"
#include "syncTools.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::sphereOverlap::sphereOverlap
(
    const fvMesh& mesh,
    const meshSymmetry& symmetry
)
:
    mesh_(mesh),
    symmetry_(symmetry),
    cellSize_(mesh.nCells(), scalar(0)),
    r_(symmetry.wedge() ? mesh.nPoints() : 0),
    z_(r_.size()),
    power_(mesh.nPoints())
{
    const pointField& points = mesh.points();
    const labelListList& cellPoints = mesh.cellPoints();
    forAll(cellPoints, celli)
    {
        for (const label pointi : cellPoints[celli])
        {
            cellSize_[celli] = max
            (
                cellSize_[celli],
                mag(points[pointi] - mesh.C()[celli])
            );
        }
    }
    if (symmetry.wedge())
    {
        findEdges();
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::sphereOverlap::preparePoints(const sphericalCap& cap)
{
    const pointField& points = mesh_.points();

    if (!symmetry_.wedge())
    {
        forAll(points, i)
        {
            power_[i] = cap.power(points[i]);
        }
        return;
    }

    const scalar base = symmetry_.height(cap.base());
    const scalar up = cap.normal() & symmetry_.axis();
    forAll(points, i)
    {
        r_[i] = symmetry_.radius(points[i]);
        z_[i] = up*(symmetry_.height(points[i]) - base);
        power_[i] =
            sqr(cap.contactRadius()) - sqr(r_[i]) - sqr(z_[i])
          - 2*cap.depth()*z_[i];
    }
}


Foam::scalar Foam::dew::sphereOverlap::checked
(
    const scalar share,
    const scalar tolerance,
    const char* what,
    const label i
) const
{
    if (!(share >= -tolerance && share <= 1 + tolerance))
    {
        FatalErrorInFunction
            << "The share of the ball in " << what << ' ' << i
            << " comes out as " << share << nl
            << "The cells must be convex, with flat faces: see checkMesh"
            << exit(FatalError);
    }
    return min(max(share, scalar(0)), scalar(1));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::sphereOverlap::calculate
(
    const sphericalCap& cap,
    scalarField& share,
    scalarField& area,
    surfaceScalarField& faceShares
)
{
    preparePoints(cap);

    const bool wedge = symmetry_.wedge();
    const labelListList& cellPoints = mesh_.cellPoints();
    share.setSize(mesh_.nCells());
    area.setSize(mesh_.nCells());

    bitSet cut(mesh_.nCells());
    forAll(cellPoints, celli)
    {
        label nIn = 0;
        scalar highest = -GREAT;
        for (const label pointi : cellPoints[celli])
        {
            nIn += power_[pointi] >= 0;
            highest = max(highest, power_[pointi]);
        }

        area[celli] = 0;
        if (nIn == cellPoints[celli].size())
        {
            share[celli] = 1;
        }
        else if
        (
            // Nearer than its size from all its points, if it touches at all
            nIn == 0
         && -highest
          > 2*cellSize_[celli]*(2*cap.radius() + 2*cellSize_[celli])
        )
        {
            share[celli] = 0;
        }
        else
        {
            cut.set(celli);
            share[celli] =
                wedge
              ? ringShare(cap, celli, area[celli])
              : cellShare(cap, celli, area[celli]);
        }
    }

    scalarField allFaces(mesh_.nFaces());
    forAll(allFaces, facei)
    {
        // A cell that is wholly in or out has such faces; the sides of a
        // wedge are wetted as their cell is
        const label own = mesh_.faceOwner()[facei];
        const label other =
            mesh_.isInternalFace(facei) ? mesh_.faceNeighbour()[facei] : own;
        allFaces[facei] =
            !cut.test(own) ? share[own]
          : !cut.test(other) ? share[other]
          : wedge && faceEdge_[facei][0] < 0 ? share[own]
          : faceShare(cap, facei);
    }

    // The owner's value on both sides
    DynamicList<scalar> across;
    for (label i = mesh_.nInternalFaces(); i < mesh_.nFaces(); i++)
    {
        across.append(allFaces[i]);
    }
    syncTools::swapBoundaryFaceList(mesh_, across);

    faceShares.primitiveFieldRef() =
        SubList<scalar>(allFaces, mesh_.nInternalFaces());
    forAll(faceShares.boundaryField(), patchi)
    {
        const polyPatch& patch = mesh_.boundaryMesh()[patchi];
        fvsPatchScalarField& values = faceShares.boundaryFieldRef()[patchi];
        const bool other =
            isA<processorPolyPatch>(patch)
         && !refCast<const processorPolyPatch>(patch).owner();

        // Fields on empty patches have no values
        forAll(values, i)
        {
            const label facei = patch.start() + i;
            values[i] =
                other
              ? across[facei - mesh_.nInternalFaces()]
              : allFaces[facei];
        }
    }
}
