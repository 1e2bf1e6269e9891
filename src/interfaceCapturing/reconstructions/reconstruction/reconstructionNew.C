/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "reconstruction.H"
#include "selectVariant.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::reconstruction> Foam::dew::reconstruction::New
(
    const fvMesh& mesh,
    const contactAngles& angles,
    const dictionary& surfaceProperties
)
{
    const dictionary& dict =
        userEntry::optionalDict(surfaceProperties, "reconstruction");

    return selectVariant<reconstruction>
    (
        dict, "type", "reconstruction", "PLIC"
    )
    (
        mesh, angles, dict
    );
}
