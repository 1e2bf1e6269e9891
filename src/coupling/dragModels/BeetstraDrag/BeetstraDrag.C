/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "BeetstraDrag.H"
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
    defineTypeName(BeetstraDrag);
    addToRunTimeSelectionTable(particleForce, BeetstraDrag, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::dragModels::BeetstraDrag::BeetstraDrag(const dictionary& dict)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::dragModels::BeetstraDrag::Sp
(
    const particle& p,
    const carrier& c
) const
{
    const scalar eps = c.alphac;
    const scalar phi = max(1 - eps, scalar(0));
    const scalar Re = dragModel::Re(p, c);

    const scalar F0 = 10*phi/sqr(eps) + sqr(eps)*(1 + 1.5*sqrt(phi));

    // Negative powers of Re multiplied out, for rest
    const scalar inertial = pow(Re, 0.5 + 2*phi);
    const scalar F1 =
        0.413/(24*sqr(eps))
       *(Re*(1/eps + 3*eps*phi) + 8.4*pow(Re, 0.657))
       *inertial/(inertial + pow(10.0, 3*phi));

    return stokes(p, c)*eps*(F0 + F1);
}


Foam::dew::lawRanges Foam::dew::dragModels::BeetstraDrag::ranges() const
{
    return
    {
        {"Re", lawQuantities::ReSuperficial, 0, 1000},
        {"alphac", lawQuantities::voidFraction, 0.4, 1}
    };
}
