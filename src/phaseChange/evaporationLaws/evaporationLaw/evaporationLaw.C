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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::evaporationLaw::fluxes
(
    const gasFilm& film,
    speciesFlux& all
) const
{
    const filmFlux one(flux(film));
    all.N[0] = one.N;
    all.dNdY[0] = one.dNdY;
    all.dNdTs[0] = one.dNdTs;
    all.dNdX[0] = 0;
    all.Xs[0] = 1;
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
