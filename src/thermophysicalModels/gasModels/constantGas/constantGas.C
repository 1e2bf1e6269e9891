/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "constantGas.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace gasModels
{
    defineTypeName(constantGas);
    addToRunTimeSelectionTable(gasModel, constantGas, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::gasModels::constantGas::constantGas
(
    const dictionary& dict,
    const liquidModel& liquid
)
:
    gasModel
    (
        userEntry::positive(dict, "p0", dimPressure),
        liquid.W(),
        1e-3*userEntry::within(dict, "Wc", 1, 2000)
    ),
    rho_(userEntry::positive(dict, "rho", dimDensity)),
    D_(userEntry::positive(dict, "D", dimViscosity)),
    Cp_(userEntry::positive(dict, "Cp", dimSpecificHeatCapacity)),
    CpVapour_
    (
        userEntry::positiveOr(dict, "CpVapour", dimSpecificHeatCapacity, Cp_)
    ),
    kappa_
    (
        userEntry::positive
        (
            dict, "kappa", dimPower/dimLength/dimTemperature
        )
    ),
    mu_(userEntry::positive(dict, "mu", dimDynamicViscosity))
{
    userEntry::onlyThese
    (
        dict,
        {"type", "p0", "Wc", "rho", "D", "Cp", "CpVapour", "kappa", "mu"}
    );
}
