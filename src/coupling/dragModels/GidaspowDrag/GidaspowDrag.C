/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "GidaspowDrag.H"
#include "ErgunDrag.H"
#include "WenYuDrag.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace dragModels
{
    defineTypeName(GidaspowDrag);
    addToRunTimeSelectionTable(particleForce, GidaspowDrag, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::dragModels::GidaspowDrag::GidaspowDrag(const dictionary& dict)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::dragModels::GidaspowDrag::Sp
(
    const particle& p,
    const carrier& c
) const
{
    return c.alphac < 0.8 ? ErgunDrag::law(p, c) : WenYuDrag::law(p, c);
}
