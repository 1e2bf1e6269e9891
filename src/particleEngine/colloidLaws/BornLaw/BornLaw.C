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
    colloidLaw(dict, medium, mats),
    laws_
    (
        perPair<BornRepulsion>
        (
            dict,
            mats,
            [&](const dictionary& d)
            {
                onlyThese(d, {"hamaker", "media", "sigma"});
                return BornRepulsion
                {
                    hamaker(d, medium),
                    userEntry::positive(d, "sigma", dimLength),
                    medium.minGap()
                };
            }
        )
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::colloidForce Foam::dew::colloidLaws::BornLaw::pair
(
    int i, int j, double Ri, double Rj, double h
) const
{
    return laws_[at(i, j)](h, DerjaguinRadius(Ri, Rj));
}


Foam::dew::colloidForce Foam::dew::colloidLaws::BornLaw::wall
(
    int i, int wall, double R, double h
) const
{
    return laws_[at(i, wall)](h, R);
}
