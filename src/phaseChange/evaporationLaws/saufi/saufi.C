/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "saufi.H"
#include "addToRunTimeSelectionTable.H"
#include "Enum.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace evaporationLaws
{
    defineTypeName(saufi);
    addToRunTimeSelectionTable(evaporationLaw, saufi, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::evaporationLaws::saufi::saufi
(
    const dictionary& dict,
    const liquidMixture& liquids,
    const gasMixture& gas
)
:
    diffusion(dict, liquids, gas, true),
    local_
    (
        Enum<bool>({{false, "global"}, {true, "local"}}).getOrDefault
        (
            "renormalise", dict, false
        )
    )
{
    userEntry::onlyThese(dict, {"type", "renormalise"});
}


// ************************************************************************* //
