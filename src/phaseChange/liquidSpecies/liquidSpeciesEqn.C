/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// The equation of the species within the liquid

#include "liquidSpecies.H"
#include "exponentialFitted.H"
#include "fvcDiv.H"
#include "surfaceInterpolate.H"
#include "fvmDiv.H"
#include "fvmLaplacian.H"
#include "fvmSup.H"
#include "fvcSnGrad.H"
#include "gaussConvectionScheme.H"
#include "interfaceTransfer.H"
#include "liquidPhase.H"
#include "phaseRegion.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::surfaceScalarField& Foam::dew::liquidSpecies::flux
(
    const surfaceScalarField& phiL
)
{
    if (F_.valid())
    {
        return F_();
    }
    const interfaceFaces& faces = interface_.faces();
    const surfaceScalarField& inside = faces.sameLiquid();
    const dimensionedScalar rho("rho", dimDensity, rhoL_);
    F_.reset(new surfaceScalarField("liquidFlux", rho*inside*phiL));
    surfaceScalarField& F = F_();

    // Mass the cells have too much, over what they stand for, beside what goes
    // through boundaries
    const scalarField& V = region_.V();
    const scalar all = gSum(V);
    if (all <= 0)
    {
        return F;
    }
    const scalar dt = mesh_.time().deltaTValue();
    const scalarField out(fvc::div(F)().primitiveField()*mesh_.V());
    const scalar scale = gSum(scalarField(before_ - dt*out))/all;
    volScalarField::Internal excess
    (
        IOobject("excess", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimDensity/dimTime, Zero)
    );
    excess.field() = (before_ - dt*out - scale*V)/(mesh_.V()*dt);

    volScalarField::Internal screen
    (
        IOobject("screen", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(inv(sqr(dimLength)), Zero)
    );
    forAll(screen, celli)
    {
        screen[celli] =
            (faces.gas()[celli] ? 1 : 1e-9)/pow(mesh_.V()[celli], 2.0/3);
    }
    fvScalarMatrix eqn
    (
      - fvm::laplacian(inside, potential_) + fvm::Sp(screen, potential_)
     ==
        excess
    );
    eqn.solve();
    F += eqn.flux();
    return F;
}


void Foam::dew::liquidSpecies::solveCells
(
    const surfaceScalarField& F,
    const volScalarField& T,
    const scalar p,
    const bool last
)
{
    const interfaceFaces& faces = interface_.faces();
    const surfaceScalarField& inside = faces.sameLiquid();
    const scalar dt = mesh_.time().deltaTValue();
    speciesFields& X = liquid_.X();

    // What the flux and the surface leave
    const scalarField divF(fvc::div(F)().primitiveField());
    after_ = before_ - dt*divF*mesh_.V();
    List<scalarField> losses(held_.size()), slopes(held_.size());
    forAll(held_, i)
    {
        losses[i] = loss(i, dt, slopes[i]);
        after_ -= losses[i];
    }

    PtrList<surfaceScalarField> Gamma(held_.size());
    const scalar Tboil = liquid_.Tboil(p);
    volScalarField rhoD
    (
        IOobject("rhoD", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimMass/dimLength/dimTime, Zero),
        zeroGradientFvPatchScalarField::typeName
    );
    surfaceScalarField sum("sum", 0*F);
    surfaceScalarField largest
    (
        IOobject("largest", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(rhoD.dimensions(), Zero)
    );
    forAll(held_, i)
    {
        forAll(rhoD, celli)
        {
            rhoD[celli] =
                faces.gas()[celli]
              ? 0
              : liquid_.rhoD
                (
                    i, p, min(T[celli], Tboil), liquid_.x(celli)
                );
        }
        rhoD.correctBoundaryConditions();
        Gamma.set(i, new surfaceScalarField(inside*fvc::interpolate(rhoD)));
        sum += Gamma[i]*fvc::snGrad(X[i])*mesh_.magSf();
        largest = max(largest, Gamma[i]);
    }
    const surfaceScalarField carrying(F + sum);

    volScalarField::Internal Sp
    (
        IOobject("held", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimDensity/dimTime, Zero)
    );
    volScalarField::Internal Su("given", Sp);
    const scalar all = gSum(before_);
    forAll(held_, i)
    {
        const scalar mean = gSum(content_[i])/all;
        forAll(Sp, celli)
        {
            const scalar rate = 1/(mesh_.V()[celli]*dt);
            const bool gas = faces.gas()[celli];
            const scalar slope = last ? 0 : slopes[i][celli];
            Sp[celli] = gas ? rhoL_/dt : (after_[celli] + slope)*rate;
            Su[celli] =
                gas
              ? rhoL_/dt*mean
              : (
                    content_[i][celli] - losses[i][celli]
                  + slope*X[i][celli]
                )*rate;
        }
        fvScalarMatrix eqn
        (
            fvm::Sp(Sp, X[i])
          + fv::gaussConvectionScheme<scalar>
            (
                mesh_,
                carrying,
                tmp<surfaceInterpolationScheme<scalar>>
                (
                    new exponentialFitted(mesh_, carrying, largest)
                )
            ).fvmDiv(carrying, X[i])
          - fvm::laplacian(Gamma[i], X[i])
         ==
            Su
        );
        eqn.solve();
        massAfter_[i] =
            gSum(scalarField(after_*X[i].primitiveField()));
    }
}


// ************************************************************************* //
