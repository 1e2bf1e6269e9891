/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "liquidDiffusivity.H"
#include "selectVariant.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::liquidDiffusivity>
Foam::dew::liquidDiffusivity::New
(
    const dictionary& dict,
    const PtrList<liquidModel>& liquids
)
{
    return
        selectVariant<liquidDiffusivity>(dict, "type", "diffusivity")
        (
            dict, liquids
        );
}
