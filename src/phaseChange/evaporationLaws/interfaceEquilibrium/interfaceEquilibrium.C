/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "interfaceEquilibrium.H"
#include "addToRunTimeSelectionTable.H"
#include "gasMixture.H"
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
    const liquidMixture& liquids,
    const gasMixture& gas
)
:
    liquids_(liquids)
{
    userEntry::onlyThese(dict, {"type"});
    pureLiquid(dict, liquids);
    correct(gas.p0());
    if (!(Tsat_ < 0.1*GREAT))
    {
        FatalIOErrorInFunction(dict)
            << "interfaceEquilibrium holds the surface at the boiling point of "
            << liquids.names()[0] << ", and that has none" << nl
            << "Give Tboil and pBoil in constant/liquidProperties"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::evaporationLaws::interfaceEquilibrium::correct(const scalar p)
{
    Tsat_ = liquids_.liquid(0).Tboil(p);
}


Foam::dew::filmFlux Foam::dew::evaporationLaws::interfaceEquilibrium::flux
(
    const gasFilm&
) const
{
    // Heat decides
    return filmFlux();
}



// ************************************************************************* //
