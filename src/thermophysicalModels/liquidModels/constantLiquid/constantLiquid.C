/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "constantLiquid.H"
#include "addToRunTimeSelectionTable.H"
#include "gasConstant.H"
#include "userEntry.H"

#include <cmath>
#include <cstdlib>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace liquidModels
{
    defineTypeName(constantLiquid);
    addToRunTimeSelectionTable(liquidModel, constantLiquid, dictionary);
}
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Is the saturation pressure given by a boiling point?
bool boilingPoint(const Foam::dictionary& dict)
{
    const bool boils = dict.found("Tboil");
    if (boils == dict.found("pSat"))
    {
        FatalIOErrorInFunction(dict)
            << (boils ? "Both" : "Neither") << " of pSat and Tboil in "
            << dict.dictName() << Foam::nl
            << "Give the constant saturation pressure pSat, or a boiling"
            << " point: Tboil and pBoil" << Foam::exit(Foam::FatalIOError);
    }
    return boils;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::liquidModels::constantLiquid::constantLiquid
(
    const dictionary& dict
)
:
    name_(dict.getOrDefault<word>("name", "liquid")),
    W_(1e-3*userEntry::within(dict, "W", 1, 2000)),
    rho_(userEntry::positive(dict, "rho", dimDensity)),
    mu_(userEntry::positive(dict, "mu", dimDynamicViscosity)),
    Cp_(userEntry::positive(dict, "Cp", dimSpecificHeatCapacity)),
    kappa_
    (
        userEntry::positive
        (
            dict, "kappa", dimPower/dimLength/dimTemperature
        )
    ),
    hv_(userEntry::positive(dict, "hv", dimEnergy/dimMass)),
    sigma_(userEntry::positive(dict, "sigma", dimForce/dimLength)),
    boils_(boilingPoint(dict)),
    pSat_(boils_ ? 0 : userEntry::notNegative(dict, "pSat", dimPressure)),
    Tboil_(boils_ ? userEntry::positive(dict, "Tboil", dimTemperature) : 0),
    pBoil_(boils_ ? userEntry::positive(dict, "pBoil", dimPressure) : 0),
    slope_(W_*hv_/gasConstant)
{
    userEntry::onlyThese
    (
        dict,
        {
            "type", "name", "W", "rho", "mu", "Cp", "kappa", "hv", "sigma",
            boils_ ? "Tboil" : "pSat", boils_ ? "pBoil" : "pSat"
        }
    );
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::liquidModels::constantLiquid::noVapour() const
{
    FatalErrorInFunction
        << "The liquid " << name_ << " of type " << type()
        << " knows nothing of its vapour" << nl
        << "Give vapour { type constant; ... } in constant/gasProperties"
        << exit(FatalError);

    ::abort();      // never reached: exit() ends the run
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::liquidModels::constantLiquid::pSat
(
    const scalar T
) const
{
    return boils_ ? pBoil_*std::exp(slope_*(1/Tboil_ - 1/T)) : pSat_;
}


Foam::scalar Foam::dew::liquidModels::constantLiquid::dpSatdT
(
    const scalar T
) const
{
    return boils_ ? pSat(T)*slope_/(T*T) : 0;
}


Foam::scalar Foam::dew::liquidModels::constantLiquid::Tboil
(
    const scalar p
) const
{
    if (!boils_)
    {
        return GREAT;
    }

    // No temperature makes pSat larger than pBoil exp(slope/Tboil)
    const scalar inverse = 1/Tboil_ - std::log(p/pBoil_)/slope_;
    return inverse > 0 ? 1/inverse : GREAT;
}
