/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "cellDiffusion.H"
#include "cyclicFvPatch.H"
#include "fvMesh.H"
#include "processorFvPatch.H"
#include "surfaceFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::cellDiffusion::cellDiffusion
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    mesh_(mesh),
    rate_(0)
{
    for (const fvPatch& patch : mesh.boundary())
    {
        const bool known =
            !patch.coupled()
         || isA<processorFvPatch>(patch) || isA<cyclicFvPatch>(patch);
        const coupledPolyPatch* coupled =
            isA<coupledPolyPatch>(patch.patch())
          ? &refCast<const coupledPolyPatch>(patch.patch()) : nullptr;

        if (!known || (coupled && !coupled->parallel()))
        {
            FatalIOErrorInFunction(dict)
                << "Smoothing does not go over patch " << patch.name()
                << " of type " << patch.type() << ", which "
                << (known ? "turns vectors" : "is not face to face") << nl
                << "Use translational cyclic patches, or remove the smoothing"
                << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::cellDiffusion::correct()
{
    const surfaceScalarField& delta = mesh_.nonOrthDeltaCoeffs();
    const surfaceScalarField& area = mesh_.magSf();
    const scalarField& V = mesh_.V();

    g_ = area.primitiveField()*delta.primitiveField();

    scalarField diagonal(mesh_.nCells(), Zero);
    forAll(g_, facei)
    {
        diagonal[mesh_.owner()[facei]] += g_[facei];
        diagonal[mesh_.neighbour()[facei]] += g_[facei];
    }

    patchG_.setSize(mesh_.boundary().size());
    forAll(patchG_, patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        scalarField& g = patchG_[patchi];
        if (!patch.coupled())
        {
            g.clear();
            continue;
        }
        g = area.boundaryField()[patchi]*delta.boundaryField()[patchi];
        forAll(g, facei)
        {
            diagonal[patch.faceCells()[facei]] += g[facei];
        }
    }

    rate_ = 2*gMax(scalarField(diagonal/V));
    weight_ = 2/(max(rate_, VSMALL)*V);
}
