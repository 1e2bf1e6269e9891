/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "evaporationLaw.H"
#include "liquidMixture.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeNameAndDebug(evaporationLaw, 0);
    defineRunTimeSelectionTable(evaporationLaw, dictionary);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::dew::evaporationLaw::pureLiquid
(
    const dictionary& dict,
    const liquidMixture& liquids
)
{
    if (liquids.size() != 1)
    {
        FatalIOErrorInFunction(dict)
            << "Evaporation by " << dict.get<word>("type") << " is that of a"
            << " liquid in its pure vapour, and constant/liquidProperties has "
            << liquids.names() << nl
            << "Give one liquid, or use 'evaporation { type diffusion; }'"
            << exit(FatalIOError);
    }
}


// ************************************************************************* //
