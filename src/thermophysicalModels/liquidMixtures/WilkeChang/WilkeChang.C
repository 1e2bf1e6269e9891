/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "WilkeChang.H"
#include "addToRunTimeSelectionTable.H"
#include "speciesData.H"
#include "userEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace liquidDiffusivities
{
    defineTypeName(WilkeChang);
    addToRunTimeSelectionTable(liquidDiffusivity, WilkeChang, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::liquidDiffusivities::WilkeChang::WilkeChang
(
    const dictionary& dict,
    const PtrList<liquidModel>& liquids
)
:
    liquidDiffusivity(liquids),
    solvent_(liquids.size()),
    solute_(liquids.size())
{
    userEntry::onlyThese(dict, {"type"});

    constexpr scalar atm = 101325;
    forAll(liquids, i)
    {
        const liquidModel& l = liquids[i];
        const speciesData* species = speciesData::find(l.name());
        const scalar association = species ? species->association : 1;
        solvent_[i] = 7.4e-15*std::sqrt(association*1e3*l.W());

        // Of constant liquids the density is the same at any temperature
        const scalar T = l.Tboil(atm);
        const scalar V = 1e6*l.W()/l.rho(atm, T < l.Tc() ? T : 0.7*l.Tc());
        solute_[i] = std::pow(V, 0.6);
    }
}
