/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "Fuller.H"
#include "addToRunTimeSelectionTable.H"
#include "speciesData.H"
#include "userEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace binaryDiffusivities
{
    defineTypeName(Fuller);
    addToRunTimeSelectionTable(binaryDiffusivity, Fuller, dictionary);
}
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

scalar volume(const dictionary& dict, const word& name)
{
    const dictionary& volumes = dew::userEntry::optionalDict(dict, "volumes");
    return
        volumes.found(name)
      ? dew::userEntry::positive(volumes, name, dimless)
      : dew::speciesData::get(name, "diffusion volume", dict).volume;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::binaryDiffusivities::Fuller::Fuller
(
    const dictionary& dict,
    const pureGas::part& a,
    const pureGas::part& b
)
{
    userEntry::onlyThese(dict, {"type", "volumes", "pairs"});

    const scalar M = 2e3/(1/a.W + 1/b.W);
    const scalar sum =
        std::cbrt(volume(dict, a.name)) + std::cbrt(volume(dict, b.name));
    factor_ = 0.0143/(std::sqrt(M)*sqr(sum));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::binaryDiffusivities::Fuller::D
(
    const scalar p,
    const scalar T
) const
{
    return factor_*std::pow(T, 1.75)/p;
}
