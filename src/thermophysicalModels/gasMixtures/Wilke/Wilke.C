/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "Wilke.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::Wilke::Wilke(const UList<scalar>& W)
:
    n_(W.size()),
    root_(n_*n_),
    factor_(n_*n_),
    sqrtMu_(n_)
{
    for (label i = 0; i < n_; i++)
    {
        for (label j = 0; j < n_; j++)
        {
            root_[i*n_ + j] = std::pow(W[j]/W[i], 0.25);
            factor_[i*n_ + j] = 1/std::sqrt(8*(1 + W[i]/W[j]));
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::Wilke::mean
(
    const UList<scalar>& x,
    const UList<scalar>& mu,
    const UList<scalar>& property
) const
{
    for (label i = 0; i < n_; i++)
    {
        sqrtMu_[i] = std::sqrt(mu[i]);
    }

    scalar sum = 0;
    for (label i = 0; i < n_; i++)
    {
        scalar weight = 0;
        for (label j = 0; j < n_; j++)
        {
            const label ij = i*n_ + j;
            weight +=
                x[j]*factor_[ij]*sqr(1 + sqrtMu_[i]/sqrtMu_[j]*root_[ij]);
        }
        sum += x[i]*property[i]/weight;
    }
    return sum;
}
