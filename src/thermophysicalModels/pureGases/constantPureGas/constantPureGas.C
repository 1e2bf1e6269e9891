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
    W_
    (
        dict.dictName() == "vapour"
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
    if (dict.dictName() == "vapour")
    {
        userEntry::onlyThese(dict, {"type", "Cp", "kappa", "mu"});
    }
    else
    {
        userEntry::onlyThese(dict, {"type", "W", "Cp", "kappa", "mu"});
    }
}
