/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "liquidMixture.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dew::liquidMixture::excess
(
    const List<scalarList>& coefficients,
    const UList<scalar>& x
) const
{
    const label n = size();
    scalar sum = 0;
    for (label i = 0; i < n; i++)
    {
        for (label j = i + 1; j < n; j++)
        {
            scalar power = x[i]*x[j];
            for (const scalar c : coefficients[i*n + j])
            {
                sum += c*power;
                power *= x[i] - x[j];
            }
        }
    }
    return sum;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::liquidMixture::V
(
    const scalar p,
    const scalar T,
    const UList<scalar>& x
) const
{
    scalar sum = excess(a_, x);
    forAll(W_, i)
    {
        sum += x[i]*W_[i]/liquids_[i].rho(p, T);
    }
    return sum;
}


Foam::scalar Foam::dew::liquidMixture::beta
(
    const scalar p,
    const scalar T,
    const UList<scalar>& x
) const
{
    const scalar h = 1e-4*T;
    return std::log(V(p, T + h, x)/V(p, T - h, x))/(2*h);
}


Foam::scalar Foam::dew::liquidMixture::mu
(
    const scalar p,
    const scalar T,
    const UList<scalar>& x
) const
{
    scalar sum = excess(G_, x);
    forAll(W_, i)
    {
        sum += x[i]*std::log(liquids_[i].mu(p, T));
    }
    return std::exp(sum);
}


Foam::scalar Foam::dew::liquidMixture::Cp
(
    const scalar p,
    const scalar T,
    const UList<scalar>& x
) const
{
    scalar sum = 0;
    forAll(W_, i)
    {
        sum += x[i]*W_[i]*liquids_[i].Cp(p, T);
    }
    return sum/W(x);
}


Foam::scalar Foam::dew::liquidMixture::kappa
(
    const scalar p,
    const scalar T,
    const UList<scalar>& x
) const
{
    const label n = size();
    const scalar mean = W(x);
    scalar sum = 0;
    for (label i = 0; i < n; i++)
    {
        work_[i] = x[i]*W_[i]/mean;
        work_[n + i] = liquids_[i].kappa(p, T);
        sum += work_[i]*work_[n + i];
        for (label j = 0; j < i; j++)
        {
            sum -= 0.72*work_[i]*work_[j]*mag(work_[n + i] - work_[n + j]);
        }
    }
    return sum;
}
