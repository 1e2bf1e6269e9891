/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "WenYuDrag.H"
#include "SchillerNaumannDrag.H"
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
    defineTypeName(WenYuDrag);
    addToRunTimeSelectionTable(particleForce, WenYuDrag, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::dragModels::WenYuDrag::WenYuDrag(const dictionary& dict)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::dragModels::WenYuDrag::law
(
    const particle& p,
    const carrier& c
)
{
    const scalar CdRe = SchillerNaumannDrag::CdRe(Re(p, c));

    return stokes(p, c)*CdRe/24*pow(c.alphac, -2.65);
}


Foam::scalar Foam::dew::dragModels::WenYuDrag::Sp
(
    const particle& p,
    const carrier& c
) const
{
    return law(p, c);
}


Foam::dew::lawRanges Foam::dew::dragModels::WenYuDrag::ranges() const
{
    return
    {
        {"Re", lawQuantities::ReSuperficial, 0, 2e5},
        {"alphac", lawQuantities::voidFraction, 0.4, 1}
    };
}
