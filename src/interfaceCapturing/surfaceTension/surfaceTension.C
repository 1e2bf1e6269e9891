/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "surfaceTension.H"
#include "fvcGrad.H"
#include "fvcLaplacian.H"
#include "fvMatrices.H"
#include "fvmLaplacian.H"
#include "mathematicalConstants.H"
#include "surfaceInterpolate.H"
#include "Switch.H"
#include "transportedSurface.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::surfaceTension::surfaceTension
(
    const transportedSurface& surface,
    const dictionary& surfaceProperties
)
:
    surface_(surface),
    tension_
    (
        surface, userEntry::subDict(surfaceProperties, "surfaceTension")
    ),
    force_
    (
        surfaceTensionForceModel::New
        (
            surface, surfaceProperties.subDict("surfaceTension")
        )
    ),
    implicitShare_(0),
    maxSteps_(1)
{
    const dictionary& dict = surfaceProperties.subDict("surfaceTension");
    wordList known({"type", "sigma", "semiImplicit", "maxSteps"});

    if (dict.getOrDefault<Switch>("semiImplicit", false))
    {
        implicitShare_ =
            dict.found("implicitShare")
          ? userEntry::within(dict, "implicitShare", 0.25, 1)
          : 0.5;
        maxSteps_ = 10;
        known.append("implicitShare");
    }
    userEntry::onlyThese(dict, known);
    maxSteps_ = userEntry::positiveOr(dict, "maxSteps", dimless, maxSteps_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::surfaceScalarField> Foam::dew::surfaceTension::force() const
{
    return tension_.sigmaf()*surface_.Kf()*force_->snGrad();
}


Foam::tmp<Foam::fvVectorMatrix> Foam::dew::surfaceTension::implicitPart
(
    const volVectorField& U,
    const surfaceScalarField& share
) const
{
    const surfaceScalarField stiffness
    (
        "stiffness",
        implicitShare_*U.time().deltaT()*share
       *fvc::interpolate(sigma()*mag(fvc::grad(surface_.alpha())))
    );

    return
        fvm::laplacian(stiffness, U)
      - fvc::laplacian(stiffness, U.oldTime());
}


Foam::scalar Foam::dew::surfaceTension::capillaryStep
(
    const scalar rho1,
    const scalar rho2
) const
{
    const fvMesh& mesh = surface_.mesh();
    const label nGeometric = mesh.nGeometricD();

    scalar least = GREAT;
    for (const label celli : surface_.planes().cell())
    {
        scalar h = GREAT;
        for (const label facei : mesh.cells()[celli])
        {
            if (mesh.isInternalFace(facei))
            {
                h = min(h, 1/mesh.nonOrthDeltaCoeffs()[facei]);
            }
        }
        if (h == GREAT)
        {
            h = Foam::pow(mesh.V()[celli], 1.0/nGeometric);
        }
        least =
            min
            (
                least,
                (rho1 + rho2)*pow3(h)
               /(4*constant::mathematical::pi*max(sigma()[celli], VSMALL))
            );
    }

    return Foam::sqrt(returnReduce(least, minOp<scalar>()));
}
