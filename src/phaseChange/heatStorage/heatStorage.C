/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "heatStorage.H"
#include "interfaceTransfer.H"
#include "phaseRegion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Capacity per volume of the phase [J/m3/K]
Foam::scalarField perVolume
(
    const Foam::dew::phaseRegion& region,
    const Foam::scalarField& C
)
{
    Foam::scalarField values(C.size(), Foam::Zero);
    forAll(C, celli)
    {
        if (region.V()[celli] > 0)
        {
            values[celli] = C[celli]/region.V()[celli];
        }
    }
    return values;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::heatStorage::heatStorage
(
    const fvMesh& mesh,
    const interfaceTransfer& interface,
    const phaseRegion& gas,
    const phaseRegion& liquid
)
:
    mesh_(mesh),
    interface_(interface),
    gas_(gas),
    liquid_(liquid),
    heatGas_(held("heat.gas", dimEnergy/dimVolume)),
    capacityGas_(held("capacity.gas", dimEnergy/dimVolume/dimTemperature)),
    heatLiquid_(held("heat.liquid", dimEnergy/dimVolume)),
    capacityLiquid_
    (
        held("capacity.liquid", dimEnergy/dimVolume/dimTemperature)
    ),
    C0_
    (
        IOobject("C0", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimEnergy/dimVolume/dimTemperature, Zero)
    ),
    T0_
    (
        IOobject("T0", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar(dimTemperature, Zero)
    ),
    lessC_("lessC", C0_),
    lessH_("lessH", lessC_*T0_),
    before_
    (
        // By the name of what schemes are chosen for
        IOobject
        (
            "T", mesh.time().timeName(), mesh, IOobject::NO_READ,
            IOobject::NO_WRITE, false
        ),
        mesh,
        dimensionedScalar(dimTemperature, Zero)
    ),
    wasGas_(interface.faces().gas())
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::volScalarField Foam::dew::heatStorage::held
(
    const word& name,
    const dimensionSet& dims
) const
{
    return volScalarField
    (
        IOobject
        (
            name,
            mesh_.time().timeName(),
            mesh_,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        ),
        mesh_,
        dimensionedScalar("none", dims, -1)
    );
}


Foam::scalarField Foam::dew::heatStorage::less
(
    const phaseRegion& region,
    const scalarField& C
) const
{
    scalarField values
    (
        (1 - region.depth())*region.beyond()
       *region.onFaces(perVolume(region, C), false)
    );
    forAll(values, k)
    {
        // Not known before the first step
        if (interface_.Ts(k) <= 0)
        {
            values[k] = 0;
        }
    }
    return values;
}


Foam::scalarField Foam::dew::heatStorage::lessInside
(
    const phaseRegion& region,
    const scalarField& C
) const
{
    return region.offset()*region.own()*perVolume(region, C);
}


void Foam::dew::heatStorage::store
(
    const phaseRegion& region,
    const scalarField& C,
    const volScalarField& T,
    scalarField& heat,
    scalarField& capacity
) const
{
    capacity = region.giveBack(C);
    heat = region.giveBack(C*T.primitiveField());

    scalarField values(less(region, C));
    const scalarField ofCells(region.onFaces(T.primitiveField(), false));
    forAll(values, k)
    {
        values[k] *= interface_.Ts(k) - ofCells[k];
    }
    scalarField off
    (
        lessInside(region, C)*(region.furtherIn(T) - T.primitiveField())
    );
    region.toCells(values, off, true);
    heat += off/mesh_.V();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dew::heatStorage::read() const
{
    return gMin(capacityGas_.primitiveField()) >= 0;
}


void Foam::dew::heatStorage::correct
(
    const volScalarField& T,
    const scalarField& rhoCp
)
{
    const scalarField C(rhoCp*mesh_.V());
    lessC_.field() = 0;
    lessH_.field() = 0;
    for (const phaseRegion* region : {&gas_, &liquid_})
    {
        scalarField values(less(*region, C));
        region->toCells(values, lessC_.field());
        forAll(values, k)
        {
            values[k] *= interface_.Ts(k);
        }
        region->toCells(values, lessH_.field());

        const scalarField inside(lessInside(*region, C));
        lessC_.field() += inside;
        lessH_.field() += inside*region->furtherIn(T);
    }
    lessC_.field() /= mesh_.V();
    lessH_.field() /= mesh_.V();
}


void Foam::dew::heatStorage::store
(
    const volScalarField& T,
    const scalarField& rhoCp
)
{
    const scalarField C(rhoCp*mesh_.V());
    store
    (
        gas_, C, T,
        heatGas_.primitiveFieldRef(), capacityGas_.primitiveFieldRef()
    );
    store
    (
        liquid_, C, T,
        heatLiquid_.primitiveFieldRef(), capacityLiquid_.primitiveFieldRef()
    );
}


Foam::scalar Foam::dew::heatStorage::meanT() const
{
    return
        gSum
        (
            scalarField
            (
                (heatGas_.primitiveField() + heatLiquid_.primitiveField())
               *mesh_.V()
            )
        )
       /gSum
        (
            scalarField
            (
                (
                    capacityGas_.primitiveField()
                  + capacityLiquid_.primitiveField()
                )
               *mesh_.V()
            )
        );
}


Foam::scalar Foam::dew::heatStorage::held(const scalar Tref) const
{
    return gSum
    (
        scalarField
        (
            (
                heatGas_.primitiveField() - Tref*capacityGas_.primitiveField()
              + heatLiquid_.primitiveField()
              - Tref*capacityLiquid_.primitiveField()
            )
           *mesh_.V()
        )
    );
}


void Foam::dew::heatStorage::move(const volScalarField& T)
{
    const scalarField C
    (
        gas_.collect(capacityGas_.primitiveField())
      + liquid_.collect(capacityLiquid_.primitiveField())
    );
    const scalarField H
    (
        gas_.collect(heatGas_.primitiveField())
      + liquid_.collect(heatLiquid_.primitiveField())
    );

    forAll(C, celli)
    {
        C0_[celli] = C[celli]/mesh_.V()[celli];
        T0_[celli] = C[celli] > 0 ? H[celli]/C[celli] : T[celli];
    }

    const boolList& isGas = interface_.faces().gas();
    before_ == T;
    forAll(isGas, celli)
    {
        if (isGas[celli] != wasGas_[celli])
        {
            before_[celli] = T0_[celli];
        }
    }
    before_.correctBoundaryConditions();
    wasGas_ = isGas;
}


// ************************************************************************* //
