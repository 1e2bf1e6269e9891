/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "saturation.H"
#include "error.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

void check(const Foam::scalar RH, const Foam::dew::liquidModel& liquid)
{
    if (!(RH >= 0 && RH <= 1))
    {
        FatalErrorInFunction
            << "Relative humidity " << RH << " of vapour of "
            << liquid.name() << Foam::nl
            << "It must be between 0 and 1; 40 % is 0.4"
            << Foam::exit(Foam::FatalError);
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Functions  * * * * * * * * * * * * * * * * //

Foam::scalar Foam::dew::saturation::Yinf
(
    const liquidModel& liquid,
    const gasMixture& gas,
    const scalar RH,
    const scalar p,
    const scalar T
)
{
    check(RH, liquid);
    return gas.Y(RH*liquid.pSat(T)/p);
}
