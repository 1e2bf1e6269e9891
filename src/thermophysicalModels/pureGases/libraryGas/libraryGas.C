/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "libraryGas.H"
#include "addToRunTimeSelectionTable.H"
#include "gasConstant.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace pureGases
{
    defineTypeName(libraryGas);
    addToRunTimeSelectionTable(pureGas, libraryGas, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::pureGases::libraryGas::libraryGas
(
    const word& species,
    const dictionary& dict
)
:
    fits_(gasFits::get(speciesData::nameOf(species), dict)),
    species_(speciesData::get(species, "molar mass", dict))
{}


Foam::dew::pureGases::libraryGas::libraryGas
(
    const dictionary& dict,
    const liquidModel&
)
:
    libraryGas(dict.get<word>("species"), dict)
{
    userEntry::onlyThese(dict, {"type", "species"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::pureGases::libraryGas::Cp(const scalar T) const
{
    return fits_.Cp(T)*gasConstant/W();
}
