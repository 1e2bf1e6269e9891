/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "KochHillDrag.H"
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
    defineTypeName(KochHillDrag);
    addToRunTimeSelectionTable(particleForce, KochHillDrag, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::dragModels::KochHillDrag::KochHillDrag(const dictionary& dict)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::dragModels::KochHillDrag::Sp
(
    const particle& p,
    const carrier& c
) const
{
    const scalar eps = c.alphac;
    const scalar phi = max(1 - eps, scalar(0));

    // The logarithm has no value at phi 0, its term has: 0
    const scalar F0 =
        phi < 0.4
      ? (
            1 + 3*sqrt(0.5*phi) + 135.0/64*phi*log(max(phi, VSMALL))
          + 16.14*phi
        )/(1 + phi*(0.681 + phi*(-8.48 + 8.16*phi)))
      : 10*phi/pow3(eps);

    const scalar F3 = 0.0673 + 0.212*phi + 0.0232/pow5(eps);

    return stokes(p, c)*sqr(eps)*(F0 + 0.5*F3*Re(p, c));
}


Foam::dew::lawRanges Foam::dew::dragModels::KochHillDrag::ranges() const
{
    return
    {
        {"Re", lawQuantities::ReSuperficial, 0, 120},
        {"alphac", lawQuantities::voidFraction, 0.36, 1}
    };
}
