/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "areaConduction.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace conductionModels
{
    defineTypeName(areaConduction);
    addToRunTimeSelectionTable(conductionModel, areaConduction, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::conductionModels::areaConduction::areaConduction
(
    const dictionary& dict,
    const materials&
)
{
    userEntry::onlyThese(dict, {"type"});
}
