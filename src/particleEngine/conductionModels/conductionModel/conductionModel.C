/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "conductionModel.H"
#include "selectVariant.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(conductionModel);
    defineRunTimeSelectionTable(conductionModel, dictionary);
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::conductionModel> Foam::dew::conductionModel::New
(
    const dictionary& properties,
    const materials& mats
)
{
    dictionary usual;
    usual.add("type", word("contact"));

    const dictionary& dict =
        properties.found("conduction")
      ? userEntry::subDict(properties, "conduction")
      : usual;

    return selectVariant<conductionModel>(dict, "type", "conduction model")
    (
        dict, mats
    );
}
