/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "constantLiquidDiffusivity.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace liquidDiffusivities
{
    defineTypeName(constantLiquidDiffusivity);
    addToRunTimeSelectionTable
    (
        liquidDiffusivity, constantLiquidDiffusivity, dictionary
    );
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::liquidDiffusivities::constantLiquidDiffusivity::
constantLiquidDiffusivity
(
    const dictionary& dict,
    const PtrList<liquidModel>& liquids
)
:
    liquidDiffusivity(liquids),
    D_(userEntry::positive(dict, "D", dimViscosity))
{
    userEntry::onlyThese(dict, {"type", "D"});
}
