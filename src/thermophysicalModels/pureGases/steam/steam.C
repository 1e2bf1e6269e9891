/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "steam.H"
#include "addToRunTimeSelectionTable.H"
#include "gasConstant.H"
#include "userEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace pureGases
{
    defineTypeName(steam);
    addToRunTimeSelectionTable(pureGas, steam, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::pureGases::steam::steam()
:
    fits_(gasFits::get("H2O"))
{}


Foam::dew::pureGases::steam::steam(const dictionary& dict, const liquidModel&)
:
    steam()
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::pureGases::steam::Cp(const scalar T) const
{
    return fits_.Cp(T)*gasConstant/W();
}


Foam::scalar Foam::dew::pureGases::steam::kappa(const scalar T) const
{
    const scalar t = T/647.096, r = 1/t;
    return
        1e-3*std::sqrt(t)
       /(
            2.443221e-3
          + r*(1.323095e-2 + r*(6.770357e-3 + r*(-3.454586e-3 + r*4.096266e-4)))
        );
}


Foam::scalar Foam::dew::pureGases::steam::mu(const scalar T) const
{
    const scalar t = T/647.096, r = 1/t;
    return
        1e-4*std::sqrt(t)
       /(1.67752 + r*(2.20462 + r*(0.6366564 - r*0.241605)));
}
