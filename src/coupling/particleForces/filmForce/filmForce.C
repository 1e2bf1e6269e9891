/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "filmForce.H"
#include "addToRunTimeSelectionTable.H"
#include "surfaceFilmEntries.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace particleForces
{
    defineTypeName(filmForce);
    addToRunTimeSelectionTable(particleForce, filmForce, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleForces::filmForce::filmForce(const dictionary& dict)
:
    film_(readSurfaceFilm(dict, {"type"}))
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::forceSuSp Foam::dew::particleForces::filmForce::force
(
    const particle&,
    const carrier& c
) const
{
    // A film is liquid, also where the cell has gas as well
    forceSuSp f;
    f.filmViscosity = c.surface.mu1 > 0 ? c.surface.mu1 : c.mu;
    return f;
}
