/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "pinnedThenReceding.H"
#include "addToRunTimeSelectionTable.H"
#include "sphericalCap.H"
#include "unitConversion.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace contactLines
{
    defineTypeName(pinnedThenReceding);
    addToRunTimeSelectionTable(contactLine, pinnedThenReceding, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::contactLines::pinnedThenReceding::pinnedThenReceding
(
    const dictionary& dict,
    const scalar startAngle
)
:
    receding_
    (
        degToRad(userEntry::positive(dict, "recedingAngle", dimless))
    )
{
    userEntry::onlyThese(dict, {"type", "recedingAngle"});

    if (receding_ > startAngle*(1 + SMALL))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'recedingAngle' in " << dict.dictName() << " is "
            << radToDeg(receding_) << " degrees" << nl
            << "It must not be above the contactAngle, "
            << radToDeg(startAngle)
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::contactLines::pinnedThenReceding::move
(
    const scalar V,
    scalar& a,
    scalar& theta
) const
{
    theta = sphericalCap::angle(V, a);
    if (theta < receding_)
    {
        theta = receding_;
        a = sphericalCap::contactRadius(V, theta);
    }
}
