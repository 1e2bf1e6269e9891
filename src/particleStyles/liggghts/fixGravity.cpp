/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fixGravity.h"

#include "atom.h"
#include "error.h"
#include "update.h"

using namespace LAMMPS_NS;


Foam::dew::fixGravity::fixGravity(LAMMPS* lmp, int narg, char** arg)
:
    Fix(lmp, narg, arg),
    g_{0, 0, 0},
    integral_{0, 0, 0}
{
    if (narg != 3)
    {
        error->fix_error(FLERR, this, "takes no arguments");
    }
}


int Foam::dew::fixGravity::setmask()
{
    return FixConst::POST_FORCE;
}


void Foam::dew::fixGravity::clear()
{
    for (int k = 0; k < 3; k++)
    {
        integral_[k] = 0;
    }
}


void Foam::dew::fixGravity::setup(int)
{
    // No time goes by
    apply();
}


void Foam::dew::fixGravity::post_force(int)
{
    const double half = 0.5*update->dt;

    for (int k = 0; k < 3; k++)
    {
        integral_[k] += half*g_[k];
    }

    apply();

    for (int k = 0; k < 3; k++)
    {
        integral_[k] += half*g_[k];
    }
}


void Foam::dew::fixGravity::apply()
{
    value_(update->ntimestep, g_);

    double** f = atom->f;
    const double* rmass = atom->rmass;

    for (int i = 0; i < atom->nlocal; i++)
    {
        for (int k = 0; k < 3; k++)
        {
            f[i][k] += rmass[i]*g_[k];
        }
    }
}
