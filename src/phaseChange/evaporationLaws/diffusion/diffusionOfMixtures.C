/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Fluxes of several vapours

#include "diffusion.H"
#include "gasConstant.H"
#include "speciesFilm.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::evaporationLaws::diffusion::prepare(const gasFilm& film) const
{
    // Properties in the middle of the film, of its end and the surface
    const scalar Tf = 0.5*(film.T + film.Ts);
    if (mass_)
    {
        y_ = film.Y;
    }
    else
    {
        gas_.moleFractions(film.Y, y_);
    }
    gas_.DY(p_, Tf, film.Y, g_);
    const scalar density =
        mass_ ? gas_.rho(p_, Tf, film.Y) : p_/(gasConstant*Tf);
    forAll(g_, i)
    {
        g_[i] *= across(film)*density/film.L;
    }
}


bool Foam::dew::evaporationLaws::diffusion::saturate
(
    const scalar Ts,
    const UList<scalar>& Xs
) const
{
    liquids_.moleFractions(Xs, x_);
    equilibrium_.partialPressures(p_, Ts, x_, ys_);
    scalar sum = 0;
    forAll(ys_, i)
    {
        ys_[i] /= p_;
        sum += ys_[i];
    }
    if (mass_)
    {
        Ym_ = ys_;
        gas_.massFractions(Ym_, ys_);
    }
    return sum < 1 - 1e-12;
}


Foam::scalar Foam::dew::evaporationLaws::diffusion::total
(
    const scalar n
) const
{
    scalar N = 0;
    forAll(g_, i)
    {
        N += massOf(i)*speciesFilm::flux(g_[i], y_[i], ys_[i], n, linear_);
    }
    return N;
}


Foam::scalar Foam::dew::evaporationLaws::diffusion::balance
(
    const gasFilm& film,
    const scalar n,
    UList<scalar>& Xs
) const
{
    const scalar N = total(n);

    // N_i = leaving Xs_i - entering, with the volatility of the present Xs
    scalar sum = 0;
    forAll(g_, i)
    {
        const scalar g = massOf(i)*g_[i]*speciesFilm::bernoulli(n/g_[i], linear_);
        const scalar leaving =
            (g + massOf(i)*n)*ys_[i]/max(Xs[i], VSMALL);
        Ym_[i] =
            ((film.gL[i] + max(N, scalar(0)))*film.X[i] + g*y_[i])
           /(film.gL[i] + max(-N, scalar(0)) + leaving);
        sum += Ym_[i];
    }
    scalar change = 0;
    forAll(g_, i)
    {
        const scalar next = max(Ym_[i]/sum, 1e-60);
        change = max(change, mag(next - Xs[i]));
        Xs[i] = next;
    }
    return change;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::evaporationLaws::diffusion::fluxes
(
    const gasFilm& film,
    speciesFlux& all
) const
{
    if (g_.size() == 1)
    {
        evaporationLaw::fluxes(film, all);
        return;
    }

    prepare(film);
    const bool mixed = film.gL[0] > 0.1*GREAT;
    if (mixed)
    {
        all.Xs = film.X;
    }
    scalar n = 0;
    for (label iter = 0; iter < 200; iter++)
    {
        if (!saturate(film.Ts, all.Xs))
        {
            // Boiling: no film resists, and heat is what there is too little of
            all.N = all.Xs*ROOTVGREAT;
            all.dNdY = 0;
            all.dNdTs = 0;
            all.dNdX = 0;
            return;
        }
        if (stefanFlow_)
        {
            n = speciesFilm::total(g_, y_, ys_, linear_);
        }
        if (mixed || balance(film, n, all.Xs) < 1e-13)
        {
            break;
        }
    }

    equilibrium_.dpdT(p_, film.Ts, x_, dysdT_);
    dysdT_ /= p_;
    if (mass_)
    {
        // Of mole fractions before
        scalar dW = 0;
        forAll(g_, i)
        {
            dW += (gas_.W(i) - gas_.Wc())*dysdT_[i];
        }
        const scalar mean = gas_.W(ys_);
        forAll(g_, i)
        {
            dysdT_[i] = (gas_.W(i)*dysdT_[i] - ys_[i]*dW)/mean;
        }
    }
    scalar dndTs = 0;
    if (stefanFlow_)
    {
        forAll(g_, i)
        {
            dndTs +=
                (g_[i]*speciesFilm::bernoulli(n/g_[i], linear_) + n)*dysdT_[i];
        }
        dndTs /= -speciesFilm::slope(g_, y_, ys_, n, linear_);
    }
    const scalar W = gas_.W(film.Y);
    const scalar N = max(total(n), scalar(0));
    forAll(g_, i)
    {
        const scalar P = n/g_[i];
        const scalar g = g_[i]*speciesFilm::bernoulli(P, linear_);
        const scalar mass = massOf(i);
        all.N[i] = mass*speciesFilm::flux(g_[i], y_[i], ys_[i], n, linear_);
        all.dNdTs[i] =
            mass
           *(
                (g + n)*dysdT_[i]
              + (
                    speciesFilm::dBernoulli(P, linear_)*(ys_[i] - y_[i])
                  + ys_[i]
                )*dndTs
            );
        const scalar dydY =
            mass_
          ? 1
          : W/gas_.W(i)*(1 - film.Y[i]*W*(1/gas_.W(i) - 1/gas_.Wc()));
        all.dNdY[i] = -mass*g*dydY;
        all.dNdX[i] = mass*(g + n)*ys_[i]/max(all.Xs[i], VSMALL);

        if (!mixed)
        {
            // The film of the liquid gives way, too: in the composition, not in
            // the sum, so dNdY stays that of the gas
            const scalar leaving = all.dNdX[i];
            all.dNdX[i] = leaving*(film.gL[i] + N)/(film.gL[i] + leaving);
        }
    }
}


// ************************************************************************* //
