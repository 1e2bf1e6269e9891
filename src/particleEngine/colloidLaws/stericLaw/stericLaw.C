/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "stericLaw.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace colloidLaws
{
    defineTypeName(stericLaw);
    addToRunTimeSelectionTable(colloidLaw, stericLaw, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::colloidLaws::stericLaw::stericLaw
(
    const dictionary& dict,
    const colloidMedium& medium,
    const materials& mats
)
:
    DerjaguinLaw<stericRepulsion>
    (
        dict,
        medium,
        mats,
        [&](const dictionary& d)
        {
            onlyThese(d, {"spacing", "thickness"});
            return stericRepulsion
            {
                medium.kT(),
                userEntry::positive(d, "spacing", dimLength),
                userEntry::positive(d, "thickness", dimLength),
                medium.minGap()
            };
        }
    )
{}
