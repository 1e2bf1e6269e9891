/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "SaffmanMeiLift.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace particleForces
{
    defineTypeName(SaffmanMeiLift);
    addToRunTimeSelectionTable(particleForce, SaffmanMeiLift, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleForces::SaffmanMeiLift::SaffmanMeiLift
(
    const dictionary& dict
)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::forceSuSp Foam::dew::particleForces::SaffmanMeiLift::force
(
    const particle& p,
    const carrier& c
) const
{
    const vector w(c.motion.vorticity());
    const vector slip(c.U - p.U);
    const scalar Re = c.rho*mag(slip)*p.d/c.mu;
    const scalar Res = c.rho*mag(w)*sqr(p.d)/c.mu;

    forceSuSp f;
    if (Re <= 0 || Res <= 0)
    {
        return f;
    }

    const scalar b = 0.5*Res/Re;
    const scalar correction =
        Re <= 40
      ? (1 - 0.3314*sqrt(b))*exp(-0.1*Re) + 0.3314*sqrt(b)
      : 0.0524*sqrt(b*Re);

    f.Su = 1.615*sqr(p.d)*sqrt(c.rho*c.mu/mag(w))*correction*(slip ^ w);
    return f;
}
