/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "surfaceTensionLaw.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(surfaceTensionLaw);
    defineRunTimeSelectionTable(surfaceTensionLaw, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::surfaceTensionLaw::surfaceTensionLaw
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    mesh_(mesh),
    field_(dict.getOrDefault<word>("field", "T"))
{
    if (mesh.foundObject<volScalarField>(field_))
    {
        return;
    }

    IOobject io
    (
        field_, mesh.time().timeName(), mesh, IOobject::MUST_READ,
        IOobject::AUTO_WRITE
    );
    if (!io.typeHeaderOk<volScalarField>(true))
    {
        FatalIOErrorInFunction(dict)
            << "The surface tension depends on the field " << field_
            << ", which is not in this run, and there is no volScalarField "
            << io.objectPath() << nl
            << "Write that file, or name another one by 'field' in "
            << dict.dictName() << exit(FatalIOError);
    }

    auto* X = new volScalarField(io, mesh);
    // A cut of a cyclic may have left other values beyond it
    X->correctBoundaryConditions();
    regIOobject::store(X);
}
