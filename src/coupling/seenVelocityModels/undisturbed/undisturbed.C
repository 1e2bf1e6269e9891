/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "undisturbed.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace seenVelocityModels
{
    defineTypeName(undisturbed);
    addToRunTimeSelectionTable(seenVelocityModel, undisturbed, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::seenVelocityModels::undisturbed::undisturbed
(
    const dictionary& dict
)
:
    width_
    (
        dict.found("width")
      ? userEntry::positive(dict, "width", dimLength)
      : 0
    )
{
    userEntry::onlyThese(dict, {"type", "width"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::seenVelocityModels::undisturbed::correct
(
    const particle& p,
    carrier& c
) const
{
    const scalar h = width_ > 0 ? width_ : cbrt(c.spread);
    const scalar Re = c.rho*mag(c.U - p.U)*h/c.mu;

    // Velocity over force, and the time it takes
    const scalar mobility =
        1/(6*constant::mathematical::pi*c.mu*0.315*h*(1 + Re/3));
    const scalar tau = mobility*c.rho*pow3(h);

    scalar* m = p.memory;
    vector u(m[velocity], m[velocity + 1], m[velocity + 2]);
    u += (1 - exp(-m[step]/tau))*(-mobility*p.F - u);

    m[velocity] = u.x();
    m[velocity + 1] = u.y();
    m[velocity + 2] = u.z();
    m[step] = c.deltaT;

    c.U -= u;
}
