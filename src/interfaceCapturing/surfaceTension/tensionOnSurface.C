/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "tensionOnSurface.H"
#include "alongInterface.H"
#include "fvcGrad.H"
#include "surfaceInterpolate.H"
#include "syncTools.H"
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


void Foam::dew::tensionOnSurface::onPlanes
(
    boolList& known,
    vectorField& F
)
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
        F[celli] = planes.area()[i]*law_->slope(value)*(g - n*(n & g));
    }
}


void Foam::dew::tensionOnSurface::spread(const vectorField& F)
{
    const interfacePlanes& planes = surface_.planes();
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const label nInternal = mesh_.nInternalFaces();

    vectorField& pull = pull_->primitiveFieldRef();
    vectorField across(mesh_.nFaces() - nInternal, Zero);
    pull = F;

    forAll(planes.cell(), i)
    {
        const label celli = planes.cell()[i];
        const vector d(planes.x()[i] - mesh_.C()[celli]);

        for (const label facei : mesh_.cells()[celli])
        {
            const bool owned = mesh_.faceOwner()[facei] == celli;
            const scalar out = (mesh_.faceAreas()[facei] & d)*(owned ? 1 : -1);
            const vector part(max(out, scalar(0))/mesh_.V()[celli]*F[celli]);

            if (facei < nInternal)
            {
                pull
                [
                    owned
                  ? mesh_.faceNeighbour()[facei]
                  : mesh_.faceOwner()[facei]
                ] += part;
            }
            else if (patches[patches.whichPatch(facei)].coupled())
            {
                across[facei - nInternal] = part;
            }
            else
            {
                continue;
            }
            pull[celli] -= part;
        }
    }

    syncTools::swapBoundaryFaceList(mesh_, across);
    for (const polyPatch& patch : patches)
    {
        if (patch.coupled())
        {
            forAll(patch, i)
            {
                pull[patch.faceCells()[i]] +=
                    across[patch.start() - nInternal + i];
            }
        }
    }
    pull /= mesh_.V();
    pull_->correctBoundaryConditions();
}


void Foam::dew::tensionOnSurface::extend(const boolList& known)
{
    const interfacePlanes& planes = surface_.planes();
    scalar area = 0, sum = 0;
    forAll(planes.cell(), i)
    {
        area += planes.area()[i];
        sum += planes.area()[i]*sigma_[planes.cell()[i]];
    }
    reduce(area, sumOp<scalar>());
    reduce(sum, sumOp<scalar>());
    // Without a surface, that of the last one
    const scalar mean = area > 0 ? sum/area : gMax(sigma_.primitiveField());

    volScalarField layer
    (
        IOobject("layer", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    );
    alongInterface::extend(sigma_, known, layer);
    forAll(sigma_, celli)
    {
        if (layer[celli] == alongInterface::beyond)
        {
            sigma_[celli] = mean;
        }
    }
    sigma_.correctBoundaryConditions();

    sigmaf_() = fvc::interpolate(sigma_);
    alongInterface::toFaces(sigma_, layer, sigmaf_());
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
        pull_.reset
        (
            new volVectorField
            (
                derived("surfaceTensionPull"), mesh_,
                dimensionedVector(dimForce/dimVolume, Zero)
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
    vectorField F(mesh_.nCells(), Zero);
    onPlanes(known, F);
    spread(F);
    extend(known);
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
