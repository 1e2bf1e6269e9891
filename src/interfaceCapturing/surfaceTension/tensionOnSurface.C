/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "tensionOnSurface.H"
#include "alongInterface.H"
#include "fvcGrad.H"
#include "surfaceInterpolate.H"
#include "transportedSurface.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const Foam::dimensionSet dimTension(Foam::dimForce/Foam::dimLength);

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dew::tensionOnSurface::sigma
(
    const scalar X,
    const point& x
) const
{
    const word& name = law_->field().name();

    if (!law_->range().contains(X))
    {
        FatalErrorInFunction
            << name << " on the surface is " << X << " at " << x
            << " m, and the surface tension is given from "
            << law_->range().min() << " to " << law_->range().max() << nl
            << "Extend sigma in surfaceTension of constant/surfaceProperties,"
            << " or correct the field " << name << exit(FatalError);
    }

    const scalar result = law_->sigma(X);
    if (!(result > 0))
    {
        FatalErrorInFunction
            << "Surface tension " << result << " N/m at " << x << " m, where "
            << name << " is " << X << nl
            << "It must be greater than zero: correct sigma in surfaceTension"
            << " of constant/surfaceProperties, or the field " << name
            << exit(FatalError);
    }
    return result;
}


Foam::scalar Foam::dew::tensionOnSurface::first() const
{
    const scalarField& alpha = surface_.alpha().primitiveField();

    scalar largest = 0;
    forAll(alpha, celli)
    {
        if (surface_.crossed(alpha[celli]))
        {
            largest =
                max(largest, sigma(law_->field()[celli], mesh_.C()[celli]));
        }
    }
    return returnReduce(largest, maxOp<scalar>());
}


void Foam::dew::tensionOnSurface::onPlanes(boolList& known)
{
    const interfacePlanes& planes = surface_.planes();
    const volScalarField& X = law_->field();
    const volVectorField gradX(fvc::grad(X));

    forAll(planes.cell(), i)
    {
        const label celli = planes.cell()[i];
        const vector& n = planes.n()[i];
        const vector& g = gradX[celli];
        const scalar value =
            X[celli] + (g & (planes.x()[i] - mesh_.C()[celli]));

        known[celli] = true;
        sigma_[celli] = sigma(value, planes.x()[i]);
        n_()[celli] = n;
        gradient_()[celli] = law_->slope(value)*(g - n*(n & g));
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::tensionOnSurface::tensionOnSurface
(
    const transportedSurface& surface,
    const dictionary& dict
)
:
    surface_(surface),
    mesh_(surface.mesh()),
    law_(surfaceTensionLaw::New(mesh_, dict)),
    sigma_
    (
        IOobject
        (
            "sigma", mesh_.time().timeName(), mesh_,
            varies() ? IOobject::READ_IF_PRESENT : IOobject::NO_READ,
            varies() ? IOobject::AUTO_WRITE : IOobject::NO_WRITE
        ),
        mesh_,
        dimensionedScalar
        (
            "sigma", dimTension, varies() ? first() : law_->sigma(0)
        )
    )
{
    if (varies())
    {
        const auto derived = [this](const word& name)
        {
            return IOobject(name, mesh_.time().timeName(), mesh_);
        };
        sigmaf_.reset
        (
            new surfaceScalarField
            (
                derived("surfaceTensionf"), fvc::interpolate(sigma_)
            )
        );
        n_.reset
        (
            new volVectorField
            (
                derived("surfaceTensionNormal"), mesh_,
                dimensionedVector(dimless, Zero)
            )
        );
        gradient_.reset
        (
            new volVectorField
            (
                derived("surfaceTensionGradient"), mesh_,
                dimensionedVector(dimTension/dimLength, Zero)
            )
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::tensionOnSurface::correct()
{
    if (!varies())
    {
        return;
    }

    boolList known(mesh_.nCells(), false);
    onPlanes(known);

    const UList<scalar>& area = surface_.planes().area();
    scalar all = 0, sum = 0;
    forAll(area, i)
    {
        all += area[i];
        sum += area[i]*sigma_[surface_.planes().cell()[i]];
    }
    reduce(all, sumOp<scalar>());
    reduce(sum, sumOp<scalar>());
    // Without a surface, that of the last one
    const scalar mean = all > 0 ? sum/all : gMax(sigma_.primitiveField());

    volScalarField layer
    (
        IOobject("layer", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    );
    alongInterface::extend(n_(), known, layer);
    alongInterface::extend(gradient_(), known, layer);
    alongInterface::extend(sigma_, known, layer);

    forAll(sigma_, celli)
    {
        if (layer[celli] == alongInterface::beyond)
        {
            sigma_[celli] = mean;
        }
        const scalar length = mag(n_()[celli]);
        n_()[celli] /= length > 0 ? length : 1;
    }
    sigma_.correctBoundaryConditions();
    n_->correctBoundaryConditions();

    sigmaf_() = fvc::interpolate(sigma_);
    alongInterface::toFaces(sigma_, layer, sigmaf_());
}


Foam::tmp<Foam::surfaceScalarField>
Foam::dew::tensionOnSurface::sigmaf() const
{
    return
        varies()
      ? tmp<surfaceScalarField>(sigmaf_())
      : fvc::interpolate(sigma_);
}


Foam::scalarMinMax Foam::dew::tensionOnSurface::bounds() const
{
    scalarMinMax found;
    for (const label celli : surface_.planes().cell())
    {
        found.add(sigma_[celli]);
    }
    return returnReduce(found, minMaxOp<scalar>());
}
