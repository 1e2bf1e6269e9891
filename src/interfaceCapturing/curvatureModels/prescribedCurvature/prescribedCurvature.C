/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "prescribedCurvature.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace curvatureModels
{
    defineTypeName(prescribedCurvature);
    addToRunTimeSelectionTable(curvatureModel, prescribedCurvature, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::curvatureModels::prescribedCurvature::prescribedCurvature
(
    const transportedSurface& surface,
    const dictionary& dict
)
:
    curvatureModel(surface),
    K_(userEntry::number(dict, "K", dimless/dimLength))
{
    userEntry::onlyThese(dict, {"type", "K"});
}


// * * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * //

void Foam::dew::curvatureModels::prescribedCurvature::calculate
(
    scalarField& K,
    boolList& known
)
{
    K = K_;
    known = true;
}
