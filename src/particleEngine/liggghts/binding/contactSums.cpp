/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "contactSums.h"
#include "liggghtsEmbedded.h"

#include <algorithm>
#include <stdexcept>

#include "comm.h"
#include "fix_property_atom.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "modify.h"
#include "pair_gran.h"
#include "primitive_wall.h"

using namespace LAMMPS_NS;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- What the engine's constructor reads: name, group, style
char* words[] =
{
    const_cast<char*>("dewContacts"),
    const_cast<char*>("all"),
    const_cast<char*>("pair/gran/local")
};

void refuseTaken(const bool taken)
{
    if (taken)
    {
        throw std::runtime_error
        (
            "contacts cannot be asked for beside a compute pair/gran/local or"
            " wall/gran/local of the native commands: remove the compute"
        );
    }
}

} // End anonymous namespace


//- The engine refuses such a compute after its first step, when it might come
//  too late for a neighbour list; this one needs none
class Foam::dew::contactSums::firstStep
{
    Update& update_;

    const bigint step_;

public:

    explicit firstStep(LAMMPS* lmp)
    :
        update_(*lmp->update),
        step_(update_.ntimestep)
    {
        update_.ntimestep = 0;
    }

    ~firstStep() { update_.ntimestep = step_; }
};


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::contactSums::contactSums(LAMMPS* lmp, int iarg, const firstStep&)
:
    ComputePairGranLocal(lmp, iarg, 3, words)
{}


Foam::dew::contactSums::contactSums(LAMMPS* lmp)
:
    contactSums(lmp, 0, firstStep(lmp))
{
    number_.assign(lmp->atom->nlocal, 0);
    moment_.assign(6*number_.size(), 0);

    if (lmp->force->newton_pair)
    {
        throw std::runtime_error
        (
            "contacts are known with 'newton off' only: change the native"
            " commands"
        );
    }

    // Velocities of ghosts are those of the middle of the last sub-step
    lmp->comm->forward_comm();

    pairs();

    for (int f = 0; f < lmp->modify->nfix; f++)
    {
        if (auto* wall = dynamic_cast<FixWallGran*>(lmp->modify->fix[f]))
        {
            wall->primitiveWall() ? primitive(*wall) : triangles(*wall);
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::contactSums::add
(
    const int i,
    const double* l,
    const double* F,
    const double factor
)
{
    double* m = moment_.data() + 6*i;
    m[0] += factor*l[0]*F[0];
    m[1] += 0.5*factor*(l[0]*F[1] + l[1]*F[0]);
    m[2] += 0.5*factor*(l[0]*F[2] + l[2]*F[0]);
    m[3] += factor*l[1]*F[1];
    m[4] += 0.5*factor*(l[1]*F[2] + l[2]*F[1]);
    m[5] += factor*l[2]*F[2];
}


void Foam::dew::contactSums::pairs()
{
    auto* pair = dynamic_cast<PairGran*>(force->pair);
    if (!pair)
    {
        return;
    }
    refuseTaken(pair->cpl());

    pair->register_compute_pair_local(this, dnum);
    pair->compute_pgl(0, 0);
    pair->unregister_compute_pair_local(this);
}


void Foam::dew::contactSums::triangles(FixWallGran& wall)
{
    refuseTaken(wall.compute_wall_gran_local());

    wall.register_compute_wall_local(this, dnum);
    wall.post_force_pgl();
    wall.unregister_compute_wall_local(this);
}


void Foam::dew::contactSums::primitive(FixWallGran& wall)
{
    const int n = atom->nlocal;
    const auto copy = [n](double** from)
    {
        return n ? std::vector<double>(from[0], from[0] + 3*n)
                 : std::vector<double>();
    };
    const std::vector<double> f(copy(atom->f)), torque(copy(atom->torque));

    std::vector<double> heat;
    auto* flux = static_cast<FixPropertyAtom*>
    (
        modify->find_fix_property
        (
            "heatFlux", "property/atom", "scalar", 0, 0, style, false
        )
    );
    if (flux)
    {
        heat.assign(flux->vector_atom, flux->vector_atom + n);
    }

    // As in a set-up, where histories stay as they are
    const int setup = update->setupflag;
    update->setupflag = 1;
    if (n)
    {
        std::fill_n(atom->f[0], 3*n, 0);
    }
    wall.post_force(0);
    update->setupflag = setup;

    for (int i = 0; i < n; i++)
    {
        const double* F = atom->f[i];
        if (F[0] != 0 || F[1] != 0 || F[2] != 0)
        {
            double l[3];
            wall.primitiveWall()->resolveContact
            (
                atom->x[i], atom->radius[i], l
            );
            add(i, l, F, -1);
        }
    }

    if (n)
    {
        std::copy(f.begin(), f.end(), atom->f[0]);
        std::copy(torque.begin(), torque.end(), atom->torque[0]);
    }
    if (flux)
    {
        std::copy(heat.begin(), heat.end(), flux->vector_atom);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::contactSums::add_pair
(
    int i, int j, double fx, double fy, double fz,
    double, double, double, double*, const double* const
)
{
    const double F[3] = {fx, fy, fz};
    const double radii = atom->radius[i] + atom->radius[j];
    const bool here = j < atom->nlocal;

    double l[3], square = 0;
    for (int k = 0; k < 3; k++)
    {
        l[k] = atom->x[i][k] - atom->x[j][k];
        square += l[k]*l[k];
    }

    add(i, l, F, atom->radius[i]/radii);
    if (here)
    {
        add(j, l, F, atom->radius[j]/radii);
    }

    // Not a law that acts at a distance
    if (square < radii*radii)
    {
        number_[i]++;
        if (here)
        {
            number_[j]++;
        }
    }
}


void Foam::dew::contactSums::add_wall_1
(
    int, int, int, double* point, double*
)
{
    std::copy(point, point + 3, point_);
}


void Foam::dew::contactSums::add_wall_2
(
    int i, double fx, double fy, double fz,
    double, double, double, double*, double, double*
)
{
    const double F[3] = {fx, fy, fz};
    double l[3];
    for (int k = 0; k < 3; k++)
    {
        l[k] = point_[k] - atom->x[i][k];
    }
    add(i, l, F, -1);
}


// The binding's call

void Foam::dew::liggghtsEmbedded::contacts(const contactView& view)
{
    trapsOff guard;

    const contactSums sums(lmp_);
    const double toSI = units_.force()*units_.length;

    for (std::size_t i = 0; view.number && i < sums.number().size(); i++)
    {
        view.number[i] = sums.number()[i];
    }
    for (std::size_t k = 0; view.moment && k < sums.moment().size(); k++)
    {
        view.moment[k] = toSI*sums.moment()[k];
    }
}
