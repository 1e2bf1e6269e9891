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
    const scalar h = width_ > 0 ? width_ : cbrt(c.motion.cellVolume);
    const scalar a = 0.315*h;
    const scalar Re = c.rho*mag(c.U - p.U)*h/c.mu;

    c.U += p.F/(6*constant::mathematical::pi*c.mu*a*(1 + Re/3));
}
