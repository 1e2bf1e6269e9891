/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "densityScaledCSF.H"
#include "addToRunTimeSelectionTable.H"
#include "fvcSnGrad.H"
#include "surfaceFields.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace surfaceTensionForceModels
{
    defineTypeName(densityScaledCSF);
    addToRunTimeSelectionTable
    (
        surfaceTensionForceModel, densityScaledCSF, dictionary
    );
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::surfaceTensionForceModels::densityScaledCSF::densityScaledCSF
(
    const transportedSurface& surface,
    const dictionary& dict
)
:
    levelSetCSF(surface, dict)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField>
Foam::dew::surfaceTensionForceModels::densityScaledCSF::snGrad() const
{
    return fvc::snGrad(sqr(step()));
}
