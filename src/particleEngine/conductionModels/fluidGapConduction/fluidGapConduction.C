/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fluidGapConduction.H"
#include "addToRunTimeSelectionTable.H"
#include "BatchelorOBrienConduction.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace conductionModels
{
    defineTypeName(fluidGapConduction);
    addToRunTimeSelectionTable(conductionModel, fluidGapConduction, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::conductionModels::fluidGapConduction::fluidGapConduction
(
    const dictionary& dict,
    const materials& mats
)
:
    Kf_
    (
        userEntry::positive
        (
            dict, "fluidConductivity", dimPower/dimLength/dimTemperature
        )
    )
{
    userEntry::onlyThese(dict, {"type", "fluidConductivity"});

    for (label i = 0; i < mats.size(); i++)
    {
        for (label j = 0; j <= i; j++)
        {
            const scalar ratio = conductivityRatio
            (
                mats.thermalConductivity(i), mats.thermalConductivity(j), Kf_
            );

            if (!(ratio > 1))
            {
                FatalIOErrorInFunction(dict)
                    << "Conduction BatchelorOBrien is for particles that"
                    << " conduct much better than the fluid, but Kp/Kf of "
                    << mats.names()[i] << " and " << mats.names()[j] << " is "
                    << ratio << ", with 1/Kp = 1/K1 + 1/K2" << nl
                    << "Correct fluidConductivity or thermalConductivity, or"
                    << " use another type"
                    << exit(FatalIOError);
            }
        }
    }
}
