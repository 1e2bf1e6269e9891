/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "AcrivosTaylorHeatTransfer.H"
#include "addToRunTimeSelectionTable.H"
#include "lawQuantities.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace heatTransferModels
{
    defineTypeName(AcrivosTaylorHeatTransfer);
    addToRunTimeSelectionTable(heatTransferModel, AcrivosTaylorHeatTransfer, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::heatTransferModels::AcrivosTaylorHeatTransfer::AcrivosTaylorHeatTransfer
(
    const dictionary& dict
)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::heatTransferModels::AcrivosTaylorHeatTransfer::Nu
(
    const scalar Re,
    const scalar Pr,
    const scalar
) const
{
    const scalar Pe = Re*Pr;

    // The logarithm has no value at rest, its terms have: 0
    const scalar lnPe = log(max(Pe, VSMALL));

    return 2 + Pe*(0.5 + Pe*(0.03404 + lnPe*(0.25 + Pe/16)));
}


Foam::dew::lawRanges Foam::dew::heatTransferModels::AcrivosTaylorHeatTransfer::ranges() const
{
    return
    {
        {"Pe", lawQuantities::Pe, 0, 1},
        {"Re", lawQuantities::ReSingle, 0, 1}
    };
}
