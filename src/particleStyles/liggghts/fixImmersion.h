/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Class
    Foam::dew::fixImmersion

Description
    fix ID all dew/immersion q cutOff

    Capillary attraction of particles that stick out of the liquid
    (immersionForce.H), of those whose surface has a tension (fixIntegrate).
    The film is what of a particle is below the surface, l = R - delta. The
    force acts in the plane that is normal to the mean normal of the two, along
    the projection of the line of centres, whose length is L; sigma is the mean.

    q        inverse of the capillary length
    cutOff   largest L

    Charges are those at the positions of the sub-step, and travel to ghosts.
    The engine's lists must reach as far (fixListReach). A pair across a
    boundary of ranks is computed on both, its energy counts half on each.

    Before the first bulk forces of a run there is no surface: the half kick at
    its start has none of this force.

SourceFiles
    fixImmersion.cpp
\*---------------------------------------------------------------------------*/

#ifndef dew_fixImmersion_h
#define dew_fixImmersion_h

#include <mpi.h>
#include <vector>
#include "fix.h"
#include "../immersionForce.H"

namespace Foam
{
namespace dew
{

class fixIntegrate;

class fixImmersion
:
    public LAMMPS_NS::Fix
{
    const double q_, cutOff_;

    //- At the cut-off
    const meniscusFunctions end_;

    fixIntegrate* integrate_;

    //- Of particles and ghosts: charge, radius of the line, tension, normal
    static const int nSeen = 6;
    std::vector<double> seen_;

    //- Of this rank, at the last sub-step [engine units]
    double energy_;

    //- Those of this rank, then of its ghosts
    void findCharges();

public:

    fixImmersion(LAMMPS_NS::LAMMPS*, int narg, char** arg);

    double energy() const { return energy_; }

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
