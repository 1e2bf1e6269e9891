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
    Fix(lmp, narg, arg)
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


void Foam::dew::fixGravity::setup(int)
{
    post_force(0);
}


void Foam::dew::fixGravity::post_force(int)
{
    double g[3];
    value_(update->ntimestep, g);

    double** f = atom->f;
    const double* rmass = atom->rmass;

    for (int i = 0; i < atom->nlocal; i++)
    {
        for (int k = 0; k < 3; k++)
        {
            f[i][k] += rmass[i]*g[k];
        }
    }
}
