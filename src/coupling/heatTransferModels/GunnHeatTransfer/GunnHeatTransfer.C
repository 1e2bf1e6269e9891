/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "GunnHeatTransfer.H"
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
    defineTypeName(GunnHeatTransfer);
    addToRunTimeSelectionTable(heatTransferModel, GunnHeatTransfer, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::heatTransferModels::GunnHeatTransfer::GunnHeatTransfer
(
    const dictionary& dict
)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::heatTransferModels::GunnHeatTransfer::Nu
(
    const scalar Re,
    const scalar Pr,
    const scalar alphac
) const
{
    const scalar superficial = alphac*Re;
    const scalar third = cbrt(Pr);

    return
        (7 - 10*alphac + 5*sqr(alphac))*(1 + 0.7*pow(superficial, 0.2)*third)
      + (1.33 - 2.4*alphac + 1.2*sqr(alphac))*pow(superficial, 0.7)*third;
}


Foam::dew::lawRanges Foam::dew::heatTransferModels::GunnHeatTransfer::ranges() const
{
    return
    {
        {"Re", lawQuantities::ReSuperficial, 0, 1e5},
        {"alphac", lawQuantities::voidFraction, 0.35, 1}
    };
}
