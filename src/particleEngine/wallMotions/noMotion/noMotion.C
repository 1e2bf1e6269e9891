/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "noMotion.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace wallMotions
{
    defineTypeName(noMotion);
    addToRunTimeSelectionTable(wallMotion, noMotion, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::wallMotions::noMotion::noMotion(const dictionary& dict)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::boundBox Foam::dew::wallMotions::noMotion::swept
(
    const boundBox& bb,
    const scalar
) const
{
    return bb;
}


std::string Foam::dew::wallMotions::noMotion::engineArguments
(
    const engineUnits&
) const
{
    return std::string();
}
