/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "StokesDrag.H"
#include "addToRunTimeSelectionTable.H"
#include "slipCorrection.H"
#include "lawQuantities.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace dragModels
{
    defineTypeName(StokesDrag);
    addToRunTimeSelectionTable(particleForce, StokesDrag, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::dragModels::StokesDrag::StokesDrag(const dictionary& dict)
:
    meanFreePath_(userEntry::notNegativeOr(dict, "meanFreePath", dimLength, 0))
{
    userEntry::onlyThese(dict, {"type", "meanFreePath"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::dragModels::StokesDrag::Cc(const scalar d) const
{
    return CunninghamFactor(meanFreePath_, d/2);
}


Foam::scalar Foam::dew::dragModels::StokesDrag::Sp
(
    const particle& p,
    const carrier& c
) const
{
    return stokes(p, c)/Cc(p.d);
}


Foam::dew::lawRanges Foam::dew::dragModels::StokesDrag::ranges() const
{
    return
    {
        {"Re", lawQuantities::ReSingle, 0, 1}
    };
}
