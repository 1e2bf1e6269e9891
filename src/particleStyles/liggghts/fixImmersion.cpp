/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fixImmersion.h"
#include "fixIntegrate.h"
#include "../surfaceSpring.H"

#include <cmath>
#include <cstdlib>
#include <cstring>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "modify.h"
#include "neigh_list.h"
#include "pair_gran.h"

using namespace LAMMPS_NS;

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::fixImmersion::fixImmersion(LAMMPS* lmp, int narg, char** arg)
:
    Fix(lmp, narg, arg),
    q_(narg > 3 ? std::atof(arg[3]) : 0),
    cutOff_(narg > 4 ? std::atof(arg[4]) : 0),
    end_(q_*cutOff_ > 0 ? q_*cutOff_ : 1),
    integrate_(nullptr),
    energy_(0)
{
    if (narg != 5 || !(q_ > 0) || !(cutOff_ > 0))
    {
        error->fix_error
        (
            FLERR, this, "takes the inverse of a capillary length and a cut-off"
        );
    }
    comm_forward = nSeen;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::fixImmersion::findCharges()
{
    typedef fixIntegrate f;
    seen_.resize(nSeen*size_t(atom->nlocal + atom->nghost));

    for (int i = 0; i < atom->nlocal; i++)
    {
        double* s = &seen_[nSeen*i];
        std::memset(s, 0, nSeen*sizeof(double));

        const double* c = integrate_->colloid(i);
        if (!(c[f::tension] > 0))
        {
            continue;
        }
        const double R = atom->radius[i];
        const double delta = surfaceDistance
        (
            c + f::offset, c + f::normal, c[f::curvature], s + 3
        );
        if (std::fabs(delta) < R)
        {
            const immersedContactLine line(R, c[f::angle], R - delta, q_);
            s[0] = line.Q;
            s[1] = line.r;
            s[2] = c[f::tension];
        }
    }

    comm->forward_comm_fix(this);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int Foam::dew::fixImmersion::setmask()
{
    return FixConst::POST_FORCE;
}


void Foam::dew::fixImmersion::init()
{
    integrate_ = dynamic_cast<fixIntegrate*>
    (
        modify->find_fix_style("dew/integrate", 0)
    );
    if (!integrate_ || !force->pair_match("gran", 0))
    {
        error->fix_error
        (
            FLERR, this, "needs dew/integrate and pair_style gran"
        );
    }
}


void Foam::dew::fixImmersion::post_force(int)
{
    energy_ = 0;
    if (!integrate_->colloids())
    {
        return;
    }
    findCharges();

    const NeighList& list = *force->pair_match("gran", 0)->list;
    double** x = atom->x;
    double** f = atom->f;
    const int nLocal = atom->nlocal;

    for (int ii = 0; ii < list.inum; ii++)
    {
        const int i = list.ilist[ii];
        const double* a = &seen_[nSeen*i];
        if (a[0] == 0)
        {
            continue;
        }

        for (int jj = 0; jj < list.numneigh[i]; jj++)
        {
            const int j = list.firstneigh[i][jj] & NEIGHMASK;
            const double* b = &seen_[nSeen*j];
            if (b[0] == 0)
            {
                continue;
            }

            double n[3], d[3], nn = 0, dn = 0, LL = 0;
            for (int k = 0; k < 3; k++)
            {
                n[k] = a[3+k] + b[3+k];
                d[k] = x[i][k] - x[j][k];
                nn += n[k]*n[k];
                dn += d[k]*n[k];
            }
            // Two that face each other have no plane in common
            if (nn <= 0)
            {
                continue;
            }
            for (int k = 0; k < 3; k++)
            {
                d[k] -= dn/nn*n[k];
                LL += d[k]*d[k];
            }
            if (LL >= cutOff_*cutOff_ || LL <= 0)
            {
                continue;
            }

            const double L = std::sqrt(LL);
            const immersionForce pair
            (
                0.5*(a[2] + b[2]), a[0], b[0], q_, L, a[1] + b[1], cutOff_,
                end_
            );
            energy_ += j < nLocal ? pair.U : 0.5*pair.U;

            for (int k = 0; k < 3; k++)
            {
                const double F = pair.F/L*d[k];
                f[i][k] += F;
                if (j < nLocal)
                {
                    f[j][k] -= F;
                }
            }
        }
    }
}


int Foam::dew::fixImmersion::pack_comm(int n, int* list, double* buf, int, int*)
{
    for (int i = 0; i < n; i++)
    {
        std::memcpy
        (
            buf + nSeen*i, &seen_[nSeen*list[i]], nSeen*sizeof(double)
        );
    }
    return nSeen;
}


void Foam::dew::fixImmersion::unpack_comm(int n, int first, double* buf)
{
    std::memcpy(&seen_[nSeen*first], buf, nSeen*n*sizeof(double));
}
