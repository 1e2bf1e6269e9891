/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleBox.H"
#include "cyclicPolyPatch.H"
#include "polyMesh.H"
#include "processorCyclicPolyPatch.H"
#include "PstreamReduceOps.H"
#include "SubField.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleBox::particleBox
(
    const polyMesh& mesh,
    const meshSymmetry& symmetry,
    const dictionary& dict
)
:
    bounds_(symmetry.bounds()),
    periodic_(false)
{
    const vector span(mesh.bounds().span());
    const scalar tolerance = 1e-6;

    const polyBoundaryMesh& patches = mesh.boundaryMesh();

    forAll(patches, patchi)
    {
        if (!isA<cyclicPolyPatch>(patches[patchi]))
        {
            continue;
        }
        const cyclicPolyPatch& cyclic =
            refCast<const cyclicPolyPatch>(patches[patchi]);

        // What a decomposition cut through lies in processorCyclic patches
        vector sep(Zero);
        if (cyclic.size())
        {
            sep = cyclic.faceCentres()[0] - cyclic.neighbPatch().faceCentres()[0];
        }
        for (const polyPatch& patch : patches)
        {
            const processorCyclicPolyPatch* proc =
                isA<processorCyclicPolyPatch>(patch);

            if (proc && proc->size() && proc->referPatchID() == patchi)
            {
                sep = proc->faceCentres()[0] - proc->neighbFaceCentres()[0];
            }
        }
        reduce(sep, maxMagSqrOp<vector>());

        const bool rotated =
            returnReduce(!cyclic.parallel(), orOp<bool>());

        label axis = -1;
        for (direction k = 0; k < 3; k++)
        {
            vector along(Zero);
            along[k] = span[k];

            if (mag(cmptMag(sep) - along) < tolerance*mag(span))
            {
                axis = k;
            }
        }

        scalar area = 0;
        forAll(patches, otheri)
        {
            const processorCyclicPolyPatch* proc =
                isA<processorCyclicPolyPatch>(patches[otheri]);

            if (otheri == patchi || (proc && proc->referPatchID() == patchi))
            {
                area += sum(mag(patches[otheri].faceAreas()));
            }
        }
        reduce(area, sumOp<scalar>());

        if (axis >= 0)
        {
            // The end of a wedge is a triangle
            const scalar side =
                (symmetry.wedge() ? 0.5 : 1)
               *span[(axis + 1)%3]*span[(axis + 2)%3];
            axis = mag(area - side) < tolerance*side ? axis : -1;
        }

        if (axis < 0 || rotated)
        {
            FatalIOErrorInFunction(dict)
                << "Cyclic patch " << cyclic.name() << " joins faces "
                << sep << " apart; the mesh spans " << span << nl
                << "Particles can only pass cyclic patches that join whole opposite"
                << " sides of the mesh's bounding box along x, y or z."
                << " Use other patches, or walls"
                << exit(FatalIOError);
        }

        periodic_[axis] = true;
    }

    if (dict.found("periodic"))
    {
        FixedList<bool, 3> expected(false);

        for (const word& axis : dict.get<wordList>("periodic"))
        {
            const label k = axis.size() == 1 ? axis[0] - 'x' : -1;
            if (k < 0 || k > 2)
            {
                FatalIOErrorInFunction(dict)
                    << "Entry 'periodic' names " << axis
                    << "; valid are x, y and z"
                    << exit(FatalIOError);
            }
            expected[k] = true;
        }

        if (expected != periodic_)
        {
            FatalIOErrorInFunction(dict)
                << "Cyclic mismatch: entry 'periodic' is "
                << flatOutput(dict.get<wordList>("periodic"))
                << " but the mesh is cyclic along (x y z) = "
                << periodic_ << nl
                << "Make the patches cyclic in constant/polyMesh/boundary"
                << " (blockMeshDict) or correct the entry"
                << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::particleBox::refuseRange
(
    const dictionary& dict,
    const word& key,
    const scalar range
) const
{
    for (direction k = 0; k < 3; k++)
    {
        const scalar side = bounds_.span()[k];
        if (periodic_[k] && range > 0.5*side)
        {
            FatalIOErrorInFunction(dict)
                << "Entry '" << key << "' in " << dict.dictName() << " is "
                << range << " m, more than half of the periodic box along "
                << "xyz"[k] << ", " << side << " m: particles would meet"
                << " others twice" << nl
                << "Lower it, or use a box of at least " << 2*range << " m"
                << exit(FatalIOError);
        }
    }
}


Foam::vector Foam::dew::particleBox::separation
(
    const point& a,
    const point& b
) const
{
    vector s(b - a);

    for (direction k = 0; k < 3; k++)
    {
        if (periodic_[k])
        {
            const scalar span = bounds_.span()[k];
            s[k] -= span*std::round(s[k]/span);
        }
    }

    return s;
}


Foam::point Foam::dew::particleBox::wrapped(const point& p) const
{
    point q(p);

    for (direction k = 0; k < 3; k++)
    {
        if (periodic_[k])
        {
            const scalar low = bounds_.min()[k];
            const scalar span = bounds_.span()[k];
            q[k] -= span*std::floor((q[k] - low)/span);
        }
    }

    return q;
}
