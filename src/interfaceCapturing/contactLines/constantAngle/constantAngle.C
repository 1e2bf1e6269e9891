/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "constantAngle.H"
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
    defineTypeName(constantAngle);
    addToRunTimeSelectionTable(contactLine, constantAngle, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::contactLines::constantAngle::constantAngle
(
    const dictionary& dict,
    const scalar
)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::contactLines::constantAngle::move
(
    const scalar V,
    scalar& a,
    scalar& theta
) const
{
    a = sphericalCap::contactRadius(V, theta);
}
