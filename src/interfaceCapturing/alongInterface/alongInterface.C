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

constexpr Foam::label nLayers = 3;

//- The layer of cells further away
constexpr Foam::scalar beyond = nLayers + 1;

Foam::scalar onFace
(
    const Foam::scalar own, const Foam::scalar layerOwn,
    const Foam::scalar nei, const Foam::scalar layerNei
)
{
    return
        layerOwn < layerNei ? own
      : layerNei < layerOwn ? nei
      : 0.5*(own + nei);
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
    surfaceScalarField& faceValues
)
{
    const fvMesh& mesh = values.mesh();
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();

    forAll(own, facei)
    {
        faceValues[facei] =
            onFace
            (
                values[own[facei]], layer[own[facei]],
                values[nei[facei]], layer[nei[facei]]
            );
    }

    forAll(mesh.boundary(), patchi)
    {
        const fvPatchScalarField& valueb = values.boundaryField()[patchi];
        const fvPatchScalarField& layerb = layer.boundaryField()[patchi];
        scalarField& facesb = faceValues.boundaryFieldRef()[patchi];

        if (valueb.coupled())
        {
            const scalarField valueIn(valueb.patchInternalField());
            const scalarField valueOut(valueb.patchNeighbourField());
            const scalarField layerIn(layerb.patchInternalField());
            const scalarField layerOut(layerb.patchNeighbourField());
            forAll(facesb, i)
            {
                facesb[i] =
                    onFace(valueIn[i], layerIn[i], valueOut[i], layerOut[i]);
            }
        }
        else
        {
            facesb = valueb.patchInternalField();
        }
    }
}
