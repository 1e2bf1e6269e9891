/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

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
    defineTypeName(SchillerNaumannDrag);
    addToRunTimeSelectionTable(particleForce, SchillerNaumannDrag, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::dragModels::SchillerNaumannDrag::SchillerNaumannDrag(const dictionary& dict)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::dragModels::SchillerNaumannDrag::CdRe(const scalar Re)
{
    return Re > 1000 ? 0.44*Re : 24*(1 + 0.15*pow(Re, 0.687));
}


Foam::scalar Foam::dew::dragModels::SchillerNaumannDrag::Sp
(
    const particle& p,
    const carrier& c
) const
{
    return stokes(p, c)*CdRe(ReSingle(p, c))/24;
}


Foam::dew::lawRanges Foam::dew::dragModels::SchillerNaumannDrag::ranges() const
{
    return
    {
        {"Re", lawQuantities::ReSingle, 0, 2e5}
    };
}
