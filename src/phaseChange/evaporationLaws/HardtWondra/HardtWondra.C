/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "HardtWondra.H"
#include "addToRunTimeSelectionTable.H"
#include "Enum.H"
#include "gasConstant.H"
#include "gasMixture.H"
#include "mathematicalConstants.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace evaporationLaws
{
    defineTypeName(HardtWondra);
    addToRunTimeSelectionTable(evaporationLaw, HardtWondra, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::evaporationLaws::HardtWondra::HardtWondra
(
    const dictionary& dict,
    const liquidMixture& liquids,
    const gasMixture& gas
)
:
    liquids_(liquids),
    gas_(gas),
    C_(userEntry::within(dict, "accommodation", SMALL, 1)),
    smeared_
    (
        Enum<bool>({{false, "reconstructed"}, {true, "gradAlpha"}}).getOrDefault
        (
            "area", dict, false
        )
    )
{
    userEntry::onlyThese(dict, {"type", "accommodation", "area"});
    pureLiquid(dict, liquids);
    correct(gas.p0());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::evaporationLaws::HardtWondra::correct(const scalar p)
{
    const liquidModel& liquid = liquids_.liquid(0);
    const scalarField noVapour(1, Zero);
    p_ = p;
    Tsat_ = liquid.Tboil(p);
    const scalar hv = liquid.hv(p, Tsat_);
    h_ =
        2*C_/(2 - C_)*hv*hv*gas_.rho(p, Tsat_, noVapour)/pow(Tsat_, 1.5)
       *sqrt(liquid.W()/(constant::mathematical::twoPi*gasConstant));
}


Foam::dew::filmFlux Foam::dew::evaporationLaws::HardtWondra::flux
(
    const gasFilm& film
) const
{
    filmFlux f;
    f.dNdTs = h_/liquids_.liquid(0).hv(p_, Tsat_)*film.cosine;
    f.N = f.dNdTs*(film.Ts - Tsat_);
    return f;
}



// ************************************************************************* //
