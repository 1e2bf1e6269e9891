/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "uniformSize.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace sizeDistributions
{
    defineTypeName(uniformSize);
    addToRunTimeSelectionTable(sizeDistribution, uniformSize, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::sizeDistributions::uniformSize::uniformSize(const dictionary& dict)
:
    sizeDistribution
    (
        dict,
        userEntry::positive(dict, "min", dimLength),
        userEntry::positive(dict, "max", dimLength)
    )
{
    userEntry::onlyThese(dict, {"type", "min", "max", "weighting"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar
Foam::dew::sizeDistributions::uniformSize::inverse(const scalar F) const
{
    return min() + F*(max() - min());
}


Foam::scalar
Foam::dew::sizeDistributions::uniformSize::cumulative(const scalar d) const
{
    return (d - min())/(max() - min());
}
