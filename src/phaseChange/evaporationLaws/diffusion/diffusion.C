/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "diffusion.H"
#include "addToRunTimeSelectionTable.H"
#include "gasModel.H"
#include "liquidModel.H"
#include "vapourDiffusion.H"
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

    const scalar xs = liquid_.pSat(film.Ts)/gas_.p0();
    const scalar dxsdT = liquid_.dpSatdT(film.Ts)/gas_.p0();

    filmFlux f;
    if (gas_.uniformDensity())
    {
        const scalar g = gas_.rho(film.Y, Tf)*gas_.D(Tf)/film.L;
        const scalar Ys = gas_.Y(xs);

        f.N = g*filmDrive(film.Y, Ys, stefanFlow_);
        f.dNdY = -g*filmSlope(film.Y, stefanFlow_);
        f.dNdTs = g*filmSlope(Ys, stefanFlow_)*gas_.dYdx(xs)*dxsdT;
    }
    else
    {
        const scalar g = molarDiffusion(gas_, Tf)/film.L;
        const scalar x = gas_.x(film.Y);

        f.N = g*filmDrive(x, xs, stefanFlow_);
        f.dNdY = -g*filmSlope(x, stefanFlow_)*gas_.dxdY(film.Y);
        f.dNdTs = g*filmSlope(xs, stefanFlow_)*dxsdT;
    }
    return f;
}


// ************************************************************************* //
