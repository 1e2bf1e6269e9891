/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "transportedSurface.H"
#include "alongInterface.H"
#include "fvcGrad.H"
#include "neighbourSum.H"
#include "surfaceInterpolate.H"
#include "userEntry.H"
#include "wallFvPatch.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(transportedSurface);
}
}

const char* const Foam::dew::transportedSurface::solvers =
    "interDemFoam takes isoAdvector and MULES, interEvapDemFoam any";


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::transportedSurface::transportedSurface
(
    const fvMesh& mesh,
    const dictionary& surfaceProperties
)
:
    surfaceMotion(mesh, surfaceProperties),
    angles_(mesh, surfaceProperties),
    volume_(heldVolume()),
    reconstruction_(reconstruction::New(mesh, angles_, surfaceProperties)),
    distance_(distanceModel::New(*this, surfaceProperties)),
    curvatureModel_(curvatureModel::New(*this, surfaceProperties)),
    alphaPhi_
    (
        IOobject
        (
            IOobject::groupName("alphaPhi", liquidName_),
            mesh.time().timeName(),
            mesh
        ),
        mesh,
        dimensionedScalar(dimVolume/dimTime, Zero)
    )
{
    userEntry::onlyThese
    (
        surfaceProperties,
        {
            "liquid", "surfaceMotion", "reconstruction", "distance",
            "curvature", "contactAngles", "surfaceTension", "handOver"
        }
    );
    // As long as nobody reads them
    psi_ == dimensionedScalar(dimLength, Zero);
    n_ == dimensionedVector(dimless, Zero);
    speed_ == dimensionedScalar(dimVelocity, Zero);

    alpha_.oldTime();
    alphaPhi_.setOriented();

    const scalar low = gMin(alpha_.primitiveField());
    const scalar high = gMax(alpha_.primitiveField());
    // Also where they are not numbers
    if (!(low >= -1e-6 && high <= 1 + 1e-6))
    {
        FatalErrorInFunction
            << "The field " << alpha_.objectPath() << " has values from " << low
            << " to " << high << nl
            << "A share of the volume is from 0 to 1" << exit(FatalError);
    }
    if (high <= 0)
    {
        WarningInFunction
            << "There is no liquid: the field " << alpha_.objectPath()
            << " is 0 everywhere" << nl
            << "setLiquid puts some there, of system/setLiquidDict" << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField>
Foam::dew::transportedSurface::normalFlux() const
{
    // Where alpha changes by less than this over a cell there is no surface
    const dimensionedScalar small
    (
        "small", dimless/dimLength,
        1e-8/Foam::cbrt(gAverage(mesh_.V().field()))
    );

    surfaceVectorField n(-fvc::interpolate(fvc::grad(alpha_)));
    n /= mag(n) + small;

    forAll(mesh_.boundary(), patchi)
    {
        if (isA<wallFvPatch>(mesh_.boundary()[patchi]))
        {
            vectorField& nb = n.boundaryFieldRef()[patchi];
            const vectorField given(nb);
            nb = angles_.normal(patchi, given);
        }
    }

    return n & mesh_.Sf();
}


Foam::tmp<Foam::surfaceScalarField> Foam::dew::transportedSurface::onSurface
(
    const dimensionedVector& g
) const
{
    const interfacePlanes& surfaces = planes();
    tmp<surfaceScalarField> tfaces(g & mesh_.Cf());

    // The cells that are crossed are of layer 0, the others do not know
    volScalarField value
    (
        IOobject("onSurface", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(g.dimensions()*dimLength, Zero),
        zeroGradientFvPatchScalarField::typeName
    );
    volScalarField layer
    (
        IOobject("layer", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("beyond", dimless, alongInterface::beyond),
        zeroGradientFvPatchScalarField::typeName
    );
    forAll(surfaces.cell(), i)
    {
        const label celli = surfaces.cell()[i];
        value[celli] = g.value() & surfaces.x()[i];
        layer[celli] = 0;
    }
    value.correctBoundaryConditions();
    layer.correctBoundaryConditions();
    alongInterface::toFaces(value, layer, tfaces.ref());

    return tfaces;
}


void Foam::dew::transportedSurface::update(const scalarField& alpha)
{
    alpha_.primitiveFieldRef() = alpha;
    alpha_.correctBoundaryConditions();
    alpha_.oldTime() == alpha_;

    alphaPhi_ =
        surfaceScalarField::New
        (
            "alphaPhi", mesh_, dimensionedScalar(alphaPhi_.dimensions(), Zero)
        );
    alphaPhi_.setOriented();
}


void Foam::dew::transportedSurface::correct
(
    const surfaceFlow& flow,
    const bool distance
)
{
    volume_ =
        gSum(alpha_.primitiveField()*flow.alphac.primitiveField()*mesh_.V());

    reconstruct(alpha_);
    area_.setSize(mesh_.nCells());
    area_ = 0;
    forAll(planes().cell(), i)
    {
        area_[planes().cell()[i]] = planes().area()[i];
    }

    angles_.correct(planes(), flow);
    if (distance || curvatureModel_->needsDistance())
    {
        distance_->correct(psi_, n_);
        correctSpeed(flow.U);
    }
    curvatureModel_->correct(curvature_);
}


void Foam::dew::transportedSurface::correctSpeed
(
    const volVectorField& U,
    const scalarField& recession
)
{
    correctSpeed(U);
    forAll(recession, celli)
    {
        if (n_[celli] != vector::zero)
        {
            speed_[celli] -= recession[celli];
        }
    }
}


Foam::tmp<Foam::scalarField> Foam::dew::transportedSurface::recession
(
    const scalarField& losing
) const
{
    scalarField above(losing), below(area_);
    auto tspeed = tmp<scalarField>::New(mesh_.nCells(), Zero);
    scalarField& speed = tspeed.ref();

    // A mean over neighbours, as wide as particles reach beyond a cell
    for (label round = 0; round < 2; round++)
    {
        above += neighbourSum<scalar>(mesh_, above)();
        below += neighbourSum<scalar>(mesh_, below)();
    }
    forAll(speed, celli)
    {
        if (below[celli] > VSMALL)
        {
            speed[celli] = above[celli]/below[celli];
        }
    }
    return tspeed;
}


void Foam::dew::transportedSurface::report(Ostream& os) const
{
    const scalar low = gMin(alpha_.primitiveField());
    const scalar high = gMax(alpha_.primitiveField());

    os  << alpha_.name() << ": volume " << volume_ << " m3, from " << low
        << " to 1 " << (high < 1 ? "- " : "+ ") << mag(high - 1) << endl;

    distance_->report(os);
    curvatureModel_->report(os);
}
