/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fixLubrication.h"
#include "fixIntegrate.h"
#include "fixWallContacts.h"
#include "../lubrication.H"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair_gran.h"
#include "update.h"

using namespace LAMMPS_NS;

// Values of a particle in ahead_
static const int nAhead = 4;


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::fixLubrication::fixLubrication(LAMMPS* lmp, int narg, char** arg)
:
    Fix(lmp, narg, arg),
    mu_(narg == 7 ? std::atof(arg[3]) : 0),
    sMin_(narg == 7 ? std::atof(arg[4]) : 0),
    sMax_(narg == 7 ? std::atof(arg[5]) : 0),
    integrate_(nullptr),
    walls_(nullptr)
{
    if (narg != 7)
    {
        error->fix_error(FLERR, this, "takes viscosity, two gaps and reach");
    }

    comm_forward = nAhead;
    neighbor->register_contact_dist_factor(std::atof(arg[6]));
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

double Foam::dew::fixLubrication::largest(const double rStar) const
{
    return sMax_ > 0 ? sMax_ : 0.1*rStar;
}


void Foam::dew::fixLubrication::note(gap& g, const double v)
{
    const lubricationGap law{sMin_, g.sMax};
    g.c = g.k*law.meanSlope(g.s, v*update->dt);

    if (g.c > 0)
    {
        C_[g.i] += g.c;
        if (g.j >= 0)
        {
            C_[g.j] += g.c;
        }
        gaps_.push_back(g);
    }
}


void Foam::dew::fixLubrication::findPairs()
{
    const NeighList& list = *force->pair_match("gran", 0)->list;
    const double reach = neighbor->contactDistanceFactor;
    double** x = atom->x;
    double** v = atom->v;
    const double* radius = atom->radius;

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

            if (r2 >= reach*reach*sum*sum)
            {
                continue;
            }

            const double r = std::sqrt(r2);
            const double rStar = radius[i]*radius[j]/sum;
            gap g;
            g.i = i;
            g.j = j;
            g.s = r - sum;
            g.sMax = largest(rStar);
            g.k = lubricationCoefficient(mu_, rStar);
            g.wallSpeed = 0;
            double opens = 0;
            for (int k = 0; k < 3; k++)
            {
                g.n[k] = d[k]/r;
                opens += (v[i][k] - v[j][k])*g.n[k];
            }
            note(g, opens);
        }
    }
}


void Foam::dew::fixLubrication::findWalls()
{
    for (const wallContact& c : walls_->contacts())
    {
        const double R = atom->radius[c.i];
        gap g;
        g.i = c.i;
        g.j = -1;
        g.s = c.gap;
        g.sMax = largest(R);
        g.k = lubricationCoefficient(mu_, R);
        g.wallSpeed = 0;
        double opens = 0;
        for (int k = 0; k < 3; k++)
        {
            g.n[k] = c.n[k];
            g.wallSpeed += c.v[k]*c.n[k];
            opens += (atom->v[c.i][k] - c.v[k])*c.n[k];
        }
        note(g, opens);
    }
}


void Foam::dew::fixLubrication::lookAhead()
{
    typedef fixIntegrate f;
    const bool loaded = integrate_->loaded();
    const double dt = update->dt;

    for (int i = 0; i < atom->nlocal; i++)
    {
        double* a = &ahead_[nAhead*i];
        const double* d = (*integrate_)[i];
        const double e = loaded ? 1 - d[f::Sp]*d[f::halfStep] : 1;
        const double b =
            loaded ? d[f::halfStep]*(1 + e) : dt/atom->rmass[i];

        for (int k = 0; k < 3; k++)
        {
            const double F =
                atom->f[i][k]
              + (loaded ? d[f::Su + k] + d[f::Sp]*d[f::U + k] : 0);
            a[k] = atom->v[i][k]*e*e + b*F;
        }
        a[3] = b*C_[i];
    }

    comm->forward_comm_fix(this);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int Foam::dew::fixLubrication::setmask()
{
    return FixConst::POST_FORCE;
}


void Foam::dew::fixLubrication::init()
{
    integrate_ = dynamic_cast<fixIntegrate*>
    (
        modify->find_fix_style("dew/integrate", 0)
    );
    walls_ = &fixWallContacts::of(lmp);

    if (!integrate_ || integrate_->overdamped())
    {
        error->fix_error(FLERR, this, "needs dew/integrate with inertia");
    }
    if (!force->pair_match("gran", 0))
    {
        error->fix_error(FLERR, this, "needs pair_style gran");
    }
}


void Foam::dew::fixLubrication::post_force(int)
{
    for (int i = 0; integrate_->colloids() && i < atom->nlocal; i++)
    {
        if (integrate_->colloid(i)[fixIntegrate::kT] > 0)
        {
            throw std::runtime_error
            (
                "lubrication and Brownian motion exclude each other: the noise"
                " of the gaps is missing. Remove the entry lubrication in"
                " particleProperties, or the Brownian force"
            );
        }
    }

    const int n = atom->nlocal + atom->nghost;
    gaps_.clear();
    C_.assign(n, 0);
    ahead_.resize(nAhead*size_t(n));

    findPairs();
    findWalls();
    lookAhead();

    double** f = atom->f;
    const double dt = update->dt;

    for (const gap& g : gaps_)
    {
        const double* a = &ahead_[nAhead*g.i];
        const double* b = g.j < 0 ? nullptr : &ahead_[nAhead*g.j];
        const double B = (b ? a[3] + b[3] : a[3])/g.c;

        double opens = -g.wallSpeed;
        for (int k = 0; k < 3; k++)
        {
            opens += (b ? a[k] - b[k] : a[k])*g.n[k];
        }

        const lubricationGap law{sMin_, g.sMax};
        const double F =
            (law.slowed(opens, g.s, B*g.k/dt, dt) - opens)/B;

        for (int k = 0; k < 3; k++)
        {
            f[g.i][k] += F*g.n[k];
            if (g.j >= 0 && g.j < atom->nlocal)
            {
                f[g.j][k] -= F*g.n[k];
            }
        }
    }
}


int Foam::dew::fixLubrication::pack_comm
(
    int n, int* list, double* buf, int, int*
)
{
    for (int i = 0; i < n; i++)
    {
        std::memcpy
        (
            buf + nAhead*i, &ahead_[nAhead*list[i]], nAhead*sizeof(double)
        );
    }
    return nAhead;
}


void Foam::dew::fixLubrication::unpack_comm(int n, int first, double* buf)
{
    std::memcpy(&ahead_[nAhead*first], buf, nAhead*n*sizeof(double));
}
