/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "RanzMarshallHeatTransfer.H"
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
    defineTypeName(RanzMarshallHeatTransfer);
    addToRunTimeSelectionTable(heatTransferModel, RanzMarshallHeatTransfer, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::heatTransferModels::RanzMarshallHeatTransfer::RanzMarshallHeatTransfer(const dictionary& dict)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::heatTransferModels::RanzMarshallHeatTransfer::Nu
(
    const scalar Re,
    const scalar Pr,
    const scalar
) const
{
    return 2 + 0.6*sqrt(Re)*cbrt(Pr);
}


Foam::dew::lawRanges Foam::dew::heatTransferModels::RanzMarshallHeatTransfer::ranges() const
{
    return
    {
        {"Re", lawQuantities::ReSingle, 0, 1e4}
    };
}
