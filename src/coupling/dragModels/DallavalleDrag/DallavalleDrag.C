/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "DallavalleDrag.H"
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
    defineTypeName(DallavalleDrag);
    addToRunTimeSelectionTable(particleForce, DallavalleDrag, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::dragModels::DallavalleDrag::DallavalleDrag(const dictionary& dict)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::dragModels::DallavalleDrag::Sp
(
    const particle& p,
    const carrier& c
) const
{
    const scalar CdRe = sqr(0.63*sqrt(ReSingle(p, c)) + 4.8);

    return stokes(p, c)*CdRe/24;
}


Foam::dew::lawRanges Foam::dew::dragModels::DallavalleDrag::ranges() const
{
    return
    {
        {"Re", lawQuantities::ReSingle, 0, 2e5}
    };
}
