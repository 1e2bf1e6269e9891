/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "MagnusLift.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace particleForces
{
    defineTypeName(MagnusLift);
    addToRunTimeSelectionTable(particleForce, MagnusLift, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleForces::MagnusLift::MagnusLift(const dictionary& dict)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::forceSuSp Foam::dew::particleForces::MagnusLift::force
(
    const particle& p,
    const carrier& c
) const
{
    const vector W(p.omega - 0.5*c.motion.vorticity());
    const scalar Re = c.rho*mag(c.U - p.U)*p.d/c.mu;
    const scalar Rer = c.rho*mag(W)*sqr(p.d)/c.mu;

    forceSuSp f;
    if (Re <= 0 || Rer <= 0)
    {
        return f;
    }

    // high + (1 - high) exp(-e), where high may be far above 1
    const scalar high = 0.45*Re/Rer;
    const scalar e = 0.05684*pow(Rer, 0.4)*pow(Re, 0.3);
    const scalar correction = exp(-e) - high*std::expm1(-e);

    f.Su =
        constant::mathematical::pi/8*c.rho*pow3(p.d)*correction
       *(W ^ (p.U - c.U));
    return f;
}
