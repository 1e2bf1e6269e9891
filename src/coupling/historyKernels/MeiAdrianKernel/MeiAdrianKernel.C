/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "MeiAdrianKernel.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace historyKernels
{
    defineTypeName(MeiAdrianKernel);
    addToRunTimeSelectionTable(historyKernel, MeiAdrianKernel, dictionary);
}
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Gauss' rule with four points on [0, 1]
const Foam::scalar points[4] =
{
    0.0694318442029737, 0.3300094782075719,
    0.6699905217924281, 0.9305681557970263
};
const Foam::scalar weights[4] =
{
    0.1739274225687269, 0.3260725774312731,
    0.3260725774312731, 0.1739274225687269
};


//- int_a^b f(s) ds for f ~ s^-1/2 at 0
template<class Function>
Foam::scalar gauss(const Foam::scalar a, const Foam::scalar b, const Function& f)
{
    const Foam::scalar x0 = Foam::sqrt(a), dx = Foam::sqrt(b) - x0;
    Foam::scalar sum = 0;
    for (int i = 0; i < 4; i++)
    {
        const Foam::scalar x = x0 + points[i]*dx;
        sum += weights[i]*2*x*f(x*x);
    }
    return sum*dx;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dew::historyKernels::MeiAdrianKernel::value
(
    const historyFlow& f,
    const scalar s
)
{
    using constant::mathematical::pi;

    const scalar fH = 0.75 + 0.105*2*f.R*f.slip/f.nu;
    const scalar wake = pi*pow3(f.slip/fH)/(2*f.R*f.nu);

    return
        1/sqr(sqrt(sqrt(pi*s*f.nu)/f.R) + sqrt(wake)*s);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::historyKernels::MeiAdrianKernel::integral
(
    const historyFlow& f,
    const scalar a,
    const scalar b
) const
{
    return gauss(a, b, [&](const scalar s) { return value(f, s); });
}


Foam::scalar Foam::dew::historyKernels::MeiAdrianKernel::newest
(
    const historyFlow& f,
    const scalar h
) const
{
    return gauss
    (
        0, h, [&](const scalar s) { return value(f, s)*(1 - s/h); }
    );
}


Foam::scalar Foam::dew::historyKernels::MeiAdrianKernel::interval
(
    const historyFlow& f,
    const scalar a,
    const scalar b,
    const scalar h
) const
{
    return
        gauss
        (
            a, a + h, [&](const scalar s) { return integral(f, s, s + b - a); }
        )/h;
}
