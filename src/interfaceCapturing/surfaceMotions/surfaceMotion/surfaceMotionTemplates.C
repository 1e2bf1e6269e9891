/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "selectVariant.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

template<class Kind>
Foam::autoPtr<Kind> Foam::dew::surfaceMotion::New
(
    const fvMesh& mesh,
    const dictionary& surfaceProperties
)
{
    const dictionary& dict =
        userEntry::subDict(surfaceProperties, "surfaceMotion");

    autoPtr<surfaceMotion> motion
    (
        selectVariant<surfaceMotion>(dict, "type", "surface motion")
        (
            mesh, surfaceProperties
        )
    );

    if (!isA<Kind>(motion()))
    {
        FatalIOErrorInFunction(dict)
            << "surfaceMotion " << motion->type() << " is not a "
            << Kind::typeName << ", which this solver needs" << nl
            << Kind::solvers << exit(FatalIOError);
    }

    return autoPtr<Kind>(&refCast<Kind>(*motion.release()));
}
