/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "insertionRegion.H"
#include "selectVariant.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(insertionRegion);
    defineRunTimeSelectionTable(insertionRegion, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::insertionRegion> Foam::dew::insertionRegion::New(const dictionary& dict)
{
    return selectVariant<insertionRegion>(dict, "type", "region")(dict);
}
