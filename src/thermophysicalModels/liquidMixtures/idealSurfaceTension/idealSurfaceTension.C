/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "idealSurfaceTension.H"
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
    defineTypeName(idealSurfaceTension);
    addToRunTimeSelectionTable
    (
        mixtureSurfaceTension, idealSurfaceTension, dictionary
    );
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::mixtureSurfaceTensions::idealSurfaceTension::idealSurfaceTension
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

Foam::scalar Foam::dew::mixtureSurfaceTensions::idealSurfaceTension::sigma
(
    const scalar p,
    const scalar T,
    const UList<scalar>& x
) const
{
    scalar sum = 0;
    forAll(liquids_, i)
    {
        sum += x[i]*liquids_[i].sigma(p, T);
    }
    return sum;
}
