/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "saturation.H"
#include "error.H"

// * * * * * * * * * * * * * * * * Functions  * * * * * * * * * * * * * * * * //

Foam::scalar Foam::dew::saturation::Yinf
(
    const liquidModel& liquid,
    const gasModel& gas,
    const scalar RH,
    const scalar T
)
{
    if (!(RH >= 0 && RH <= 1))
    {
        FatalErrorInFunction
            << "Relative humidity " << RH << " of vapour of "
            << liquid.name() << nl
            << "It must be between 0 and 1; 40 % is 0.4"
            << exit(FatalError);
    }
    return gas.Y(RH*xs(liquid, gas, T));
}
