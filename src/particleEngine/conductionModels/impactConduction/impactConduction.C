/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "impactConduction.H"
#include "addToRunTimeSelectionTable.H"
#include "impactHeat.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace conductionModels
{
    defineTypeName(impactConduction);
    addToRunTimeSelectionTable(conductionModel, impactConduction, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::conductionModels::impactConduction::impactConduction
(
    const dictionary& dict,
    const materials& mats
)
{
    userEntry::onlyThese(dict, {"type"});

    for (label i = 0; i < mats.size(); i++)
    {
        for (label j = 0; j < i; j++)
        {
            const scalar a = mats.density(i)*mats.heatCapacity(i);
            const scalar b = mats.density(j)*mats.heatCapacity(j);
            const scalar x = min(a, b)/max(a, b);

            if (x < impactRatioMin)
            {
                FatalIOErrorInFunction(dict)
                    << "Conduction impact is for materials whose density times"
                    << " heat capacity differ little, but the ratio of "
                    << mats.names()[i] << " and " << mats.names()[j] << " is "
                    << x << ", less than " << impactRatioMin << nl
                    << "Use another type, or other materials"
                    << exit(FatalIOError);
            }
        }
    }
}
