/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "neighbourSum.H"

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

template<class Type>
void Foam::dew::alongInterface::extend
(
    GeometricField<Type, fvPatchField, volMesh>& values,
    const boolList& known,
    volScalarField& layer
)
{
    const fvMesh& mesh = values.mesh();
    Field<Type>& value = values.primitiveFieldRef();
    scalarField& of = layer.primitiveFieldRef();

    forAll(value, celli)
    {
        of[celli] = known[celli] ? 0 : beyond;
        value[celli] = known[celli] ? value[celli] : pTraits<Type>::zero;
    }

    for (label step = 1; step <= nLayers; step++)
    {
        tmp<scalarField> tin(new scalarField(of.size()));
        forAll(of, celli)
        {
            tin.ref()[celli] = of[celli] < step;
        }
        const scalarField in(tin());
        const scalarField n(neighbourSum<scalar>(mesh, tin));
        const Field<Type> sum(neighbourSum<Type>(mesh, in*value));

        forAll(of, celli)
        {
            if (of[celli] == beyond && n[celli] > 0)
            {
                value[celli] = sum[celli]/n[celli];
                of[celli] = step;
            }
        }
    }

    values.correctBoundaryConditions();
    layer.correctBoundaryConditions();
}
