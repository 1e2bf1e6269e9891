/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "paraboloid.H"
#include "addToRunTimeSelectionTable.H"
#include "transportedSurface.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace curvatureModels
{
    defineTypeName(paraboloid);
    addToRunTimeSelectionTable(curvatureModel, paraboloid, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::curvatureModels::paraboloid::paraboloid
(
    const transportedSurface& surface,
    const dictionary& dict
)
:
    curvatureModel(surface),
    around_(surface.mesh())
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * //

void Foam::dew::curvatureModels::paraboloid::calculate
(
    scalarField& K,
    boolList& known
)
{
    const interfacePlanes& planes = surface_.planes();
    const paraboloidFit fit(surface_.mesh());

    around_.correct(planes, surface_.angles());
    nFits_ = nLeft_ = 0;
    planesAround::plane surface;
    for (const label celli : planes.cell())
    {
        known[celli] = fit.find(around_, celli, K[celli], surface);
        known[celli] ? nFits_++ : nLeft_++;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::curvatureModels::paraboloid::report(Ostream& os) const
{
    const label nFits = returnReduce(nFits_, sumOp<label>());
    const label nLeft = returnReduce(nLeft_, sumOp<label>());

    os  << "Curvature: " << nFits << " cells by paraboloids, " << nLeft
        << " by neighbours" << endl;
}
