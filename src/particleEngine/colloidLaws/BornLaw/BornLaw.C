/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "BornLaw.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace colloidLaws
{
    defineTypeName(BornLaw);
    addToRunTimeSelectionTable(colloidLaw, BornLaw, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::colloidLaws::BornLaw::BornLaw
(
    const dictionary& dict,
    const colloidMedium& medium,
    const materials& mats
)
:
    DerjaguinLaw<BornRepulsion>
    (
        dict,
        medium,
        mats,
        [&](const dictionary& d)
        {
            onlyThese(d, {"hamaker", "media", "sigma"});
            return BornRepulsion
            {
                attraction(d, medium),
                userEntry::positive(d, "sigma", dimLength),
                medium.minGap()
            };
        }
    )
{}
