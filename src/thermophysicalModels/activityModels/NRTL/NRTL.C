/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "NRTL.H"
#include "addToRunTimeSelectionTable.H"
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
    defineTypeName(NRTL);
    addToRunTimeSelectionTable(activityModel, NRTL, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::activityModels::NRTL::NRTL
(
    const dictionary& dict,
    const liquidMixture& liquids
)
:
    activityModel(liquids),
    a_(n_*n_, 0),
    b_(n_*n_, 0),
    alpha_(n_*n_, 0),
    t_(n_*n_),
    G_(n_*n_),
    R_(n_),
    S_(n_)
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
            userEntry::onlyThese(pair, {"a12", "a21", "b12", "b21", "alpha"});
            const auto of = [&](const word& key, const dimensionSet& dims)
            {
                return
                    pair.found(key) ? userEntry::number(pair, key, dims) : 0;
            };

            const label one = swapped ? j : i, two = swapped ? i : j;
            const label ij = one*n_ + two, ji = two*n_ + one;
            a_[ij] = of("a12", dimless);
            a_[ji] = of("a21", dimless);
            b_[ij] = of("b12", dimTemperature);
            b_[ji] = of("b21", dimTemperature);
            alpha_[ij] = alpha_[ji] = userEntry::within(pair, "alpha", 0, 1);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::activityModels::NRTL::lnGamma
(
    const scalar T,
    const UList<scalar>& x,
    UList<scalar>& result
) const
{
    for (label j = 0; j < n_; j++)
    {
        R_[j] = S_[j] = 0;
        for (label k = 0; k < n_; k++)
        {
            const label kj = k*n_ + j;
            t_[kj] = a_[kj] + b_[kj]/T;
            G_[kj] = std::exp(-alpha_[kj]*t_[kj]);
            R_[j] += x[k]*G_[kj];
            S_[j] += x[k]*t_[kj]*G_[kj];
        }
    }
    for (label i = 0; i < n_; i++)
    {
        result[i] = S_[i]/R_[i];
        for (label j = 0; j < n_; j++)
        {
            const label ij = i*n_ + j;
            result[i] += x[j]*G_[ij]/R_[j]*(t_[ij] - S_[j]/R_[j]);
        }
    }
}
