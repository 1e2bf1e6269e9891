/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Class
    Foam::dew::fixLubrication

Description
    fix ID all dew/lubrication mu sMin sMax reach

    The force of the fluid in narrow gaps (lubrication.H), between particles
    and between particles and walls. It is the last force: it knows the velocity
    that all others lead to at the next half sub-step, and takes away what the
    gaps take from it, for any sub-step.

        v* = v e^2 + b (F + Su + Sp U),   e = exp(-Sp dt/(2 m)),
        b = dt/(2 m) phi1(Sp dt/(2 m)) (1 + e)

    is what fixIntegrate makes of force F in a step; without drag v + F dt/m.

    mu      viscosity of the fluid, engine units
    sMin    gap below which it is sMin that counts
    sMax    largest gap; 0: 0.1 r* of each pair
    reach   contact distance that the engine's lists must have, over the sum of
            radii, for particles and walls

    Both ranks of a pair across their boundary come to the same numbers: v*
    and what else enters are those of the owner.

    Not with dynamics without inertia, where the drag of the coming step is not
    known before it. With Brownian motion the noise of a gap would be missing:
    an error.

SourceFiles
    fixLubrication.cpp
\*---------------------------------------------------------------------------*/

#ifndef dew_fixLubrication_h
#define dew_fixLubrication_h

#include <mpi.h>
#include <vector>
#include "fix.h"

namespace Foam
{
namespace dew
{

class fixIntegrate;
class fixWallContacts;

class fixLubrication
:
    public LAMMPS_NS::Fix
{
    //- A pair, or a particle and a wall (j < 0), with their gap
    struct gap
    {
        int i, j;
        double n[3], s, sMax, k, c;

        //- Of the wall along n
        double wallSpeed;
    };

    const double mu_, sMin_, sMax_;

    fixIntegrate* integrate_;
    fixWallContacts* walls_;

    std::vector<gap> gaps_;

    //- v* and b C of particles and ghosts, four values each
    std::vector<double> ahead_;

    //- Sum of coefficients
    std::vector<double> C_;

    double largest(double rStar) const;

    //- Note a gap, with its coefficient for the speed v at which it opens
    void note(gap&, double v);

    void findPairs();
    void findWalls();

    //- v* and b C of this rank's particles, then of its ghosts
    void lookAhead();

public:

    fixLubrication(LAMMPS_NS::LAMMPS*, int narg, char** arg);

    int setmask() override;
    void init() override;
    void setup(int) override { post_force(0); }
    void post_force(int) override;

    int pack_comm(int, int*, double*, int, int*) override;
    void unpack_comm(int, int, double*) override;
};

} // End namespace dew
} // End namespace Foam

#endif
