/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "ErgunDrag.H"
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
    defineTypeName(ErgunDrag);
    addToRunTimeSelectionTable(particleForce, ErgunDrag, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::dragModels::ErgunDrag::ErgunDrag(const dictionary& dict)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::dragModels::ErgunDrag::law
(
    const particle& p,
    const carrier& c
)
{
    const scalar viscous = 150*(1 - c.alphac)*c.mu/(c.alphac*sqr(p.d));
    const scalar inertial = 1.75*c.rho*mag(c.U - p.U)/p.d;

    return p.volume()*(viscous + inertial);
}


Foam::scalar Foam::dew::dragModels::ErgunDrag::Sp
(
    const particle& p,
    const carrier& c
) const
{
    return law(p, c);
}


Foam::dew::lawRanges Foam::dew::dragModels::ErgunDrag::ranges() const
{
    return
    {
        {"Re", lawQuantities::ReSuperficial, 0, 1000},
        {"alphac", lawQuantities::voidFraction, 0.35, 0.6}
    };
}
