/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fixConduction.h"
#include "fixWallContacts.h"
#include "../BatchelorOBrienConduction.H"
#include "../contactConduction.H"

#include <cmath>
#include <cstdlib>
#include <string>

#include "atom.h"
#include "error.h"
#include "fix_property_atom.h"
#include "force.h"
#include "modify.h"
#include "neigh_list.h"
#include "pair_gran.h"
#include "update.h"

using namespace LAMMPS_NS;


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::fixConduction::fixConduction(LAMMPS* lmp, int narg, char** arg)
:
    Fix(lmp, narg, arg),
    law_(contact),
    Kf_(0),
    temperature_(nullptr),
    heatFlux_(nullptr),
    walls_(nullptr),
    wallHeat_(0)
{
    const int nPerType = 3;
    if (narg != 5 + nPerType*atom->ntypes)
    {
        error->fix_error
        (
            FLERR, this, "takes law, Kf, and three values of each type"
        );
    }

    const std::string law(arg[3]);
    if (law == "BatchelorOBrien")
    {
        law_ = BatchelorOBrien;
    }
    else if (law == "impact")
    {
        law_ = impact;
    }
    else if (law != "contact")
    {
        error->fix_error(FLERR, this, "knows no such law");
    }

    Kf_ = std::atof(arg[4]);
    for (int t = 0; t < atom->ntypes; t++)
    {
        char** values = arg + 5 + nPerType*t;
        body_.push_back({std::atof(values[0]), std::atof(values[1])});
        compliance_.push_back(std::atof(values[2]));
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

double Foam::dew::fixConduction::conductance
(
    const int a,
    const int b,
    const double area,
    const double RStar,
    const double mStar,
    const double speed
) const
{
    const thermalBody &one = body_[a - 1], &two = body_[b - 1];

    switch (law_)
    {
        case contact:
            return contactConductance(one.k, two.k, area);

        case BatchelorOBrien:
            return BatchelorOBrienConductance
            (
                Kf_, conductivityRatio(one.k, two.k, Kf_), 2*RStar
            );

        default:
            return
                speed > 0
              ? impactHeat
                (
                    one, two, mStar, RStar,
                    1/(compliance_[a - 1] + compliance_[b - 1]), speed
                )/update->dt
              : 0;
    }
}


void Foam::dew::fixConduction::pairs()
{
    const NeighList& list = *force->pair_match("gran", 0)->list;
    const double* T = temperature_->vector_atom;
    double* flux = heatFlux_->vector_atom;
    const double dt = update->dt;
    const double* R = atom->radius;
    const double* m = atom->rmass;

    for (int ii = 0; ii < list.inum; ii++)
    {
        const int i = list.ilist[ii];

        for (int jj = 0; jj < list.numneigh[i]; jj++)
        {
            const int j = list.firstneigh[i][jj] & NEIGHMASK;
            const double sum = R[i] + R[j];
            double r2 = 0, before2 = 0, opens = 0;
            for (int k = 0; k < 3; k++)
            {
                const double d = atom->x[i][k] - atom->x[j][k];
                const double w = atom->v[i][k] - atom->v[j][k];
                r2 += d*d;
                before2 += (d - w*dt)*(d - w*dt);
                opens += w*d;
            }
            if (r2 >= sum*sum)
            {
                continue;
            }

            const double r = std::sqrt(r2);
            const double Q =
                (T[j] - T[i])
               *conductance
                (
                    atom->type[i], atom->type[j],
                    contactArea(R[i], R[j], r), R[i]*R[j]/sum,
                    m[i]*m[j]/(m[i] + m[j]),
                    before2 >= sum*sum ? -opens/r : -1
                );

            flux[i] += Q;
            if (j < atom->nlocal)
            {
                flux[j] -= Q;
            }
        }
    }
}


void Foam::dew::fixConduction::walls()
{
    const double* T = temperature_->vector_atom;
    double* flux = heatFlux_->vector_atom;
    const double dt = update->dt;

    for (const wallContact& c : walls_->contacts())
    {
        if (c.T < 0 || c.gap >= 0)
        {
            continue;
        }

        const double R = atom->radius[c.i];
        double opens = 0;
        for (int k = 0; k < 3; k++)
        {
            opens += (atom->v[c.i][k] - c.v[k])*c.n[k];
        }

        const double Q =
            (c.T - T[c.i])
           *conductance
            (
                atom->type[c.i], c.type, wallContactArea(R, R + c.gap), R,
                atom->rmass[c.i], c.gap - opens*dt >= 0 ? -opens : -1
            );

        flux[c.i] += Q;
        wallHeat_ += Q*dt;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

int Foam::dew::fixConduction::setmask()
{
    return FixConst::POST_FORCE;
}


void Foam::dew::fixConduction::init()
{
    const auto property = [this](const char* name)
    {
        return static_cast<FixPropertyAtom*>
        (
            modify->find_fix_property
            (
                name, "property/atom", "scalar", 0, 0, style
            )
        );
    };
    temperature_ = property("Temp");
    heatFlux_ = property("heatFlux");
    walls_ = &fixWallContacts::of(lmp);

    if (!force->pair_match("gran", 0))
    {
        error->fix_error(FLERR, this, "needs pair_style gran");
    }
}


void Foam::dew::fixConduction::post_force(int)
{
    pairs();
    walls();
}
