/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "HardtWondra.H"
#include "addToRunTimeSelectionTable.H"
#include "gasConstant.H"
#include "gasModel.H"
#include "liquidModel.H"
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
    const liquidModel& liquid,
    const gasModel& gas
)
:
    liquid_(liquid),
    p0_(gas.p0()),
    Tsat_(liquid.Tboil(p0_)),
    h_
    (
        [&]
        {
            const scalar C =
                userEntry::within(dict, "accommodation", SMALL, 1);
            const scalar hv = liquid.hv(p0_, Tsat_);
            return
                2*C/(2 - C)*hv*hv*gas.rho(0, Tsat_)/pow(Tsat_, 1.5)
               *sqrt
                (
                    liquid.W()
                   /(constant::mathematical::twoPi*gasConstant)
                );
        }()
    )
{
    userEntry::onlyThese(dict, {"type", "accommodation"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::filmFlux Foam::dew::evaporationLaws::HardtWondra::flux
(
    const gasFilm& film
) const
{
    filmFlux f;
    f.dNdTs = h_/liquid_.hv(p0_, Tsat_)*film.cosine;
    f.N = f.dNdTs*(film.Ts - Tsat_);
    return f;
}



// ************************************************************************* //
