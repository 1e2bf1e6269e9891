/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "idealActivity.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace activityModels
{
    defineTypeName(idealActivity);
    addToRunTimeSelectionTable(activityModel, idealActivity, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::activityModels::idealActivity::idealActivity
(
    const dictionary& dict,
    const liquidMixture& liquids
)
:
    activityModel(liquids)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::activityModels::idealActivity::lnGamma
(
    const scalar T,
    const UList<scalar>& x,
    UList<scalar>& result
) const
{
    // A temperature and a composition have no influence
    static_cast<void>(T);
    static_cast<void>(x);
    for (label i = 0; i < n_; i++)
    {
        result[i] = 0;
    }
}
