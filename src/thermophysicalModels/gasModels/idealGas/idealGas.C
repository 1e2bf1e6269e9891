/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "idealGas.H"
#include "addToRunTimeSelectionTable.H"
#include "gasConstant.H"
#include "userEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace gasModels
{
    defineTypeName(idealGas);
    addToRunTimeSelectionTable(gasModel, idealGas, dictionary);
}
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::autoPtr<Foam::dew::pureGas> vapour
(
    const Foam::dictionary& dict,
    const Foam::dew::liquidModel& liquid
)
{
    if (dict.found("vapour"))
    {
        return Foam::dew::pureGas::New
        (
            Foam::dew::userEntry::subDict(dict, "vapour"), liquid
        );
    }

    Foam::dictionary ofLiquid(dict, Foam::dictionary{Foam::fileName("vapour")});
    ofLiquid.add("type", Foam::word("ofLiquid"));
    return Foam::dew::pureGas::New(ofLiquid, liquid);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::gasModels::idealGas::idealGas
(
    const dictionary& dict,
    const liquidModel& liquid,
    autoPtr<pureGas> carrier
)
:
    gasModel
    (
        userEntry::positive(dict, "p0", dimPressure), liquid.W(), carrier->W()
    ),
    carrier_(std::move(carrier)),
    vapour_(vapour(dict, liquid)),
    D0_
    (
        userEntry::positive
        (
            userEntry::subDict(dict, "diffusivity"), "D0", dimViscosity
        )
       *userEntry::positive
        (
            userEntry::subDict(dict, "diffusivity"), "pRef", dimPressure
        )/p0()
    ),
    Tref_
    (
        userEntry::positive
        (
            userEntry::subDict(dict, "diffusivity"), "Tref", dimTemperature
        )
    ),
    n_
    (
        dict.subDict("diffusivity").found("n")
      ? userEntry::within(dict.subDict("diffusivity"), "n", 0, 3)
      : 1.75
    )
{
    userEntry::onlyThese
    (
        dict, {"type", "p0", "carrier", "vapour", "diffusivity"}
    );
    userEntry::onlyThese
    (
        dict.subDict("diffusivity"), {"D0", "Tref", "pRef", "n"}
    );
}


Foam::dew::gasModels::idealGas::idealGas
(
    const dictionary& dict,
    const liquidModel& liquid
)
:
    idealGas
    (
        dict,
        liquid,
        pureGas::New(userEntry::subDict(dict, "carrier"), liquid)
    )
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dew::gasModels::idealGas::mean
(
    const scalar Y,
    const scalar T,
    const scalar ofCarrier,
    const scalar ofVapour
) const
{
    const scalar xv = x(Y), xc = 1 - xv;
    const scalar ratio = std::sqrt(vapour_->mu(T)/carrier_->mu(T));
    const scalar masses = Wv()/Wc();

    const scalar root = std::pow(masses, 0.25);
    const scalar phiVc = sqr(1 + ratio/root)/std::sqrt(8*(1 + masses));
    const scalar phiCv = sqr(1 + root/ratio)/std::sqrt(8*(1 + 1/masses));

    return
        xv*ofVapour/(xv + xc*phiVc) + xc*ofCarrier/(xc + xv*phiCv);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::gasModels::idealGas::rho
(
    const scalar Y,
    const scalar T
) const
{
    return p0()*W(Y)/(gasConstant*T);
}


Foam::scalar Foam::dew::gasModels::idealGas::D(const scalar T) const
{
    return D0_*std::pow(T/Tref_, n_);
}


Foam::scalar Foam::dew::gasModels::idealGas::Cp
(
    const scalar Y,
    const scalar T
) const
{
    return Y*vapour_->Cp(T) + (1 - Y)*carrier_->Cp(T);
}


Foam::scalar Foam::dew::gasModels::idealGas::kappa
(
    const scalar Y,
    const scalar T
) const
{
    return mean(Y, T, carrier_->kappa(T), vapour_->kappa(T));
}


Foam::scalar Foam::dew::gasModels::idealGas::mu
(
    const scalar Y,
    const scalar T
) const
{
    return mean(Y, T, carrier_->mu(T), vapour_->mu(T));
}
