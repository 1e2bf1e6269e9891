/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "diffusion.H"
#include "addToRunTimeSelectionTable.H"
#include "speciesFilm.H"
#include "stefanFlux.H"
#include "Switch.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace evaporationLaws
{
    defineTypeName(diffusion);
    addToRunTimeSelectionTable(evaporationLaw, diffusion, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::evaporationLaws::diffusion::diffusion
(
    const dictionary& dict,
    const liquidMixture& liquids,
    const gasMixture& gas
)
:
    diffusion(dict, liquids, gas, false)
{
    userEntry::onlyThese(dict, {"type", "stefanFlow"});
}


Foam::dew::evaporationLaws::diffusion::diffusion
(
    const dictionary& dict,
    const liquidMixture& liquids,
    const gasMixture& gas,
    const bool linear
)
:
    liquids_(liquids),
    gas_(gas),
    linear_(linear),
    mass_(linear || gas.uniformDensity()),
    stefanFlow_(dict.getOrDefault<Switch>("stefanFlow", true)),
    equilibrium_(liquids),
    pure_(liquids.size(), 1.0),
    x_(liquids.size()),
    g_(x_),
    y_(x_),
    ys_(x_),
    dysdT_(x_),
    Ym_(x_)
{
    setPressure(gas.p0());
}



// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::evaporationLaws::diffusion::setPressure(const scalar p)
{
    p_ = p;
    TsMax_ = 0;
    for (const liquidModel& liquid : liquids_.liquids())
    {
        TsMax_ = max(TsMax_, liquid.Tboil(p));
    }
}


Foam::dew::filmFlux Foam::dew::evaporationLaws::diffusion::flux
(
    const gasFilm& film
) const
{
    // Differences of the properties over the film are of second order
    const scalar Tf = 0.5*(film.T + film.Ts);

    const scalar Y = film.Y[0];
    equilibrium_.partialPressures(p_, film.Ts, pure_, y_);
    equilibrium_.dpdT(p_, film.Ts, pure_, dysdT_);
    const scalar xs = y_[0]/p_;
    const scalar dxsdT = dysdT_[0]/p_;

    // Fractions, derivatives by Y and T, and conductance in the form that is
    // exact for the gas
    const scalar y = mass_ ? Y : gas_.x(Y);
    const scalar ys = mass_ ? gas_.Y(xs) : xs;
    const scalar dydY = mass_ ? 1 : gas_.dxdY(Y);
    const scalar dysdT = mass_ ? gas_.dYdx(xs)*dxsdT : dxsdT;
    const scalar g =
        across(film)
       *(
            mass_
          ? stefanFlux::massConductance
            (
                gas_.rho(p_, Tf, film.Y), gas_.DY(0, p_, Tf, film.Y), film.L
            )
          : stefanFlux::moleConductance
            (
                p_, Tf, gas_.DY(0, p_, Tf, film.Y), film.L, gas_.W(0)
            )
        );

    filmFlux f;
    if (stefanFlow_ && linear_)
    {
        f.N = stefanFlux::surfaceFlux(g, y, ys);
        f.dNdY = -g/(1 - ys)*dydY;
        f.dNdTs = stefanFlux::dSurfaceFluxdys(g, y, ys)*dysdT;
    }
    else if (stefanFlow_)
    {
        f.N = stefanFlux::flux(g, y, ys);
        f.dNdY = stefanFlux::dFluxdy(g, y)*dydY;
        f.dNdTs = stefanFlux::dFluxdys(g, ys)*dysdT;
    }
    else
    {
        f.N = stefanFlux::fickFlux(g, y, ys);
        f.dNdY = -g*dydY;
        f.dNdTs = g*dysdT;
    }
    return f;
}


// ************************************************************************* //
