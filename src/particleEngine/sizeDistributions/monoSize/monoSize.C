/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "monoSize.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace sizeDistributions
{
    defineTypeName(monoSize);
    addToRunTimeSelectionTable(sizeDistribution, monoSize, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::sizeDistributions::monoSize::monoSize(const dictionary& dict)
:
    sizeDistribution
    (
        dict,
        userEntry::positive(dict, "value", dimLength),
        userEntry::positive(dict, "value", dimLength)
    )
{
    userEntry::onlyThese(dict, {"type", "value", "weighting"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar
Foam::dew::sizeDistributions::monoSize::inverse(const scalar F) const
{
    return max();
}


Foam::scalar
Foam::dew::sizeDistributions::monoSize::cumulative(const scalar d) const
{
    return d < max() ? 0 : 1;
}
