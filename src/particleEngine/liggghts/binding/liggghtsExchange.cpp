/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Bulk forces to the engine, state and what was received from it

#include "liggghtsEmbedded.h"

#include <cmath>
#include <cstring>
#include <stdexcept>

using namespace LAMMPS_NS;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

// Copy nv values a particle from or to the stored columns, times a factor

void setColumn
(
    Foam::dew::fixIntegrate& f,
    const int* id,
    const int n,
    const double* from,
    const int col,
    const int nv,
    const double factor
)
{
    for (int i = 0; i < n; i++)
    {
        for (int k = 0; k < nv; k++)
        {
            const double value = from ? from[nv*i + k] : 0;

            if (!std::isfinite(value))
            {
                throw std::runtime_error
                (
                    "the bulk force (or torque, or heat) of particle "
                  + std::to_string(id[i]) + " is not a finite number: look at"
                    " the law and the fields it was computed from"
                );
            }
            f[i][col + k] = factor*value;
        }
    }
}

void getColumn
(
    const Foam::dew::fixIntegrate& f,
    const int n,
    double* to,
    const int col,
    const int nv,
    const double factor
)
{
    for (int i = 0; to && i < n; i++)
    {
        for (int k = 0; k < nv; k++)
        {
            to[nv*i + k] = factor*f[i][col + k];
        }
    }
}

void getVectors(double** from, const int n, double* to, const double factor)
{
    for (int i = 0; to && i < n; i++)
    {
        for (int k = 0; k < 3; k++)
        {
            to[3*i + k] = factor*from[i][k];
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::liggghtsEmbedded::push(const bulkForcesView& b)
{
    typedef fixIntegrate f;
    fixIntegrate& data = integrator();
    const int n = size();
    const int* id = lmp_->atom->tag;
    const engineUnits& u = units_;

    // Decided together: a particle may migrate to a rank that pushed nothing
    int any = b.Su || b.Sp || b.Tu || b.Tp || b.Qu || b.Qp;
    MPI_Allreduce(MPI_IN_PLACE, &any, 1, MPI_INT, MPI_MAX, world_);

    if (!any && !data.loaded() && !data.heated())
    {
        return;
    }

    setColumn(data, id, n, b.Su, f::Su, 3, 1/u.force());
    setColumn(data, id, n, b.Sp, f::Sp, 1, u.velocity()/u.force());
    setColumn(data, id, n, b.U, f::U, 3, 1/u.velocity());
    setColumn(data, id, n, b.Tu, f::Tu, 3, 1/u.torque());
    setColumn(data, id, n, b.Tp, f::Tp, 1, 1/(u.torque()*u.time));
    setColumn(data, id, n, b.Omega, f::Omega, 3, u.time);
    setColumn(data, id, n, b.Qu, f::Qu, 1, 1/u.power());
    setColumn(data, id, n, b.Qp, f::Qp, 1, 1/u.power());
    setColumn(data, id, n, b.Tf, f::Tf, 1, 1);

    for (int i = 0; i < n; i++)
    {
        std::memset(data[i] + f::impulse, 0, 7*sizeof(double));
    }

    data.load(any);
}


void Foam::dew::liggghtsEmbedded::pull(const stateView& s) const
{
    typedef fixIntegrate f;
    const fixIntegrate& data = *integrate_;
    const Atom& atom = *lmp_->atom;
    const int n = atom.nlocal;
    const engineUnits& u = units_;

    if (s.id) std::memcpy(s.id, atom.tag, n*sizeof(int));
    if (s.type) std::memcpy(s.type, atom.type, n*sizeof(int));

    getVectors(atom.x, n, s.x, u.length);
    getVectors(atom.v, n, s.v, u.velocity());
    getVectors(atom.omega, n, s.omega, 1/u.time);

    for (int i = 0; s.d && i < n; i++)
    {
        s.d[i] = 2*u.length*atom.radius[i];
    }
    for (int i = 0; s.rho && i < n; i++)
    {
        s.rho[i] = u.density()*atom.density[i];
    }
    if (s.T && data.temperature())
    {
        std::memcpy(s.T, data.temperature(), n*sizeof(double));
    }

    getColumn(data, n, s.impulse, f::impulse, 3, u.force()*u.time);
    getColumn(data, n, s.angularImpulse, f::angularImpulse, 3, u.torque()*u.time);
    getColumn(data, n, s.heat, f::heat, 1, u.power()*u.time);
}


std::vector<Foam::dew::departedParticle>
Foam::dew::liggghtsEmbedded::departed()
{
    std::vector<departedParticle> result(integrator().departed());

    for (departedParticle& p : result)
    {
        p.mass *= units_.mass;
        p.heat *= units_.power()*units_.time;
        for (int k = 0; k < 3; k++)
        {
            p.x[k] *= units_.length;
            p.v[k] *= units_.velocity();
            p.impulse[k] *= units_.force()*units_.time;
        }
    }

    return result;
}
