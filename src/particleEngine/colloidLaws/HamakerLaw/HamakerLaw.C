/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "HamakerLaw.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace colloidLaws
{
    defineTypeName(HamakerLaw);
    addToRunTimeSelectionTable(colloidLaw, HamakerLaw, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::colloidLaws::HamakerLaw::HamakerLaw
(
    const dictionary& dict,
    const colloidMedium& medium,
    const materials& mats
)
:
    colloidLaw(dict, medium, mats, entriesOf::pairs),
    laws_
    (
        perPair<HamakerSpheres>
        (
            dict,
            mats,
            [&](const dictionary& d)
            {
                onlyThese(d, {"hamaker", "media", "retardation"});
                return HamakerSpheres
                {
                    hamaker(d, medium),
                    medium.minGap(),
                    userEntry::notNegativeOr(d, "retardation", dimLength, 0)
                };
            }
        )
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::colloidForce Foam::dew::colloidLaws::HamakerLaw::pair
(
    int i, int j, double Ri, double Rj, double h
) const
{
    return laws_[at(i, j)].spheres(h, Ri, Rj);
}


Foam::dew::colloidForce Foam::dew::colloidLaws::HamakerLaw::wall
(
    int i, int wall, double R, double h
) const
{
    return laws_[at(i, wall)].plate(h, R);
}
