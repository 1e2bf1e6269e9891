/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "BassetKernel.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace historyKernels
{
    defineTypeName(BassetKernel);
    addToRunTimeSelectionTable(historyKernel, BassetKernel, dictionary);
}
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- R/sqrt(pi nu) [s^1/2]
Foam::scalar factor(const Foam::dew::historyFlow& f)
{
    return f.R/Foam::sqrt(Foam::constant::mathematical::pi*f.nu);
}


Foam::scalar pow32(const Foam::scalar s)
{
    return s*Foam::sqrt(s);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::historyKernels::BassetKernel::integral
(
    const historyFlow& f,
    const scalar a,
    const scalar b
) const
{
    return 2*factor(f)*(sqrt(b) - sqrt(a));
}


Foam::scalar Foam::dew::historyKernels::BassetKernel::newest
(
    const historyFlow& f,
    const scalar h
) const
{
    return 4.0/3*factor(f)*sqrt(h);
}


Foam::scalar Foam::dew::historyKernels::BassetKernel::interval
(
    const historyFlow& f,
    const scalar a,
    const scalar b,
    const scalar h
) const
{
    return
        4.0/3*factor(f)/h
       *((pow32(b + h) - pow32(b)) - (pow32(a + h) - pow32(a)));
}
