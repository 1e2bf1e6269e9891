/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "DarcyDrag.H"
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
    defineTypeName(DarcyDrag);
    addToRunTimeSelectionTable(particleForce, DarcyDrag, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::dragModels::DarcyDrag::DarcyDrag(const dictionary& dict)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::dragModels::DarcyDrag::Sp
(
    const particle& p,
    const carrier& c
) const
{
    return 180*p.volume()*(1 - c.alphac)*c.mu/(c.alphac*sqr(p.d));
}


Foam::dew::lawRanges Foam::dew::dragModels::DarcyDrag::ranges() const
{
    return
    {
        {"Re", lawQuantities::ReSuperficial, 0, 1},
        {"alphac", lawQuantities::voidFraction, 0.3, 0.7}
    };
}
