/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "WinterfeldScrivenDavis.H"
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
    defineTypeName(WinterfeldScrivenDavis);
    addToRunTimeSelectionTable
    (
        mixtureSurfaceTension, WinterfeldScrivenDavis, dictionary
    );
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::mixtureSurfaceTensions::WinterfeldScrivenDavis::
WinterfeldScrivenDavis
(
    const dictionary& dict,
    const wordList& names,
    const PtrList<liquidModel>& liquids
)
:
    mixtureSurfaceTension(liquids)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::mixtureSurfaceTensions::WinterfeldScrivenDavis::sigma
(
    const scalar p,
    const scalar T,
    const UList<scalar>& x
) const
{
    scalar volume = 0, sum = 0;
    forAll(liquids_, i)
    {
        const liquidModel& l = liquids_[i];
        const scalar xV = x[i]*l.W()/l.rho(p, T);
        volume += xV;
        sum += xV*std::sqrt(l.sigma(p, T));
    }
    return sqr(sum/volume);
}
