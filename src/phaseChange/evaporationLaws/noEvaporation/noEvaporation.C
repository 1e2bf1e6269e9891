/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "noEvaporation.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace evaporationLaws
{
    defineTypeName(noEvaporation);
    addToRunTimeSelectionTable(evaporationLaw, noEvaporation, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::evaporationLaws::noEvaporation::noEvaporation
(
    const dictionary& dict,
    const liquidMixture&,
    const gasMixture&
)
{
    userEntry::onlyThese(dict, {"type"});
}



// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::filmFlux Foam::dew::evaporationLaws::noEvaporation::flux
(
    const gasFilm&
) const
{
    return filmFlux();
}


void Foam::dew::evaporationLaws::noEvaporation::fluxes
(
    const gasFilm& film,
    speciesFlux& all
) const
{
    all.N = 0;
    all.dNdY = 0;
    all.dNdTs = 0;
    all.dNdX = 0;
    all.Xs = film.X;
}


// ************************************************************************* //
