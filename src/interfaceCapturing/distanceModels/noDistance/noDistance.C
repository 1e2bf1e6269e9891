/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "noDistance.H"
#include "addToRunTimeSelectionTable.H"
#include "transportedSurface.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace distanceModels
{
    defineTypeName(noDistance);
    addToRunTimeSelectionTable(distanceModel, noDistance, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::distanceModels::noDistance::noDistance
(
    const transportedSurface& surface,
    const dictionary& dict
)
:
    distanceModel(surface)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::distanceModels::noDistance::correct
(
    volScalarField& psi,
    volVectorField& n
)
{
    const dimensionedScalar far("far", dimLength, surface_.mesh().bounds().mag());

    psi = (2*surface_.alpha() - 1)*far;
    n = dimensionedVector(dimless, Zero);
}
