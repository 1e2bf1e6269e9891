/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "TennetiDrag.H"
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
    defineTypeName(TennetiDrag);
    addToRunTimeSelectionTable(particleForce, TennetiDrag, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::dragModels::TennetiDrag::TennetiDrag(const dictionary& dict)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::dragModels::TennetiDrag::Sp
(
    const particle& p,
    const carrier& c
) const
{
    const scalar eps = c.alphac;
    const scalar phi = 1 - eps;
    const scalar Re = dragModel::Re(p, c);

    const scalar F =
        (1 + 0.15*pow(Re, 0.687) + 5.81*phi + 0.48*cbrt(phi)/eps)/pow3(eps)
      + pow3(phi)*Re*(0.95 + 0.61*pow3(phi)/sqr(eps));

    return stokes(p, c)*sqr(eps)*F;
}


Foam::dew::lawRanges Foam::dew::dragModels::TennetiDrag::ranges() const
{
    return
    {
        {"Re", lawQuantities::ReSuperficial, 0, 300},
        {"alphac", lawQuantities::voidFraction, 0.5, 1}
    };
}
