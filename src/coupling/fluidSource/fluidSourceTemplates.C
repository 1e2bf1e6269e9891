/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

template<class Type>
Foam::dew::fluidSource<Type>::fluidSource
(
    const word& name,
    const particleMesh& map,
    const smoothing& smoothing,
    const fieldType& phi,
    const dimensionSet& dims
)
:
    map_(map),
    smoothing_(smoothing),
    phi_(phi),
    phi0_(phi.primitiveField()),
    F_
    (
        IOobject
        (
            name + "F",
            phi.time().timeName(),
            phi.mesh()
        ),
        phi.mesh(),
        dimensioned<Type>(dims/dimVolume/dimTime, Zero),
        zeroGradientFvPatchField<Type>::typeName
    ),
    Sp_
    (
        IOobject
        (
            name + "Sp",
            phi.time().timeName(),
            phi.mesh()
        ),
        phi.mesh(),
        dimensionedScalar(dims/phi.dimensions()/dimVolume/dimTime, Zero),
        zeroGradientFvPatchScalarField::typeName
    ),
    deltaT_(phi.time().deltaTValue())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
void Foam::dew::fluidSource<Type>::correct
(
    const UList<Type>& received,
    const UList<scalar>& sensitivity
)
{
    deltaT_ = phi_.time().deltaTValue();
    phi0_ = phi_.primitiveField();

    Field<Type>& F = F_.primitiveFieldRef();
    scalarField& Sp = Sp_.primitiveFieldRef();
    F = Zero;
    Sp = 0;

    struct transfer
    {
        Type J;
        scalar s;
    };
    List<transfer> values(received.size());
    forAll(values, i)
    {
        values[i] = transfer{map_.toMesh(received[i], i), sensitivity[i]};
    }

    map_.share
    (
        values,
        [&](const label celli, const scalar w, const transfer& value)
        {
            F[celli] -= w*value.J;
            Sp[celli] += w*value.s;
        }
    );

    smoothing_.spread(F);
    smoothing_.spread(Sp);

    const scalarField& V = phi_.mesh().V();
    forAll(F, celli)
    {
        const scalar perVolume = 1/(V[celli]*deltaT_);
        Sp[celli] *= perVolume;
        F[celli] *= perVolume;
    }
    F_.correctBoundaryConditions();
    Sp_.correctBoundaryConditions();
}


template<class Type>
void Foam::dew::fluidSource<Type>::kicks
(
    const UList<scalar>& sensitivity,
    DynamicList<Type>& kick
) const
{
    Field<Type> change(phi_.primitiveField() - phi0_);
    smoothing_.average(change);

    kick.setSize(sensitivity.size());
    UList<Type>& values = kick;
    values = Zero;
    map_.average(change, values);

    forAll(kick, i)
    {
        kick[i] *= sensitivity[i];
    }
}


template<class Type>
Type Foam::dew::fluidSource<Type>::lost() const
{
    const scalarField& V = phi_.mesh().V();
    Type sum(Zero);

    forAll(V, celli)
    {
        sum += V[celli]*deltaT_
           *(Sp_[celli]*(phi_[celli] - phi0_[celli]) - F_[celli]);
    }
    return map_.symmetry().ringFactor()*returnReduce(sum, sumOp<Type>());
}
