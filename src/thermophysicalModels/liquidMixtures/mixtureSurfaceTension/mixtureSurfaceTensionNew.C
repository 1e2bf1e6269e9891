/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "mixtureSurfaceTension.H"
#include "selectVariant.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::mixtureSurfaceTension>
Foam::dew::mixtureSurfaceTension::New
(
    const dictionary& dict,
    const wordList& names,
    const PtrList<liquidModel>& liquids
)
{
    return
        selectVariant<mixtureSurfaceTension>
        (
            dict, "type", "surface tension"
        )(dict, names, liquids);
}
