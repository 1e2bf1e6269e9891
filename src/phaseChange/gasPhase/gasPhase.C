/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "gasPhase.H"
#include "Enum.H"
#include "gasModel.H"
#include "interfaceTransfer.H"
#include "meanRhoD.H"
#include "neighbourSum.H"
#include "surfaceShape.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::IOobject massIO
(
    const Foam::word& name,
    const Foam::fvMesh& mesh,
    const bool transient
)
{
    return Foam::IOobject
    (
        name,
        mesh.time().timeName(),
        mesh,
        transient
      ? Foam::IOobject::READ_IF_PRESENT : Foam::IOobject::NO_READ,
        transient
      ? Foam::IOobject::AUTO_WRITE : Foam::IOobject::NO_WRITE
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::gasPhase::gasPhase
(
    const gasModel& model,
    const surfaceShape& surface,
    const interfaceTransfer& interface,
    const volScalarField& T,
    volScalarField* Y,
    const dictionary& phaseChangeProperties
)
:
    mesh_(T.mesh()),
    model_(model),
    surface_(surface),
    interface_(interface),
    T_(T),
    Y_(Y),
    transient_
    (
        Enum<bool>({{false, "quasiSteady"}, {true, "transient"}}).getOrDefault
        (
            "gas", phaseChangeProperties, false
        )
    ),
    Vg_(mesh_.nCells(), Zero),
    rho_
    (
        IOobject("rho.gas", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("rho", dimDensity, 1)
    ),
    GammaY_
    (
        IOobject("GammaY", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("zero", dimMass/dimLength/dimTime, Zero)
    ),
    vapourMass_
    (
        massIO("vapourMass", mesh_, transient_),
        mesh_,
        dimensionedScalar("none", dimMass, -1)
    ),
    gasMass_
    (
        massIO("gasMass", mesh_, transient_),
        mesh_,
        dimensionedScalar("none", dimMass, -1)
    ),
    wasGas_(interface.faces().gas())
{
    findVolumes();
    correct();

    // Not read: what the fields at the start make it
    if (transient_ && gMin(gasMass_.primitiveField()) < 0)
    {
        store();
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalarField Foam::dew::gasPhase::weights() const
{
    const auto& faces = interface_.faces().faces();
    scalarField w(faces.size());
    forAll(faces, k)
    {
        w[k] = faces[k].S*mag(faces[k].n & faces[k].e);
    }
    return w;
}


void Foam::dew::gasPhase::findVolumes()
{
    const interfaceFaces& faces = interface_.faces();
    const boolList& gas = faces.gas();
    const scalarField& alpha = surface_.alpha();
    const scalarField w(weights());

    scalarField all(mesh_.nCells(), Zero);
    faces.toLiquid(w, all);

    // Gas in liquid cells, per weight of their faces
    volScalarField beyond
    (
        IOobject("beyond", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("zero", dimless, Zero)
    );
    scalar unassigned = 0;
    forAll(gas, celli)
    {
        const scalar volume = (1 - alpha[celli])*mesh_.V()[celli];
        Vg_[celli] = gas[celli] ? volume : 0;

        if (!gas[celli] && all[celli] > VSMALL)
        {
            beyond[celli] = volume/all[celli];
        }
        else if (!gas[celli])
        {
            unassigned += volume;
        }
    }
    beyond.correctBoundaryConditions();
    reduce(unassigned, sumOp<scalar>());
    const scalar perWeight = unassigned/max(gSum(w), VSMALL);

    const scalarField share(faces.ofLiquid(beyond));
    forAll(w, k)
    {
        const interfaceFace& face = faces.faces()[k];
        Vg_[face.gas] += w[k]*((face.wall ? 0 : share[k]) + perWeight);
    }
}


void Foam::dew::gasPhase::fillNew()
{
    const boolList& gas = interface_.faces().gas();
    volScalarField& Y = *Y_;

    scalarField known(mesh_.nCells());
    forAll(known, celli)
    {
        known[celli] = gas[celli] && wasGas_[celli];
    }
    const scalarField sum
    (
        neighbourSum<scalar>(mesh_, known*Y.primitiveField())
    );
    const scalarField n(neighbourSum<scalar>(mesh_, known));

    forAll(gas, celli)
    {
        if (gas[celli] && !wasGas_[celli] && n[celli] > 0)
        {
            Y[celli] = sum[celli]/n[celli];
        }
    }
    Y.correctBoundaryConditions();
}


void Foam::dew::gasPhase::spread(const scalar vapour, const scalar gas)
{
    const auto& faces = interface_.faces().faces();
    const scalarField w(weights());
    const scalar sum = gSum(w);

    if (sum > VSMALL)
    {
        forAll(faces, k)
        {
            vapourMass_[faces[k].gas] += vapour*w[k]/sum;
            gasMass_[faces[k].gas] += gas*w[k]/sum;
        }
    }
    else
    {
        const scalar V = gSum(Vg_);
        vapourMass_.primitiveFieldRef() += vapour*Vg_/V;
        gasMass_.primitiveFieldRef() += gas*Vg_/V;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::gasPhase::correct()
{
    if (!Y_)
    {
        forAll(rho_, celli)
        {
            rho_[celli] = model_.rho(0, T_[celli]);
        }
        return;
    }

    const volScalarField& Y = *Y_;
    const boolList& gas = interface_.faces().gas();
    const surfaceScalarField& same = interface_.faces().sameGas();
    const bool stefan = interface_.law().stefanFlow();

    forAll(rho_, celli)
    {
        rho_[celli] = model_.rho(gas[celli] ? Y[celli] : 0, T_[celli]);
    }

    forAll(mesh_.owner(), facei)
    {
        const label own = mesh_.owner()[facei];
        const label nei = mesh_.neighbour()[facei];
        GammaY_[facei] =
            same[facei] > 0
          ? meanRhoD
            (
                model_, Y[own], Y[nei], 0.5*(T_[own] + T_[nei]), stefan
            )
          : 0;
    }
    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        const scalarField& mask = same.boundaryField()[patchi];
        const scalarField Yb
        (
            patch.coupled()
          ? Y.boundaryField()[patchi].patchNeighbourField()
          : tmp<scalarField>(Y.boundaryField()[patchi])
        );
        const scalarField Tb
        (
            patch.coupled()
          ? T_.boundaryField()[patchi].patchNeighbourField()
          : tmp<scalarField>(T_.boundaryField()[patchi])
        );

        scalarField& Gamma = GammaY_.boundaryFieldRef()[patchi];
        forAll(Gamma, facei)
        {
            const label celli = patch.faceCells()[facei];
            Gamma[facei] =
                mask[facei] > 0
              ? meanRhoD
                (
                    model_, Y[celli], Yb[facei], 0.5*(T_[celli] + Tb[facei]),
                    stefan
                )
              : 0;
        }
    }
}


Foam::tmp<Foam::volScalarField::Internal>
Foam::dew::gasPhase::storageSp() const
{
    auto tsp = tmp<volScalarField::Internal>::New
    (
        IOobject("storageSp", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("zero", dimDensity/dimTime, Zero)
    );
    if (transient_)
    {
        tsp.ref().field() =
            rho_.primitiveField()*Vg_/mesh_.V()/mesh_.time().deltaTValue();
    }
    return tsp;
}


Foam::tmp<Foam::volScalarField::Internal>
Foam::dew::gasPhase::storageSu() const
{
    auto tsu = tmp<volScalarField::Internal>::New
    (
        IOobject("storageSu", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("zero", dimDensity/dimTime, Zero)
    );
    if (transient_)
    {
        tsu.ref().field() =
            vapourMass_.primitiveField()/mesh_.V()/mesh_.time().deltaTValue();
    }
    return tsu;
}


Foam::tmp<Foam::volScalarField::Internal> Foam::dew::gasPhase::storage() const
{
    auto ts = storageSp();
    if (transient_)
    {
        ts.ref().field() -=
            gasMass_.primitiveField()/mesh_.V()/mesh_.time().deltaTValue();
    }
    return ts;
}


void Foam::dew::gasPhase::store()
{
    if (transient_)
    {
        // The density the equation had: the mass closes
        gasMass_.primitiveFieldRef() = rho_.primitiveField()*Vg_;
        vapourMass_.primitiveFieldRef() =
            Y_
          ? gasMass_.primitiveField()*Y_->primitiveField()
          : tmp<scalarField>(new scalarField(mesh_.nCells(), Zero));
    }
}


void Foam::dew::gasPhase::move()
{
    const scalar vapour = held();
    const scalar gas = transient_ ? gSum(gasMass_.primitiveField()) : 0;

    findVolumes();
    if (Y_)
    {
        fillNew();
    }
    wasGas_ = interface_.faces().gas();

    if (transient_)
    {
        forAll(rho_, celli)
        {
            rho_[celli] =
                model_.rho
                (
                    wasGas_[celli] && Y_ ? (*Y_)[celli] : 0, T_[celli]
                );
        }
        store();
        spread
        (
            vapour - held(), gas - gSum(gasMass_.primitiveField())
        );
    }
}


void Foam::dew::gasPhase::add(const scalar vapour)
{
    spread(vapour, vapour);
}


Foam::scalar Foam::dew::gasPhase::held() const
{
    return transient_ ? gSum(vapourMass_.primitiveField()) : 0;
}


// ************************************************************************* //
