/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "liquidShape.H"
#include "selectVariant.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::liquidShape> Foam::dew::liquidShape::New
(
    const Time& runTime,
    const meshSymmetry& symmetry,
    const dictionary& dict
)
{
    return selectVariant<liquidShape>(dict, "type", "liquid shape")
    (
        runTime, symmetry, dict
    );
}
