/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "interfaceEquilibrium.H"
#include "addToRunTimeSelectionTable.H"
#include "gasModel.H"
#include "liquidModel.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace evaporationLaws
{
    defineTypeName(interfaceEquilibrium);
    addToRunTimeSelectionTable(evaporationLaw, interfaceEquilibrium, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::evaporationLaws::interfaceEquilibrium::interfaceEquilibrium
(
    const dictionary& dict,
    const liquidModel& liquid,
    const gasModel& gas
)
:
    Tsat_(liquid.Tboil(gas.p0()))
{
    userEntry::onlyThese(dict, {"type"});
    if (!(Tsat_ < 0.1*GREAT))
    {
        FatalIOErrorInFunction(dict)
            << "interfaceEquilibrium holds the surface at the boiling point of "
            << liquid.name() << ", and that has none" << nl
            << "Give Tboil and pBoil in constant/liquidProperties"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::filmFlux Foam::dew::evaporationLaws::interfaceEquilibrium::flux
(
    const gasFilm&
) const
{
    // Heat decides
    return filmFlux();
}



// ************************************************************************* //
