/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "libraryLiquid.H"
#include "addToRunTimeSelectionTable.H"
#include "liquidProperties.H"
#include "speciesData.H"
#include "userEntry.H"
#include "waterDensity.H"

#include <cmath>
#include <cstdlib>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace liquidModels
{
    defineTypeName(libraryLiquid);
    addToRunTimeSelectionTable(liquidModel, libraryLiquid, dictionary);
}
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Coefficients of a fit, as the library reads them
dictionary coefficients(const wordList& names, const scalarList& values)
{
    dictionary dict;
    forAll(names, i)
    {
        dict.add(names[i], values[i]);
    }
    return dict;
}


//- What v1912 has wrong about a liquid
dictionary mended(const word& liquid)
{
    dictionary fits{fileName(liquid)};

    if (liquid == "C2H5OH")
    {
        // + there for the coefficient of T^2
        fits.add
        (
            "Cp",
            coefficients
            (
                {"a", "b", "c", "d", "e", "f"},
                {
                    2052.57331394213, -1.21990926653498,
                    -0.00714146172046278, 5.20523562482363e-05, 0, 0
                }
            )
        );
    }
    else if (liquid == "C9H20")
    {
        // -90304 there: the decimal point
        fits.add
        (
            "pv",
            coefficients
            (
                {"a", "b", "c", "d", "e"},
                {109.35, -9030.4, -12.882, 7.8544e-06, 2}
            )
        );
    }
    else if (liquid == "N2")
    {
        // +32.165 there
        fits.add
        (
            "mu",
            coefficients
            (
                {"a", "b", "c", "d", "e"}, {-32.165, 496.9, 3.9069, -1.08e-21, 10}
            )
        );
    }
    else if (liquid == "CH3OH")
    {
        // There, coefficients of 0.056 - 1.4583e-4 T + 1.08e-7 T^2 in the place
        // of those of a (1 - T/Tc)^b. The latter through the values of the
        // former at 0 and 60 degrees:
        fits.add
        (
            "sigma",
            coefficients
            (
                {"Tc", "a", "b", "c", "d", "e"},
                {512.58, 0.0435066, 0.769248, 0, 0, 0}
            )
        );
    }
    return fits;
}


//- A constant instead of a fit, or -1
scalar constantOf
(
    const dictionary& overrides,
    const word& key,
    const dimensionSet& dims
)
{
    return
        overrides.found(key) && !overrides.isDict(key)
      ? dew::userEntry::positive(overrides, key, dims)
      : -1;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::autoPtr<Foam::liquidProperties>
Foam::dew::liquidModels::libraryLiquid::select(const dictionary& dict)
{
    const word name(speciesData::nameOf(dict.get<word>("liquid")));
    const dictionary& overrides = userEntry::optionalDict(dict, "overrides");

    if (!liquidProperties::dictionaryConstructorTablePtr_->found(name))
    {
        FatalIOErrorInLookup
        (
            dict,
            "liquid",
            name,
            *liquidProperties::dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }
    if (overrides.found("D"))
    {
        FatalIOErrorInFunction(overrides)
            << "The diffusivity D is none of the liquid" << nl
            << "Give it in constant/gasProperties: diffusivity { ... }"
            << exit(FatalIOError);
    }
    userEntry::onlyThese
    (
        overrides,
        {
            "rho", "mu", "Cp", "kappa", "hl", "sigma", "pv",
            "Cpg", "kappag", "mug", "Antoine"
        }
    );
    if (overrides.found("Antoine") && overrides.found("pv"))
    {
        FatalIOErrorInFunction(overrides)
            << "Both pv and Antoine in " << overrides.dictName() << nl
            << "Remove one of them" << exit(FatalIOError);
    }
    if (overrides.found("pv") && !overrides.isDict("pv"))
    {
        FatalIOErrorInFunction(overrides)
            << "pv is one number" << nl
            << "Give the coefficients of the fit: pv { a ...; b ...; }, or use"
            << " type constant" << exit(FatalIOError);
    }

    // The name of the dictionary selects the liquid
    dictionary fits(mended(name));
    for (const entry& e : overrides)
    {
        if (e.isDict() && e.keyword() != "Antoine")
        {
            // The library calls the conductivity K
            const word key(e.keyword() == "kappa" ? "K" : e.keyword());
            fits.set(key, e.dict());
        }
    }
    return liquidProperties::New(fits);
}


void Foam::dew::liquidModels::libraryLiquid::refuse(const scalar T) const
{
    FatalErrorInFunction
        << "Liquid " << name_ << " at " << T << " K, but its properties are"
        << " known from 0 to the critical temperature, " << Tc_ << " K" << nl
        << "Check temperatures and time step"
        << exit(FatalError);

    ::abort();      // never reached: exit() ends the run
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::liquidModels::libraryLiquid::libraryLiquid(const dictionary& dict)
:
    name_(speciesData::nameOf(dict.get<word>("liquid"))),
    water_
    (
        name_ == "H2O"
     && !userEntry::optionalDict(dict, "overrides").found("rho")
    ),
    fits_(select(dict)),
    W_(1e-3*fits_->W()),
    Tc_(fits_->Tc()),
    Tmin_(fits_->Tt()),
    antoineA_(0),
    antoineB_(-1),
    antoineC_(0)
{
    userEntry::onlyThese(dict, {"type", "liquid", "overrides"});

    const dictionary& overrides = userEntry::optionalDict(dict, "overrides");
    const dimensionSet dimKappa(dimPower/dimLength/dimTemperature);
    const auto of = [&](const word& key, const dimensionSet& dims)
    {
        return constantOf(overrides, key, dims);
    };

    rho_ = of("rho", dimDensity);
    mu_ = of("mu", dimDynamicViscosity);
    Cp_ = of("Cp", dimSpecificHeatCapacity);
    kappa_ = of("kappa", dimKappa);
    hv_ = of("hl", dimEnergy/dimMass);
    sigma_ = of("sigma", dimForce/dimLength);
    Cpg_ = of("Cpg", dimSpecificHeatCapacity);
    kappag_ = of("kappag", dimKappa);
    mug_ = of("mug", dimDynamicViscosity);

    if (overrides.found("Antoine"))
    {
        const dictionary& antoine = userEntry::subDict(overrides, "Antoine");
        userEntry::onlyThese(antoine, {"A", "B", "C", "unitOfP", "zeroOfT"});

        const scalar ln10 = std::log(10.0);
        antoineA_ =
            ln10*userEntry::number(antoine, "A", dimless)
          + std::log(userEntry::positive(antoine, "unitOfP", dimPressure));
        antoineB_ = ln10*userEntry::positive(antoine, "B", dimTemperature);
        antoineC_ =
            userEntry::number(antoine, "C", dimTemperature)
          - userEntry::notNegative(antoine, "zeroOfT", dimTemperature);
    }
}


Foam::dew::liquidModels::libraryLiquid::~libraryLiquid()
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::liquidModels::libraryLiquid::rho
(
    const scalar p,
    const scalar T
) const
{
    if (water_)
    {
        return waterDensity(checked(T));
    }
    return rho_ < 0 ? fits_->rho(p, checked(T)) : rho_;
}


Foam::scalar Foam::dew::liquidModels::libraryLiquid::mu
(
    const scalar p,
    const scalar T
) const
{
    return mu_ < 0 ? fits_->mu(p, checked(T)) : mu_;
}


Foam::scalar Foam::dew::liquidModels::libraryLiquid::Cp
(
    const scalar p,
    const scalar T
) const
{
    return Cp_ < 0 ? fits_->Cp(p, checked(T)) : Cp_;
}


Foam::scalar Foam::dew::liquidModels::libraryLiquid::kappa
(
    const scalar p,
    const scalar T
) const
{
    return kappa_ < 0 ? fits_->kappa(p, checked(T)) : kappa_;
}


Foam::scalar Foam::dew::liquidModels::libraryLiquid::hv
(
    const scalar p,
    const scalar T
) const
{
    return hv_ < 0 ? fits_->hl(p, checked(T)) : hv_;
}


Foam::scalar Foam::dew::liquidModels::libraryLiquid::sigma
(
    const scalar p,
    const scalar T
) const
{
    return sigma_ < 0 ? fits_->sigma(p, checked(T)) : sigma_;
}


Foam::scalar Foam::dew::liquidModels::libraryLiquid::saturation
(
    const scalar T
) const
{
    return
        antoineB_ < 0
      ? fits_->pv(0, T)
      : std::exp(antoineA_ - antoineB_/(T + antoineC_));
}


Foam::scalar Foam::dew::liquidModels::libraryLiquid::pSat
(
    const scalar T
) const
{
    return saturation(checked(T));
}


Foam::scalar Foam::dew::liquidModels::libraryLiquid::dpSatdT
(
    const scalar T
) const
{
    // The coefficients are hidden. The logarithm is nearly linear in 1/T: the
    // difference is right to some 1e-8
    const scalar h = 1e-4*checked(T);

    return
        pSat(T)
       *std::log(saturation(T + h)/saturation(T - h))/(2*h);
}


Foam::scalar Foam::dew::liquidModels::libraryLiquid::Tboil
(
    const scalar p
) const
{
    if (p >= saturation(Tc_))
    {
        return GREAT;
    }

    // pSat grows with T. Newton on ln p over 1/T, kept in the bracket
    scalar low = max(0.1*Tc_, antoineB_ < 0 ? 0 : 1e-2*Tc_ - antoineC_);
    scalar high = Tc_;
    scalar T = fits_->Tb();
    for (label i = 0; i < 100; i++)
    {
        const scalar error = std::log(saturation(T)/p);
        (error > 0 ? high : low) = T;
        const scalar h = 1e-4*T;
        const scalar slope =
            std::log(saturation(T + h)/saturation(T - h))/(2*h);

        scalar next = 1/(1/T + error/(slope*T*T));
        if (!(next > low && next < high))
        {
            next = 0.5*(low + high);
        }
        if (mag(next - T) < 1e-10*T)
        {
            return next;
        }
        T = next;
    }
    return T;
}


Foam::scalar Foam::dew::liquidModels::libraryLiquid::vapourCp
(
    const scalar p,
    const scalar T
) const
{
    return Cpg_ < 0 ? fits_->Cpg(p, T) : Cpg_;
}


Foam::scalar Foam::dew::liquidModels::libraryLiquid::vapourKappa
(
    const scalar p,
    const scalar T
) const
{
    return kappag_ < 0 ? fits_->kappag(p, T) : kappag_;
}


Foam::scalar Foam::dew::liquidModels::libraryLiquid::vapourMu
(
    const scalar p,
    const scalar T
) const
{
    return mug_ < 0 ? fits_->mug(p, T) : mug_;
}
