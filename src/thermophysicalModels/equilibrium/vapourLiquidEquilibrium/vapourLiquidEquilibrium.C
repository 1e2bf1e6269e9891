/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "vapourLiquidEquilibrium.H"
#include "gasConstant.H"
#include "speciesData.H"
#include "Switch.H"
#include "userEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

dictionary activity(const dictionary& dict)
{
    dictionary of(dew::userEntry::optionalDict(dict, "activity"));
    of.name() = dict.name() + ".activity";
    if (!of.found("type"))
    {
        of.add("type", word("ideal"));
    }
    return of;
}


bool PengRobinsonChosen(const dictionary& dict)
{
    const word fugacity(dict.getOrDefault<word>("fugacity", "none"));
    if (fugacity != "none" && fugacity != "PengRobinson")
    {
        FatalIOErrorInFunction(dict)
            << "Unknown fugacity " << fugacity << nl
            << "It is none or PengRobinson" << exit(FatalIOError);
    }
    return fugacity == "PengRobinson";
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::vapourLiquidEquilibrium::readFugacity(const dictionary& dict)
{
    const dictionary& given = userEntry::optionalDict(dict, "critical");
    userEntry::onlyThese(given, liquids_.names());

    scalarField Tc(n_ + 1), pc(n_ + 1), omega(n_ + 1);
    for (label i = 0; i <= n_; i++)
    {
        const word name
        (
            i < n_
          ? liquids_.names()[i]
          : dict.getOrDefault<word>("carrier", "air")
        );
        if (given.found(name))
        {
            const dictionary& of = userEntry::subDict(given, name);
            userEntry::onlyThese(of, {"Tc", "pc", "omega"});
            Tc[i] = userEntry::positive(of, "Tc", dimTemperature);
            pc[i] = userEntry::positive(of, "pc", dimPressure);
            omega[i] = userEntry::number(of, "omega", dimless);
            continue;
        }
        const speciesData& species = speciesData::get
        (
            i < n_ ? liquids_.liquid(i).name() : name, "critical point", dict
        );
        Tc[i] = species.Tc;
        pc[i] = species.pc;
        omega[i] = species.omega;
    }
    vapour_.reset(new PengRobinson(Tc, pc, omega));
}


void Foam::dew::vapourLiquidEquilibrium::volatilities
(
    const scalar p,
    const scalar T,
    const UList<scalar>& x
) const
{
    activity_->lnGamma(T, x, lnGamma_);
    for (label i = 0; i < n_; i++)
    {
        const liquidModel& l = liquids_.liquid(i);
        const scalar pSat = l.pSat(T);
        scalar exponent = lnGamma_[i];
        if (fugacity_)
        {
            exponent += vapour_->lnPhi(i, pSat, T);
        }
        if (Poynting_)
        {
            exponent += l.W()/l.rho(p, T)*(p - pSat)/(gasConstant*T);
        }
        K_[i] = pSat*std::exp(exponent);
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::vapourLiquidEquilibrium::vapourLiquidEquilibrium
(
    const liquidMixture& liquids,
    const dictionary& dict
)
:
    liquids_(liquids),
    n_(liquids.size()),
    activity_(activityModel::New(::activity(dict), liquids)),
    fugacity_(PengRobinsonChosen(dict)),
    Poynting_(dict.getOrDefault<Switch>("Poynting", false)),
    Tc_(GREAT),
    K_(n_),
    lnGamma_(n_),
    lnPhi_(n_ + 1, 0),
    y_(n_ + 1),
    x_(n_),
    above_(n_),
    slope_(n_)
{
    userEntry::onlyThese
    (
        dict, {"activity", "fugacity", "carrier", "Poynting", "critical"}
    );
    if (fugacity_)
    {
        readFugacity(dict);
    }
    for (const liquidModel& l : liquids.liquids())
    {
        Tc_ = min(Tc_, l.Tc()*(1 - 1e-9));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::vapourLiquidEquilibrium::partialPressures
(
    const scalar p,
    const scalar T,
    const UList<scalar>& x,
    UList<scalar>& pi
) const
{
    volatilities(p, T, x);
    for (label i = 0; i < n_; i++)
    {
        pi[i] = x[i]*K_[i];
    }
    if (!fugacity_)
    {
        return;
    }

    // phi depends on the gas that it makes; the coefficients are near one
    for (label iter = 0; iter < 50; iter++)
    {
        scalar vapours = 0;
        for (label i = 0; i < n_; i++)
        {
            y_[i] = pi[i]/p;
            vapours += y_[i];
        }
        y_[n_] = max(1 - vapours, 0);
        vapour_->lnPhi(p, T, y_, lnPhi_);

        scalar change = 0;
        for (label i = 0; i < n_; i++)
        {
            const scalar next = x[i]*K_[i]*std::exp(-lnPhi_[i]);
            change = max(change, mag(next - pi[i]));
            pi[i] = next;
        }
        if (change < 1e-13*p)
        {
            return;
        }
    }
}


void Foam::dew::vapourLiquidEquilibrium::dpdT
(
    const scalar p,
    const scalar T,
    const UList<scalar>& x,
    UList<scalar>& result
) const
{
    if (fugacity_ || Poynting_)
    {
        const scalar h = 1e-4*T;
        partialPressures(p, T - h, x, above_);
        partialPressures(p, T + h, x, result);
        for (label i = 0; i < n_; i++)
        {
            result[i] = (result[i] - above_[i])/(2*h);
        }
        return;
    }

    activity_->dT(T, x, slope_);
    activity_->lnGamma(T, x, lnGamma_);
    for (label i = 0; i < n_; i++)
    {
        const liquidModel& l = liquids_.liquid(i);
        result[i] =
            x[i]*std::exp(lnGamma_[i])*(l.dpSatdT(T) + l.pSat(T)*slope_[i]);
    }
}


void Foam::dew::vapourLiquidEquilibrium::dpdx
(
    const label j,
    const scalar p,
    const scalar T,
    const UList<scalar>& x,
    UList<scalar>& result
) const
{
    // In the direction of the amount, with the sum kept at one
    const scalar h = 1e-5;
    for (label side = -1; side <= 1; side += 2)
    {
        for (label i = 0; i < n_; i++)
        {
            x_[i] = (x[i] + (i == j ? side*h : 0))/(1 + side*h);
        }
        partialPressures(p, T, x_, side < 0 ? above_ : result);
    }
    for (label i = 0; i < n_; i++)
    {
        result[i] = (result[i] - above_[i])/(2*h);
    }
}
