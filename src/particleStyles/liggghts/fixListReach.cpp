/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fixListReach.h"
#include "fixIntegrate.h"

#include <cstdlib>

#include "atom.h"
#include "error.h"
#include "modify.h"
#include "neighbor.h"
#include "update.h"

using namespace LAMMPS_NS;

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::fixListReach::fixListReach(LAMMPS* lmp, int narg, char** arg)
:
    Fix(lmp, narg, arg),
    reach_(narg == 6 ? std::atof(arg[3]) : 0),
    margin_(narg == 6 ? std::atof(arg[4]) : 0),
    touch_(1),
    wide_(1)
{
    if (margin_ <= 0)
    {
        error->fix_error
        (
            FLERR, this, "takes the reach, a margin > 0, and a factor"
        );
    }
    neighbor->register_contact_dist_factor(std::atof(arg[5]));
    force_reneighbor = 1;
    next_reneighbor = -1;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int Foam::dew::fixListReach::setmask()
{
    return
        FixConst::PRE_NEIGHBOR
      | FixConst::POST_INTEGRATE
      | FixConst::PRE_FORCE
      | FixConst::POST_FORCE;
}


void Foam::dew::fixListReach::init()
{
    // All have registered theirs
    wide_ = neighbor->contactDistanceFactor;

    auto* integrate = dynamic_cast<fixIntegrate*>
    (
        modify->find_fix_style("dew/integrate", 0)
    );
    if (!integrate)
    {
        error->fix_error(FLERR, this, "needs dew/integrate");
    }
    touch_ = integrate->touchFactor();
}


void Foam::dew::fixListReach::pre_neighbor()
{
    const double* x = atom->nlocal ? atom->x[0] : nullptr;
    built_.assign(x, x + 3*atom->nlocal);
    neighbor->contactDistanceFactor = touch_;
}


void Foam::dew::fixListReach::post_integrate()
{
    const double most = margin_*margin_;
    int far = 0;

    for (int i = 0; i < atom->nlocal; i++)
    {
        const double* x = atom->x[i];
        const double* y = &built_[3*i];
        const double d[3] = {x[0] - y[0], x[1] - y[1], x[2] - y[2]};
        far |= d[0]*d[0] + d[1]*d[1] + d[2]*d[2] > most;
    }

    MPI_Allreduce(MPI_IN_PLACE, &far, 1, MPI_INT, MPI_MAX, world);
    if (far)
    {
        next_reneighbor = update->ntimestep;
    }
}


void Foam::dew::fixListReach::pre_force(int)
{
    neighbor->contactDistanceFactor = touch_;
}


void Foam::dew::fixListReach::post_force(int)
{
    neighbor->contactDistanceFactor = wide_;
}
