/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "reconstructedDistance.H"
#include "addToRunTimeSelectionTable.H"
#include "transportedSurface.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace curvatureModels
{
    defineTypeName(reconstructedDistance);
    addToRunTimeSelectionTable
    (
        curvatureModel, reconstructedDistance, dictionary
    );
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::curvatureModels::reconstructedDistance::reconstructedDistance
(
    const transportedSurface& surface,
    const dictionary& dict
)
:
    curvatureModel(surface)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::dew::curvatureModels::reconstructedDistance::onFace
(
    const label facei
) const
{
    const fvMesh& mesh = surface_.mesh();
    const volVectorField& n = surface_.n();

    if (mesh.isInternalFace(facei))
    {
        const scalar w = mesh.weights()[facei];
        return
            w*n[mesh.owner()[facei]] + (1 - w)*n[mesh.neighbour()[facei]];
    }

    const label patchi = mesh.boundaryMesh().whichPatch(facei);
    const fvPatch& patch = mesh.boundary()[patchi];
    const label i = facei - patch.start();
    const label celli = mesh.faceOwner()[facei];
    if (patch.size() == 0)
    {
        return Zero;
    }
    if (patch.coupled())
    {
        const scalar w = patch.weights()[i];
        return w*n[celli] + (1 - w)*behind_[patchi][i];
    }
    if (polyPatch::constraintType(patch.type()))
    {
        // In the sides of a wedge n lies in these
        return Zero;
    }
    return surface_.angles().normal(patchi, i, n[celli]);
}


// * * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * //

void Foam::dew::curvatureModels::reconstructedDistance::calculate
(
    scalarField& K,
    boolList& known
)
{
    const fvMesh& mesh = surface_.mesh();
    const scalar m = paraboloidFit(mesh).nBends();

    behind_.setSize(mesh.boundary().size());
    for (const fvPatchVectorField& patch : surface_.n().boundaryField())
    {
        if (patch.coupled())
        {
            behind_[patch.patch().index()] = patch.patchNeighbourField();
        }
    }

    for (const label celli : surface_.planes().cell())
    {
        scalar flux = 0;
        for (const label facei : mesh.cells()[celli])
        {
            const scalar out = mesh.faceOwner()[facei] == celli ? 1 : -1;
            flux += out*(onFace(facei) & mesh.faceAreas()[facei]);
        }
        const scalar k = flux/mesh.V()[celli];
        const scalar level = 1 + surface_.psi()[celli]*k/m;
        if (level > 0.25)
        {
            K[celli] = k/level;
            known[celli] = true;
        }
    }
}
