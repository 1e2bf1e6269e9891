/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Class
    Foam::dew::contactSums

Description
    Sums over the contacts of each particle, found by asking the contact laws
    once more at the present state, without a change of forces or histories. A
    compute of the engine for the length of one call only: a run that does not
    ask pays nothing.

    Contacts with particles and with walls of triangles are told one by one.
    For the primitive walls of the engine, each of which touches a particle
    once, the force on the particle is found by itself.

SourceFiles
    contactSums.cpp
\*---------------------------------------------------------------------------*/

#ifndef dew_contactSums_h
#define dew_contactSums_h

#include "compute_pair_gran_local.h"

#include <vector>

namespace LAMMPS_NS
{
    class FixWallGran;
}

namespace Foam
{
namespace dew
{

class contactSums
:
    public LAMMPS_NS::ComputePairGranLocal
{
    //- Of the particles of this rank; six values each of moment
    std::vector<double> number_, moment_;

    //- Where the contact with a wall is that comes next
    double point_[3];

    class firstStep;

    contactSums(LAMMPS_NS::LAMMPS*, int iarg, const firstStep&);

    //- Add the symmetric part of factor l F
    void add
    (
        const int i, const double* l, const double* F, const double factor
    );

    void pairs();

    void triangles(LAMMPS_NS::FixWallGran&);

    void primitive(LAMMPS_NS::FixWallGran&);

public:

    //- Ghosts must be at the positions of the last forces
    explicit contactSums(LAMMPS_NS::LAMMPS*);

    const std::vector<double>& number() const { return number_; }

    //- xx xy xz yy yz zz of -sum l F, in units of the engine
    const std::vector<double>& moment() const { return moment_; }


    // What the engine tells

        void add_pair
        (
            int i, int j, double fx, double fy, double fz,
            double, double, double, double*, const double* const
        ) override;

        void add_wall_1(int, int, int, double* point, double*) override;

        void add_wall_2
        (
            int i, double fx, double fy, double fz,
            double, double, double, double*, double, double*
        ) override;

        void add_heat(int, int, double) override {}

        void add_heat_wall(int, double) override {}

        void pair_finalize() override {}
};

} // End namespace dew
} // End namespace Foam

#endif
