/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fixColloidPairs.h"
#include "fixWallContacts.h"
#include "../pairInteraction.H"

#include <cmath>
#include <stdexcept>

#include "atom.h"
#include "error.h"
#include "force.h"
#include "neigh_list.h"
#include "pair_gran.h"

using namespace LAMMPS_NS;

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::fixColloidPairs::fixColloidPairs(LAMMPS* lmp, int narg, char** arg)
:
    Fix(lmp, narg, arg),
    law_(nullptr),
    length_(1),
    force_(1),
    walls_(nullptr),
    energy_(0)
{
    if (narg != 3)
    {
        error->fix_error(FLERR, this, "takes no arguments");
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::fixColloidPairs::pairs()
{
    const NeighList& list = *force->pair_match("gran", 0)->list;
    const double length = length_;
    const double cutOff = law_->cutOff()/length;
    double** x = atom->x;
    double** f = atom->f;
    const double* radius = atom->radius;
    const int* type = atom->type;
    const int nLocal = atom->nlocal;

    for (int ii = 0; ii < list.inum; ii++)
    {
        const int i = list.ilist[ii];

        for (int jj = 0; jj < list.numneigh[i]; jj++)
        {
            const int j = list.firstneigh[i][jj] & NEIGHMASK;
            const double sum = radius[i] + radius[j];
            const double d[3] =
            {
                x[i][0] - x[j][0], x[i][1] - x[j][1], x[i][2] - x[j][2]
            };
            const double r2 = d[0]*d[0] + d[1]*d[1] + d[2]*d[2];

            if (r2 >= (sum + cutOff)*(sum + cutOff))
            {
                continue;
            }

            const double r = std::sqrt(r2);
            const colloidForce c = law_->pair
            (
                type[i] - 1, type[j] - 1,
                radius[i]*length, radius[j]*length, (r - sum)*length
            );
            const double scale = c.F/(force_*r);
            energy_ += j < nLocal ? c.U : 0.5*c.U;

            for (int k = 0; k < 3; k++)
            {
                f[i][k] += scale*d[k];
                if (j < nLocal)
                {
                    f[j][k] -= scale*d[k];
                }
            }
        }
    }
}


void Foam::dew::fixColloidPairs::atWalls()
{
    for (const wallContact& w : walls_->contacts())
    {
        const double h = w.gap*length_;
        if (h >= law_->cutOff())
        {
            continue;
        }
        const colloidForce c = law_->wall
        (
            atom->type[w.i] - 1, w.type - 1,
            atom->radius[w.i]*length_, h
        );
        energy_ += c.U;
        for (int k = 0; k < 3; k++)
        {
            atom->f[w.i][k] += c.F/force_*w.n[k];
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::fixColloidPairs::interaction
(
    const pairInteraction& law,
    const double length,
    const double force
)
{
    law_ = &law;
    length_ = length;
    force_ = force;
}


int Foam::dew::fixColloidPairs::setmask()
{
    return FixConst::POST_FORCE;
}


void Foam::dew::fixColloidPairs::init()
{
    walls_ = &fixWallContacts::of(lmp);

    if (!law_)
    {
        throw std::runtime_error("dew/colloidPairs has got no laws");
    }
    if (!force->pair_match("gran", 0))
    {
        error->fix_error(FLERR, this, "needs pair_style gran");
    }
}


void Foam::dew::fixColloidPairs::post_force(int)
{
    energy_ = 0;
    pairs();
    atWalls();
}
