/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Cells with flat faces

#include "sphereOverlap.H"
#include "ballPolyhedron.H"
#include "fvMesh.H"
#include "mathematicalConstants.H"
#include "wedgePolyPatch.H"

using Foam::constant::mathematical::pi;

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

    ball_.begin(cap);
    scalar wholeCones = 0;
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
            point x[3];
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

            ball_.add(x, 3, normal);
            wholeCones +=
                0.5*magNormal*(normal & (x[0] - mesh_.C()[celli]));
            centreInside = centreInside && (normal & (x[0] - c)) > 0;
        }
    }

    const scalar V = wholeCones/3;
    const scalar cones = ball_.cones();
    const scalar tolerance = 1e-10 + 1e-14*sqr(R/size);

    scalar solidAngle = ball_.solidAngle(o);
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
    ball_.begin(cap);
    scalar part = 0, whole = 0;
    forAll(f, k)
    {
        const point x[3] =
        {
            middle, points[f[k]], points[f[(k + 1) % f.size()]]
        };
        const vector normal((x[1] - x[0])^(x[2] - x[0]));
        const scalar magNormal = mag(normal);
        if (magNormal > 0)
        {
            part += ball_.add(x, 3, normal/magNormal);
            whole += 0.5*magNormal;
        }
    }
    return checked(part/whole, 1e-10, "face", facei);
}
