/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "lubricationProperties.H"
#include "engineText.H"
#include "userEntry.H"

// Largest gap over r*, without an entry
static const Foam::scalar usualGap = 0.1;

// The engine's lists reach further than the gaps by this
static const Foam::scalar margin = 1.1;


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::lubricationProperties::lubricationProperties
(
    const dictionary& properties,
    const scalar smallest,
    const scalar largest
)
:
    on_(properties.found("lubrication")),
    mu_(0),
    minGap_(0),
    maxGap_(0),
    smallest_(smallest),
    largest_(largest)
{
    if (!on_)
    {
        return;
    }

    const dictionary& dict = userEntry::subDict(properties, "lubrication");
    userEntry::onlyThese(dict, {"viscosity", "minGap", "maxGap"});

    mu_ = userEntry::positive(dict, "viscosity", dimDynamicViscosity);
    minGap_ = userEntry::positive(dict, "minGap", dimLength);
    if (dict.found("maxGap"))
    {
        maxGap_ = userEntry::positive(dict, "maxGap", dimLength);
    }

    if (maxGap_ > smallest)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'maxGap' in " << dict.dictName() << " is " << maxGap_
            << " m, more than the smallest radius " << smallest << " m: the"
            << " law holds for gaps that are small against it" << nl
            << "Lower it, a tenth of the radius is usual"
            << exit(FatalIOError);
    }

    const scalar least = maxGap_ > 0 ? maxGap_ : usualGap*0.5*smallest;
    if (minGap_ >= least)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'minGap' in " << dict.dictName() << " is " << minGap_
            << " m, not below the largest gap " << least << " m"
            << (maxGap_ > 0 ? "" : " (0.1 r* of the smallest particles)") << nl
            << "Lower minGap, or raise maxGap"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::lubricationProperties::maxGap() const
{
    return maxGap_ > 0 ? maxGap_ : usualGap*largest_;
}


Foam::scalar Foam::dew::lubricationProperties::reach() const
{
    // A wall's is counted in one radius
    return 1 + margin*(maxGap_ > 0 ? maxGap_/smallest_ : usualGap);
}


std::string Foam::dew::lubricationProperties::engineArguments
(
    const engineUnits& units
) const
{
    return
        engineText(mu_/(units.pressure()*units.time)) + ' '
      + engineText(minGap_/units.length) + ' '
      + engineText(maxGap_/units.length) + ' '
      + engineText(reach());
}
