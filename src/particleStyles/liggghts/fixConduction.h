/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Class
    Foam::dew::fixConduction

Description
    fix ID all dew/conduction law Kf (k rc w)...

    Heat between particles that touch, and between particles and walls with a
    temperature, added to the engine's heatFlux at every sub-step:

        contact          contactConduction.H
        BatchelorOBrien  BatchelorOBrienConduction.H, fluid of conductivity Kf
        impact           impactHeat.H: all of it in the sub-step in which
                         the particles come to touch

    What a pair exchanges is one number for both, also across ranks. A pair comes
    to touch when it does now and did not before its last displacement v dt. For
    a particle under drag the displacement differs from that by (Sp dt/m)^2/24
    of it, the share of impacts that may be missed, or counted twice.

    Kf      conductivity of the fluid, engine units
    k rc w  of each type: conductivity, density times heat capacity,
            (1 - nu^2)/E

    Heat taken up from walls is summed on each rank.

SourceFiles
    fixConduction.cpp
\*---------------------------------------------------------------------------*/

#ifndef dew_fixConduction_h
#define dew_fixConduction_h

#include <mpi.h>
#include <vector>
#include "fix.h"
#include "../impactHeat.H"

namespace LAMMPS_NS { class FixPropertyAtom; }

namespace Foam
{
namespace dew
{

class fixWallContacts;

class fixConduction
:
    public LAMMPS_NS::Fix
{
    enum lawType { contact, BatchelorOBrien, impact };

    lawType law_;

    double Kf_;

    //- By type, from 0
    std::vector<thermalBody> body_;
    std::vector<double> compliance_;

    LAMMPS_NS::FixPropertyAtom *temperature_, *heatFlux_;
    fixWallContacts* walls_;

    double wallHeat_;

    //- Power per temperature difference of bodies of types a and b that touch:
    //  their area; R*; mass and speed of the first touch,
    //  < 0 where there was none
    double conductance
    (
        int a, int b, double area, double RStar, double mStar, double speed
    ) const;

    void pairs();
    void walls();

public:

    fixConduction(LAMMPS_NS::LAMMPS*, int narg, char** arg);

    //- Taken up from walls by this rank's particles since clear()
    double wallHeat() const { return wallHeat_; }

    void clear() { wallHeat_ = 0; }

    int setmask() override;
    void init() override;
    void post_force(int) override;
};

} // End namespace dew
} // End namespace Foam

#endif
