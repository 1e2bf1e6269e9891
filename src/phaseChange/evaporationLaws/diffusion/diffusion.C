/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "diffusion.H"
#include "addToRunTimeSelectionTable.H"
#include "gasModel.H"
#include "liquidModel.H"
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
    const liquidModel& liquid,
    const gasModel& gas
)
:
    liquid_(liquid),
    gas_(gas),
    stefanFlow_(dict.getOrDefault<Switch>("stefanFlow", true)),
    TsMax_(liquid.Tboil(gas.p0()))
{
    userEntry::onlyThese(dict, {"type", "stefanFlow"});
}



// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::filmFlux Foam::dew::evaporationLaws::diffusion::flux
(
    const gasFilm& film
) const
{
    // Differences of the properties over the film are of second order
    const scalar Tf = 0.5*(film.T + film.Ts);

    const scalar xs = saturation::xs(liquid_, gas_, film.Ts);
    const scalar dxsdT = saturation::dxsdT(liquid_, gas_, film.Ts);

    // Fractions, derivatives by Y and T, and conductance in the form that is
    // exact for the gas
    const bool mass = gas_.uniformDensity();
    const scalar y = mass ? film.Y : gas_.x(film.Y);
    const scalar ys = mass ? gas_.Y(xs) : xs;
    const scalar dydY = mass ? 1 : gas_.dxdY(film.Y);
    const scalar dysdT = mass ? gas_.dYdx(xs)*dxsdT : dxsdT;
    const scalar g =
        mass
      ? stefanFlux::massConductance
        (
            gas_.rho(film.Y, Tf), gas_.D(Tf), film.L
        )
      : stefanFlux::moleConductance
        (
            gas_.p0(), Tf, gas_.D(Tf), film.L, gas_.Wv()
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
