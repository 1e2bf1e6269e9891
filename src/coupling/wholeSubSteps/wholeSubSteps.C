/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "wholeSubSteps.H"
#include "Time.H"

#include <cmath>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::wholeSubSteps
(
    const Time& time,
    const scalar wanted,
    const scalar subStep
)
{
    // What is a whole number but for rounding is one
    const scalar tolerance = 1e-6;

    scalar n = std::floor(wanted/subStep*(1 + tolerance));
    if (n < 1)
    {
        WarningInFunction
            << "The fluid asks for a time step of " << wanted
            << " s, less than one sub-step of the particles, " << subStep
            << " s, at time " << time.timeName() << nl
            << "Lower timeStep.deltaT or timeStep.fraction in"
            << " constant/particleProperties" << endl;
        n = 1;
    }

    const dictionary& control = time.controlDict();
    const word writeControl
    (
        control.getOrDefault<word>("writeControl", "timeStep")
    );
    if (writeControl == "adjustable" || writeControl == "adjustableRunTime")
    {
        const scalar interval = control.get<scalar>("writeInterval");
        const scalar past = time.value() - time.startTime().value();

        // The write times are multiples; half a sub-step early counts as met
        const scalar next =
            (std::floor((past + 0.5*subStep)/interval) + 1)*interval;
        const scalar left = max(std::round((next - past)/subStep), scalar(1));
        const scalar steps = std::ceil(left/n*(1 - 1e-12));

        n = std::ceil(left/steps*(1 - 1e-12));

        // Time takes half a step early for met: leave more than that
        while (n > 1 && left > n && left - n <= 0.5*n)
        {
            n--;
        }
    }

    return n*subStep;
}
