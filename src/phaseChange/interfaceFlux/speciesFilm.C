/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "speciesFilm.H"

// * * * * * * * * * * * * * * * * Functions  * * * * * * * * * * * * * * * * //

Foam::scalar Foam::dew::speciesFilm::slope
(
    const UList<scalar>& g,
    const UList<scalar>& y,
    const UList<scalar>& ys,
    const scalar n
)
{
    scalar sum = -1;
    forAll(g, i)
    {
        sum += dBernoulli(n/g[i])*(ys[i] - y[i]) + ys[i];
    }
    return sum;
}


Foam::scalar Foam::dew::speciesFilm::total
(
    const UList<scalar>& g,
    const UList<scalar>& y,
    const UList<scalar>& ys
)
{
    // The solution for equal conductances, with their mean
    scalar mean = 0, at = 1, atSurface = 1;
    forAll(g, i)
    {
        mean += g[i]/g.size();
        at -= y[i];
        atSurface -= ys[i];
    }
    scalar n = mean*std::log1p((at - atSurface)/atSurface);

    // F falls from its zero on and is positive before it
    scalar low = -GREAT, high = GREAT;
    for (label iter = 0; iter < 100; iter++)
    {
        scalar F = -n;
        forAll(g, i)
        {
            F += flux(g[i], y[i], ys[i], n);
        }
        (F > 0 ? low : high) = n;
        scalar next = n - F/slope(g, y, ys, n);
        if (!(next > low && next < high))
        {
            next =
                low > -0.1*GREAT && high < 0.1*GREAT ? 0.5*(low + high)
              : F > 0 ? n + mean : n - mean;
        }
        const bool done = mag(next - n) <= 1e-15*(mag(n) + mean);
        n = next;
        if (done)
        {
            break;
        }
    }
    return n;
}


// ************************************************************************* //
