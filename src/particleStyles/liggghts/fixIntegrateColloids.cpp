/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Brownian motion, and the force of a liquid's surface

#include "fixIntegrate.h"
#include "../brownianMotion.H"
#include "../sphereInSurface.H"
#include "../surfaceSpring.H"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "atom.h"
#include "memory.h"
#include "update.h"

using namespace LAMMPS_NS;

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

bool Foam::dew::fixIntegrate::pulled
(
    const double* c,
    const double R,
    double& delta,
    double* m
) const
{
    if (!surfaced(c))
    {
        return false;
    }
    delta = surfaceDistance(c + offset, c + normal, c[curvature], m);

    return delta > (c[tension] > 0 ? -R : 0) && delta < R;
}


double Foam::dew::fixIntegrate::pull
(
    const double* c,
    const double R,
    const double delta,
    double& k
) const
{
    if (c[planePull] > 0)
    {
        const planeSurfacePull plane(c[tension], c[angle], R, delta);
        k = plane.stiffness;
        return plane.force;
    }
    if (c[tension] > 0)
    {
        const contactLinePull line(c[tension], c[angle], R, delta);
        // Where it grows with delta it drives the particle away: explicit
        k = std::max(line.stiffness, 0.0);
        return line.force;
    }
    k = c[stiffness];
    return -k*delta;
}


double Foam::dew::fixIntegrate::spring
(
    const int i,
    const double delta,
    const double* m,
    const double t,
    double& dv,
    double& dJ
) const
{
    const double* d = data_[i];
    const double* c = colloid_[i];
    const double mass = atom->rmass[i];
    const double perMass = t/mass;
    const double h = d[Sp]*perMass;
    double k = 0;
    const double held = pull(c, atom->radius[i], delta, k);
    const springResponse response(h, k*t*perMass);

    // In the frame of the surface
    const double w = c[speed]*dot(c + normal, m);
    const double v = dot(atom->v[i], m);
    const double bulk = dot(d + Su, m) + d[Sp]*dot(d + U, m);
    const double F = dot(atom->f[i], m) + bulk;
    const double B = F - d[Sp]*w + held;
    const double way = t*(response.speed*(v - w) + perMass*response.force*B);
    const double after =
        response.keep*(v - w) + perMass*response.speed*B + w;

    // What the free relaxation will do
    const double free = perMass*phi1(h)*(F - d[Sp]*v);

    dv = after - v - free;
    dJ =
        bulk*t - d[Sp]*(way + w*t)
      - (mass*free - t*dot(atom->f[i], m));

    return way;
}


void Foam::dew::fixIntegrate::beforeFirst()
{
    const double dt = update->dt;

    for (int i = 0; i < atom->nlocal; i++)
    {
        double* d = data_[i];
        double* c = colloid_[i];
        double* x = atom->x[i];
        const double* v = atom->v[i];
        double* m = c + springNormal;
        double delta = 0;

        for (int k = 0; k < 3; k++)
        {
            c[pending+k] = 0;
        }
        if (!pulled(c, atom->radius[i], delta, m))
        {
            std::memset(m, 0, 3*sizeof(double));
        }
        if (!surfaced(c))
        {
            continue;
        }

        // The offset moves on with the particle
        for (int k = 0; k < 3; k++)
        {
            c[offset+k] -= x[k];
        }
        if (dot(m, m) > 0)
        {
            double dv, dJ, unused;
            const double way = spring(i, delta, m, dt, unused, dJ);
            const double a =
                dot(atom->f[i], m) + dot(d + Su, m)
              + d[Sp]*(dot(d + U, m) - dot(v, m));
            const double more =
                way + c[speed]*dot(c + normal, m)*dt
              - dt*dot(v, m) - a*d[fullStep];

            c[springDistance] = delta + spring(i, delta, m, 0.5*dt, dv, dJ);
            for (int k = 0; k < 3; k++)
            {
                x[k] += more*m[k];
                d[impulse+k] += dJ*m[k];
                c[pending+k] = dv*m[k];
            }
        }
    }
}


void Foam::dew::fixIntegrate::afterFirst()
{
    const double dt = update->dt;
    const uint64_t step = uint64_t(update->ntimestep);
    const ziggurat& normalOf = ziggurat::instance();

    for (int i = 0; i < atom->nlocal; i++)
    {
        double* c = colloid_[i];
        double* x = atom->x[i];

        for (int k = 0; k < 3; k++)
        {
            // Of the surface: before the noise of this sub-step
            if (surfaces_)
            {
                atom->v[i][k] += c[pending+k];
            }
            c[pending+k] = 0;
        }
        if (c[noiseV] > 0)
        {
            double g[6];
            gaussians<6>(normalOf, seed_, atom->tag[i], step, g);

            const double m = atom->rmass[i];
            for (int k = 0; k < 3; k++)
            {
                x[k] += c[noiseXV]*g[k] + c[noiseX]*g[3+k];
                c[pending+k] = c[noiseV]*g[k];
                data_[i][impulse+k] += m*c[pending+k];
            }
        }
        if (surfaces_ && surfaced(c))
        {
            for (int k = 0; k < 3; k++)
            {
                c[offset+k] += x[k] - c[speed]*dt*c[normal+k];
            }
        }
    }
}


void Foam::dew::fixIntegrate::beforeSecond()
{
    for (int i = 0; i < atom->nlocal; i++)
    {
        double* c = colloid_[i];
        const double* m = c + springNormal;

        if (dot(m, m) > 0)
        {
            double dv, dJ;
            spring(i, c[springDistance], m, 0.5*update->dt, dv, dJ);

            for (int k = 0; k < 3; k++)
            {
                data_[i][impulse+k] += dJ*m[k];
                c[pending+k] += dv*m[k];
            }
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::fixIntegrate::needColloids()
{
    if (colloid_)
    {
        return;
    }

    // At least one, so that all ranks know of them
    const int n = std::max(atom->nmax, 1);
    memory->create
    (
        colloid_, n, int(nColloidColumns), "dew/integrate:colloid"
    );
    std::memset(colloid_[0], 0, size_t(n)*nColloidColumns*sizeof(double));
}
