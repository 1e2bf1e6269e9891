/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Particles added to the engine, and the search for those in their way

#include "liggghtsEmbedded.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "atom_vec.h"
#include "domain.h"
#include "fix.h"
#include "fix_property_atom.h"
#include "modify.h"

using namespace LAMMPS_NS;

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

long Foam::dew::liggghtsEmbedded::add(const newParticles& p)
{
    trapsOff guard;
    Atom& atom = *lmp_->atom;
    Domain& box = *lmp_->domain;
    Modify& modify = *lmp_->modify;
    const int before = atom.nlocal;

    FixPropertyAtom* temperature = static_cast<FixPropertyAtom*>
    (
        modify.find_fix_property
        (
            "Temp", "property/atom", "scalar", 0, 0, "add", false
        )
    );

    // Particles already there go on from the forces they have; those added
    // since the last set-up have none yet
    if (forcesValid_)
    {
        integrator().keepForces();
        forcesValid_ = false;
    }

    // Values of the new ones are set below: the engine's first set-up would
    // return them to their defaults
    for (int f = 0; f < modify.nfix; f++)
    {
        modify.fix[f]->just_created = 0;
    }

    for (size_t i = 0; i < p.id.size(); i++)
    {
        double x[3];
        bool mine = true;

        for (int k = 0; k < 3; k++)
        {
            x[k] = p.x[3*i + k]/units_.length;

            // Wrap after the conversion: one ulp outside is outside
            if (box.periodicity[k])
            {
                const double span = box.boxhi[k] - box.boxlo[k];
                while (x[k] < box.boxlo[k]) x[k] += span;
                while (x[k] >= box.boxhi[k]) x[k] -= span;
            }
            mine = mine && x[k] >= box.sublo[k] && x[k] < box.subhi[k];
        }

        if (!mine)
        {
            continue;
        }

        atom.avec->create_atom(p.type[i], x);
        const int n = atom.nlocal - 1;
        const double R = 0.5*p.d[i]/units_.length;
        const double rho = p.rho[i]/units_.density();

        atom.tag[n] = p.id[i];
        atom.radius[n] = R;
        atom.density[n] = rho;
        atom.rmass[n] = 4.0/3.0*M_PI*R*R*R*rho;

        for (int k = 0; k < 3; k++)
        {
            atom.v[n][k] = p.v[3*i + k]/units_.velocity();
            atom.omega[n][k] = p.omega[3*i + k]*units_.time;
        }

        for (int f = 0; f < modify.nfix; f++)
        {
            if (modify.fix[f]->create_attribute)
            {
                modify.fix[f]->pre_set_arrays();
                modify.fix[f]->set_arrays(n);
            }
        }

        if (temperature)
        {
            temperature->vector_atom[n] = p.T[i];
        }
    }

    long placed = atom.nlocal - before, all = 0;
    MPI_Allreduce(&placed, &all, 1, MPI_LONG, MPI_SUM, world_);
    atom.natoms += all;

    if (atom.map_style)
    {
        atom.nghost = 0;
        atom.map_init();
        atom.map_set();
    }

    return all;
}


void Foam::dew::liggghtsEmbedded::overlapping
(
    const newParticles& p,
    const double share,
    std::vector<char>& hit
) const
{
    const Atom& atom = *lmp_->atom;
    const Domain& box = *lmp_->domain;
    const int n = int(p.id.size());

    hit.assign(n, 0);

    // The new ones in a hashed grid as wide as any contact
    double reach = 0;
    for (int i = 0; i < n; i++)
    {
        reach = std::max(reach, 0.5*p.d[i]/units_.length);
    }
    double old = 0;
    for (int i = 0; i < atom.nlocal; i++)
    {
        old = std::max(old, atom.radius[i]);
    }
    MPI_Allreduce(MPI_IN_PLACE, &old, 1, MPI_DOUBLE, MPI_MAX, world_);
    const double width = reach + old;

    if (n == 0 || width <= 0)
    {
        return;
    }

    const auto cell = [width](const double* x, int di, int dj, int dk)
    {
        const long i = long(std::floor(x[0]/width)) + di;
        const long j = long(std::floor(x[1]/width)) + dj;
        const long k = long(std::floor(x[2]/width)) + dk;
        return
            (i*73856093L) ^ (j*19349663L) ^ (k*83492791L);
    };

    std::unordered_multimap<long, int> grid;
    std::vector<double> x(3*n);
    for (int i = 0; i < n; i++)
    {
        for (int k = 0; k < 3; k++)
        {
            x[3*i + k] = p.x[3*i + k]/units_.length;
        }
        grid.emplace(cell(&x[3*i], 0, 0, 0), i);
    }

    for (int a = 0; a < atom.nlocal; a++)
    {
        // Images across periodic sides
        for (int image = 0; image < 27; image++)
        {
            const int s[3] = {image%3 - 1, (image/3)%3 - 1, image/9 - 1};
            double y[3];
            bool used = true;

            for (int k = 0; k < 3; k++)
            {
                const double span = box.boxhi[k] - box.boxlo[k];
                y[k] = atom.x[a][k] + s[k]*span;
                used = used
                 && (
                        s[k] == 0
                     || (
                            box.periodicity[k]
                         && y[k] > box.boxlo[k] - width
                         && y[k] < box.boxhi[k] + width
                        )
                    );
            }

            for (int c = 0; used && c < 27; c++)
            {
                const auto range = grid.equal_range
                (
                    cell(y, c%3 - 1, (c/3)%3 - 1, c/9 - 1)
                );

                for (auto it = range.first; it != range.second; ++it)
                {
                    const int i = it->second;
                    const double R = 0.5*p.d[i]/units_.length;
                    const double gap =
                        std::sqrt
                        (
                            std::pow(x[3*i] - y[0], 2)
                          + std::pow(x[3*i + 1] - y[1], 2)
                          + std::pow(x[3*i + 2] - y[2], 2)
                        )
                      - R - atom.radius[a];

                    if (gap < -share*std::min(R, atom.radius[a]))
                    {
                        hit[i] = 1;
                    }
                }
            }
        }
    }

    MPI_Allreduce(MPI_IN_PLACE, hit.data(), n, MPI_CHAR, MPI_MAX, world_);
}
