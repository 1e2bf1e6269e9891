/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "pinned.H"
#include "addToRunTimeSelectionTable.H"
#include "sphericalCap.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace contactLines
{
    defineTypeName(pinned);
    addToRunTimeSelectionTable(contactLine, pinned, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::contactLines::pinned::pinned
(
    const dictionary& dict,
    const scalar
)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::contactLines::pinned::move
(
    const scalar V,
    scalar& a,
    scalar& theta
) const
{
    theta = sphericalCap::angle(V, a);
}
