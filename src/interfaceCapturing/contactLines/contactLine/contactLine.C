/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactLine.H"
#include "selectVariant.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(contactLine);
    defineRunTimeSelectionTable(contactLine, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::contactLine> Foam::dew::contactLine::New
(
    const dictionary& dict,
    const scalar startAngle
)
{
    return selectVariant<contactLine>(dict, "type", "contact line")
    (
        dict, startAngle
    );
}
