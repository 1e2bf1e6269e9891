/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "constantPureGas.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace pureGases
{
    defineTypeName(constantPureGas);
    addToRunTimeSelectionTable(pureGas, constantPureGas, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::pureGases::constantPureGas::constantPureGas
(
    const dictionary& dict,
    const liquidModel& liquid
)
:
    name_
    (
        dict.dictName() == "carrier"
      ? dict.getOrDefault<word>("species", "carrier")
      : liquid.name()
    ),
    W_
    (
        dict.dictName() != "carrier"
      ? liquid.W()
      : 1e-3*userEntry::within(dict, "W", 1, 2000)
    ),
    Cp_(userEntry::positive(dict, "Cp", dimSpecificHeatCapacity)),
    kappa_
    (
        userEntry::positive
        (
            dict, "kappa", dimPower/dimLength/dimTemperature
        )
    ),
    mu_(userEntry::positive(dict, "mu", dimDynamicViscosity))
{
    if (dict.dictName() == "carrier")
    {
        userEntry::onlyThese
        (
            dict, {"type", "species", "W", "Cp", "kappa", "mu"}
        );
    }
    else
    {
        userEntry::onlyThese(dict, {"type", "Cp", "kappa", "mu"});
    }
}
