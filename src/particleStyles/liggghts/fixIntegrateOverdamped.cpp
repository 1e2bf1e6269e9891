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

    along = 1;

    double delta = 0, way = 0;
    for (int k = 0; film_.reach() > 0 && k < 3; k++)
    {
        way +=
            update->dt
           *std::fabs(d[U+k] + d[mobility]*(atom->f[i][k] + d[Su+k]));
    }
    const bool held =
        colloid_ && pulled(colloid_[i], atom->radius[i], way, delta, m);
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
        v[k] = share*d[U+k] + d[mobility]*(atom->f[i][k] + d[Su+k]);
    }

    if (held)
    {
        // Exact relaxation in the frame of the surface
        const double* c = colloid_[i];
        const double dt = update->dt;
        double stiff = 0;
        const double force = pull(c, atom->radius[i], delta, stiff);
        const double w = c[speed]*dot(c + normal, m);
        const double free = dot(v, m);

        // Mobility in the film, relative
        const double h = -delta - atom->radius[i];
        const double a = h > 0 ? c[drainage]*d[mobility] : 0;
        const lubricationGap gap(film_.gap());
        const double less = 1/(1 + a*gap.slope(h));

        const double q = less*d[mobility]*stiff*dt;
        double out = phi1(q)*(free - w + d[mobility]*force);
        if (a > 0)
        {
            out = -gap.slowed(-out, h, a/dt, dt);
            if (h > gap.sMin && h < gap.sMax)
            {
                out -= c[kT]*d[mobility]*a*(less/h)*(less/h);
            }
        }

        for (int k = 0; k < 3; k++)
        {
            v[k] += (out + w - free)*m[k];
        }
        along = std::sqrt(less*phi1(2*q));
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
    const double drift = colloid_ ? colloid_[i][kT]*w.slope*d[mobility] : 0;
    double F[3];

    for (int k = 0; k < 3; k++)
    {
        F[k] = (atom->f[i][k] + d[Su+k])*d[mobility];
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


void Foam::dew::fixIntegrate::loadOverdamped(const int i)
{
    double* d = data_[i];
    const double R = atom->radius[i];

    d[mobility] = 1/d[Sp];
    d[turning] = 1/(d[Tp] > 0 ? d[Tp] : 4.0/3.0*R*R*d[Sp]);
    if (colloid_)
    {
        const double dt = update->dt;
        colloid_[i][noiseV] = diffusionStep(colloid_[i][kT], d[Sp], dt)/dt;
    }
}


void Foam::dew::fixIntegrate::spin(const int i) const
{
    const double* d = data_[i];

    for (int k = 0; k < 3; k++)
    {
        atom->omega[i][k] =
            d[Omega+k] + (atom->torque[i][k] + d[Tu+k])*d[turning];
    }
}


bool Foam::dew::fixIntegrate::noise(const int i, double* g) const
{
    if (!colloid_ || !(colloid_[i][noiseV] > 0))
    {
        return false;
    }
    gaussians<3>
    (
        ziggurat::instance(), seed_, atom->tag[i],
        uint64_t(update->ntimestep), g
    );

    for (int k = 0; k < 3; k++)
    {
        g[k] *= colloid_[i][noiseV];
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

    spin(i);

    for (int k = 0; k < 3; k++)
    {
        v[k] = d[U+k] + d[mobility]*(f[k] + d[Su+k]);
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
