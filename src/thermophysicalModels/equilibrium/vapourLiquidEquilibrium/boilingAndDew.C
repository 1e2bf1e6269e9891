/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "vapourLiquidEquilibrium.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dew::vapourLiquidEquilibrium::excess
(
    const scalar p,
    const scalar T,
    const UList<scalar>& x,
    UList<scalar>& pi
) const
{
    partialPressures(p, T, x, pi);
    scalar sum = 0;
    for (label i = 0; i < n_; i++)
    {
        sum += pi[i];
    }
    return std::log(sum/p);
}


Foam::scalar Foam::dew::vapourLiquidEquilibrium::deficit
(
    const scalar p,
    const scalar T,
    const UList<scalar>& y,
    UList<scalar>& x
) const
{
    if (fugacity_)
    {
        for (label i = 0; i < n_; i++)
        {
            y_[i] = y[i];
        }
        y_[n_] = 0;
        vapour_->lnPhi(p, T, y_, lnPhi_);
    }

    // Liquid of the vapour: damped, for activities push it to and fro
    scalar sum = 0;
    for (label iter = 0; iter < 500; iter++)
    {
        volatilities(p, T, x);
        sum = 0;
        for (label i = 0; i < n_; i++)
        {
            above_[i] = y[i]*p*std::exp(lnPhi_[i])/K_[i];
            sum += above_[i];
        }
        scalar change = 0;
        for (label i = 0; i < n_; i++)
        {
            const scalar step = 0.5*(above_[i]/sum - x[i]);
            change = max(change, mag(step));
            x[i] += step;
        }
        if (change < 1e-13)
        {
            break;
        }
    }
    return std::log(sum);
}


template<class Function>
Foam::scalar Foam::dew::vapourLiquidEquilibrium::temperature
(
    const Function& f,
    const char* what,
    const scalar p
) const
{
    // Boiling points of the pure liquids as a start; fits end at Tc_
    scalar T = 0;
    for (label i = 0; i < n_; i++)
    {
        const scalar boiling = liquids_.liquid(i).Tboil(p);
        T += (boiling < Tc_ ? boiling : min(0.99*Tc_, 1e3))/n_;
    }
    T = min(T, 0.99*Tc_);

    // The function is nearly linear in 1/T: secant, kept in the bracket
    scalar low = 0.1*T, high = min(Tc_, 10*T);
    bool boils = false;
    scalar before = 0.99*T, fBefore = f(before);
    for (label iter = 0; iter < 200; iter++)
    {
        const scalar fT = f(T);
        (fT > 0 ? high : low) = T;
        boils = boils || fT > 0;
        if (mag(fT) < 1e-12)
        {
            return T;
        }
        scalar next =
            1/(1/T - fT*(1/T - 1/before)/(fT - fBefore));
        if (!(next > low && next < high))
        {
            next = 0.5*(low + high);
        }
        if (mag(next - T) < 1e-12*T)
        {
            if (boils || mag(fT) < 1e-8)
            {
                return next;
            }
            break;
        }
        before = T;
        fBefore = fT;
        T = next;
    }

    FatalErrorInFunction
        << "No " << what << " of " << liquids_.names() << " at " << p << " Pa"
        << nl << "The pressure is above the critical one, or the saturation"
        << " pressure of a liquid is constant" << exit(FatalError);
    return T;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::vapourLiquidEquilibrium::bubbleT
(
    const scalar p,
    const UList<scalar>& x,
    UList<scalar>& y
) const
{
    const scalar T = temperature
    (
        [&](const scalar T) { return excess(p, T, x, y); }, "boiling point", p
    );
    excess(p, T, x, y);
    for (label i = 0; i < n_; i++)
    {
        y[i] /= p;
    }
    return T;
}


Foam::scalar Foam::dew::vapourLiquidEquilibrium::bubbleP
(
    const scalar T,
    const UList<scalar>& x,
    UList<scalar>& y
) const
{
    // The corrections depend weakly on the pressure
    scalar p = 0;
    for (label i = 0; i < n_; i++)
    {
        p += x[i]*liquids_.liquid(i).pSat(T);
    }
    for (label iter = 0; iter < 200; iter++)
    {
        const scalar error = excess(p, T, x, y);
        p *= std::exp(error);
        if (mag(error) < 1e-12)
        {
            break;
        }
    }
    for (label i = 0; i < n_; i++)
    {
        y[i] /= p;
    }
    return p;
}


Foam::scalar Foam::dew::vapourLiquidEquilibrium::dewT
(
    const scalar p,
    const UList<scalar>& y,
    UList<scalar>& x
) const
{
    for (label i = 0; i < n_; i++)
    {
        x[i] = y[i];
    }
    const scalar T = temperature
    (
        [&](const scalar T) { return -deficit(p, T, y, x); }, "dew point", p
    );
    deficit(p, T, y, x);
    return T;
}


Foam::scalar Foam::dew::vapourLiquidEquilibrium::dewP
(
    const scalar T,
    const UList<scalar>& y,
    UList<scalar>& x
) const
{
    scalar p = 0;
    for (label i = 0; i < n_; i++)
    {
        x[i] = y[i];
        p += y[i]*liquids_.liquid(i).pSat(T);
    }
    for (label iter = 0; iter < 200; iter++)
    {
        const scalar error = deficit(p, T, y, x);
        p *= std::exp(-error);
        if (mag(error) < 1e-12)
        {
            break;
        }
    }
    return p;
}
