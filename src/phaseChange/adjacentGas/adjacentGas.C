/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "adjacentGas.H"
#include "gaussGrad.H"
#include "interfaceFaces.H"
#include "surfaceMotion.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::adjacentGas::adjacentGas
(
    const interfaceFaces& faces,
    const surfaceMotion& surface
)
:
    faces_(faces),
    surface_(surface),
    free_
    (
        IOobject
        (
            "freeOfLiquid", surface.alpha().time().timeName(),
            surface.alpha().mesh()
        ),
        surface.alpha().mesh(),
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    )
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarField Foam::dew::adjacentGas::alongNormal
(
    const volScalarField& field
) const
{
    const fvMesh& mesh = free_.mesh();

    volScalarField outside(free_);
    outside.primitiveFieldRef() *= field.primitiveField();
    outside.correctBoundaryConditions();
    const volVectorField gradient
    (
        fv::gaussGrad<scalar>(mesh).grad(outside)
    );

    // Across coupled patches
    List<vectorField> gradientOf(mesh.boundary().size());
    List<scalarField> freeOf(mesh.boundary().size());
    forAll(gradientOf, patchi)
    {
        if (mesh.boundary()[patchi].coupled())
        {
            gradientOf[patchi] =
                gradient.boundaryField()[patchi].patchNeighbourField();
            freeOf[patchi] =
                free_.boundaryField()[patchi].patchNeighbourField();
        }
    }

    scalarField along(faces_.faces().size(), Zero);
    forAll(along, k)
    {
        const interfaceFace& face = faces_.faces()[k];
        if (free_[face.gas] > 0.5)
        {
            along[k] = gradient[face.gas] & face.n;
            continue;
        }

        scalar weights = 0;
        const auto add = [&]
        (
            const vector& Sf, const scalar isFree, const vector& there
        )
        {
            const scalar w = isFree*max(Sf & face.n, scalar(0));
            weights += w;
            along[k] += w*(there & face.n);
        };
        for (const label facei : mesh.cells()[face.gas])
        {
            if (mesh.isInternalFace(facei))
            {
                const bool owns = mesh.owner()[facei] == face.gas;
                const label other =
                    owns ? mesh.neighbour()[facei] : mesh.owner()[facei];
                add
                (
                    (owns ? 1 : -1)*mesh.Sf()[facei], free_[other],
                    gradient[other]
                );
                continue;
            }
            const label patchi = mesh.boundaryMesh().whichPatch(facei);
            if (mesh.boundary()[patchi].coupled())
            {
                const label i = facei - mesh.boundary()[patchi].start();
                add
                (
                    mesh.boundary()[patchi].Sf()[i], freeOf[patchi][i],
                    gradientOf[patchi][i]
                );
            }
        }
        along[k] = weights > 0 ? along[k]/weights : 0;
    }

    return along;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::adjacentGas::correct()
{
    // Shares that round-off and advection leave behind are no surface
    const scalar least = 1e-3;

    const volScalarField& alpha = surface_.alpha();
    forAll(free_, celli)
    {
        free_[celli] = faces_.gas()[celli] && alpha[celli] < least;
    }
    free_.correctBoundaryConditions();

    // That of 1 - s, where a gradient of s points at the surface
    L_ = alongNormal(free_);
    forAll(L_, k)
    {
        const interfaceFace& face = faces_.faces()[k];
        L_[k] = L_[k]*(face.dG + face.dL) > 0.01 ? 1/L_[k] : 0;
    }
}


// ************************************************************************* //
