/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "planeAdvection.H"
#include "cellVelocity.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::planeAdvection::planeAdvection(const fvMesh& mesh)
:
    mesh_(mesh),
    cut_(mesh),
    moved_(0)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::planeAdvection::upwindFlux
(
    const volScalarField& alpha,
    const surfaceScalarField& alphacPhi,
    const scalar dt
)
{
    fluid_.setSize(mesh_.nFaces());
    liquid_.setSize(mesh_.nFaces());

    const labelUList& own = mesh_.owner();
    const labelUList& nei = mesh_.neighbour();
    forAll(own, facei)
    {
        fluid_[facei] = dt*alphacPhi[facei];
        liquid_[facei] =
            fluid_[facei]*alpha[fluid_[facei] > 0 ? own[facei] : nei[facei]];
    }

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        const label patchi = patch.index();
        const scalarField& flux = alphacPhi.boundaryField()[patchi];
        const fvPatchScalarField& share = alpha.boundaryField()[patchi];
        const labelUList& cells = patch.faceCells();

        // Those of empty patches have no values
        forAll(patch, i)
        {
            const label facei = patch.start() + i;
            fluid_[facei] = flux.empty() ? 0 : dt*flux[i];
            liquid_[facei] =
                fluid_[facei] > 0 ? fluid_[facei]*alpha[cells[i]]
              : fluid_[facei] < 0 ? fluid_[facei]*share[i]
              : 0;
        }
    }
}


void Foam::dew::planeAdvection::planeFlux
(
    const interfacePlanes& planes,
    const volVectorField& U,
    const scalar dt
)
{
    const cellVelocity velocity(U);

    forAll(planes.cell(), i)
    {
        const label celli = planes.cell()[i];
        const point& x = planes.x()[i];
        const vector& n = planes.n()[i];
        const scalar travel = dt*velocity(celli, x, n);

        for (const label facei : mesh_.cells()[celli])
        {
            if (outOf(celli, facei, fluid_[facei]) > 0)
            {
                liquid_[facei] =
                    fluid_[facei]*cut_.meanShare(facei, x, n, travel);
            }
        }
    }
}


void Foam::dew::planeAdvection::shareCoupled()
{
    const label nInternal = mesh_.nInternalFaces();
    scalarField across(mesh_.nFaces() - nInternal);
    forAll(across, i)
    {
        across[i] = liquid_[nInternal + i];
    }
    syncTools::swapBoundaryFaceList(mesh_, across);

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (patch.coupled())
        {
            forAll(patch, i)
            {
                const label facei = patch.start() + i;
                if (fluid_[facei] < 0)
                {
                    liquid_[facei] = -across[facei - nInternal];
                }
            }
        }
    }
}


void Foam::dew::planeAdvection::balance
(
    const volScalarField& alpha,
    const volScalarField& alphac
)
{
    const scalarField& V = mesh_.V();
    const scalarField& Vold = mesh_.moving() ? mesh_.V0().field() : V;
    content_ = alphac.oldTime()*alpha.oldTime()*Vold;
    capacity_ = alphac*V;

    const label nInternal = mesh_.nInternalFaces();
    const labelList& own = mesh_.faceOwner();
    const labelList& nei = mesh_.faceNeighbour();
    forAll(liquid_, facei)
    {
        content_[own[facei]] -= liquid_[facei];
        if (facei < nInternal)
        {
            content_[nei[facei]] += liquid_[facei];
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::planeAdvection::advect
(
    volScalarField& alpha,
    surfaceScalarField& alphaPhi,
    const interfacePlanes& planes,
    const surfaceScalarField& alphacPhi,
    const volVectorField& U,
    const volScalarField& alphac
)
{
    const scalar dt = mesh_.time().deltaTValue();

    upwindFlux(alpha.oldTime(), alphacPhi, dt);
    planeFlux(planes, U, dt);
    shareCoupled();
    balance(alpha, alphac);
    bound();

    alpha.primitiveFieldRef() = content_/capacity_;
    alpha.correctBoundaryConditions();

    forAll(alphaPhi, facei)
    {
        alphaPhi[facei] = liquid_[facei]/dt;
    }
    forAll(mesh_.boundary(), patchi)
    {
        const label start = mesh_.boundaryMesh()[patchi].start();
        scalarField& flux = alphaPhi.boundaryFieldRef()[patchi];
        forAll(flux, i)
        {
            flux[i] = liquid_[start + i]/dt;
        }
    }
}
