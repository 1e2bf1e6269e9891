/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "heightFunction.H"
#include "mathematicalConstants.H"
#include "transportedSurface.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- A surface of constant curvature kappa in the plane, that leaves the wall at
//  the angle theta < pi/2 at u = 0
struct arc
{
    scalar sinTheta, cosTheta, kappa;

    scalar sinPhi(const scalar u) const
    {
        return sinTheta - kappa*u;
    }

    //- Height over the wall; also where kappa vanishes
    scalar height(const scalar u) const
    {
        const scalar s = sinPhi(u);
        return
            u*(sinTheta + s)
           /(cosTheta + Foam::sqrt(max(1 - sqr(s), scalar(0))));
    }

    //- Integral of h, or of h (r - u), from a to b, by Gauss
    scalar volume(const scalar a, const scalar b, const scalar r) const
    {
        static const scalar at[] =
            {0.1834346424956498, 0.5255324099163290,
             0.7966664774136267, 0.9602898564975363};
        static const scalar weight[] =
            {0.3626837833783620, 0.3137066458778873,
             0.2223810344533745, 0.1012285362903763};

        const scalar middle = 0.5*(a + b);
        const scalar half = 0.5*(b - a);
        scalar sum = 0;
        for (label i = 0; i < 4; i++)
        {
            for (const scalar u : {middle - half*at[i], middle + half*at[i]})
            {
                sum += weight[i]*height(u)*(r > 0 ? r - u : 1);
            }
        }
        return half*sum;
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::curvatureModels::heightFunction::fetchAngles
(
    const cellColumns& columns
)
{
    const fvMesh& mesh = surface_.mesh();
    if (theta_.size() != alpha_.size())
    {
        theta_.setSize(alpha_.size());
        theta_ = 0.5*constant::mathematical::pi;
    }
    bool any = false;
    forAll(mesh.boundary(), patchi)
    {
        if (surface_.angles().has(patchi))
        {
            any = true;
            const labelUList& cells = mesh.boundary()[patchi].faceCells();
            forAll(cells, i)
            {
                theta_[cells[i]] = surface_.angles().theta(patchi)[i];
            }
        }
    }
    if (any)
    {
        columns.refresh(theta_);
    }
}


bool Foam::dew::curvatureModels::heightFunction::atContactLine
(
    const cellColumns& columns,
    const label celli,
    const label toGas,
    const label across,
    const FixedList<column, 3>& beside,
    scalar& K
) const
{
    // The wall, from the centre of the cell
    label wall = -1;
    scalar at = 0;
    for (const column& c : beside)
    {
        if (c.wall >= 0)
        {
            if (wall >= 0 && wall != c.wall)
            {
                return false;
            }
            wall = c.wall;
            at = c.wall == toGas ? c.h + c.depth : c.h - c.depth;
        }
    }

    // Between the wall and the surface: liquid, or gas in its stead
    const bool gas = wall == toGas;
    FixedList<scalar, 3> depth;
    forAll(depth, i)
    {
        depth[i] = gas ? at - beside[i].h : beside[i].h - at;
    }

    // The contact line is in the last column that has any
    const vector& w = columns.width(celli);
    const label dry = depth[1] < depth[2] ? 0 : 1;
    const bool here = depth[1 + dry] < 1e-6*w[toGas/2];
    const label line = here ? celli : columns.next(celli, 2*across + dry);
    const label wet =
        here ? columns.next(celli, 2*across + 1 - dry) : celli;
    const scalar depthLine = here ? depth[0] : depth[1 + dry];
    const scalar depthWet = here ? depth[2 - dry] : depth[0];
    if (line < 0 || wet < 0 || depthLine <= 0)
    {
        return false;
    }

    // The angle, at the wall below
    label foot = line;
    for
    (
        label steps = 0;
        steps <= columns.reach && columns.next(foot, wall) >= 0;
        steps++
    )
    {
        foot = columns.next(foot, wall);
    }
    if (columns.next(foot, wall) != cellColumns::boundary)
    {
        return false;
    }
    const scalar theta =
        gas ? constant::mathematical::pi - theta_[foot] : theta_[foot];
    arc shape{Foam::sin(theta), Foam::cos(theta), 0};
    if (shape.cosTheta < 0.1 || shape.sinTheta < 1e-3)
    {
        return false;
    }

    // Volumes as mean depths; of rings, from the axis. All in units of a cell
    const scalar unit = columns.width(line)[across];
    const scalar wLine = 1;
    const scalar wWet = columns.width(wet)[across]/unit;
    const bool rings = columns.wedge();
    const scalar out = dry ? 1 : -1;
    const scalar rLine =
        (columns.inner(line) + 0.5*columns.width(line)[across])/unit;
    const scalar edge = rLine - 0.5*out*wLine;
    const scalar areaLine = rings ? wLine*rLine : wLine;
    const scalar areaWet =
        rings ? wWet*(edge - 0.5*out*wWet) : wWet;

    scalar s =
        Foam::sqrt(2*depthLine/unit*shape.cosTheta/shape.sinTheta);

    // Misfits of both volumes. Radius at u: edge + out (s - u)
    const auto misfit = [&](const scalar s, const scalar kappa, scalar f[2])
    {
        shape.kappa = kappa;
        const auto volume = [&](const scalar a, const scalar b)
        {
            const scalar plain = shape.volume(a, b, 0);
            return
                !rings ? plain
              : out > 0 ? shape.volume(a, b, edge + s)
              : 2*edge*plain - shape.volume(a, b, edge + s);
        };
        f[0] =
            volume(max(s - wLine, scalar(0)), s)/areaLine - depthLine/unit;
        f[1] = volume(s, s + wWet)/areaWet - depthWet/unit;
    };

    scalar kappa = 0;
    bool found = false;
    for (label iter = 0; iter < 30 && !found; iter++)
    {
        constexpr scalar step = 1e-6;
        scalar f[2], fs[2], fk[2];
        misfit(s, kappa, f);
        misfit(s + step, kappa, fs);
        misfit(s, kappa + step, fk);
        const scalar a = (fs[0] - f[0])/step;
        const scalar b = (fk[0] - f[0])/step;
        const scalar c = (fs[1] - f[1])/step;
        const scalar d = (fk[1] - f[1])/step;
        const scalar det = a*d - b*c;
        if (mag(det) < 1e-12)
        {
            return false;
        }
        const scalar ds = (d*f[0] - b*f[1])/det;
        const scalar dk = (a*f[1] - c*f[0])/det;
        s = max(s - ds, 0.1*s);
        kappa -= max(min(dk, scalar(0.5)), scalar(-0.5));
        found = mag(ds) < 1e-9 && mag(dk) < 1e-9;
    }
    shape.kappa = kappa;
    if (!found || s > 3 || mag(shape.sinPhi(s + wWet)) >= 1)
    {
        return false;
    }

    K = kappa/unit;
    if (rings)
    {
        const scalar own = columns.width(celli)[across]/unit;
        const scalar u = max(here ? s - 0.5*own : s + 0.5*own, scalar(0));
        K += out*shape.sinPhi(u)/((edge + out*(s - u))*unit);
    }
    if (gas)
    {
        K = -K;
    }
    return true;
}
