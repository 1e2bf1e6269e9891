/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "StokesCunninghamDrag.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace dragModels
{
    defineTypeName(StokesCunninghamDrag);
    addToRunTimeSelectionTable(particleForce, StokesCunninghamDrag, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::dragModels::StokesCunninghamDrag::StokesCunninghamDrag
(
    const dictionary& dict
)
:
    StokesDrag(dict)
{
    userEntry::positive(dict, "meanFreePath", dimLength);
}
