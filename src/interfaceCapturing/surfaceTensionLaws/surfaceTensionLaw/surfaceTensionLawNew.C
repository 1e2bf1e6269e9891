/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "surfaceTensionLaw.H"
#include "constantTension.H"
#include "selectVariant.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::surfaceTensionLaw> Foam::dew::surfaceTensionLaw::New
(
    const fvMesh& mesh,
    const dictionary& dict
)
{
    if (!dict.isDict("sigma"))
    {
        return autoPtr<surfaceTensionLaw>
        (
            new surfaceTensionLaws::constantTension
            (
                mesh, surfaceTensionLaws::constantTension::read(dict)
            )
        );
    }

    const dictionary& sigma = dict.subDict("sigma");

    return selectVariant<surfaceTensionLaw>
    (
        sigma, "type", "surface tension law"
    )
    (
        mesh, sigma
    );
}
