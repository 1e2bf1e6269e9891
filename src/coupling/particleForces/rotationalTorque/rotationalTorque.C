/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "rotationalTorque.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace particleForces
{
    defineTypeName(rotationalTorque);
    addToRunTimeSelectionTable(particleForce, rotationalTorque, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleForces::rotationalTorque::rotationalTorque
(
    const dictionary& dict
)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::particleForces::rotationalTorque::Rer
(
    const particle& p,
    const carrier& c
)
{
    return
        c.rho*mag(0.5*c.motion.vorticity() - p.omega)*sqr(p.d)/c.mu;
}


Foam::dew::forceSuSp Foam::dew::particleForces::rotationalTorque::force
(
    const particle& p,
    const carrier& c
) const
{
    using constant::mathematical::pi;

    forceSuSp f;
    f.Tp =
        pi*c.mu*pow3(p.d)
       *max(scalar(1), (12.9*sqrt(Rer(p, c)) + 128.4)/(64*pi));
    return f;
}
