/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "PLIC.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace reconstructions
{
    defineTypeName(PLIC);
    addToRunTimeSelectionTable(reconstruction, PLIC, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::reconstructions::PLIC::PLIC
(
    const fvMesh& mesh,
    const contactAngles&,
    const dictionary& dict
)
:
    reconstruction(mesh, dict),
    iterations_
    (
        dict.found("iterations") ? userEntry::count(dict, "iterations") : 1
    ),
    pointMean_(mesh),
    cut_(mesh)
{
    userEntry::onlyThese(dict, {"type", "tolerance", "iterations"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::reconstructions::PLIC::correct(const volScalarField& alpha)
{
    const scalarField& share = alpha.primitiveField();
    findCrossed(share);

    // Highest where there is no liquid
    const scalarField gas(pointMean_(1 - share, crossed_));
    for (const label celli : crossed_)
    {
        cut_.set(celli);
        cut_.function(gas);
        appendPlane
        (
            cut_, celli, cut_.gradient(), share[celli],
            mesh_.cellCentres()[celli]
        );
    }

    for (label iteration = 0; iteration < iterations_; iteration++)
    {
        before_ = planes_;
        const scalarField& distance = pointMean_(before_, crossed_);
        planes_.clear(mesh_.nCells());
        forAll(before_.cell(), i)
        {
            const label celli = before_.cell()[i];
            cut_.set(celli);
            cut_.function(distance);
            const vector g(cut_.gradient());
            appendPlane
            (
                cut_, celli, mag(mag(g) - 1) < 0.2 ? g : before_.n()[i],
                share[celli], before_.x()[i]
            );
        }
    }
}
