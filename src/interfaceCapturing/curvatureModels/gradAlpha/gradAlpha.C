/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "gradAlpha.H"
#include "addToRunTimeSelectionTable.H"
#include "fvcDiv.H"
#include "transportedSurface.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace curvatureModels
{
    defineTypeName(gradAlpha);
    addToRunTimeSelectionTable(curvatureModel, gradAlpha, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::curvatureModels::gradAlpha::gradAlpha
(
    const transportedSurface& surface,
    const dictionary& dict
)
:
    curvatureModel(surface)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * //

void Foam::dew::curvatureModels::gradAlpha::calculate
(
    scalarField& K,
    boolList& known
)
{
    K = fvc::div(surface_.normalFlux())().primitiveField();
    known = true;
}
