/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "insertionModel.H"
#include "selectVariant.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(insertionModel);
    defineRunTimeSelectionTable(insertionModel, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::insertionModel::insertionModel
(
    const word& name,
    const dictionary& dict,
    const materials& mats,
    const particleBox& box,
    const Time& time,
    const bool materialRequired
)
:
    name_(name),
    dict_(dict),
    materials_(mats),
    box_(box),
    time_(time),
    material_
    (
        materialRequired || dict.found("material")
      ? mats.index(dict, "material")
      : -1
    ),
    velocity_(userEntry::pointOr(dict, "velocity", dimVelocity, Zero)),
    omega_(userEntry::pointOr(dict, "omega", dimless/dimTime, Zero)),
    T_(userEntry::positiveOr(dict, "T", dimTemperature, 293.15)),
    seed_(dict.getOrDefault<label>("seed", 1))
{}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::insertionModel> Foam::dew::insertionModel::New
(
    const word& name,
    const dictionary& dict,
    const materials& mats,
    const particleBox& box,
    const Time& time
)
{
    return selectVariant<insertionModel>(dict, "type", "insertion")
    (
        name, dict, mats, box, time
    );
}
