/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "levelSetCSF.H"
#include "addToRunTimeSelectionTable.H"
#include "cellWidth.H"
#include "fvcSnGrad.H"
#include "mathematicalConstants.H"
#include "transportedSurface.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace surfaceTensionForceModels
{
    defineTypeName(levelSetCSF);
    addToRunTimeSelectionTable
    (
        surfaceTensionForceModel, levelSetCSF, dictionary
    );
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::surfaceTensionForceModels::levelSetCSF::levelSetCSF
(
    const transportedSurface& surface,
    const dictionary&
)
:
    surfaceTensionForceModel(surface)
{}


// * * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * //

Foam::tmp<Foam::volScalarField>
Foam::dew::surfaceTensionForceModels::levelSetCSF::step() const
{
    const fvMesh& mesh = surface_.mesh();
    const scalarField& psi = surface_.psi().primitiveField();
    const vectorField& n = surface_.n().primitiveField();
    const scalarField& width = cellWidth::of(mesh);
    const scalar pi = constant::mathematical::pi;

    tmp<volScalarField> tstep
    (
        new volScalarField
        (
            IOobject("step", mesh.time().timeName(), mesh),
            mesh,
            dimensionedScalar(dimless, Zero),
            zeroGradientFvPatchScalarField::typeName
        )
    );
    volScalarField& step = tstep.ref();
    forAll(psi, celli)
    {
        const scalar eps = 1.5*width[celli];
        if (mag(psi[celli]) >= eps || n[celli] == vector(Zero))
        {
            step[celli] = psi[celli] > 0 ? 1 : 0;
            continue;
        }
        const scalar p = psi[celli]/eps;
        step[celli] = 0.5*(1 + p + Foam::sin(pi*p)/pi);
    }
    step.correctBoundaryConditions();
    return tstep;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField>
Foam::dew::surfaceTensionForceModels::levelSetCSF::snGrad() const
{
    return fvc::snGrad(step());
}
