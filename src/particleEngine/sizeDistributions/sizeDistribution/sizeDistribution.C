/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sizeDistribution.H"
#include "userEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(sizeDistribution);
    defineRunTimeSelectionTable(sizeDistribution, dictionary);
}
}


// * * * * * * * * * * * * * * * * Functions * * * * * * * * * * * * * * * * //

Foam::scalar Foam::dew::cumulativeNormal(const scalar z)
{
    return 0.5*std::erfc(-z/std::sqrt(2.0));
}


Foam::scalar Foam::dew::inverseNormal(const scalar F)
{
    // Bisection to a bracket, then Newton: no table of coefficients needed
    scalar low = -40, high = 40, z = 0;

    for (int i = 0; i < 200 && high - low > 1e-15*(1 + mag(z)); i++)
    {
        (cumulativeNormal(z) < F ? low : high) = z;

        const scalar density =
            std::exp(-0.5*z*z)/std::sqrt(2*std::acos(-1.0));
        const scalar newton = z - (cumulativeNormal(z) - F)/density;

        if (newton == z)
        {
            break;
        }
        z = newton > low && newton < high ? newton : 0.5*(low + high);
    }

    return z;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::sizeDistribution::sizeDistribution
(
    const dictionary& dict,
    const scalar min,
    const scalar max
)
:
    min_(min),
    max_(max),
    byMass_(false)
{
    const word weighting(dict.getOrDefault<word>("weighting", "number"));

    if (weighting != "number" && weighting != "mass")
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'weighting' in " << dict.dictName() << " is "
            << weighting << nl << "It must be number or mass"
            << exit(FatalIOError);
    }
    byMass_ = (weighting == "mass");

    if (max_ < min_)
    {
        FatalIOErrorInFunction(dict)
            << "In " << dict.dictName() << " max (" << max_
            << ") is smaller than min (" << min_ << ")"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::sizeDistribution::sample(counterRandom& random) const
{
    if (max_ <= min_)
    {
        return min_;
    }

    const scalar F0 = cumulative(min_);
    const scalar F1 = cumulative(max_);

    while (true)
    {
        const scalar F = F0 + random.uniform()*(F1 - F0);
        const scalar d = Foam::min(Foam::max(inverse(F), min_), max_);

        if (!byMass_ || random.uniform() < pow3(min_/d))
        {
            return d;
        }
    }
}
