/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Particles without inertia, and walls that slow them down

#include "fixIntegrate.h"
#include "../brownianMotion.H"
#include "../exponentialRelaxation.H"
#include "../wallMobility.H"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "atom.h"
#include "update.h"

using namespace LAMMPS_NS;

// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

double Foam::dew::fixIntegrate::drift
(
    const int i,
    double* v,
    double* m,
    double& along
) const
{
    const double* d = data_[i];
    const double mobility = 1/d[Sp];

    along = 1;

    double delta = 0;
    const bool held =
        colloid_ && pulled(colloid_[i], atom->radius[i], delta, m);
    const double share = 1 - std::max(delta, 0.0)/atom->radius[i];

    if (share <= 0)
    {
        // The liquid has let go: the particle stays where it is
        std::memset(v, 0, 3*sizeof(double));
        std::memset(m, 0, 3*sizeof(double));
        return 0;
    }

    for (int k = 0; k < 3; k++)
    {
        v[k] = share*d[U+k] + mobility*(atom->f[i][k] + d[Su+k]);
    }

    if (held)
    {
        // Exact relaxation in the frame of the surface
        const double* c = colloid_[i];
        double stiff = 0;
        const double force = pull(c, atom->radius[i], delta, stiff);
        const double q = mobility*stiff*update->dt;
        const double w = c[speed]*dot(c + normal, m);
        const double free = dot(v, m);
        const double more = phi1(q)*(free - w + mobility*force) + w - free;

        for (int k = 0; k < 3; k++)
        {
            v[k] += more*m[k];
        }
        along = std::sqrt(phi1(2*q));
    }
    else
    {
        std::memset(m, 0, 3*sizeof(double));
    }

    return share;
}


Foam::dew::fixIntegrate::nearWall Foam::dew::fixIntegrate::hindrance
(
    const int i
) const
{
    const double* x = atom->x[i];
    const double R = atom->radius[i];
    nearWall w{nullptr, 1, 1, 0};
    double least = 0;

    for (size_t k = 0; k < planes_.size(); k += 6)
    {
        const double* p = &planes_[k];
        const double gap =
            (x[0] - p[0])*p[3] + (x[1] - p[1])*p[4] + (x[2] - p[2])*p[5] - R;

        if (!w.n || gap < least)
        {
            w.n = p + 3;
            least = gap;
        }
    }

    const wallMobility m(std::max(least, minGap_), R);
    w.normal = m.normal;
    w.parallel = m.parallel;
    // Where the mobility is held at its least, it does not vary
    w.slope = least > minGap_ ? m.normalSlope : 0;

    return w;
}


void Foam::dew::fixIntegrate::hinder
(
    const nearWall& w,
    const int i,
    double* v
) const
{
    const double* d = data_[i];
    const double drift = colloid_ ? colloid_[i][kT]*w.slope/d[Sp] : 0;
    double F[3];

    for (int k = 0; k < 3; k++)
    {
        F[k] = (atom->f[i][k] + d[Su+k])/d[Sp];
    }
    const double along = (w.normal - w.parallel)*dot(F, w.n) + drift;

    for (int k = 0; k < 3; k++)
    {
        v[k] = w.parallel*F[k] + along*w.n[k];
    }
}


void Foam::dew::fixIntegrate::moveHindered(const int i)
{
    const double dt = update->dt;
    double* d = data_[i];
    double* v = atom->v[i];
    const nearWall w = hindrance(i);

    hinder(w, i, v);
    spin(i);

    // The drag balances all other forces
    for (int k = 0; k < 3; k++)
    {
        d[impulse+k] -= atom->f[i][k]*dt;
        d[angularImpulse+k] -= atom->torque[i][k]*dt;
    }

    double g[3];
    if (noise(i, g))
    {
        const double across = std::sqrt(w.parallel);
        const double along = (std::sqrt(w.normal) - across)*dot(g, w.n);
        for (int k = 0; k < 3; k++)
        {
            v[k] += across*g[k] + along*w.n[k];
        }
    }

    for (int k = 0; k < 3; k++)
    {
        atom->x[i][k] += v[k]*dt;
    }
}


void Foam::dew::fixIntegrate::spin(const int i) const
{
    const double* d = data_[i];
    const double R = atom->radius[i];
    const double friction = d[Tp] > 0 ? d[Tp] : 4.0/3.0*R*R*d[Sp];

    for (int k = 0; k < 3; k++)
    {
        atom->omega[i][k] =
            d[Omega+k] + (atom->torque[i][k] + d[Tu+k])/friction;
    }
}


bool Foam::dew::fixIntegrate::noise(const int i, double* g) const
{
    if (!colloid_ || !(colloid_[i][noiseX] > 0))
    {
        return false;
    }
    gaussians<3>
    (
        ziggurat::instance(), seed_, atom->tag[i],
        uint64_t(update->ntimestep), g
    );

    const double width = colloid_[i][noiseX]/update->dt;
    for (int k = 0; k < 3; k++)
    {
        g[k] *= width;
    }
    return true;
}


void Foam::dew::fixIntegrate::follow(const int i, const double* v)
{
    double* c = colloid_[i];
    for (int k = 0; k < 3; k++)
    {
        c[offset+k] += (v[k] - c[speed]*c[normal+k])*update->dt;
    }
}


void Foam::dew::fixIntegrate::moveFree(const int i)
{
    const double dt = update->dt;
    double* d = data_[i];
    double* x = atom->x[i];
    double* v = atom->v[i];
    const double* f = atom->f[i];
    const double mobility = 1/d[Sp];

    spin(i);

    for (int k = 0; k < 3; k++)
    {
        v[k] = d[U+k] + mobility*(f[k] + d[Su+k]);
        d[impulse+k] -= f[k]*dt;
        d[angularImpulse+k] -= atom->torque[i][k]*dt;
    }

    double g[3];
    if (noise(i, g))
    {
        for (int k = 0; k < 3; k++)
        {
            v[k] += g[k];
        }
    }
    for (int k = 0; k < 3; k++)
    {
        x[k] += v[k]*dt;
    }
}


void Foam::dew::fixIntegrate::moveSurfaced(const int i)
{
    const double dt = update->dt;
    double* d = data_[i];
    double* v = atom->v[i];
    double m[3], along;

    const double share = drift(i, v, m, along);
    if (share == 0)
    {
        std::memset(atom->omega[i], 0, 3*sizeof(double));
        follow(i, v);
        return;
    }
    spin(i);

    for (int k = 0; k < 3; k++)
    {
        d[impulse+k] += (d[Sp]*(share*d[U+k] - v[k]) + d[Su+k])*dt;
        d[angularImpulse+k] -= atom->torque[i][k]*dt;
    }

    double g[3];
    if (noise(i, g))
    {
        const double less = (along - 1)*dot(g, m);
        for (int k = 0; k < 3; k++)
        {
            v[k] += g[k] + less*m[k];
        }
    }
    follow(i, v);

    for (int k = 0; k < 3; k++)
    {
        atom->x[i][k] += v[k]*dt;
    }
}


void Foam::dew::fixIntegrate::moveOverdamped()
{
    if (!planes_.empty())
    {
        for (int i = 0; i < atom->nlocal; i++)
        {
            moveHindered(i);
        }
    }
    else if (surfaces_)
    {
        for (int i = 0; i < atom->nlocal; i++)
        {
            moveSurfaced(i);
        }
    }
    else
    {
        for (int i = 0; i < atom->nlocal; i++)
        {
            moveFree(i);
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::fixIntegrate::finish()
{
    // Without noise: the speed of the noise has no meaning
    for (int i = 0; overdamped_ && i < atom->nlocal; i++)
    {
        double m[3], along;
        if (!planes_.empty())
        {
            hinder(hindrance(i), i, atom->v[i]);
            spin(i);
        }
        else if (drift(i, atom->v[i], m, along) > 0)
        {
            spin(i);
        }
    }
}
