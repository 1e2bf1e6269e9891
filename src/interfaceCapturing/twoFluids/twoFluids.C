/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "twoFluids.H"
#include "userEntry.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::word Foam::dew::twoFluids::other(const word& liquid) const
{
    const wordList phases(get<wordList>("phases"));
    if (phases.size() != 2 || (phases[0] != liquid && phases[1] != liquid))
    {
        FatalIOErrorInFunction(*this)
            << "phases " << phases << " are not two of which one is " << liquid
            << ", the liquid of constant/surfaceProperties"
            << exit(FatalIOError);
    }
    return phases[phases[0] == liquid];
}


Foam::dimensionedScalar Foam::dew::twoFluids::density(const word& phase) const
{
    return dimensionedScalar
    (
        "rho", dimDensity,
        userEntry::positive(userEntry::subDict(*this, phase), "rho", dimDensity)
    );
}


void Foam::dew::twoFluids::checkViscosity
(
    const word& phase,
    const viscosityModel& model
) const
{
    const scalar least = gMin(model.nu()().primitiveField());
    if (!(least >= 0))
    {
        FatalIOErrorInFunction(subDict(phase))
            << "The viscosity of " << phase << " in constant/transportProperties"
            << " is " << least << " m2/s somewhere" << nl
            << "It is 0 or positive" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::twoFluids::twoFluids
(
    const word& liquid,
    const volScalarField& alpha,
    const volVectorField& U,
    const surfaceScalarField& phi
)
:
    IOdictionary
    (
        IOobject
        (
            "transportProperties", U.time().constant(), U.db(),
            IOobject::MUST_READ, IOobject::NO_WRITE
        )
    ),
    alpha_(alpha),
    nu1_
    (
        viscosityModel::New("nu1", userEntry::subDict(*this, liquid), U, phi)
    ),
    nu2_
    (
        viscosityModel::New
        (
            "nu2", userEntry::subDict(*this, other(liquid)), U, phi
        )
    ),
    rho1_(density(liquid)),
    rho2_(density(other(liquid))),
    rho_
    (
        IOobject
        (
            "rho", U.time().timeName(), U.db(), IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        alpha*rho1_ + (scalar(1) - alpha)*rho2_
    ),
    mu1_(IOobject("mu1", U.time().timeName(), U.db()), rho1_*nu1_->nu()),
    mu2_(IOobject("mu2", U.time().timeName(), U.db()), rho2_*nu2_->nu()),
    mu_(IOobject("mu", U.time().timeName(), U.db()), rho_*nu1_->nu()),
    nu_(IOobject("nu", U.time().timeName(), U.db()), mu_/rho_)
{
    checkViscosity(liquid, nu1_());
    checkViscosity(other(liquid), nu2_());
    correct();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::twoFluids::correct()
{
    nu1_->correct();
    nu2_->correct();

    const volScalarField alpha(min(max(alpha_, scalar(0)), scalar(1)));

    rho_ = alpha*rho1_ + (scalar(1) - alpha)*rho2_;
    mu1_ = rho1_*nu1_->nu();
    mu2_ = rho2_*nu2_->nu();
    mu_ = alpha*mu1_ + (scalar(1) - alpha)*mu2_;
    nu_ = mu_/rho_;
}


bool Foam::dew::twoFluids::read()
{
    return regIOobject::read();
}
