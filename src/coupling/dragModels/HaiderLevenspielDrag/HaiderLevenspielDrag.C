/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "HaiderLevenspielDrag.H"
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
    defineTypeName(HaiderLevenspielDrag);
    addToRunTimeSelectionTable(particleForce, HaiderLevenspielDrag, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::dragModels::HaiderLevenspielDrag::HaiderLevenspielDrag(const dictionary& dict)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::dragModels::HaiderLevenspielDrag::Sp
(
    const particle& p,
    const carrier& c
) const
{
    const scalar Re = ReSingle(p, c);

    const scalar CdRe =
        24*(1 + 0.1806*pow(Re, 0.6459)) + 0.4251*sqr(Re)/(Re + 6880.95);

    return stokes(p, c)*CdRe/24;
}


Foam::dew::lawRanges Foam::dew::dragModels::HaiderLevenspielDrag::ranges() const
{
    return
    {
        {"Re", lawQuantities::ReSingle, 0, 2.6e5}
    };
}
