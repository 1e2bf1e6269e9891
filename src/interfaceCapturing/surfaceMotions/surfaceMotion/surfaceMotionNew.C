/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "surfaceMotion.H"
#include "selectVariant.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::surfaceMotion> Foam::dew::surfaceMotion::New
(
    const fvMesh& mesh,
    const word& liquidName,
    const dictionary& surfaceProperties
)
{
    const dictionary& dict =
        userEntry::subDict(surfaceProperties, "surfaceMotion");

    return selectVariant<surfaceMotion>(dict, "type", "surface motion")
    (
        mesh, liquidName, dict
    );
}
