/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Brownian motion, and the force of a liquid's surface

#include "fixIntegrate.h"
#include "../brownianMotion.H"
#include "../falsePosition.H"
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
    const double way,
    double& delta,
    double* m
) const
{
    if (!surfaced(c))
    {
        return false;
    }
    delta = surfaceDistance(c + offset, c + normal, c[curvature], m);

    const double reach = film_.reach();
    const double from =
        reach > 0 ? -R - reach - way : c[tension] > 0 ? -R : 0;

    return delta > from && delta < R;
}


double Foam::dew::fixIntegrate::pull
(
    const double* c,
    const double R,
    const double delta,
    double& k
) const
{
    const double h = -delta - R;
    if (h > 0)
    {
        const filmForce f = film_.force(filmRadius(R, c[curvature]), h);
        k = std::max(-f.slope, 0.0);
        return -f.F;
    }
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
    k = delta > 0 ? c[stiffness] : 0;
    return -k*delta;
}


void Foam::dew::fixIntegrate::drain
(
    const int i,
    const double delta,
    const double* m
)
{
    double* c = colloid_[i];
    c[filmSpeed] = 0;

    const double h = -delta - atom->radius[i];
    const lubricationGap gap(film_.gap());
    if (h <= 0 || !(c[drainage] > 0))
    {
        return;
    }

    // The way by the friction that is the mean over it
    const double dt = update->dt;
    double unused;
    const auto friction = [&](const double way)
    {
        return c[drainage]*gap.meanSlope(h, -way);
    };
    const auto excess = [&](const double way)
    {
        return way - spring(i, delta, m, dt, friction(way), unused, unused);
    };

    const double* d = data_[i];
    double k = 0;
    const double held = pull(c, atom->radius[i], delta, k);
    const double v = dot(atom->v[i], m) - c[speed]*dot(c + normal, m);
    const double push =
        dot(atom->f[i], m) + dot(d + Su, m) + held
      + d[Sp]*(dot(d + U, m) - c[speed]*dot(c + normal, m));
    const double most =
        dt*(std::fabs(v) + dt*std::fabs(push)/atom->rmass[i]) + 1e-300;
    if (h - most >= gap.sMax)
    {
        return;
    }

    c[filmFriction] = friction(falsePosition(excess, -most, most, 1e-13*h));
    if (h > gap.sMin && h < gap.sMax)
    {
        const double all = d[Sp] + c[filmFriction];
        c[filmSpeed] = c[kT]*c[drainage]/(h*h*all*all);
    }
}


double Foam::dew::fixIntegrate::spring
(
    const int i,
    const double delta,
    const double* m,
    const double t,
    const double friction,
    double& dv,
    double& dJ
) const
{
    const double* d = data_[i];
    const double* c = colloid_[i];
    const double mass = atom->rmass[i];
    const double perMass = t/(mass + d[addedMass]);
    const double h = d[Sp]*perMass;
    double k = 0;
    const double held = pull(c, atom->radius[i], delta, k);
    const springResponse response(h + friction*perMass, k*t*perMass);

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
    // Without the momentum of the fluid it carries along
    dJ =
        bulk*t - d[Sp]*(way + w*t) - d[addedMass]*(after - v)
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
        c[filmFriction] = 0;
        const double* f = atom->f[i];
        double way = 0;
        for (int k = 0; film_.reach() > 0 && k < 3; k++)
        {
            const double a = f[k] + d[Su+k] + d[Sp]*(d[U+k] - v[k]);
            way += std::fabs(dt*v[k] + a*d[fullStep]);
        }
        if (!pulled(c, atom->radius[i], way, delta, m))
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
            drain(i, delta, m);

            const double film = c[filmFriction];
            double dv, dJ, unused;
            const double way = spring(i, delta, m, dt, film, unused, dJ);
            const double a =
                dot(atom->f[i], m) + dot(d + Su, m)
              + d[Sp]*(dot(d + U, m) - dot(v, m));
            const double more =
                way + c[speed]*dot(c + normal, m)*dt
              - dt*dot(v, m) - a*d[fullStep];

            c[springDistance] =
                delta + spring(i, delta, m, 0.5*dt, film, dv, dJ);
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
            if (surfaces_ && c[filmFriction] > 0)
            {
                filmNoise(i, g);
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


void Foam::dew::fixIntegrate::filmNoise(const int i, const double* g)
{
    // The normal direction anew, with the whole friction; of its noise the
    // drag's share is received
    const double dt = update->dt;
    const double* d = data_[i];
    double* c = colloid_[i];
    const double* n = c + springNormal;
    const double moved = atom->rmass[i] + d[addedMass];
    const double all = d[Sp] + c[filmFriction];
    const ornsteinUhlenbeck noise(c[kT], moved, all, dt);
    const filmDrift drift(c[filmSpeed], all*dt/moved, dt);
    const double g1 = dot(g, n), g2 = dot(g + 3, n);

    const double dx =
        (noise.xv - c[noiseXV])*g1 + (noise.x - c[noiseX])*g2 - drift.dx;
    const double dv = (noise.v - c[noiseV])*g1 - drift.dv;
    const double counted = (noise.v*d[Sp]/all - c[noiseV])*g1;

    for (int k = 0; k < 3; k++)
    {
        atom->x[i][k] += dx*n[k];
        c[pending+k] += dv*n[k];
        data_[i][impulse+k] += atom->rmass[i]*counted*n[k];
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
            spring
            (
                i, c[springDistance], m, 0.5*update->dt, c[filmFriction], dv, dJ
            );

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
