/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "activityModel.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeNameAndDebug(activityModel, 0);
    defineRunTimeSelectionTable(activityModel, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::activityModel::activityModel(const liquidMixture& liquids)
:
    x_(liquids.size()),
    below_(liquids.size()),
    n_(liquids.size())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::activityModel::dT
(
    const scalar T,
    const UList<scalar>& x,
    UList<scalar>& result
) const
{
    const scalar h = 1e-4*T;
    lnGamma(T - h, x, below_);
    lnGamma(T + h, x, result);
    for (label i = 0; i < n_; i++)
    {
        result[i] = (result[i] - below_[i])/(2*h);
    }
}


void Foam::dew::activityModel::dx
(
    const label j,
    const scalar T,
    const UList<scalar>& x,
    UList<scalar>& result
) const
{
    // At x_j = 0 the models are smooth into negative amounts
    const scalar h = 1e-5;
    x_ = x;
    x_[j] = x[j] - h;
    lnGamma(T, x_, below_);
    x_[j] = x[j] + h;
    lnGamma(T, x_, result);
    for (label i = 0; i < n_; i++)
    {
        result[i] = (result[i] - below_[i])/(2*h);
    }
}


Foam::scalar Foam::dew::activityModel::factor
(
    const scalar T,
    const UList<scalar>& x
) const
{
    if (n_ != 2)
    {
        FatalErrorInFunction
            << "The thermodynamic factor is for two liquids; here are " << n_
            << exit(FatalError);
    }

    const scalar h = 1e-5;
    x_[0] = x[0] - h;
    x_[1] = x[1] + h;
    lnGamma(T, x_, below_);
    const scalar low = below_[0];
    x_[0] = x[0] + h;
    x_[1] = x[1] - h;
    lnGamma(T, x_, below_);
    return 1 + x[0]*(below_[0] - low)/(2*h);
}
