/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "heatStorage.H"
#include "phaseRegion.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::heatStorage::heatStorage
(
    const fvMesh& mesh,
    const phaseRegion& gas,
    const phaseRegion& liquid
)
:
    mesh_(mesh),
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
    )
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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dew::heatStorage::read() const
{
    return gMin(capacityGas_.primitiveField()) >= 0;
}


void Foam::dew::heatStorage::store
(
    const volScalarField& T,
    const scalarField& rhoCp
)
{
    const scalarField C(rhoCp*mesh_.V());
    const scalarField H(C*T.primitiveField());

    capacityGas_.primitiveFieldRef() = gas_.giveBack(C);
    heatGas_.primitiveFieldRef() = gas_.giveBack(H);
    capacityLiquid_.primitiveFieldRef() = liquid_.giveBack(C);
    heatLiquid_.primitiveFieldRef() = liquid_.giveBack(H);
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
}


// ************************************************************************* //
