/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "gasPhase.H"
#include "Enum.H"
#include "fvcDiv.H"
#include "gasMixture.H"
#include "interfaceTransfer.H"
#include "linear.H"
#include "meanRhoD.H"
#include "neighbourSum.H"
#include "phaseRegion.H"
#include "speciesFields.H"
#include "Time.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::volScalarField heldField
(
    const Foam::word& name,
    const Foam::fvMesh& mesh,
    const Foam::dimensionSet& dims,
    const bool transient
)
{
    using namespace Foam;
    return volScalarField
    (
        IOobject
        (
            name,
            mesh.time().timeName(),
            mesh,
            transient ? IOobject::READ_IF_PRESENT : IOobject::NO_READ,
            transient ? IOobject::AUTO_WRITE : IOobject::NO_WRITE
        ),
        mesh,
        dimensionedScalar("none", dims, -1)
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::gasPhase::gasPhase
(
    const gasMixture& model,
    const scalar& p0,
    const interfaceTransfer& interface,
    const phaseRegion& region,
    const volScalarField& T,
    speciesFields& Y,
    const dictionary& phaseChangeProperties
)
:
    mesh_(T.mesh()),
    model_(model),
    p0_(p0),
    interface_(interface),
    region_(region),
    T_(T),
    Y_(Y),
    transient_
    (
        Enum<bool>({{false, "quasiSteady"}, {true, "transient"}}).getOrDefault
        (
            "gas", phaseChangeProperties, false
        )
    ),
    rho_
    (
        IOobject("rho.gas", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("rho", dimDensity, 1),
        zeroGradientFvPatchScalarField::typeName
    ),
    GammaY_
    (
        IOobject("GammaY", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("zero", dimMass/dimLength/dimTime, Zero)
    ),
    gas_(heldField("gasHeld", mesh_, dimDensity, transient_)),
    share_(heldField("gasShare", mesh_, dimless, transient_)),
    vapour0_(model.size(), scalarField(mesh_.nCells(), Zero)),
    gas0_(mesh_.nCells(), Zero),
    V0_(mesh_.nCells(), Zero),
    wasGas_(interface.faces().gas()),
    meanRhoD_(model)
{
    GammaYs_.setSize(Y.solved() ? model.size() : 0);
    forAll(GammaYs_, i)
    {
        GammaYs_.set(i, new surfaceScalarField(GammaY_));
    }
    vapour_.setSize(model.size());
    forAll(vapour_, i)
    {
        // A single vapour needs no name
        const word name
        (
            model.size() > 1 ? "vapourHeld." + model.names()[i] : "vapourHeld"
        );
        vapour_.set
        (
            i,
            new volScalarField(heldField(name, mesh_, dimDensity, transient_))
        );
    }
    correct();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::gasPhase::collect()
{
    forAll(vapour_, i)
    {
        vapour0_[i] = region_.collect(vapour_[i].primitiveField());
    }
    gas0_ = region_.collect(gas_.primitiveField());
    V0_ = region_.collect(share_.primitiveField());
}


void Foam::dew::gasPhase::fillNew()
{
    const boolList& gas = interface_.faces().gas();

    scalarField known(mesh_.nCells());
    forAll(known, celli)
    {
        known[celli] = gas[celli] && wasGas_[celli];
    }
    const scalarField n(neighbourSum<scalar>(mesh_, known));
    for (label k = 0; k < Y_.size(); k++)
    {
        volScalarField& Y = Y_[k];
        const scalarField sum
        (
            neighbourSum<scalar>(mesh_, known*Y.primitiveField())
        );
        forAll(gas, celli)
        {
            if (gas[celli] && !wasGas_[celli] && n[celli] > 0)
            {
                Y[celli] = sum[celli]/n[celli];
            }
        }
        Y.correctBoundaryConditions();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::gasPhase::start()
{
    if (transient_)
    {
        // Not read: what the fields at the start make it
        if (gMin(gas_.primitiveField()) < 0)
        {
            store();
        }
        collect();
    }
}


void Foam::dew::gasPhase::store()
{
    if (transient_)
    {
        // The density the equation had: the mass closes
        const scalarField mass(rho_.primitiveField()*region_.V());
        gas_.primitiveFieldRef() = region_.giveBack(mass);
        for (label i = 0; i < vapour_.size(); i++)
        {
            vapour_[i].primitiveFieldRef() =
                Y_.solved()
              ? region_.giveBack(mass*Y_[i].primitiveField())
              : tmp<scalarField>(new scalarField(mesh_.nCells(), Zero));
        }
        share_.primitiveFieldRef() = region_.giveBack(region_.V());
    }
}


void Foam::dew::gasPhase::move()
{
    if (Y_.solved())
    {
        fillNew();
    }
    wasGas_ = interface_.faces().gas();

    if (transient_)
    {
        collect();
    }
}


void Foam::dew::gasPhase::add(const label i, const scalar mass)
{
    const auto& faces = interface_.faces().faces();
    const scalarField shares(region_.shares());
    forAll(shares, k)
    {
        const label celli = faces[k].gas;
        const scalar part = mass*shares[k]/mesh_.V()[celli];
        vapour_[i][celli] += part;
        gas_[celli] += part;
    }
    if (!returnReduce(shares.size(), sumOp<label>()))
    {
        const scalarField part
        (
            mass*region_.V()/gSum(region_.V())/mesh_.V()
        );
        vapour_[i].primitiveFieldRef() += part;
        gas_.primitiveFieldRef() += part;
    }
}


Foam::scalar Foam::dew::gasPhase::held(const label i) const
{
    return
        transient_ ? gSum(vapour_[i].primitiveField()*mesh_.V()) : 0;
}


Foam::scalar Foam::dew::gasPhase::heldVapours() const
{
    scalar sum = 0;
    forAll(vapour_, i)
    {
        sum += held(i);
    }

    return sum;
}


Foam::scalar Foam::dew::gasPhase::heldGas() const
{
    return transient_ ? gSum(gas_.primitiveField()*mesh_.V()) : 0;
}


Foam::scalar Foam::dew::gasPhase::mass() const
{
    return gSum(scalarField(rho_.primitiveField()*region_.V()));
}


// ************************************************************************* //
