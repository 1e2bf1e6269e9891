/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Cells with flat faces

#include "sphereOverlap.H"
#include "fvMesh.H"
#include "mathematicalConstants.H"
#include "wedgePolyPatch.H"

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


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::sphereOverlap::discPart::add
(
    const sphericalCap& cap,
    const FixedList<point, 3>& x,
    const vector& n,
    const vector& o
)
{
    whole += 0.5*(n & ((x[1] - x[0])^(x[2] - x[0])));

    scalar power[3];
    for (label k = 0; k < 3; k++)
    {
        power[k] = cap.power(x[k]);
    }

    // Straight parts in the order of the edges
    point from[3], to[3];
    bool ends[3], begins[3];
    label nParts = 0;
    for (label k = 0; k < 3; k++)
    {
        const label l = (k + 1) % 3;
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

    const scalar R = cap.radius();
    const point c(cap.centre());
    const scalar d = n & (x[0] - c);
    const point foot(c + d*n);

    if (nParts == 0)
    {
        // The whole disc, or nothing
        for (label k = 0; k < 3; k++)
        {
            if ((n & ((x[(k + 1) % 3] - x[k])^(foot - x[k]))) < 0)
            {
                return;
            }
        }
        const scalar rhoSqr = (R - d)*(R + d);
        if (rhoSqr > 0)
        {
            area += pi*rhoSqr;
            solidAngle -= 2*pi*(1 - d/R);
        }
        return;
    }

    const point ref(c + R*o);
    for (label k = 0; k < nParts; k++)
    {
        const vector p(to[k] - from[0]);
        area += 0.5*(n & ((from[k] - from[0])^p));

        if (!ends[k])
        {
            continue;
        }

        // The arc from here to the next straight part
        const label l = (k + 1) % nParts;
        const vector q(from[l] - from[0]);
        area += 0.5*(n & (p^q));

        const scalar chord = mag(q - p);
        if (!(chord > 0))
        {
            continue;
        }
        const scalar toCentre = (n & ((q - p)^(foot - to[k])))/chord;
        const scalar phi = 2*atan2(0.5*chord, toCentre);
        const scalar rhoSqr = sqr(toCentre) + 0.25*sqr(chord);
        area += 0.5*rhoSqr*sineDefect(phi);

        const scalar t =
            d >= 0 ? rhoSqr/sqr(R + d) : sqr(R - d)/rhoSqr;
        const label parts = label(phi/longestArc) + 1;
        const vector u(to[k] - foot), v(n^u);
        vector a(to[k] - ref);
        for (label part = 1; part <= parts; part++)
        {
            vector b(from[l] - ref);
            if (part < parts)
            {
                const scalar angle = part*phi/parts;
                b = foot + cos(angle)*u + sin(angle)*v - ref;
            }
            solidAngle -= lune(t, phi/parts) + greatTriangle(o, a, b, R);
            a = b;
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dew::sphereOverlap::cellShare
(
    const sphericalCap& cap,
    const label celli,
    scalar& area
) const
{
    const pointField& points = mesh_.points();
    const scalar R = cap.radius();
    const point c(cap.centre());
    const scalar size = cellSize_[celli];

    // Away from the antipode of all arcs
    const vector o
    (
        size < 0.9*R
      ? cap.outward(mesh_.C()[celli])
      : vector(0.3607, 0.5413, 0.7595)/mag(vector(0.3607, 0.5413, 0.7595))
    );

    scalar cones = 0, wholeCones = 0, solidAngle = 0;
    bool centreInside = true;

    for (const label facei : mesh_.cells()[celli])
    {
        const face& f = mesh_.faces()[facei];
        const bool owner = mesh_.faceOwner()[facei] == celli;
        const point middle(f.centre(points));

        // Triangles, as the volume of a cell is defined; one is enough of one
        const label n = f.size() == 3 ? 1 : f.size();
        for (label k = 0; k < n; k++)
        {
            FixedList<point, 3> x;
            x[0] = f.size() == 3 ? points[f[2]] : middle;
            x[1] = points[f[k]];
            x[2] = points[f[(k + 1) % f.size()]];
            if (!owner)
            {
                Swap(x[1], x[2]);
            }
            vector normal((x[1] - x[0])^(x[2] - x[0]));
            const scalar magNormal = mag(normal);
            if (!(magNormal > 0))
            {
                continue;
            }
            normal /= magNormal;

            discPart part;
            part.add(cap, x, normal, o);
            const scalar d = normal & (x[0] - c);
            cones += d*part.area;
            wholeCones += (normal & (x[0] - mesh_.C()[celli]))*part.whole;
            solidAngle += part.solidAngle;
            centreInside = centreInside && d > 0;
        }
    }

    const scalar V = wholeCones/3;
    const scalar tolerance = 1e-10 + 1e-14*sqr(R/size);

    solidAngle -= 4*pi*round(solidAngle/(4*pi));
    scalar held = (cones + pow3(R)*solidAngle)/3;
    if (held < 0 && (centreInside || held < -tolerance*V))
    {
        solidAngle += 4*pi;
        held = (cones + pow3(R)*solidAngle)/3;
    }
    area = max(sqr(R)*solidAngle, scalar(0));

    return checked(held/V, tolerance, "cell", celli);
}


Foam::scalar Foam::dew::sphereOverlap::faceShare
(
    const sphericalCap& cap,
    const label facei
) const
{
    const face& f = mesh_.faces()[facei];
    bool in = true;
    for (const label pointi : f)
    {
        in = in && power_[pointi] >= 0;
    }
    if (in)
    {
        return 1;
    }

    if (faceEdge_.size() && faceEdge_[facei].start() >= 0)
    {
        const label a = faceEdge_[facei].start();
        const label b = faceEdge_[facei].end();
        const scalar L2 = sqr(r_[b] - r_[a]) + sqr(z_[b] - z_[a]);
        scalar t0, t1;
        if
        (
            !(r_[a] + r_[b] > 0)
         || !sphericalCap::inside(power_[a], power_[b], L2, t0, t1)
        )
        {
            return 0;
        }
        return
            (t1 - t0)
           *(2*r_[a] + (t0 + t1)*(r_[b] - r_[a]))/(r_[a] + r_[b]);
    }

    const pointField& points = mesh_.points();
    const point middle(f.centre(points));
    discPart part;
    forAll(f, k)
    {
        FixedList<point, 3> x;
        x[0] = middle;
        x[1] = points[f[k]];
        x[2] = points[f[(k + 1) % f.size()]];
        vector normal((x[1] - x[0])^(x[2] - x[0]));
        const scalar magNormal = mag(normal);
        if (magNormal > 0)
        {
            part.add(cap, x, normal/magNormal, cap.normal());
        }
    }
    return checked(part.area/part.whole, 1e-10, "face", facei);
}
