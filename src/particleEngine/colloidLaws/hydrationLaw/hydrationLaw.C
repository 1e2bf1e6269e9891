/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "hydrationLaw.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace colloidLaws
{
    defineTypeName(hydrationLaw);
    addToRunTimeSelectionTable(colloidLaw, hydrationLaw, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::colloidLaws::hydrationLaw::hydrationLaw
(
    const dictionary& dict,
    const colloidMedium& medium,
    const materials& mats
)
:
    DerjaguinLaw<hydrationForce>
    (
        dict,
        medium,
        mats,
        [&](const dictionary& d)
        {
            onlyThese(d, {"energy", "length"});
            return hydrationForce
            {
                userEntry::number(d, "energy", dimEnergy/dimArea),
                userEntry::positive(d, "length", dimLength)
            };
        }
    )
{}
