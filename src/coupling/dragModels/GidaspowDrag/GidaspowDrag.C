/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "GidaspowDrag.H"
#include "ErgunDrag.H"
#include "WenYuDrag.H"
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
    defineTypeName(GidaspowDrag);
    addToRunTimeSelectionTable(particleForce, GidaspowDrag, dictionary);
}
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam::dew;

bool dense(const carrier& c)
{
    return c.alphac < 0.8;
}


//- Of the particles that Ergun's law is for
Foam::scalar ReDense(const particle& p, const carrier& c)
{
    return dense(c) ? lawQuantities::ReSuperficial(p, c) : 0;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::dragModels::GidaspowDrag::GidaspowDrag(const dictionary& dict)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::dragModels::GidaspowDrag::Sp
(
    const particle& p,
    const carrier& c
) const
{
    return dense(c) ? ErgunDrag::law(p, c) : WenYuDrag::law(p, c);
}


Foam::dew::lawRanges Foam::dew::dragModels::GidaspowDrag::ranges() const
{
    return
    {
        {"Re at alphac < 0.8", ReDense, 0, 1000},
        {"Re", lawQuantities::ReSuperficial, 0, 2e5},
        {"alphac", lawQuantities::voidFraction, 0.35, 1}
    };
}
