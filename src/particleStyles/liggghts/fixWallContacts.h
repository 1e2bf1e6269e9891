/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Class
    Foam::dew::fixWallContacts

Description
    fix ID all dew/wallContacts [wall T]...

    The particles that touch a wall or are near one, anew at every sub-step,
    for the laws between particles and walls: what the engine's walls of all
    shapes find, up to its contact distance.

    The engine decides which triangles of a wall a particle meets, and keeps it
    to itself. Each of its walls, fix wall/gran, has an object that computes the
    force of one contact: here a listener takes its place, which passes the call
    on and notes it.

    wall    id of the fix of a wall: wall/gran, or mesh/surface; with its
            temperature T [K]. A wall without is adiabatic.

SourceFiles
    fixWallContacts.cpp
\*---------------------------------------------------------------------------*/

#ifndef dew_fixWallContacts_h
#define dew_fixWallContacts_h

#include <mpi.h>
#include <map>
#include <memory>
#include <string>
#include <vector>
#include "fix.h"

namespace Foam
{
namespace dew
{

//- A particle at a wall, engine units
struct wallContact
{
    //- Particle, and the wall's type, from 1
    int i, type;

    //- Distance of the surfaces; < 0: overlap
    double gap;

    //- Unit normal towards the particle, velocity of the wall
    double n[3], v[3];

    //- Of the wall; < 0: adiabatic
    double T;
};


class fixWallContacts
:
    public LAMMPS_NS::Fix
{
public:

    typedef std::vector<wallContact> list;

private:

    std::map<std::string, double> T_;

    //- Outlives this fix in the listeners
    std::shared_ptr<list> contacts_;

public:

    fixWallContacts(LAMMPS_NS::LAMMPS*, int narg, char** arg);

    //- The only one of an engine; throws where there is none
    static fixWallContacts& of(LAMMPS_NS::LAMMPS*);

    const list& contacts() const { return *contacts_; }

    int setmask() override;
    void init() override;
    void setup_pre_force(int) override { contacts_->clear(); }
    void pre_force(int) override { contacts_->clear(); }
};

} // End namespace dew
} // End namespace Foam

#endif
