/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "noConduction.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace conductionModels
{
    defineTypeName(noConduction);
    addToRunTimeSelectionTable(conductionModel, noConduction, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::conductionModels::noConduction::noConduction
(
    const dictionary& dict,
    const materials&
)
{
    userEntry::onlyThese(dict, {"type"});
}
