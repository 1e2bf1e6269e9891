/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "CSF.H"
#include "addToRunTimeSelectionTable.H"
#include "fvcSnGrad.H"
#include "transportedSurface.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace surfaceTensionForceModels
{
    defineTypeName(CSF);
    addToRunTimeSelectionTable(surfaceTensionForceModel, CSF, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::surfaceTensionForceModels::CSF::CSF
(
    const transportedSurface& surface,
    const dictionary&
)
:
    surfaceTensionForceModel(surface)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField>
Foam::dew::surfaceTensionForceModels::CSF::snGrad() const
{
    return fvc::snGrad(surface_.alpha());
}
