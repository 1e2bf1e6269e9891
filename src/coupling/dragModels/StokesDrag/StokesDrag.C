/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "StokesDrag.H"
#include "addToRunTimeSelectionTable.H"
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
    const scalar Kn = 2*meanFreePath_/d;

    return Kn > 0 ? 1 + Kn*(1.257 + 0.4*exp(-1.1/Kn)) : 1;
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
