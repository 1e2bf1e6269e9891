/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "heightFunction.H"
#include "heightStencil.H"
#include "transportedSurface.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Shares that count as full and empty: h is 1e-6 of a width off at most
constexpr scalar pure = 1e-6;

//- Out of a wall of contact angle theta, along it the surface has the slope p.y
//  and the second derivative 2 p.z
scalar alongWall(const label side, const scalar cot, const vector& p)
{
    return (side ? 1 : -1)*cot*p.y()*2*p.z()/Foam::sqrt(1 + sqr(p.y()));
}

//- Slopes at walls: they depend on the slope along the wall
void setSlopes
(
    const dew::heightStencil& stencil,
    const scalar cot[2][2],
    dew::heightStencil::values& v
)
{
    bool walls = false;
    for (label i = 0; i < stencil.nAxes; i++)
    {
        walls = walls || stencil.wall[i][0] || stencil.wall[i][1];
    }

    vector p[2] = {Zero, Zero};
    for (label pass = 0; pass < 3 && walls; pass++)
    {
        for (label i = 0; i < stencil.nAxes; i++)
        {
            const scalar along =
                pass && stencil.nAxes == 2 ? p[1 - i].y() : 0;
            for (label side = 0; side < 2; side++)
            {
                if (!stencil.wall[i][side])
                {
                    continue;
                }
                scalar& slope = v.line[i][1 + side];
                slope =
                    (side ? 1 : -1)*cot[i][side]*Foam::sqrt(1 + sqr(along));
                if (stencil.ring)
                {
                    // Of the square of the radius
                    const scalar x = stencil.at[i][side];
                    slope *=
                        2*Foam::sqrt
                        (
                            mag(pass ? p[0] & vector(1, x, sqr(x))
                          : v.line[0][0])
                        );
                }
            }
            p[i] = stencil.quadratic(i, v.line[i]);
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::dew::curvatureModels::heightFunction::find
(
    const cellColumns& columns,
    const label celli,
    const label toGas,
    column& result
) const
{
    const label k = toGas/2;
    const bool out = toGas & 1;
    const bool ring = columns.wedge() && k == 0;

    const auto size = [&](const label i)
    {
        const scalar w = columns.width(i)[k];
        return ring ? w*(2*columns.inner(i) + w) : w;
    };

    const scalar own = size(celli);
    scalar low =
        !ring ? -0.5*own
      : out ? sqr(columns.inner(celli))
      : -sqr(columns.inner(celli) + columns.width(celli)[k]);
    scalar liquid = alpha_[celli]*own;
    scalar gas = own - liquid;
    result.wall = -1;
    result.depth = 0;

    for (label end = 0; end < 2; end++)
    {
        const label dir = end == 0 ? toGas ^ 1 : toGas;
        label at = celli;
        label steps = 0;
        while (end == 0 ? alpha_[at] < 1 - pure : alpha_[at] > pure)
        {
            const label next = columns.next(at, dir);
            if (next == cellColumns::boundary || next == cellColumns::axis)
            {
                if (result.wall >= 0)
                {
                    return false;
                }
                result.wall = dir;
                break;
            }
            if (next < 0 || !columns.fits(next) || steps++ == columns.reach)
            {
                return false;
            }
            at = next;
            const scalar s = size(at);
            liquid += alpha_[at]*s;
            gas += (1 - alpha_[at])*s;
            if (end == 0)
            {
                low -= s;
            }
        }
    }

    result.h = low + liquid;
    if (result.wall >= 0)
    {
        result.depth = result.wall == toGas ? gas : liquid;
    }
    return true;
}


Foam::scalar Foam::dew::curvatureModels::heightFunction::cotangent
(
    const cellColumns& columns,
    const label celli,
    const label dir
) const
{
    const label facei = columns.boundaryFace(celli, dir);
    if (facei < 0)
    {
        return 0;
    }
    const label patchi = surface_.mesh().boundaryMesh().whichPatch(facei);
    if (!surface_.angles().has(patchi))
    {
        return 0;
    }
    const scalar theta =
        surface_.angles().theta(patchi)
        [
            facei - surface_.mesh().boundaryMesh()[patchi].start()
        ];

    return Foam::cos(theta)/max(Foam::sin(theta), SMALL);
}


Foam::dew::curvatureModels::heightFunction::found
Foam::dew::curvatureModels::heightFunction::byHeights
(
    const cellColumns& columns,
    const label celli,
    const vector& n,
    const label toGas,
    scalar& K
) const
{
    const label k = toGas/2;
    const bool ring = columns.wedge() && k == 0;
    const scalar radius =
        columns.inner(celli) + 0.5*columns.width(celli).x();

    // The axes across
    label axes[2] = {-1, -1};
    label nAxes = 0;
    for (label a = 0; a < 3; a++)
    {
        if (a != k && columns.solved(a))
        {
            axes[nAxes++] = a;
        }
    }

    column own;
    if (!find(columns, celli, toGas, own))
    {
        return found::none;
    }

    // Half the rise of the surface over a column
    scalar rise = 0;
    for (label i = 0; i < nAxes; i++)
    {
        rise +=
            0.5*columns.width(celli)[axes[i]]*mag(n[axes[i]])
           /max(mag(n[k]), VSMALL);
    }
    const auto meetsWall = [&](const column& c)
    {
        return
            c.wall >= 0
         && (
                ring
              ? c.depth < rise*(2*radius + rise)
              : c.depth < rise
            );
    };

    heightStencil stencil;
    stencil.nAxes = nAxes;
    stencil.ring = ring;
    heightStencil::values v;
    scalar cot[2][2];

    for (label i = 0; i < nAxes; i++)
    {
        const label a = axes[i];
        stencil.setCell
        (
            i, columns.width(celli)[a], columns.wedge() && a == 0 ? radius : 0
        );
        v.line[i][0] = own.h;

        FixedList<column, 3> beside({own, own, own});
        bool contactLine = meetsWall(own);
        for (label side = 0; side < 2; side++)
        {
            const label dir = 2*a + side;
            const label next = columns.next(celli, dir);
            if (next >= 0)
            {
                column& c = beside[1 + side];
                if (!columns.fits(next) || !find(columns, next, toGas, c))
                {
                    return found::none;
                }
                stencil.setBeside(i, side, columns.width(next)[a]);
                v.line[i][1 + side] = c.h;
                contactLine = contactLine || meetsWall(c);
            }
            else if (next == cellColumns::none)
            {
                return found::none;
            }
            else
            {
                stencil.setWall(i, side);
                cot[i][side] =
                    next == cellColumns::axis
                  ? 0
                  : cotangent(columns, celli, dir);
                if (mag(cot[i][side]) > columns.reach)
                {
                    return found::none;
                }
            }
        }

        if (contactLine)
        {
            return
                nAxes == 1 && !ring
             && atContactLine(columns, celli, toGas, a, beside, K)
              ? found::exact : found::none;
        }
    }

    setSlopes(stencil, cot, v);
    if (nAxes == 2)
    {
        const vector pa(stencil.quadratic(0, v.line[0]));
        const vector pb(stencil.quadratic(1, v.line[1]));
        for (label sideb = 0; sideb < 2; sideb++)
        {
            scalar* beyond = v.beyond[sideb];
            if (stencil.wall[1][sideb])
            {
                beyond[0] = alongWall(sideb, cot[1][sideb], pa);
                continue;
            }
            const label next = columns.next(celli, 2*axes[1] + sideb);
            beyond[0] = v.line[1][1 + sideb];
            for (label sidea = 0; sidea < 2; sidea++)
            {
                if (stencil.wall[0][sidea])
                {
                    beyond[1 + sidea] =
                        v.line[0][1 + sidea]
                      + stencil.at[1][sideb]
                       *alongWall(sidea, cot[0][sidea], pb);
                    continue;
                }
                const label corner = columns.next(next, 2*axes[0] + sidea);
                column there;
                if
                (
                    corner < 0 || !columns.fits(corner)
                 || !find(columns, corner, toGas, there) || meetsWall(there)
                )
                {
                    return found::none;
                }
                beyond[1 + sidea] = there.h;
            }
        }
    }

    heightStencil::derivatives d(stencil.finite(v));
    if (ring && (d.h > 0) != bool(toGas & 1))
    {
        return found::none;
    }
    const bool exact = stencil.refine(d);
    K = stencil.curvature(d, columns.wedge() ? radius : 0);
    return exact ? found::exact : found::rough;
}
