/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Class
    Foam::dew::fixListReach

Description
    fix ID all dew/listReach reach margin factor

    Has the engine build its lists as soon as a particle has moved by the
    margin. The engine itself waits until one has moved by half of the skin:
    then only what overlaps is in the lists for sure. With a skin of

        pairs          reach + 2 margin
        flat walls     2 (reach + margin), their lists hold half of it

    all gaps up to the reach are.

    Walls tell of gaps up to the contact distance factor alone, which holds for
    pairs and lists as well and makes them dear: those get that of touch. To be
    made before the walls.

    The engine passes a particle on to ranks as contacts need it;
    extend_cut_ghost() adds what the lists hold beyond them.

    reach    largest gap between particles that laws need, engine units
    margin   way of a particle from one build to the next, engine units
    factor   contact distance of walls over the radius, 1 without

SourceFiles
    fixListReach.cpp
\*---------------------------------------------------------------------------*/

#ifndef dew_fixListReach_h
#define dew_fixListReach_h

#include <mpi.h>
#include <vector>
#include "fix.h"

namespace Foam
{
namespace dew
{

class fixListReach
:
    public LAMMPS_NS::Fix
{
    const double reach_, margin_;

    //- Contact distance factor of pairs and lists, and of walls
    double touch_, wide_;

    //- Positions when the lists were built, three a particle
    std::vector<double> built_;

public:

    fixListReach(LAMMPS_NS::LAMMPS*, int narg, char** arg);

    int setmask() override;
    void init() override;
    void setup_pre_neighbor() override { pre_neighbor(); }
    void pre_neighbor() override;
    void post_integrate() override;
    void setup_pre_force(int) override { pre_force(0); }
    void pre_force(int) override;
    void setup(int) override { post_force(0); }
    void post_force(int) override;
    double extend_cut_ghost() override { return reach_ + 2*margin_; }
};

} // End namespace dew
} // End namespace Foam

#endif
