/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fixedFlux.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace evaporationLaws
{
    defineTypeName(fixedFlux);
    addToRunTimeSelectionTable(evaporationLaw, fixedFlux, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::evaporationLaws::fixedFlux::fixedFlux
(
    const dictionary& dict,
    const liquidMixture&,
    const gasMixture&
)
:
    J_(userEntry::number(dict, "flux", dimMass/dimArea/dimTime))
{
    userEntry::onlyThese(dict, {"type", "flux"});
}



// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::filmFlux Foam::dew::evaporationLaws::fixedFlux::flux
(
    const gasFilm& film
) const
{
    filmFlux f;
    f.N = J_*film.cosine;
    return f;
}


void Foam::dew::evaporationLaws::fixedFlux::fluxes
(
    const gasFilm& film,
    speciesFlux& all
) const
{
    all.N = J_*film.cosine*film.X;
    all.dNdY = 0;
    all.dNdTs = 0;
    all.dNdX = mag(J_)*film.cosine;
    all.Xs = film.X;
}


// ************************************************************************* //
