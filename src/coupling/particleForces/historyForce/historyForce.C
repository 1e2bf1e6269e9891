/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "historyForce.H"
#include "addToRunTimeSelectionTable.H"
#include "Switch.H"
#include "userEntry.H"

#include <algorithm>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace particleForces
{
    defineTypeName(historyForce);
    addToRunTimeSelectionTable(particleForce, historyForce, dictionary);
}
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::vector get(const Foam::scalar* m)
{
    return Foam::vector(m[0], m[1], m[2]);
}


void set(Foam::scalar* m, const Foam::vector& v)
{
    m[0] = v.x();
    m[1] = v.y();
    m[2] = v.z();
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleForces::historyForce::historyForce(const dictionary& dict)
:
    kernel_(historyKernel::New(dict)),
    window_(userEntry::positive(dict, "window", dimTime)),
    intervals_(dict.found("intervals") ? userEntry::count(dict, "intervals") : 20),
    tail_(dict.getOrDefault<Switch>("tail", kernel_->type() == "Basset")),
    impulsiveStart_(dict.getOrDefault<Switch>("impulsiveStart", true))
{
    userEntry::onlyThese
    (
        dict,
        {"type", "kernel", "window", "intervals", "tail", "impulsiveStart"}
    );

    if (intervals_ < 1 || intervals_ > 140)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'intervals' is " << intervals_ << ": it must be from 1"
            << " to 140" << exit(FatalIOError);
    }
    if (tail_ && kernel_->type() != "Basset")
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'tail' is on, but only the kernel Basset has one; kernel "
            << kernel_->type() << " falls off by itself" << nl
            << "Remove the entry, and choose a long window"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::particleForces::historyForce::add
(
    scalar* m,
    const vector& dw,
    const scalar length
) const
{
    const label n = label(m[used]);
    if (n == intervals_)
    {
        FatalErrorInFunction
            << "The history force of a particle has more than " << intervals_
            << " steps in its window of " << window_ << " s" << nl
            << "Raise 'intervals' or shorten 'window' in the law 'history' of"
            << " constant/particleProperties, or use longer steps"
            << exit(FatalError);
    }
    std::copy_backward(m + past, m + past + 4*n, m + past + 4*(n + 1));
    set(m + past, dw);
    m[past + 3] = length;
    m[used] = n + 1;
}


void Foam::dew::particleForces::historyForce::remember
(
    scalar* m,
    const vector& w,
    const historyFlow& f
) const
{
    // All in the window are older by the last step
    const scalar h = m[step];
    const scalar perWindow = 1/(2*window_);
    const scalar tailFactor =
        tail_
      ? std::exp(0.5)*kernel_->integral(f, 0, window_)*perWindow
      : 0;
    vector E(exp(-h*perWindow)*get(m + tail));

    // A jump at the end of the window is out of it, whatever the round-off
    const scalar end = (1 - 1e-9)*window_;
    scalar age = h;
    label n = 0;
    for (label k = 0; k < label(m[used]); k++)
    {
        const scalar* one = m + past + 4*k;
        const scalar length = one[3];

        if (age + 0.5*length < end)
        {
            n++;
        }
        else
        {
            const scalar x = length*perWindow;
            E +=
                tailFactor*exp(-age*perWindow)
               *(x > 1e-8 ? (1 - exp(-x))/x : 1)*get(one);
        }
        age += length;
    }
    m[used] = n;
    set(m + tail, E);

    add(m, w - get(m + slip), h);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::forceSuSp Foam::dew::particleForces::historyForce::force
(
    const particle& p,
    const carrier& c
) const
{
    scalar* m = p.memory;
    const vector w(c.U - p.U);
    const historyFlow f{0.5*p.d, c.mu/c.rho, mag(w)};
    const scalar h = c.deltaT;

    if (m[started] > 0)
    {
        remember(m, w, f);
    }
    else if (impulsiveStart_)
    {
        add(m, w, 0);
    }
    m[started] = 1;
    m[step] = h;
    set(m + slip, w);

    const scalar perWindow = 1/(2*window_);
    vector sum((1 - exp(-h*perWindow))/(h*perWindow)*get(m + tail));

    scalar age = 0;
    for (label k = 0; k < label(m[used]); k++)
    {
        const scalar* one = m + past + 4*k;
        const scalar length = one[3];

        sum +=
            (
                length > 0
              ? kernel_->interval(f, age, age + length, h)/length
              : kernel_->jump(f, age, h)
            )
           *get(one);
        age += length;
    }

    const scalar stokes = 6*constant::mathematical::pi*c.mu*f.R;

    forceSuSp result;
    result.addedMass = stokes*kernel_->newest(f, h);
    result.Su =
        stokes*sum
      + result.addedMass*(c.motion.DUDt - (w & c.motion.gradU));
    return result;
}
