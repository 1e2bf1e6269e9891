/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "smoothing.H"
#include "noSmoothing.H"
#include "selectVariant.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::smoothing> Foam::dew::smoothing::New
(
    const dictionary& coupling,
    const fvMesh& mesh
)
{
    if (!coupling.found("smoothing"))
    {
        return autoPtr<smoothing>(new noSmoothing);
    }

    const dictionary& dict = userEntry::subDict(coupling, "smoothing");

    return selectVariant<smoothing>(dict, "type", "smoothing")(dict, mesh);
}
