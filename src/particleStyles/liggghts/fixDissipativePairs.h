/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Class
    Foam::dew::fixDissipativePairs

Description
    fix ID all dew/dissipativePairs seed range s kT a11 g11 a12 g12 ...

    Dissipative particle dynamics (dissipativeParticle.H): conservative,
    dissipative and random force along the line of centres, between particles.

    seed    of the noise
    range   of the forces rc
    s, kT   exponent of the weight, thermal energy
    a, g    largest conservative force and friction of each pair of types

    Velocity Verlet with the velocity at the half sub-step, and the sum of all
    pairs: the temperature is too high in proportion to the sub-step, 0.4 % at
    0.01 (m rc^2/kT)^1/2 and 1 % at twice that in the fluid of Groot and Warren.
    Exact steps of one pair after another (pairThermostat) have no such error,
    but need an order of the pairs, and ranks could not agree on one without
    waiting for each other.

    The engine's lists must reach as far as rc (fixListReach).

    A pair across a boundary of ranks is computed on both, each for its own
    particle; its number is that of particles and sub-step, its energy counts
    half on each.

    Errors: Brownian motion beside it, a second thermostat; dynamics without
    inertia.

SourceFiles
    fixDissipativePairs.cpp
\*---------------------------------------------------------------------------*/

#ifndef dew_fixDissipativePairs_h
#define dew_fixDissipativePairs_h

#include <mpi.h>
#include <cstdint>
#include <vector>
#include "fix.h"

namespace Foam
{
namespace dew
{

class fixIntegrate;

class fixDissipativePairs
:
    public LAMMPS_NS::Fix
{
    uint64_t seed_;
    double range_, s_, kT_;

    //- Of each pair of types
    std::vector<double> a_, gamma_;

    fixIntegrate* integrate_;

    //- Of this rank, at the last sub-step [engine units]
    double energy_;

    //- Refuse Brownian particles
    void checkNoise() const;

public:

    fixDissipativePairs(LAMMPS_NS::LAMMPS*, int narg, char** arg);

    //- Conservative energy of this rank [engine units]
    double energy() const { return energy_; }

    int setmask() override;
    void init() override;
    void setup(int) override { post_force(0); }
    void post_force(int) override;
};

} // End namespace dew
} // End namespace Foam

#endif
