/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "alongInterface.H"
#include "DynamicList.H"
#include "fvMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Nothing, where both cells have no value
void setFace
(
    Foam::scalar& face,
    const Foam::scalar own, const Foam::scalar layerOwn,
    const Foam::scalar nei, const Foam::scalar layerNei
)
{
    if (Foam::min(layerOwn, layerNei) < Foam::dew::alongInterface::beyond)
    {
        face =
            layerOwn < layerNei ? own
          : layerNei < layerOwn ? nei
          : 0.5*(own + nei);
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
    const labelUList& own = mesh.faceOwner();
    const labelUList& nei = mesh.faceNeighbour();
    scalarField& value = values.primitiveFieldRef();
    scalarField& of = layer.primitiveFieldRef();

    DynamicList<label> front, next;
    forAll(value, celli)
    {
        of[celli] = known[celli] ? 0 : beyond;
        value[celli] = known[celli] ? value[celli] : 0;
        if (known[celli])
        {
            front.append(celli);
        }
    }

    scalarField sum(value.size(), Zero);
    labelList n(value.size(), Zero);
    const auto give = [&](const label celli, const scalar given)
    {
        if (of[celli] == beyond)
        {
            if (n[celli] == 0)
            {
                next.append(celli);
            }
            sum[celli] += given;
            n[celli]++;
        }
    };
    for (label step = 1; step <= nLayers; step++)
    {
        next.clear();
        for (const label celli : front)
        {
            for (const label facei : mesh.cells()[celli])
            {
                if (mesh.isInternalFace(facei))
                {
                    const label other =
                        own[facei] == celli ? nei[facei] : own[facei];
                    give(other, value[celli]);
                }
            }
        }

        values.correctBoundaryConditions();
        layer.correctBoundaryConditions();
        forAll(mesh.boundary(), patchi)
        {
            const fvPatchScalarField& valueb = values.boundaryField()[patchi];
            const fvPatchScalarField& layerb = layer.boundaryField()[patchi];
            if (valueb.coupled())
            {
                const labelUList& cells = valueb.patch().faceCells();
                const scalarField valueOut(valueb.patchNeighbourField());
                const scalarField layerOut(layerb.patchNeighbourField());
                forAll(cells, i)
                {
                    if (layerOut[i] == step - 1)
                    {
                        give(cells[i], valueOut[i]);
                    }
                }
            }
        }

        for (const label celli : next)
        {
            value[celli] = sum[celli]/n[celli];
            of[celli] = step;
        }
        front.transfer(next);
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
        setFace
        (
            faceValues[facei],
            values[own[facei]], layer[own[facei]],
            values[nei[facei]], layer[nei[facei]]
        );
    }

    forAll(mesh.boundary(), patchi)
    {
        const fvPatchScalarField& valueb = values.boundaryField()[patchi];
        const fvPatchScalarField& layerb = layer.boundaryField()[patchi];
        scalarField& facesb = faceValues.boundaryFieldRef()[patchi];
        const bool coupled = valueb.coupled();

        // A patch without cells beyond it has those inside on both sides
        const scalarField valueIn(valueb.patchInternalField());
        const scalarField layerIn(layerb.patchInternalField());
        const scalarField valueOut
        (
            coupled ? valueb.patchNeighbourField() : tmp<scalarField>(valueIn)
        );
        const scalarField layerOut
        (
            coupled ? layerb.patchNeighbourField() : tmp<scalarField>(layerIn)
        );
        forAll(facesb, i)
        {
            setFace
            (
                facesb[i], valueIn[i], layerIn[i], valueOut[i], layerOut[i]
            );
        }
    }
}
