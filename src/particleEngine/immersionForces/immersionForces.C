/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "immersionForces.H"
#include "engineText.H"
#include "particleBox.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::immersionForces::immersionForces
(
    const dictionary& dict,
    const particleBox& box,
    const scalar largestDiameter
)
:
    dict_(dict),
    length_(userEntry::positive(dict, "capillaryLength", dimLength)),
    cutOff_(userEntry::positive(dict, "cutOff", dimLength)),
    largest_(largestDiameter)
{
    userEntry::onlyThese(dict, {"capillaryLength", "cutOff"});

    if (cutOff_ <= largest_)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'cutOff' in " << dict.dictName() << " is " << cutOff_
            << " m, not above the largest diameter " << largest_
            << " m: particles would touch before they attract" << nl
            << "Raise it to a few diameters"
            << exit(FatalIOError);
    }
    box.refuseRange(dict, "cutOff", cutOff_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::immersionForces::range() const
{
    // Both are cut by the surface: that is how far one may be above another
    return Foam::hypot(cutOff_, largest_);
}


void Foam::dew::immersionForces::refuse() const
{
    FatalIOErrorInFunction(dict_)
        << "Entry 'immersion' needs the surface of a liquid with tension and"
        << " contact angle, and there is none" << nl
        << "Give surfaceTension and contactAngle to fluid.surface (demFoam), or"
        << " add the law capillaryForce to coupling.forces; or remove the entry"
        << exit(FatalIOError);
}


std::string Foam::dew::immersionForces::engineArguments
(
    const engineUnits& units
) const
{
    return
        engineText(units.length/length_) + ' '
      + engineText(cutOff_/units.length);
}
