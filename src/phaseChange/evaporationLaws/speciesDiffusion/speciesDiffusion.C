/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "speciesDiffusion.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace evaporationLaws
{
    defineTypeName(speciesDiffusion);
    addToRunTimeSelectionTable(evaporationLaw, speciesDiffusion, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::evaporationLaws::speciesDiffusion::speciesDiffusion
(
    const dictionary& dict,
    const liquidMixture& liquids,
    const gasMixture& gas
)
:
    diffusion(dict, liquids, gas, true)
{
    userEntry::onlyThese(dict, {"type", "stefanFlow"});
}


// ************************************************************************* //
