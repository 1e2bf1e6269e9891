/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "pointMean.H"
#include "polyMesh.H"
#include "syncTools.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::pointMean::choose(const labelUList& pointLabels)
{
    for (const label pointi : pointLabels)
    {
        if (!chosen_[pointi])
        {
            chosen_[pointi] = true;
            points_.append(pointi);
        }
    }
}


void Foam::dew::pointMean::choosePoints(const labelUList& cells)
{
    chosen_.setSize(mesh_.nPoints());
    chosen_ = false;
    value_.setSize(mesh_.nPoints());
    weight_.setSize(mesh_.nPoints());
    points_.clear();

    for (const label celli : cells)
    {
        for (const label facei : mesh_.cells()[celli])
        {
            choose(mesh_.faces()[facei]);
        }
    }

    // The other side may ask for any point of a coupled boundary
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (patch.coupled())
        {
            for (const face& f : patch)
            {
                choose(f);
            }
        }
    }
}


const Foam::scalarField& Foam::dew::pointMean::mean()
{
    syncTools::syncPointList(mesh_, value_, plusEqOp<scalar>(), scalar(0));
    syncTools::syncPointList(mesh_, weight_, plusEqOp<scalar>(), scalar(0));

    for (const label pointi : points_)
    {
        value_[pointi] /= max(weight_[pointi], VSMALL);
    }
    return value_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::scalarField& Foam::dew::pointMean::operator()
(
    const scalarField& cellValues,
    const labelUList& cells
)
{
    choosePoints(cells);

    const pointField& x = mesh_.points();
    const vectorField& centres = mesh_.cellCentres();
    const labelListList& pointCells = mesh_.pointCells();

    for (const label pointi : points_)
    {
        value_[pointi] = 0;
        weight_[pointi] = 0;
        for (const label celli : pointCells[pointi])
        {
            const scalar weight = 1/mag(x[pointi] - centres[celli]);
            value_[pointi] += weight*cellValues[celli];
            weight_[pointi] += weight;
        }
    }
    return mean();
}


const Foam::scalarField& Foam::dew::pointMean::operator()
(
    const interfacePlanes& planes,
    const labelUList& cells
)
{
    choosePoints(cells);

    const pointField& x = mesh_.points();
    const vectorField& centres = mesh_.cellCentres();
    const labelListList& pointCells = mesh_.pointCells();

    for (const label pointi : points_)
    {
        value_[pointi] = 0;
        weight_[pointi] = 0;
        for (const label celli : pointCells[pointi])
        {
            const label i = planes.of(celli);
            if (i >= 0)
            {
                const scalar weight = 1/magSqr(x[pointi] - centres[celli]);
                value_[pointi] +=
                    weight*((x[pointi] - planes.x()[i]) & planes.n()[i]);
                weight_[pointi] += weight;
            }
        }
    }
    return mean();
}
