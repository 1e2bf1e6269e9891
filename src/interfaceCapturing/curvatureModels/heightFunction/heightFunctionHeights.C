/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "heightFunction.H"
#include "transportedSurface.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Shares that count as full and empty: h is 1e-6 of a width off at most
constexpr scalar pure = 1e-6;

//- A condition r.(a, b, c) = v on p(x) = a + b x + c x^2
struct condition
{
    vector r;
    scalar v;
};

//- The quadratic by three conditions
vector quadratic(const condition c[3])
{
    return
        (
            c[0].v*(c[1].r ^ c[2].r)
          + c[1].v*(c[2].r ^ c[0].r)
          + c[2].v*(c[0].r ^ c[1].r)
        )/(c[0].r & (c[1].r ^ c[2].r));
}

//- Means of 1, x, x^2 from x0 to x1, of a ring around x = -r if r > 0
vector means(const scalar x0, const scalar x1, const scalar r)
{
    const scalar i0 = x1 - x0;
    const scalar i1 = 0.5*(sqr(x1) - sqr(x0));
    const scalar i2 = (pow3(x1) - pow3(x0))/3;
    if (r <= 0)
    {
        return vector(1, i1/i0, i2/i0);
    }
    const scalar i3 = 0.25*(pow4(x1) - pow4(x0));
    const scalar m0 = r*i0 + i1;
    return vector(1, (r*i1 + i2)/m0, (r*i2 + i3)/m0);
}

//- Slope at x
vector slope(const scalar x)
{
    return vector(0, 1, 2*x);
}

//- The columns of a cell and those beside it along one axis
struct besideLine
{
    //- Of the cells beside; a boundary is below 0
    label next[2];

    //- Of p for the cell and the two sides
    condition c[3];

    //- Position of the sides: of the cell beside, or of the boundary
    scalar x[2];

    //- Cotangent of the contact angle at a boundary
    scalar cot[2];
};

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


bool Foam::dew::curvatureModels::heightFunction::byHeights
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
        return false;
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

    besideLine lines[2];
    for (label i = 0; i < nAxes; i++)
    {
        const label a = axes[i];
        besideLine& l = lines[i];
        const scalar w = columns.width(celli)[a];
        const scalar r = columns.wedge() && a == 0 ? radius : 0;

        FixedList<column, 3> beside({own, own, own});
        bool contactLine = meetsWall(own);

        l.c[0] = {means(-0.5*w, 0.5*w, r), own.h};
        for (label side = 0; side < 2; side++)
        {
            const scalar sgn = side ? 1 : -1;
            const label dir = 2*a + side;
            const label next = columns.next(celli, dir);
            l.next[side] = next;
            if (next >= 0)
            {
                column& c = beside[1 + side];
                if (!columns.fits(next) || !find(columns, next, toGas, c))
                {
                    return false;
                }
                const scalar wn = columns.width(next)[a];
                const scalar x0 = side ? 0.5*w : -0.5*w - wn;
                l.x[side] = sgn*0.5*(w + wn);
                l.c[1 + side] = {means(x0, x0 + wn, r), c.h};
                contactLine = contactLine || meetsWall(c);
            }
            else if (next == cellColumns::none)
            {
                return false;
            }
            else
            {
                l.x[side] = sgn*0.5*w;
                l.cot[side] =
                    next == cellColumns::axis
                  ? 0
                  : cotangent(columns, celli, dir);
                l.c[1 + side] = {slope(l.x[side]), 0};
                if (mag(l.cot[side]) > columns.reach)
                {
                    return false;
                }
            }
        }

        if (contactLine)
        {
            return
                nAxes == 1 && !ring
             && atContactLine(columns, celli, toGas, a, beside, K);
        }
    }

    // Derivatives. Slopes at walls depend on the slope along the wall
    vector p[2] = {Zero, Zero};
    const bool walls =
        lines[0].next[0] < 0 || lines[0].next[1] < 0
     || (nAxes == 2 && (lines[1].next[0] < 0 || lines[1].next[1] < 0));

    for (label pass = 0; pass < (walls ? 3 : 1); pass++)
    {
        for (label i = 0; i < nAxes; i++)
        {
            besideLine& l = lines[i];
            const scalar along = pass && nAxes == 2 ? p[1 - i].y() : 0;
            for (label side = 0; side < 2; side++)
            {
                if (l.next[side] < 0)
                {
                    const scalar out =
                        l.cot[side]*Foam::sqrt(1 + sqr(along));
                    l.c[1 + side].v = (side ? 1 : -1)*out;
                    if (ring)
                    {
                        // Of Q = R^2
                        const scalar h =
                            pass ? p[0] & vector(1, l.x[side], sqr(l.x[side]))
                          : own.h;
                        l.c[1 + side].v *= 2*Foam::sqrt(mag(h));
                    }
                }
            }
            p[i] = quadratic(l.c);
        }
    }

    if (ring)
    {
        const scalar s = toGas & 1 ? 1 : -1;
        const scalar Q = s*p[0].x();
        if (Q <= 0)
        {
            return false;
        }
        const scalar R = Foam::sqrt(Q);
        const scalar Rz = 0.5*s*p[0].y()/R;
        const scalar Rzz = (s*p[0].z() - sqr(Rz))/R;
        const scalar N = Foam::sqrt(1 + sqr(Rz));
        K = s*(1/(R*N) - Rzz/pow3(N));
        return true;
    }

    const scalar ha = p[0].y();
    const scalar haa = 2*p[0].z();
    if (nAxes == 1)
    {
        const scalar N = Foam::sqrt(1 + sqr(ha));
        K = -haa/pow3(N);
        if (columns.wedge())
        {
            K -= ha/(radius*N);
        }
        return true;
    }

    // Derivative along b of the slopes along a
    const scalar hb = p[1].y();
    const scalar hbb = 2*p[1].z();
    condition mixed[3];
    mixed[0] = {lines[1].c[0].r, ha};
    for (label sideb = 0; sideb < 2; sideb++)
    {
        const label next = lines[1].next[sideb];
        mixed[1 + sideb].r = lines[1].c[1 + sideb].r;
        if (next < 0)
        {
            mixed[1 + sideb].v =
                (sideb ? 1 : -1)*lines[1].cot[sideb]
               *ha*haa/Foam::sqrt(1 + sqr(ha));
            continue;
        }

        condition c[3];
        column there;
        if (!find(columns, next, toGas, there) || meetsWall(there))
        {
            return false;
        }
        c[0] = {lines[0].c[0].r, there.h};
        for (label sidea = 0; sidea < 2; sidea++)
        {
            c[1 + sidea] = lines[0].c[1 + sidea];
            if (lines[0].next[sidea] < 0)
            {
                c[1 + sidea].v +=
                    lines[1].x[sideb]*(sidea ? 1 : -1)*lines[0].cot[sidea]
                   *hb*hbb/Foam::sqrt(1 + sqr(hb));
                continue;
            }
            const label corner = columns.next(next, 2*axes[0] + sidea);
            if
            (
                corner < 0 || !columns.fits(corner)
             || !find(columns, corner, toGas, there) || meetsWall(there)
            )
            {
                return false;
            }
            c[1 + sidea].v = there.h;
        }
        mixed[1 + sideb].v = quadratic(c).y();
    }
    const scalar hab = quadratic(mixed).y();

    K =
       -(
            (1 + sqr(hb))*haa - 2*ha*hb*hab + (1 + sqr(ha))*hbb
        )/pow3(Foam::sqrt(1 + sqr(ha) + sqr(hb)));
    return true;
}
