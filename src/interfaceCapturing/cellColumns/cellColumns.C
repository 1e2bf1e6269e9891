/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "cellColumns.H"
#include "cyclicPolyPatch.H"
#include "emptyPolyPatch.H"
#include "globalIndex.H"
#include "processorPolyPatch.H"
#include "syncTools.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeNameAndDebug(cellColumns, 0);
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Cosine of the largest angle between a face and its axis, about 1e-3
constexpr scalar aligned = 1 - 1e-6;

//- Sides of a mesh without thickness
bool flat(const polyPatch& patch)
{
    return isA<emptyPolyPatch>(patch) || isA<wedgePolyPatch>(patch);
}

//- Is there exactly one cell behind each face, and is it in line?
bool inLine(const polyPatch& patch)
{
    return
        (isA<processorPolyPatch>(patch) || isA<cyclicPolyPatch>(patch))
     && refCast<const coupledPolyPatch>(patch).parallel();
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::cellColumns::chooseAxes()
{
    if (symmetry_.wedge())
    {
        e_[0] = symmetry_.radial();
        e_[1] = symmetry_.axis();
        e_[2] = symmetry_.azimuth();
        return;
    }

    // Of the first hexahedron whose faces are at right angles
    vectorField axes(3, Zero);
    label rank = Pstream::nProcs();
    forAll(mesh_.cells(), celli)
    {
        const cell& faces = mesh_.cells()[celli];
        if (faces.size() != 6)
        {
            continue;
        }
        label found = 0;
        for (const label facei : faces)
        {
            const vector n(normalised(mesh_.faceAreas()[facei]));
            bool isNew = true;
            bool right = true;
            for (label k = 0; k < found; k++)
            {
                const scalar c = mag(n & axes[k]);
                isNew = isNew && c < aligned;
                right = right && (c > aligned || c < 1e-3);
            }
            if (!right)
            {
                found = 0;
                break;
            }
            if (isNew && found < 3)
            {
                axes[found++] = n;
            }
        }
        if (found == 3)
        {
            rank = Pstream::myProcNo();
            break;
        }
    }

    const label first = returnReduce(rank, minOp<label>());
    if (first == Pstream::nProcs())
    {
        // Nothing of the cells that were tried
        axes = Zero;
        for (label k = 0; k < 3; k++)
        {
            axes[k][k] = 1;
        }
    }
    else
    {
        if (rank != first)
        {
            axes = Zero;
        }
        for (vector& e : axes)
        {
            reduce(e, sumOp<vector>());
        }
    }

    // In the order and sense of x, y, z
    for (label k = 0; k < 3; k++)
    {
        label best = 0;
        forAll(axes, j)
        {
            if (mag(axes[j][k]) > mag(axes[best][k]))
            {
                best = j;
            }
        }
        e_[k] = axes[best]*sign(axes[best][k]);
        axes[best] = Zero;
    }
}


Foam::label Foam::dew::cellColumns::direction(const vector& areaVector) const
{
    const scalar limit = aligned*mag(areaVector);
    for (label k = 0; k < 3; k++)
    {
        const scalar along = areaVector & e_[k];
        if (mag(along) > limit)
        {
            return 2*k + (along > 0);
        }
    }
    return -1;
}


void Foam::dew::cellColumns::measure()
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const scalar scale = wedge() ? 1/symmetry_.cosHalfAngle() : 1;
    List<label> solved(3, 0);

    width_.setSize(mesh_.nCells());
    width_ = Zero;
    inner_.setSize(mesh_.nCells());
    inner_ = 0;
    nUnfit_ = 0;

    // What is solved for
    for (const polyPatch& patch : patches)
    {
        if (!flat(patch))
        {
            forAll(patch, i)
            {
                const label dir = direction(patch.faceAreas()[i]);
                if (dir >= 0)
                {
                    solved[dir/2] = 1;
                }
            }
        }
    }
    for (label facei = 0; facei < mesh_.nInternalFaces(); facei++)
    {
        const label dir = direction(mesh_.faceAreas()[facei]);
        if (dir >= 0)
        {
            solved[dir/2] = 1;
        }
    }
    for (label k = 0; k < 3; k++)
    {
        reduce(solved[k], maxOp<label>());
        solved_[k] = solved[k] && !(wedge() && k == 2);
    }

    forAll(width_, celli)
    {
        FixedList<scalar, 6> at(scalar(0));
        FixedList<label, 6> n(label(0));
        bool fits = true;

        for (const label facei : mesh_.cells()[celli])
        {
            const label patchi = patches.whichPatch(facei);
            if (patchi >= 0 && flat(patches[patchi]))
            {
                continue;
            }
            const scalar out = mesh_.faceOwner()[facei] == celli ? 1 : -1;
            const label dir = direction(out*mesh_.faceAreas()[facei]);
            if (dir < 0)
            {
                fits = false;
                break;
            }
            n[dir]++;
            at[dir] =
                e_[dir/2] & (mesh_.faceCentres()[facei] - symmetry_.origin());
        }

        // At the axis of a wedge a ring has no inside
        if (wedge() && n[0] == 0)
        {
            n[0] = 1;
            at[0] = 0;
        }

        vector width(vector::one);
        for (label k = 0; k < 3; k++)
        {
            if (solved_[k])
            {
                fits = fits && n[2*k] == 1 && n[2*k + 1] == 1;
                width[k] = at[2*k + 1] - at[2*k];
            }
        }
        if (wedge())
        {
            width.x() *= scale;
            inner_[celli] = at[0]*scale;
        }

        if (fits)
        {
            width_[celli] = width;
        }
        else
        {
            nUnfit_++;
        }
    }
    reduce(nUnfit_, sumOp<label>());
}


void Foam::dew::cellColumns::link()
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const globalIndex numbers(mesh_.nCells());
    const label nInternal = mesh_.nInternalFaces();

    labelList behind(mesh_.nBoundaryFaces());
    forAll(behind, i)
    {
        behind[i] = numbers.toGlobal(mesh_.faceOwner()[nInternal + i]);
    }
    syncTools::swapBoundaryFaceList(mesh_, behind);

    FixedList<label, 6> noNeighbour(none);
    if (wedge())
    {
        noNeighbour[0] = axis;
    }
    next_.setSize(mesh_.nCells());
    next_ = noNeighbour;

    for (label facei = 0; facei < nInternal; facei++)
    {
        const label dir = direction(mesh_.faceAreas()[facei]);
        if (dir >= 0)
        {
            const label own = mesh_.faceOwner()[facei];
            const label nei = mesh_.faceNeighbour()[facei];
            next_[own][dir] = numbers.toGlobal(nei);
            next_[nei][dir ^ 1] = numbers.toGlobal(own);
        }
    }

    for (const polyPatch& patch : patches)
    {
        if (flat(patch))
        {
            continue;
        }
        const bool through = inLine(patch);
        forAll(patch, i)
        {
            const label facei = patch.start() + i;
            const label dir = direction(mesh_.faceAreas()[facei]);
            if (dir >= 0)
            {
                next_[mesh_.faceOwner()[facei]][dir] =
                    through ? behind[facei - nInternal]
                  : patch.coupled() ? none
                  : boundary;
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::cellColumns::cellColumns(const fvMesh& mesh)
:
    MeshObject<fvMesh, GeometricMeshObject, cellColumns>(mesh),
    symmetry_(mesh)
{
    chooseAxes();
    measure();
    link();
    addHalo();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::dew::cellColumns::boundaryFace
(
    const label celli,
    const label dir
) const
{
    for (const label facei : mesh_.cells()[celli])
    {
        if
        (
            !mesh_.isInternalFace(facei)
         && direction(mesh_.faceAreas()[facei]) == dir
        )
        {
            return facei;
        }
    }
    return -1;
}
