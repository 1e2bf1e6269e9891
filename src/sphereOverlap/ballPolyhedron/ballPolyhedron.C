/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "ballPolyhedron.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{
namespace
{

//- x - sin(x)
scalar sineDefect(const scalar x)
{
    if (mag(x) > 0.5)
    {
        return x - sin(x);
    }
    const scalar s = sqr(x);
    return
        x*s/6
       *(1 - s/20*(1 - s/42*(1 - s/72*(1 - s/110*(1 - s/156*(1 - s/210))))));
}


//- Between an arc of angle phi on the unit sphere and its great circle
scalar lune(const scalar t, const scalar phi)
{
    const scalar w = phi/(1 + t);
    return 2*atan2
    (
        t*sineDefect(w) - sineDefect(t*w),
        cos(t*w) + t*cos(w)
    );
}


//- Signed triangle of great circles o, o + p, o + q on a sphere of radius R
scalar greatTriangle
(
    const vector& o,
    const vector& p,
    const vector& q,
    const scalar R
)
{
    // Unit vectors o, o + p/R, o + q/R
    const scalar op = 1 - 0.5*magSqr(p)/sqr(R);
    const scalar oq = 1 - 0.5*magSqr(q)/sqr(R);
    const scalar pq = 1 - 0.5*magSqr(p - q)/sqr(R);
    return 2*atan2((o & (p ^ q))/sqr(R), 1 + op + oq + pq);
}


//- Arcs are followed in parts of at most this angle
constexpr scalar longestArc = 1.2;

} // End anonymous namespace
} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::ballPolyhedron::addArc
(
    const point& from,
    const point& to,
    const point& foot,
    const vector& n,
    const scalar t,
    const scalar phi
)
{
    const label parts = label(phi/longestArc) + 1;
    const vector u(from - foot), v(n^u);
    point a(from);
    for (label part = 1; part <= parts; part++)
    {
        const scalar angle = part*phi/parts;
        const point b
        (
            part == parts ? to : foot + cos(angle)*u + sin(angle)*v
        );
        arcs_.append(arc{a, b, t, phi/parts});
        a = b;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::ballPolyhedron::begin(const sphericalCap& cap)
{
    cap_ = &cap;
    arcs_.clear();
    circles_ = 0;
    cones_ = 0;
}


Foam::scalar Foam::dew::ballPolyhedron::add
(
    const point x[],
    const label n,
    const vector& normal
)
{
    const scalar R = cap_->radius();
    const point c(cap_->centre());
    const scalar d = normal & (x[0] - c);

    scalar power[maxCorners];
    for (label k = 0; k < n; k++)
    {
        power[k] = cap_->power(x[k]);
    }

    // Straight parts in the order of the edges
    point from[maxCorners], to[maxCorners];
    bool ends[maxCorners], begins[maxCorners];
    label nParts = 0;
    for (label k = 0; k < n; k++)
    {
        const label l = k + 1 < n ? k + 1 : 0;
        scalar t0, t1;
        const vector side(x[l] - x[k]);
        if (sphericalCap::inside(power[k], power[l], magSqr(side), t0, t1))
        {
            begins[nParts] = power[k] < 0;
            ends[nParts] = power[l] < 0;
            from[nParts] = begins[nParts] ? x[k] + t0*side : x[k];
            to[nParts] = ends[nParts] ? x[k] + t1*side : x[l];
            nParts++;
        }
    }

    const point foot(c + d*normal);

    if (nParts == 0)
    {
        // The whole disc, or nothing
        const scalar rhoSqr = (R - d)*(R + d);
        if (!(rhoSqr > 0))
        {
            return 0;
        }
        for (label k = 0; k < n; k++)
        {
            const label l = k + 1 < n ? k + 1 : 0;
            if ((normal & ((x[l] - x[k])^(foot - x[k]))) < 0)
            {
                return 0;
            }
        }
        circles_ -= 2*pi*(1 - d/R);
        cones_ += d*pi*rhoSqr;
        return pi*rhoSqr;
    }

    scalar area = 0;
    for (label k = 0; k < nParts; k++)
    {
        const vector p(to[k] - from[0]);
        area += 0.5*(normal & ((from[k] - from[0])^p));

        if (!ends[k])
        {
            continue;
        }

        // The arc from here to the next straight part
        const label l = k + 1 < nParts ? k + 1 : 0;
        const vector q(from[l] - from[0]);
        area += 0.5*(normal & (p^q));

        const scalar chord = mag(q - p);
        if (!(chord > 0))
        {
            continue;
        }
        const scalar toCentre = (normal & ((q - p)^(foot - to[k])))/chord;
        const scalar phi = 2*atan2(0.5*chord, toCentre);
        const scalar rhoSqr = sqr(toCentre) + 0.25*sqr(chord);
        area += 0.5*rhoSqr*sineDefect(phi);

        addArc
        (
            to[k], from[l], foot, normal,
            d >= 0 ? rhoSqr/sqr(R + d) : sqr(R - d)/rhoSqr,
            phi
        );
    }

    cones_ += d*area;
    return area;
}


Foam::scalar Foam::dew::ballPolyhedron::solidAngle(const vector& o) const
{
    const scalar R = cap_->radius();
    const point ref(cap_->centre() + R*o);

    scalar angle = circles_;
    for (const arc& part : arcs_)
    {
        angle -=
            lune(part.t, part.phi)
          + greatTriangle(o, part.a - ref, part.b - ref, R);
    }
    return angle;
}


Foam::vector Foam::dew::ballPolyhedron::bestOrigin() const
{
    const point c(cap_->centre());

    // The middle of the arcs, and four directions no mesh is aligned with
    vector middle(Zero);
    for (const arc& part : arcs_)
    {
        middle += part.a - c;
    }
    const scalar length = mag(middle);
    const vector candidates[] =
    {
        length > 1e-3*cap_->radius()*arcs_.size()
      ? vector(middle/length) : vector(0.48, 0.60, 0.64),
        vector(0.36, 0.48, -0.80), vector(-0.64, 0.48, 0.60),
        vector(-0.28, -0.96, 0), vector(0.60, 0, -0.80)
    };

    vector best(candidates[0]);
    scalar farthest = -GREAT;
    for (const vector& o : candidates)
    {
        scalar least = GREAT;
        for (const arc& part : arcs_)
        {
            least = min(least, o & (part.a - c));
        }
        if (least > farthest)
        {
            farthest = least;
            best = o;
        }
        if (farthest > -0.7*cap_->radius())
        {
            break;
        }
    }
    return best;
}
