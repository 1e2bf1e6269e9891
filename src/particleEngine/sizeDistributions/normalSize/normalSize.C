/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "normalSize.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace sizeDistributions
{
    defineTypeName(normalSize);
    addToRunTimeSelectionTable(sizeDistribution, normalSize, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::sizeDistributions::normalSize::normalSize(const dictionary& dict)
:
    sizeDistribution
    (
        dict,
        userEntry::positive(dict, "min", dimLength),
        userEntry::positive(dict, "max", dimLength)
    ),
    mean_(userEntry::positive(dict, "mean", dimLength)),
    deviation_(userEntry::positive(dict, "deviation", dimLength))
{
    userEntry::onlyThese(dict, {"type", "mean", "deviation", "min", "max", "weighting"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar
Foam::dew::sizeDistributions::normalSize::inverse(const scalar F) const
{
    return mean_ + deviation_*inverseNormal(F);
}


Foam::scalar
Foam::dew::sizeDistributions::normalSize::cumulative(const scalar d) const
{
    return cumulativeNormal((d - mean_)/deviation_);
}
