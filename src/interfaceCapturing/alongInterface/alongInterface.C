/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "alongInterface.H"
#include "fvMesh.H"
#include "neighbourSum.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Nothing, where both cells have no value
void setFace
(
    Foam::scalar& face,
    const Foam::scalar own, const Foam::scalar layerOwn,
    const Foam::scalar nei, const Foam::scalar layerNei,
    const Foam::scalar weightOwn, const Foam::scalar weightNei
)
{
    if (Foam::min(layerOwn, layerNei) < Foam::dew::alongInterface::beyond)
    {
        face =
            layerOwn < layerNei ? own
          : layerNei < layerOwn ? nei
          : (weightOwn*own + weightNei*nei)/(weightOwn + weightNei);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::dew::alongInterface::extend
(
    volScalarField& values,
    const boolList& known,
    volScalarField& layer
)
{
    const fvMesh& mesh = values.mesh();
    scalarField& value = values.primitiveFieldRef();
    scalarField& of = layer.primitiveFieldRef();

    forAll(value, celli)
    {
        of[celli] = known[celli] ? 0 : beyond;
        value[celli] = known[celli] ? value[celli] : 0;
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
        const scalarField sum(neighbourSum<scalar>(mesh, in*value));

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


void Foam::dew::alongInterface::toFaces
(
    const volScalarField& values,
    const volScalarField& layer,
    const volScalarField& weight,
    surfaceScalarField& faceValues
)
{
    const fvMesh& mesh = values.mesh();
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();

    forAll(own, facei)
    {
        setFace
        (
            faceValues[facei],
            values[own[facei]], layer[own[facei]],
            values[nei[facei]], layer[nei[facei]],
            weight[own[facei]], weight[nei[facei]]
        );
    }

    forAll(mesh.boundary(), patchi)
    {
        const fvPatchScalarField& valueb = values.boundaryField()[patchi];
        const fvPatchScalarField& layerb = layer.boundaryField()[patchi];
        scalarField& facesb = faceValues.boundaryFieldRef()[patchi];
        const fvPatchScalarField& weightb = weight.boundaryField()[patchi];
        const bool coupled = valueb.coupled();

        // A patch without cells beyond it has those inside on both sides
        const scalarField valueIn(valueb.patchInternalField());
        const scalarField layerIn(layerb.patchInternalField());
        const scalarField weightIn(weightb.patchInternalField());
        const scalarField valueOut
        (
            coupled ? valueb.patchNeighbourField() : tmp<scalarField>(valueIn)
        );
        const scalarField layerOut
        (
            coupled ? layerb.patchNeighbourField() : tmp<scalarField>(layerIn)
        );
        const scalarField weightOut
        (
            coupled ? weightb.patchNeighbourField() : tmp<scalarField>(weightIn)
        );
        forAll(facesb, i)
        {
            setFace
            (
                facesb[i], valueIn[i], layerIn[i], valueOut[i], layerOut[i],
                weightIn[i], weightOut[i]
            );
        }
    }
}
