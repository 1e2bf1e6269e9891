/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "air.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace pureGases
{
    defineTypeName(air);
    addToRunTimeSelectionTable(pureGas, air, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::pureGases::air::air(const dictionary& dict, const liquidModel&)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::pureGases::air::Cp(const scalar T) const
{
    return (28.11 + T*(1.967e-3 + T*(4.802e-6 - T*1.966e-9)))/W();
}


Foam::scalar Foam::dew::pureGases::air::kappa(const scalar T) const
{
    return 2.64638e-3*T*std::sqrt(T)/(T + 245.4*std::pow(10, -12/T));
}


Foam::scalar Foam::dew::pureGases::air::mu(const scalar T) const
{
    return 1.458e-6*T*std::sqrt(T)/(T + 110.4);
}
