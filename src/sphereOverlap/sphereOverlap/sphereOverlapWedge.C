/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Rings with a polygonal section

#include "sphereOverlap.H"
#include "bitSet.H"
#include "fvMesh.H"
#include "mathematicalConstants.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::sphereOverlap::findEdges()
{
    cellSide_.setSize(mesh_.nCells(), -1);
    faceEdge_.setSize(mesh_.nFaces(), edge(-1, -1));
    bitSet onSide(mesh_.nPoints());
    bitSet sideFace(mesh_.nFaces());
    bool first = true;
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (!isA<wedgePolyPatch>(patch))
        {
            continue;
        }
        forAll(patch, i)
        {
            sideFace.set(patch.start() + i);
            if (first)
            {
                cellSide_[patch.faceCells()[i]] = patch.start() + i;
                for (const label pointi : patch[i])
                {
                    onSide.set(pointi);
                }
            }
        }
        first = false;
    }

    bool thick = cellSide_.found(-1);
    forAll(faceEdge_, facei)
    {
        if (sideFace.test(facei))
        {
            continue;
        }
        label n = 0;
        for (const label pointi : mesh_.faces()[facei])
        {
            if (onSide.test(pointi))
            {
                if (n < 2)
                {
                    faceEdge_[facei][n] = pointi;
                }
                n++;
            }
        }
        thick = thick || n != 2;
    }
    if (thick)
    {
        FatalErrorInFunction
            << "The mesh between the wedge patches is not one cell thick"
            << nl << "A surface on a wedge needs cells that reach from one"
            << " wedge patch to the other"
            << exit(FatalError);
    }
}


Foam::scalar Foam::dew::sphereOverlap::ringShare
(
    const sphericalCap& cap,
    const label celli,
    scalar& area
) const
{
    const face& f = mesh_.faces()[cellSide_[celli]];
    const label n = f.size();

    // All integrals are of r^2 - r0^2 over z - z0, with a vertex as 0: they
    // are of the size of the cell, and closed loops do not notice
    const scalar r0 = r_[f[0]], z0 = z_[f[0]], power0 = power_[f[0]];
    const scalar slope = -2*(z0 + cap.depth());

    const auto straight = [&]
    (
        const scalar ra, const scalar za, const scalar rb, const scalar zb
    )
    {
        const scalar a = ra - r0, b = rb - r0;
        return (zb - za)*(3*r0*(a + b) + sqr(a) + a*b + sqr(b))/3;
    };
    const auto arc = [&](const scalar z)
    {
        const scalar s = z - z0;
        return s*(power0 + s*(slope/2 - s/3));
    };

    scalar whole = 0, held = 0, rise = 0, turn = 0;
    for (label k = 0; k < n; k++)
    {
        const label i = f[k], j = f[(k + 1) % n];
        const scalar dr = r_[j] - r_[i], dz = z_[j] - z_[i];
        whole += straight(r_[i], z_[i], r_[j], z_[j]);
        turn += (r_[i] - r0)*(z_[j] - z0) - (r_[j] - r0)*(z_[i] - z0);

        scalar t0, t1;
        if
        (
            !sphericalCap::inside
            (
                power_[i], power_[j], sqr(dr) + sqr(dz), t0, t1
            )
        )
        {
            continue;
        }
        const scalar za = z_[i] + t0*dz;
        const scalar zb = t1 < 1 ? z_[i] + t1*dz : z_[j];
        held += straight
        (
            r_[i] + t0*dr, za, t1 < 1 ? r_[i] + t1*dr : r_[j], zb
        );
        if (power_[i] < 0)
        {
            held += arc(za);
            rise += za - z0;
        }
        if (power_[j] < 0)
        {
            held -= arc(zb);
            rise -= zb - z0;
        }
    }

    // Clockwise in (r, z): all signs change
    area = max
    (
        constant::mathematical::twoPi*cap.radius()*(turn < 0 ? -rise : rise)
       /symmetry_.ringFactor(),
        scalar(0)
    );
    return checked(held/whole, 1e-10, "cell", celli);
}


// ************************************************************************* //
