/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/


// What the equations of vapour and heat have of the gas

#include "gasPhase.H"
#include "fvcDiv.H"
#include "gasMixture.H"
#include "interfaceTransfer.H"
#include "linear.H"
#include "meanRhoD.H"
#include "phaseRegion.H"
#include "speciesFields.H"
#include "Time.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::gasPhase::correct()
{
    if (!Y_.solved())
    {
        forAll(rho_, celli)
        {
            rho_[celli] = model_.rho(p0_, T_[celli], Y_.standard());
        }
        rho_.correctBoundaryConditions();

        // Without vapour, what drives the flow is heat
        volScalarField Gamma
        (
            IOobject("Gamma", mesh_.time().timeName(), mesh_),
            mesh_,
            dimensionedScalar(GammaY_.dimensions(), Zero),
            zeroGradientFvPatchScalarField::typeName
        );
        forAll(Gamma, celli)
        {
            const scalar T = T_[celli];
            Gamma[celli] =
                model_.kappa(T, Y_.standard())/model_.Cp(T, Y_.standard());
        }
        Gamma.correctBoundaryConditions();
        GammaY_ =
            interface_.faces().sameGas()
           *linear<scalar>(mesh_).interpolate(Gamma);
        return;
    }

    const scalarField noVapour(Y_.size(), Zero);
    const boolList& gas = interface_.faces().gas();
    const surfaceScalarField& same = interface_.faces().sameGas();
    const bool stefan = interface_.law().stefanFlow();
    forAll(rho_, celli)
    {
        rho_[celli] =
            model_.rho
            (
                p0_, T_[celli], gas[celli] ? Y_.cell(celli) : noVapour
            );
    }
    rho_.correctBoundaryConditions();

    const label n = Y_.size();
    scalarField Y1(n), Gamma(n);
    forAll(mesh_.owner(), facei)
    {
        Gamma = 0;
        if (same[facei] > 0)
        {
            const label own = mesh_.owner()[facei];
            const label nei = mesh_.neighbour()[facei];
            Y1 = Y_.cell(own);
            meanRhoD_
            (
                p0_, Y1, Y_.cell(nei), 0.5*(T_[own] + T_[nei]), stefan, Gamma
            );
        }
        forAll(Gamma, i)
        {
            GammaYs_[i][facei] = Gamma[i];
        }
    }
    forAll(mesh_.boundary(), patchi)
    {
        correctPatch(patchi, stefan);
    }
    mean();
}


void Foam::dew::gasPhase::correctPatch(const label patchi, const bool stefan)
{
    const fvPatch& patch = mesh_.boundary()[patchi];
    const scalarField& mask =
        interface_.faces().sameGas().boundaryField()[patchi];
    const label n = Y_.size();
    const auto beyond = [&](const volScalarField& field)
    {
        const fvPatchScalarField& values = field.boundaryField()[patchi];
        return scalarField
        (
            patch.coupled()
          ? values.patchNeighbourField()
          : tmp<scalarField>(values)
        );
    };
    const scalarField Tb(beyond(T_));
    List<scalarField> Yb(n);
    forAll(Yb, i)
    {
        Yb[i] = beyond(Y_[i]);
    }
    scalarField Y1(n), Y2(n), Gamma(n);
    forAll(mask, facei)
    {
        Gamma = 0;
        if (mask[facei] > 0)
        {
            const label celli = patch.faceCells()[facei];
            Y1 = Y_.cell(celli);
            forAll(Y2, i)
            {
                Y2[i] = Yb[i][facei];
            }
            meanRhoD_
            (
                p0_, Y1, Y2, 0.5*(T_[celli] + Tb[facei]), stefan, Gamma
            );
        }
        forAll(Gamma, i)
        {
            GammaYs_[i].boundaryFieldRef()[patchi][facei] = Gamma[i];
        }
    }
}


void Foam::dew::gasPhase::mean()
{
    GammaY_ = GammaYs_[0];
    for (label i = 1; i < GammaYs_.size(); i++)
    {
        GammaY_ += GammaYs_[i];
    }
    if (GammaYs_.size() > 1)
    {
        GammaY_ /= scalar(GammaYs_.size());
    }
}


Foam::tmp<Foam::volScalarField::Internal>
Foam::dew::gasPhase::storageSp() const
{
    auto tsp = tmp<volScalarField::Internal>::New
    (
        IOobject("storageSp", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("zero", dimDensity/dimTime, Zero)
    );
    if (transient_)
    {
        tsp.ref().field() =
            rho_.primitiveField()*region_.V()/mesh_.V()/mesh_.time().deltaTValue();
    }
    return tsp;
}


Foam::tmp<Foam::volScalarField::Internal>
Foam::dew::gasPhase::storageSu(const label i) const
{
    auto tsu = tmp<volScalarField::Internal>::New
    (
        IOobject("storageSu", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("zero", dimDensity/dimTime, Zero)
    );
    if (transient_)
    {
        tsu.ref().field() =
            vapour0_[i]/mesh_.V()/mesh_.time().deltaTValue();
    }
    return tsu;
}


Foam::tmp<Foam::volScalarField::Internal> Foam::dew::gasPhase::storage() const
{
    auto ts = storageSp();
    if (transient_)
    {
        ts.ref().field() -=
            gas0_/mesh_.V()/mesh_.time().deltaTValue();
    }
    return ts;
}


Foam::tmp<Foam::volScalarField::Internal> Foam::dew::gasPhase::expansion
(
    const surfaceScalarField& phiG
) const
{
    auto te = tmp<volScalarField::Internal>::New
    (
        IOobject("expansion", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimless/dimTime, Zero)
    );
    scalarField& e = te.ref().field();

    // Where the density differs, what the flux brings changes its volume
    const volScalarField v(1/rho_);
    e =
        fvc::div(phiG*linear<scalar>(mesh_).interpolate(v))().primitiveField()
      - v.primitiveField()*fvc::div(phiG)().primitiveField();

    const boolList& gas = interface_.faces().gas();
    const scalar dt = mesh_.time().deltaTValue();
    forAll(e, celli)
    {
        if (!gas[celli])
        {
            e[celli] = 0;
        }
        else if (transient_ && V0_[celli] > 0)
        {
            e[celli] -=
                region_.V()[celli]
               *(1 - gas0_[celli]/(V0_[celli]*rho_[celli]))
               /(mesh_.V()[celli]*dt);
        }
    }

    for (label k = 0; k < interface_.faces().faces().size(); k++)
    {
        const label celli = interface_.faces().faces()[k].gas;
        e[celli] += interface_.through(k)*v[celli]/mesh_.V()[celli];
    }

    return te;
}


// ************************************************************************* //
