/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "vapourOfLiquid.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace pureGases
{
    defineTypeName(vapourOfLiquid);
    addToRunTimeSelectionTable(pureGas, vapourOfLiquid, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::pureGases::vapourOfLiquid::vapourOfLiquid
(
    const dictionary& dict,
    const liquidModel& liquid
)
:
    liquid_(liquid)
{
    userEntry::onlyThese(dict, {"type"});

    if (!liquid_.hasVapour())
    {
        FatalIOErrorInFunction(dict)
            << "The liquid " << liquid_.name() << " of type "
            << liquid_.type() << " knows nothing of its vapour" << nl
            << "Give: vapour { type constant; Cp ...; kappa ...; mu ...; }"
            << exit(FatalIOError);
    }
}
