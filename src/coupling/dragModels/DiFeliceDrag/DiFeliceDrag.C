/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "DiFeliceDrag.H"
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
    defineTypeName(DiFeliceDrag);
    addToRunTimeSelectionTable(particleForce, DiFeliceDrag, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::dragModels::DiFeliceDrag::DiFeliceDrag(const dictionary& dict)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::dragModels::DiFeliceDrag::Sp
(
    const particle& p,
    const carrier& c
) const
{
    const scalar Re = dragModel::Re(p, c);

    // The logarithm has no value at rest, chi has: 3.7
    const scalar chi =
        3.7 - 0.65*exp(-0.5*sqr(1.5 - log10(max(Re, VSMALL))));

    const scalar CdRe = sqr(0.63*sqrt(Re) + 4.8);

    return stokes(p, c)*CdRe/24*pow(c.alphac, 1 - chi);
}


Foam::dew::lawRanges Foam::dew::dragModels::DiFeliceDrag::ranges() const
{
    return
    {
        {"Re", lawQuantities::ReSuperficial, 0, 2e5},
        {"alphac", lawQuantities::voidFraction, 0.4, 1}
    };
}
