/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactAngle.H"
#include "selectVariant.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(contactAngle);
    defineRunTimeSelectionTable(contactAngle, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::contactAngle> Foam::dew::contactAngle::New
(
    const dictionary& dict
)
{
    return selectVariant<contactAngle>(dict, "type", "contact angle")(dict);
}
