/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "LiMasonHeatTransfer.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace heatTransferModels
{
    defineTypeName(LiMasonHeatTransfer);
    addToRunTimeSelectionTable(heatTransferModel, LiMasonHeatTransfer, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::heatTransferModels::LiMasonHeatTransfer::LiMasonHeatTransfer(const dictionary& dict)
:
    n_(userEntry::notNegativeOr(dict, "n", dimless, 3.5))
{
    userEntry::onlyThese(dict, {"type", "n"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::heatTransferModels::LiMasonHeatTransfer::Nu
(
    const scalar Re,
    const scalar Pr,
    const scalar alphac
) const
{
    const scalar epsn = pow(alphac, n_);

    if (Re <= 200)
    {
        return 2 + 0.6*epsn*sqrt(Re)*cbrt(Pr);
    }
    if (Re <= 1500)
    {
        return 2 + epsn*cbrt(Pr)*(0.5*sqrt(Re) + 0.02*pow(Re, 0.8));
    }
    return 2 + 0.000045*epsn*pow(Re, 1.8);
}
