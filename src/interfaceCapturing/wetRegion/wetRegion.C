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
#include "surfaceInterpolate.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

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
    const label nLayers
)
{
    const fvMesh& mesh = U.mesh();

    volScalarField known
    (
        IOobject("known", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("zero", dimless, Zero)
    );
    forAll(U, celli)
    {
        known[celli] = dry[celli] < 0.5;
        if (known[celli] < 0.5)
        {
            U[celli] = Zero;
        }
    }

    for (label layer = 0; layer < nLayers; layer++)
    {
        known.correctBoundaryConditions();
        U.correctBoundaryConditions();

        vectorField sum(mesh.nCells(), Zero);
        scalarField n(mesh.nCells(), Zero);
        forAll(mesh.owner(), facei)
        {
            const label own = mesh.owner()[facei];
            const label nei = mesh.neighbour()[facei];
            sum[own] += known[nei]*U[nei];
            n[own] += known[nei];
            sum[nei] += known[own]*U[own];
            n[nei] += known[own];
        }
        forAll(mesh.boundary(), patchi)
        {
            if (mesh.boundary()[patchi].coupled())
            {
                const labelUList& cells = mesh.boundary()[patchi].faceCells();
                const scalarField k
                (
                    known.boundaryField()[patchi].patchNeighbourField()
                );
                const vectorField u
                (
                    U.boundaryField()[patchi].patchNeighbourField()
                );
                forAll(cells, facei)
                {
                    sum[cells[facei]] += k[facei]*u[facei];
                    n[cells[facei]] += k[facei];
                }
            }
        }

        forAll(U, celli)
        {
            if (known[celli] < 0.5 && n[celli] > 0.5)
            {
                U[celli] = sum[celli]/n[celli];
                known[celli] = 1;
            }
        }
    }
    U.correctBoundaryConditions();
}


// ************************************************************************* //
