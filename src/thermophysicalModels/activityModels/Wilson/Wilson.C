/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "Wilson.H"
#include "addToRunTimeSelectionTable.H"
#include "gasConstant.H"
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
    defineTypeName(Wilson);
    addToRunTimeSelectionTable(activityModel, Wilson, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::activityModels::Wilson::Wilson
(
    const dictionary& dict,
    const liquidMixture& liquids
)
:
    activityModel(liquids),
    ratio_(n_*n_, 1),
    energy_(n_*n_, 0),
    L_(n_*n_),
    sum_(n_)
{
    const wordList& names = liquids.names();
    speciesPairs::onlyThese(dict, names, {"type"});

    for (label i = 0; i < n_; i++)
    {
        for (label j = i + 1; j < n_; j++)
        {
            bool swapped = false;
            const dictionary& pair = userEntry::subDict
            (
                dict, speciesPairs::key(dict, names[i], names[j], swapped)
            );
            userEntry::onlyThese(pair, {"a12", "a21", "V1", "V2"});

            const label one = swapped ? j : i, two = swapped ? i : j;
            const dimensionSet dimV(dimVolume/dimMoles);
            const scalar V =
                userEntry::positive(pair, "V2", dimV)
               /userEntry::positive(pair, "V1", dimV);
            const dimensionSet dimA(dimEnergy/dimMoles);
            const label ij = one*n_ + two, ji = two*n_ + one;
            ratio_[ij] = V;
            ratio_[ji] = 1/V;
            energy_[ij] = userEntry::number(pair, "a12", dimA)/gasConstant;
            energy_[ji] = userEntry::number(pair, "a21", dimA)/gasConstant;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::activityModels::Wilson::lnGamma
(
    const scalar T,
    const UList<scalar>& x,
    UList<scalar>& result
) const
{
    scalar total = 0;
    for (label i = 0; i < n_; i++)
    {
        total += x[i];
        sum_[i] = 0;
        for (label j = 0; j < n_; j++)
        {
            const label ij = i*n_ + j;
            L_[ij] = ratio_[ij]*std::exp(-energy_[ij]/T);
            sum_[i] += x[j]*L_[ij];
        }
    }
    for (label i = 0; i < n_; i++)
    {
        result[i] = 1 - std::log(sum_[i]/total);
        for (label k = 0; k < n_; k++)
        {
            result[i] -= x[k]*L_[k*n_ + i]/sum_[k];
        }
    }
}
