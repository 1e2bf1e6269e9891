/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "evaporatingFluids.H"
#include "gasMixture.H"
#include "liquidPhase.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const Foam::dimensionSet conductivity
(
    Foam::dimPower/Foam::dimLength/Foam::dimTemperature
);
const Foam::dimensionSet heatCapacity
(
    Foam::dimEnergy/Foam::dimMass/Foam::dimTemperature
);


Foam::volScalarField property
(
    const Foam::word& name,
    const Foam::fvMesh& mesh,
    const Foam::dimensionSet& dims,
    const Foam::IOobject::writeOption write = Foam::IOobject::NO_WRITE
)
{
    using namespace Foam;
    return volScalarField
    (
        IOobject
        (
            name, mesh.time().timeName(), mesh, IOobject::NO_READ, write
        ),
        mesh,
        dimensionedScalar(dims, Zero),
        zeroGradientFvPatchScalarField::typeName
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::evaporatingFluids::evaporatingFluids
(
    const liquidPhase& liquid,
    const gasMixture& gas,
    const scalar& p0,
    const scalar rhoL,
    const volScalarField& alpha,
    const volScalarField& T,
    const volScalarField& rhoGas,
    const speciesFields& Y
)
:
    liquid_(liquid),
    gas_(gas),
    p0_(p0),
    alpha_(alpha),
    T_(T),
    rhoGas_(rhoGas),
    Y_(Y),
    rho1_("rho1", dimDensity, rhoL),
    rho2_("rho2", dimDensity, 0),
    rho_(property("rho", T.mesh(), dimDensity, IOobject::AUTO_WRITE)),
    rhoWeight_(property("rhoWeight", T.mesh(), dimDensity)),
    mu1_(property("mu1", T.mesh(), dimDynamicViscosity)),
    mu2_(property("mu2", T.mesh(), dimDynamicViscosity)),
    mu_(property("mu", T.mesh(), dimDynamicViscosity)),
    nu_(property("nu", T.mesh(), dimViscosity)),
    thermal_(false),
    kappa1_(property("kappa1", T.mesh(), conductivity)),
    kappa2_(property("kappa2", T.mesh(), conductivity)),
    kappa_(property("kappaFluids", T.mesh(), conductivity)),
    Cp1_(property("Cp1", T.mesh(), heatCapacity)),
    Cp2_(property("Cp2", T.mesh(), heatCapacity)),
    Cp_(property("CpFluids", T.mesh(), heatCapacity))
{
    correct();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::evaporatingFluids::correctThermal()
{
    const scalar Tboil = liquid_.Tboil(p0_);
    const scalarField noVapour(Y_.size(), Zero);

    forAll(kappa_, celli)
    {
        const scalar a = min(max(alpha_[celli], scalar(0)), scalar(1));
        const scalar T = T_[celli];
        const scalarField& x = liquid_.x(celli);
        const scalarField& Y = a < 0.5 ? Y_.cell(celli) : noVapour;

        kappa1_[celli] = liquid_.liquids().kappa(p0_, min(T, Tboil), x);
        Cp1_[celli] = liquid_.liquids().Cp(p0_, min(T, Tboil), x);
        kappa2_[celli] = gas_.kappa(T, Y);
        Cp2_[celli] = gas_.Cp(T, Y);

        kappa_[celli] = a*kappa1_[celli] + (1 - a)*kappa2_[celli];
        Cp_[celli] =
            (
                a*rho1_.value()*Cp1_[celli]
              + (1 - a)*rhoGas_[celli]*Cp2_[celli]
            )
           /rho_[celli];
    }
    for (volScalarField* f : {&kappa1_, &kappa2_, &kappa_, &Cp1_, &Cp2_, &Cp_})
    {
        f->correctBoundaryConditions();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::evaporatingFluids::correct()
{
    const scalar Tboil = liquid_.Tboil(p0_);
    const scalarField noVapour(Y_.size(), Zero);
    const scalarField& V = T_.mesh().V();

    scalar mass = 0, volume = 0;
    forAll(rho_, celli)
    {
        const scalar a = min(max(alpha_[celli], scalar(0)), scalar(1));
        const scalar T = T_[celli];

        rho_[celli] = a*rho1_.value() + (1 - a)*rhoGas_[celli];
        const scalar Tl = min(T, Tboil);
        const scalarField& x = liquid_.x(celli);
        // Of a cell of the gas T is not that of the liquid
        rhoWeight_[celli] =
            rho_[celli]
          + (a < 0.5 ? 0 : a*(liquid_.liquids().rho(p0_, Tl, x) - rho1_.value()));
        mu1_[celli] = liquid_.liquids().mu(p0_, Tl, x);
        mu2_[celli] = gas_.mu(T, a < 0.5 ? Y_.cell(celli) : noVapour);
        mu_[celli] = a*mu1_[celli] + (1 - a)*mu2_[celli];
        nu_[celli] = mu_[celli]/rho_[celli];

        mass += (1 - a)*rhoGas_[celli]*V[celli];
        volume += (1 - a)*V[celli];
    }
    reduce(mass, sumOp<scalar>());
    reduce(volume, sumOp<scalar>());
    rho2_.value() = volume > 0 ? mass/volume : gAverage(rhoGas_);

    rho_.correctBoundaryConditions();
    rhoWeight_.correctBoundaryConditions();
    mu1_.correctBoundaryConditions();
    mu2_.correctBoundaryConditions();
    mu_.correctBoundaryConditions();
    nu_.correctBoundaryConditions();

    if (thermal_)
    {
        correctThermal();
    }
}


void Foam::dew::evaporatingFluids::setThermal()
{
    thermal_ = true;
    correctThermal();
}


// ************************************************************************* //
