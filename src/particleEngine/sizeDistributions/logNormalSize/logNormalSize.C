/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "logNormalSize.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace sizeDistributions
{
    defineTypeName(logNormalSize);
    addToRunTimeSelectionTable(sizeDistribution, logNormalSize, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::sizeDistributions::logNormalSize::logNormalSize(const dictionary& dict)
:
    sizeDistribution
    (
        dict,
        userEntry::positive(dict, "min", dimLength),
        userEntry::positive(dict, "max", dimLength)
    ),
    median_(userEntry::positive(dict, "median", dimLength)),
    deviation_(userEntry::positive(dict, "deviation", dimless))
{
    userEntry::onlyThese(dict, {"type", "median", "deviation", "min", "max", "weighting"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar
Foam::dew::sizeDistributions::logNormalSize::inverse(const scalar F) const
{
    return median_*exp(deviation_*inverseNormal(F));
}


Foam::scalar
Foam::dew::sizeDistributions::logNormalSize::cumulative(const scalar d) const
{
    return cumulativeNormal(log(d/median_)/deviation_);
}
