/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "surfaceFilmEntries.H"
#include "Enum.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;
using namespace Foam::dew;

//- Of a law that begins above the least thickness
scalar readRange(const dictionary& dict, const scalar hMin)
{
    const scalar range = userEntry::positive(dict, "range", dimLength);
    if (range <= hMin)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'range' in " << dict.dictName() << " is " << range
            << " m, not above minThickness " << hMin << " m: it would never"
            << " act" << nl << "Raise it, or lower minThickness"
            << exit(FatalIOError);
    }
    return range;
}


scalar notZero
(
    const dictionary& dict,
    const word& key,
    const dimensionSet& dims
)
{
    const scalar value = userEntry::number(dict, key, dims);
    if (value == 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' in " << dict.dictName() << " is 0: there"
            << " would be no force" << nl
            << "Give its value, or remove " << dict.dictName()
            << exit(FatalIOError);
    }
    return value;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::dew::surfaceFilm Foam::dew::readSurfaceFilm
(
    const dictionary& dict,
    const wordList& others
)
{
    wordList known
    ({
        "minThickness", "drainage", "vanDerWaals", "hydrophobic"
    });
    known.append(others);
    userEntry::onlyThese(dict, known);

    surfaceFilm film;
    film.hMin = userEntry::positive(dict, "minThickness", dimLength);

    if (dict.found("drainage"))
    {
        const dictionary& law = userEntry::subDict(dict, "drainage");
        userEntry::onlyThese(law, {"surface", "range"});
        const bool mobile =
            Enum<bool>({{false, "rigid"}, {true, "mobile"}})
           .get("surface", law);
        film.share = mobile ? 0.25 : 1;
        film.hMax = readRange(law, film.hMin);
    }
    if (dict.found("vanDerWaals"))
    {
        const dictionary& law = userEntry::subDict(dict, "vanDerWaals");
        userEntry::onlyThese(law, {"HamakerConstant", "range"});
        film.H = notZero(law, "HamakerConstant", dimEnergy);
        film.rangeH = readRange(law, film.hMin);
    }
    if (dict.found("hydrophobic"))
    {
        const dictionary& law = userEntry::subDict(dict, "hydrophobic");
        userEntry::onlyThese(law, {"strength", "range"});
        film.K = notZero(law, "strength", dimEnergy);
        film.rangeK = readRange(law, film.hMin);
    }

    if (film.reach() == 0)
    {
        FatalIOErrorInFunction(dict)
            << "The film " << dict.dictName() << " has no law" << nl
            << "Add drainage, vanDerWaals or hydrophobic, or remove it"
            << exit(FatalIOError);
    }
    return film;
}
