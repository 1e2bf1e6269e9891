/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "curvatureModel.H"
#include "alongInterface.H"
#include "transportedSurface.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(curvatureModel);
    defineRunTimeSelectionTable(curvatureModel, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Weight of full and empty cells with the surface between them
constexpr Foam::scalar least = 1e-9;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::curvatureModel::curvatureModel(const transportedSurface& surface)
:
    layer_
    (
        IOobject
        (
            "interfaceLayer", surface.mesh().time().timeName(), surface.mesh()
        ),
        surface.mesh(),
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    ),
    Kf_
    (
        IOobject
        (
            "Kf", surface.mesh().time().timeName(), surface.mesh(),
            IOobject::NO_READ, IOobject::NO_WRITE, false
        ),
        surface.mesh(),
        dimensionedScalar(dimless/dimLength, Zero)
    ),
    surface_(surface)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::curvatureModel::correct(volScalarField& curvature)
{
    boolList known(curvature.size(), false);

    calculate(curvature.primitiveFieldRef(), known);
    alongInterface::extend(curvature, known, layer_);

    // As large as the mesh is now
    Kf_ =
        surfaceScalarField::New
        (
            "Kf", surface_.mesh(), dimensionedScalar(Kf_.dimensions(), Zero)
        );
    if (shareCounts())
    {
        // One that the surface has just come to has no say yet
        volScalarField weight("interfaceWeight", layer_);
        const scalarField& share = surface_.alpha().primitiveField();
        forAll(share, celli)
        {
            weight[celli] = max(share[celli]*(1 - share[celli]), least);
        }
        weight.correctBoundaryConditions();
        alongInterface::toFaces(curvature, layer_, weight, Kf_);
    }
    else
    {
        alongInterface::toFaces(curvature, layer_, Kf_);
    }

    curvature *= 0.5;
}
