/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "wetRegion.H"
#include "fvcDiv.H"
#include "fvcGrad.H"
#include "fvcSnGrad.H"
#include "fvcSurfaceIntegrate.H"
#include "regionSplit.H"
#include "surfaceInterpolate.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::dew::findWetRegion
(
    volScalarField& alpha,
    surfaceScalarField& a,
    volScalarField& dry
)
{
    const fvMesh& mesh = alpha.mesh();
    constexpr scalar least = 1e-5;

    // Ways to other cells, wetted and all
    surfaceScalarField ways(mesh.magSf());
    forAll(mesh.boundary(), patchi)
    {
        if (!mesh.boundary()[patchi].coupled())
        {
            ways.boundaryFieldRef()[patchi] = 0;
        }
    }
    const volScalarField wetted(fvc::surfaceSum(a*ways));
    const volScalarField all(fvc::surfaceSum(ways));
    forAll(dry, celli)
    {
        dry[celli] =
            alpha[celli] <= 0 || wetted[celli] <= least*all[celli];
    }
    dry.correctBoundaryConditions();

    // Dry cells stay together: each a region would be as many as cells
    const auto separate = []
    (
        const scalar wet, const scalar one, const scalar other
    )
    {
        return one != other || (one < 0.5 && wet <= least);
    };
    boolList blocked(mesh.nFaces(), false);
    forAll(mesh.owner(), facei)
    {
        blocked[facei] = separate
        (
            a[facei], dry[mesh.owner()[facei]], dry[mesh.neighbour()[facei]]
        );
    }
    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        if (patch.coupled())
        {
            const scalarField other
            (
                dry.boundaryField()[patchi].patchNeighbourField()
            );
            forAll(patch, facei)
            {
                blocked[patch.start() + facei] = separate
                (
                    a.boundaryField()[patchi][facei],
                    dry[patch.faceCells()[facei]],
                    other[facei]
                );
            }
        }
    }

    const regionSplit regions(mesh, blocked);
    scalarField volume(regions.nRegions(), Zero);
    forAll(dry, celli)
    {
        if (dry[celli] < 0.5)
        {
            volume[regions[celli]] += alpha[celli]*mesh.V()[celli];
        }
    }
    Pstream::listCombineGather(volume, plusEqOp<scalar>());
    Pstream::listCombineScatter(volume);
    const label largest = findMax(volume);

    forAll(dry, celli)
    {
        if (regions[celli] != largest)
        {
            dry[celli] = 1;
        }
        alpha[celli] *= 1 - dry[celli];
    }
    alpha.correctBoundaryConditions();
    dry.correctBoundaryConditions();

    forAll(mesh.owner(), facei)
    {
        if (blocked[facei] || dry[mesh.owner()[facei]] > 0)
        {
            a[facei] = 0;
        }
    }
    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        scalarField& ab = a.boundaryFieldRef()[patchi];
        forAll(ab, facei)
        {
            if
            (
                blocked[patch.start() + facei]
             || dry[patch.faceCells()[facei]] > 0
            )
            {
                ab[facei] = 0;
            }
        }
    }
}


Foam::tmp<Foam::volVectorField> Foam::dew::wetReconstruct
(
    const surfaceScalarField& a,
    const volScalarField& p
)
{
    const fvMesh& mesh = p.mesh();

    const surfaceVectorField n(mesh.Sf()/mesh.magSf());
    const volTensorField shape(fvc::surfaceSum(a*n*mesh.Sf()));
    const volVectorField flux
    (
        fvc::surfaceSum(a*n*fvc::snGrad(p)*mesh.magSf())
    );

    tmp<volVectorField> tgradp
    (
        new volVectorField
        (
            IOobject("gradp", mesh.time().timeName(), mesh),
            mesh,
            dimensionedVector(p.dimensions()/dimLength, Zero)
        )
    );
    volVectorField& gradp = tgradp.ref();

    // So small that it decides only where nothing is wetted
    const scalar least = 1e-9;
    forAll(gradp, celli)
    {
        const scalar size = tr(shape[celli]);
        if (size > VSMALL)
        {
            gradp[celli] =
                inv(shape[celli] + least*size*tensor::I) & flux[celli];
        }
    }
    gradp.correctBoundaryConditions();

    return tgradp;
}


Foam::tmp<Foam::volVectorField> Foam::dew::transposedStress
(
    const surfaceScalarField& aNu,
    const volVectorField& U
)
{
    const tmp<volTensorField> gradU(fvc::grad(U));

    return
        fvc::div
        (
            aNu*(U.mesh().Sf() & fvc::interpolate(T(gradU())))
        );
}


void Foam::dew::extend
(
    volVectorField& U,
    const volScalarField& dry,
    const volVectorField& n,
    const label nLayers
)
{
    const fvMesh& mesh = U.mesh();
    const vectorField& C = mesh.cellCentres();

    volScalarField known("known", 1 - dry);
    U.primitiveFieldRef() *= known.primitiveField();

    for (label layer = 0; layer < nLayers; layer++)
    {
        known.correctBoundaryConditions();
        U.correctBoundaryConditions();

        vectorField sum(mesh.nCells(), Zero);
        scalarField count(mesh.nCells(), Zero);

        // What stands in the way to the liquid, within 45 degrees
        const auto add = [&]
        (
            const label celli, const vector& d, const scalar k, const vector& u
        )
        {
            if (k > 0.5 && (d & n[celli]) < -0.7*mag(d))
            {
                sum[celli] += u;
                count[celli] += 1;
            }
        };

        forAll(mesh.owner(), facei)
        {
            const label own = mesh.owner()[facei];
            const label nei = mesh.neighbour()[facei];
            add(own, C[nei] - C[own], known[nei], U[nei]);
            add(nei, C[own] - C[nei], known[own], U[own]);
        }
        for (const fvPatch& patch : mesh.boundary())
        {
            if (patch.coupled())
            {
                const scalarField k
                (
                    known.boundaryField()[patch.index()].patchNeighbourField()
                );
                const vectorField u
                (
                    U.boundaryField()[patch.index()].patchNeighbourField()
                );
                const vectorField d(patch.delta());
                forAll(k, facei)
                {
                    add(patch.faceCells()[facei], d[facei], k[facei], u[facei]);
                }
            }
        }

        forAll(U, celli)
        {
            if (known[celli] < 0.5 && count[celli] > 0)
            {
                U[celli] = sum[celli]/count[celli];
                known[celli] = 1;
            }
        }
    }
    U.correctBoundaryConditions();
}


// ************************************************************************* //
