/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "wallLennardJones.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace colloidLaws
{
    defineTypeName(wallLennardJones);
    addToRunTimeSelectionTable(colloidLaw, wallLennardJones, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::colloidLaws::wallLennardJones::wallLennardJones
(
    const dictionary& dict,
    const colloidMedium& medium,
    const materials& mats
)
:
    colloidLaw(dict, medium, mats, entriesOf::pairs),
    laws_
    (
        perPair<LennardJonesWall>
        (
            dict,
            mats,
            [&](const dictionary& d)
            {
                onlyThese(d, {"hamaker", "media", "sigma", "vanDerWaals"});
                return LennardJonesWall
                {
                    attraction(d, medium),
                    userEntry::positive(d, "sigma", dimLength),
                    medium.minGap(),
                    d.getOrDefault<Switch>("vanDerWaals", true)
                };
            }
        )
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::colloidForce Foam::dew::colloidLaws::wallLennardJones::pair
(
    int i, int j, double Ri, double Rj, double h
) const
{
    return {0, 0};
}


Foam::dew::colloidForce Foam::dew::colloidLaws::wallLennardJones::wall
(
    int i, int wall, double R, double h
) const
{
    return laws_[at(i, wall)](h, R);
}


bool Foam::dew::colloidLaws::wallLennardJones::wallVanDerWaals() const
{
    for (const LennardJonesWall& law : laws_)
    {
        if (law.vanDerWaals)
        {
            return true;
        }
    }
    return false;
}
