/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "Eberhart.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace mixtureSurfaceTensions
{
    defineTypeName(Eberhart);
    addToRunTimeSelectionTable(mixtureSurfaceTension, Eberhart, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::mixtureSurfaceTensions::Eberhart::Eberhart
(
    const dictionary& dict,
    const wordList& names,
    const PtrList<liquidModel>& liquids
)
:
    mixtureSurfaceTension(liquids),
    S_(names.size())
{
    userEntry::onlyThese(dict, {"type", "S"});
    const dictionary& S = userEntry::subDict(dict, "S");
    userEntry::onlyThese(S, names);
    forAll(S_, i)
    {
        S_[i] = userEntry::positive(S, names[i], dimless);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::mixtureSurfaceTensions::Eberhart::sigma
(
    const scalar p,
    const scalar T,
    const UList<scalar>& x
) const
{
    scalar surface = 0, sum = 0;
    forAll(liquids_, i)
    {
        surface += S_[i]*x[i];
        sum += S_[i]*x[i]*liquids_[i].sigma(p, T);
    }
    return sum/surface;
}
