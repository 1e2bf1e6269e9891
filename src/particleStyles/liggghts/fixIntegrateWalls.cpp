/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Particles with inertia beside walls that slow them down

#include "fixIntegrate.h"
#include "../brownianMotion.H"

#include <cstring>

#include "atom.h"
#include "update.h"

using namespace LAMMPS_NS;

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::dew::fixIntegrate::relaxBeside
(
    const int i,
    const double t,
    double* dv,
    double* way
) const
{
    const double* d = data_[i];
    const double* c = colloid_[i];
    const double* n = c + wallNormal;
    const double* v = atom->v[i];
    const double perMass = t/(atom->rmass[i] + d[addedMass]);
    const double Sn = d[Sp]/c[wallMn], Sl = d[Sp]/c[wallMp];
    const double vn = dot(v, n);
    double F[3];

    for (int k = 0; k < 3; k++)
    {
        F[k] = atom->f[i][k] + d[Su+k] - Sl*(v[k] - vn*n[k]) - Sn*vn*n[k];
    }
    const double Fn = dot(F, n);
    const double along = perMass*phi1(perMass*Sn);
    const double across = perMass*phi1(perMass*Sl);

    for (int k = 0; k < 3; k++)
    {
        dv[k] = across*F[k] + (along - across)*Fn*n[k];
    }
    if (way)
    {
        const double an = t*perMass*phi2(perMass*Sn);
        const double al = t*perMass*phi2(perMass*Sl);
        for (int k = 0; k < 3; k++)
        {
            way[k] = t*v[k] + al*F[k] + (an - al)*Fn*n[k];
        }
    }
}


void Foam::dew::fixIntegrate::firstBeside(const int i)
{
    const double dt = update->dt;
    const double m = atom->rmass[i];
    double* d = data_[i];
    double* c = colloid_[i];
    double* n = c + wallNormal;
    double* v = atom->v[i];

    const nearWall w = hindrance(i);
    std::memcpy(n, w.n, 3*sizeof(double));
    c[wallMn] = w.normal;
    c[wallMp] = w.parallel;

    double dv[3], unused[3], way[3];
    relaxBeside(i, dt, unused, way);
    relaxBeside(i, 0.5*dt, dv, nullptr);

    for (int k = 0; k < 3; k++)
    {
        atom->x[i][k] += way[k];
        v[k] += dv[k];
        d[impulse+k] += m*dv[k] - 0.5*dt*atom->f[i][k];
        c[pending+k] = 0;
    }
    turn
    (
        d, atom->torque[i], atom->omega[i], inertiaOf(m, atom->radius[i]),
        0.5*dt
    );

    if (c[kT] > 0 && d[Sp] > 0)
    {
        double g[6];
        gaussians<6>
        (
            ziggurat::instance(), seed_, atom->tag[i],
            uint64_t(update->ntimestep), g
        );
        const double moved = m + d[addedMass];
        const double Sn = d[Sp]/w.normal;
        const ornsteinUhlenbeck along(c[kT], moved, Sn, dt);
        const ornsteinUhlenbeck across(c[kT], moved, d[Sp]/w.parallel, dt);
        const mobilityDrift drift(c[kT]*w.slope/d[Sp], Sn*dt/moved, dt);
        const double g1 = dot(g, n), g2 = dot(g + 3, n);
        const double dx =
            (along.xv - across.xv)*g1 + (along.x - across.x)*g2 + drift.dx;
        const double more = (along.v - across.v)*g1 + drift.dv;

        for (int k = 0; k < 3; k++)
        {
            atom->x[i][k] += across.xv*g[k] + across.x*g[3+k] + dx*n[k];
            c[pending+k] = across.v*g[k] + more*n[k];
            d[impulse+k] += m*c[pending+k];
        }
    }
}


void Foam::dew::fixIntegrate::secondBeside(const int i)
{
    double* d = data_[i];
    const double* more = colloid_[i] + pending;
    const double m = atom->rmass[i];
    double dv[3];

    relaxBeside(i, 0.5*update->dt, dv, nullptr);
    for (int k = 0; k < 3; k++)
    {
        atom->v[i][k] += dv[k] + more[k];
        d[impulse+k] += m*dv[k] - 0.5*update->dt*atom->f[i][k];
    }
    turn
    (
        d, atom->torque[i], atom->omega[i], inertiaOf(m, atom->radius[i]),
        0.5*update->dt
    );
}
