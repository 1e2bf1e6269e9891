/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "diffusion.H"
#include "addToRunTimeSelectionTable.H"
#include "gasMixture.H"
#include "saturation.H"
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
    liquids_(liquids),
    gas_(gas),
    stefanFlow_(dict.getOrDefault<Switch>("stefanFlow", true))
{
    correct(gas.p0());
    userEntry::onlyThese(dict, {"type", "stefanFlow"});
    pureLiquid(dict, liquids);
}



// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::evaporationLaws::diffusion::correct(const scalar p)
{
    p_ = p;
    TsMax_ = liquids_.liquid(0).Tboil(p);
}


Foam::dew::filmFlux Foam::dew::evaporationLaws::diffusion::flux
(
    const gasFilm& film
) const
{
    // Differences of the properties over the film are of second order
    const scalar Tf = 0.5*(film.T + film.Ts);

    const liquidModel& liquid = liquids_.liquid(0);
    const scalar Y = film.Y[0];
    const scalar xs = saturation::xs(liquid, p_, film.Ts);
    const scalar dxsdT = saturation::dxsdT(liquid, p_, film.Ts);

    // Fractions, derivatives by Y and T, and conductance in the form that is
    // exact for the gas
    const bool mass = gas_.uniformDensity();
    const scalar y = mass ? Y : gas_.x(Y);
    const scalar ys = mass ? gas_.Y(xs) : xs;
    const scalar dydY = mass ? 1 : gas_.dxdY(Y);
    const scalar dysdT = mass ? gas_.dYdx(xs)*dxsdT : dxsdT;
    const scalar g =
        mass
      ? stefanFlux::massConductance
        (
            gas_.rho(p_, Tf, film.Y), gas_.DY(0, p_, Tf, film.Y), film.L
        )
      : stefanFlux::moleConductance
        (
            p_, Tf, gas_.DY(0, p_, Tf, film.Y), film.L, gas_.W(0)
        );

    filmFlux f;
    if (stefanFlow_)
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
