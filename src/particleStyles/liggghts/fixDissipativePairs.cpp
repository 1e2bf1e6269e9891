/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fixDissipativePairs.h"
#include "fixIntegrate.h"
#include "../dissipativeParticle.H"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "modify.h"
#include "neigh_list.h"
#include "pair_gran.h"
#include "update.h"

using namespace LAMMPS_NS;

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::fixDissipativePairs::fixDissipativePairs
(
    LAMMPS* lmp,
    int narg,
    char** arg
)
:
    Fix(lmp, narg, arg),
    seed_(0),
    range_(0),
    s_(1),
    kT_(0),
    integrate_(nullptr),
    energy_(0)
{
    const int nCommon = 7;
    const int nPairs = atom->ntypes*atom->ntypes;
    if (narg != nCommon + 2*nPairs)
    {
        error->fix_error
        (
            FLERR, this,
            "takes seed, range, exponent, kT, and two values of each"
            " pair of types"
        );
    }

    seed_ = std::strtoull(arg[3], nullptr, 10);
    range_ = std::atof(arg[4]);
    s_ = std::atof(arg[5]);
    kT_ = std::atof(arg[6]);
    for (int p = 0; p < nPairs; p++)
    {
        a_.push_back(std::atof(arg[nCommon + 2*p]));
        gamma_.push_back(std::atof(arg[nCommon + 2*p + 1]));
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::fixDissipativePairs::checkNoise() const
{
    for (int i = 0; integrate_->colloids() && i < atom->nlocal; i++)
    {
        if (integrate_->colloid(i)[fixIntegrate::kT] > 0)
        {
            throw std::runtime_error
            (
                "dissipative forces and Brownian motion exclude each other:"
                " each is a thermostat. Remove the entry dissipative in"
                " particleProperties, or the Brownian force"
            );
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int Foam::dew::fixDissipativePairs::setmask()
{
    return FixConst::POST_FORCE;
}


void Foam::dew::fixDissipativePairs::init()
{
    integrate_ = dynamic_cast<fixIntegrate*>
    (
        modify->find_fix_style("dew/integrate", 0)
    );

    if (!integrate_ || integrate_->overdamped())
    {
        error->fix_error(FLERR, this, "needs dew/integrate with inertia");
    }
    if (!force->pair_match("gran", 0) || !comm->ghost_velocity)
    {
        error->fix_error
        (
            FLERR, this, "needs pair_style gran and communicate vel yes"
        );
    }
}


void Foam::dew::fixDissipativePairs::post_force(int)
{
    checkNoise();
    energy_ = 0;

    const NeighList& list = *force->pair_match("gran", 0)->list;
    double** x = atom->x;
    double** v = atom->v;
    double** f = atom->f;
    const int* type = atom->type;
    const int* tag = atom->tag;
    const int nLocal = atom->nlocal;
    const int nTypes = atom->ntypes;
    const uint64_t step = uint64_t(update->ntimestep);
    const double dt = update->dt;

    for (int ii = 0; ii < list.inum; ii++)
    {
        const int i = list.ilist[ii];

        for (int jj = 0; jj < list.numneigh[i]; jj++)
        {
            const int j = list.firstneigh[i][jj] & NEIGHMASK;
            const double d[3] =
            {
                x[i][0] - x[j][0], x[i][1] - x[j][1], x[i][2] - x[j][2]
            };
            const double r2 = d[0]*d[0] + d[1]*d[1] + d[2]*d[2];

            // Two in the same place have no line of centres
            if (r2 >= range_*range_ || r2 <= 0)
            {
                continue;
            }

            const double r = std::sqrt(r2);
            const int p = (type[i] - 1)*nTypes + type[j] - 1;
            const dissipativePair pair(a_[p], r, range_, s_);
            double F = pair.F;

            if (gamma_[p] > 0)
            {
                double opens = 0;
                for (int k = 0; k < 3; k++)
                {
                    opens += (v[i][k] - v[j][k])*d[k];
                }
                F = pair.force
                (
                    gamma_[p], kT_, opens/r, dt,
                    pairGaussian(seed_, tag[i], tag[j], step)
                );
            }
            energy_ += j < nLocal ? pair.U : 0.5*pair.U;

            for (int k = 0; k < 3; k++)
            {
                f[i][k] += F/r*d[k];
                if (j < nLocal)
                {
                    f[j][k] -= F/r*d[k];
                }
            }
        }
    }
}
