/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Class
    Foam::dew::fixColloidPairs

Description
    fix ID all dew/colloidPairs

    Forces along the line of centres that depend on the gap alone
    (pairInteraction.H), between particles and between particles and walls,
    and their energy.

    The engine's lists must reach as far as the laws do (fixListReach).

    A pair across a boundary of ranks is computed on both, each for its own
    particle; its energy counts half on each.

SourceFiles
    fixColloidPairs.cpp
\*---------------------------------------------------------------------------*/

#ifndef dew_fixColloidPairs_h
#define dew_fixColloidPairs_h

#include <mpi.h>
#include "fix.h"

namespace Foam
{
namespace dew
{

class fixWallContacts;
class pairInteraction;

class fixColloidPairs
:
    public LAMMPS_NS::Fix
{
    const pairInteraction* law_;

    //- One unit of the engine [m], [N]
    double length_, force_;

    fixWallContacts* walls_;

    //- Of this rank, at the last sub-step [J]
    double energy_;

    void pairs();
    void atWalls();

public:

    fixColloidPairs(LAMMPS_NS::LAMMPS*, int narg, char** arg);

    //- The laws, which outlive this fix, and the engine's units [m], [N]
    void interaction(const pairInteraction&, double length, double force);

    //- Energy of this rank [J]
    double energy() const { return energy_; }

    int setmask() override;
    void init() override;
    void setup(int) override { post_force(0); }
    void post_force(int) override;
};

} // End namespace dew
} // End namespace Foam

#endif
