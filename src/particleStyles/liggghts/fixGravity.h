/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Class
    Foam::dew::fixGravity

Description
    fix ID all dew/gravity

    F = m g(t), with g read from a function of time at every sub-step, so that
    a shaken container is seen in its own frame.

    m   particle mass
    g   acceleration, engine units

    Its integral over time since clear() is kept, by the rule of the velocity
    Verlet step: half of g at either end of a sub-step.

SourceFiles
    fixGravity.cpp
\*---------------------------------------------------------------------------*/

#ifndef dew_fixGravity_h
#define dew_fixGravity_h

#include <mpi.h>
#include <functional>
#include "fix.h"

namespace Foam
{
namespace dew
{

class fixGravity
:
    public LAMMPS_NS::Fix
{
    std::function<void(long step, double* g)> value_;

    //- Last value, and integral over time
    double g_[3], integral_[3];

    void apply();

public:

    fixGravity(LAMMPS_NS::LAMMPS*, int narg, char** arg);

    void value(std::function<void(long, double*)> f) { value_ = f; }

    void clear();

    //- Integral of g dt over the sub-steps since clear()
    const double* integral() const { return integral_; }

    int setmask() override;
    void setup(int) override;
    void post_force(int) override;
};

} // End namespace dew
} // End namespace Foam

#endif
