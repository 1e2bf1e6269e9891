/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "givenDiffusivity.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace binaryDiffusivities
{
    defineTypeName(givenDiffusivity);
    addToRunTimeSelectionTable(binaryDiffusivity, givenDiffusivity, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::binaryDiffusivities::givenDiffusivity::givenDiffusivity
(
    const dictionary& dict,
    const pureGas::part&,
    const pureGas::part&
)
:
    D0_
    (
        userEntry::positive(dict, "D0", dimViscosity)
       *userEntry::positive(dict, "pRef", dimPressure)
    ),
    Tref_(userEntry::positive(dict, "Tref", dimTemperature)),
    n_(dict.found("n") ? userEntry::within(dict, "n", 0, 3) : 1.75)
{
    userEntry::onlyThese(dict, {"type", "D0", "Tref", "pRef", "n", "pairs"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::binaryDiffusivities::givenDiffusivity::D
(
    const scalar p,
    const scalar T
) const
{
    return D0_/p*std::pow(T/Tref_, n_);
}
