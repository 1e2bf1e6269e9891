/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "wallMotion.H"
#include "selectVariant.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(wallMotion);
    defineRunTimeSelectionTable(wallMotion, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::wallMotion> Foam::dew::wallMotion::New
(
    const dictionary& wallDict
)
{
    dictionary atRest;
    atRest.add("type", word("none"));

    const dictionary& dict =
        wallDict.found("motion")
      ? userEntry::subDict(wallDict, "motion")
      : atRest;

    return selectVariant<wallMotion>(dict, "type", "wallMotion")(dict);
}
