/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "levelSet.H"
#include "cellWidth.H"
#include "transportedSurface.H"
#include "wallContact.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::distanceModels::levelSet::setBand
(
    const UList<labelPair>& betweenFaces
)
{
    const fvMesh& mesh = surface_.mesh();

    layer_.setSize(mesh.nCells());
    layer_ = -1;
    for (const label celli : surface_.planes().cell())
    {
        layer_[celli] = 0;
    }
    for (const labelPair& pair : betweenFaces)
    {
        layer_[pair.first()] = 0;
    }
    cellLinks::grow(mesh, nLayers, layer_);

    DynamicList<label> cells;
    forAll(layer_, celli)
    {
        if (layer_[celli] >= 0)
        {
            cells.append(celli);
        }
    }
    band_.set
    (
        cells, layer_, wallContact::faces(surface_, betweenFaces, nLayers)
    );

    dx_.setSize(cells.size());
    held_.setSize(cells.size());
    gradn_.setSize(mesh.nCells());
    gradn_ = Zero;
    const scalarField& width = cellWidth::of(mesh);
    forAll(cells, i)
    {
        dx_[i] = width[cells[i]];
        held_[i] = layer_[cells[i]] == 0;
    }

    atWalls_.clear();
    forAll(cells, i)
    {
        for (const cellLinks::link& l : band_.of(i))
        {
            if (l.patch >= 0)
            {
                atWalls_.append(i);
                break;
            }
        }
    }
}


void Foam::dew::distanceModels::levelSet::start
(
    const UList<labelPair>& betweenFaces,
    scalarField& psi
)
{
    const fvMesh& mesh = surface_.mesh();
    const interfacePlanes& planes = surface_.planes();
    const scalarField& alpha = surface_.alpha().primitiveField();

    gradient_.setSize(mesh.nCells());
    forAll(band_.cell(), i)
    {
        const label celli = band_.cell()[i];
        gradient_[celli] = Zero;
        psi[celli] = 0.75*(2*alpha[celli] - 1)*dx_[i];
    }
    forAll(planes.cell(), i)
    {
        const label celli = planes.cell()[i];
        psi[celli] = (planes.x()[i] - mesh.C()[celli]) & planes.n()[i];
        gradient_[celli] = -planes.n()[i];
    }
    for (const labelPair& pair : betweenFaces)
    {
        const label celli = pair.first();
        const vector m(normalised(mesh.faceAreas()[pair.second()]));
        psi[celli] =
            mag((mesh.faceCentres()[pair.second()] - mesh.C()[celli]) & m)
           *(alpha[celli] > 0.5 ? 1 : -1);

        const bool out = mesh.faceOwner()[pair.second()] == celli;
        gradient_[celli] = out == (alpha[celli] > 0.5) ? -m : m;
    }

    for (label layer = 1; layer <= nLayers; layer++)
    {
        fetch(psi);
        fetchGradient();
        march(layer, psi);
    }
}


void Foam::dew::distanceModels::levelSet::march
(
    const label layer,
    scalarField& psi
)
{
    List<label> layerBehind;
    cellLinks::fetch(surface_.mesh(), layer_, layerBehind);

    forAll(band_.cell(), i)
    {
        const label celli = band_.cell()[i];
        if (layer_[celli] != layer)
        {
            continue;
        }
        vector g(Zero);
        scalar sum = 0;
        label n = 0;
        for (const cellLinks::link& l : band_.of(i))
        {
            if (l.patch != cellLinks::inside)
            {
                continue;
            }
            const bool here = l.cell >= 0;
            const label k = here ? l.cell : -1 - l.cell;
            if ((here ? layer_[k] : layerBehind[k]) == layer - 1)
            {
                const vector& gk = here ? gradient_[k] : gradientBehind_[k];
                sum += (here ? psi[k] : psiBehind_[k]) - (gk & l.d);
                g += gk;
                n++;
            }
        }
        if (n > 0)
        {
            gradient_[celli] = normalised(g);
            psi[celli] = sum/n;
        }
    }
}
