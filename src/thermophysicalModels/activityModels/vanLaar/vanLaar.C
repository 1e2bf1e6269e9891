/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "vanLaar.H"
#include "addToRunTimeSelectionTable.H"
#include "speciesPairs.H"
#include "userEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace activityModels
{
    defineTypeName(vanLaar);
    addToRunTimeSelectionTable(activityModel, vanLaar, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::activityModels::vanLaar::vanLaar
(
    const dictionary& dict,
    const liquidMixture& liquids
)
:
    activityModel(liquids)
{
    const wordList& names = liquids.names();
    if (names.size() != 2)
    {
        FatalIOErrorInFunction(dict)
            << "van Laar's activities are for two liquids; here are " << names
            << nl << "Use Wilson, NRTL or UNIFAC" << exit(FatalIOError);
    }
    speciesPairs::onlyThese(dict, names, {"type"});

    bool swapped = false;
    const dictionary& pair = userEntry::subDict
    (
        dict, speciesPairs::key(dict, names[0], names[1], swapped)
    );
    userEntry::onlyThese(pair, {"A12", "A21"});
    A_[0] = userEntry::number(pair, swapped ? "A21" : "A12", dimless);
    A_[1] = userEntry::number(pair, swapped ? "A12" : "A21", dimless);
    if (!(A_[0]*A_[1] > 0))
    {
        FatalIOErrorInFunction(pair)
            << "A12 and A21 are " << A_[0] << " and " << A_[1] << nl
            << "They must have the same sign" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::activityModels::vanLaar::lnGamma
(
    const scalar T,
    const UList<scalar>& x,
    UList<scalar>& result
) const
{
    // The constants hold for one temperature
    static_cast<void>(T);
    const scalar a = A_[0]*x[0], b = A_[1]*x[1];
    result[0] = A_[0]*sqr(b/(a + b));
    result[1] = A_[1]*sqr(a/(a + b));
}
