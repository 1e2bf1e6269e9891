/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "cellOverlap.H"
#include "mathematicalConstants.H"
#include "polyMesh.H"

using Foam::constant::mathematical::pi;

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::cellOverlap::cellOverlap(const polyMesh& mesh)
:
    mesh_(mesh)
{
    correct();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::dew::cellOverlap::flat(const label facei) const
{
    const face& f = mesh_.faces()[facei];
    const pointField& points = mesh_.points();
    const scalar area = mag(mesh_.faceAreas()[facei]);

    if (f.size() > ballPolyhedron::maxCorners || !(area > VSMALL))
    {
        return false;
    }

    const vector n(mesh_.faceAreas()[facei]/area);
    forAll(f, k)
    {
        const point& a = points[f[k]];
        const point& b = points[f[f.fcIndex(k)]];
        const point& c = points[f[f.fcIndex(f.fcIndex(k))]];

        // Positions are rounded, which tilts small faces far from the origin
        const scalar round =
            1e-13*std::sqrt(area) + 1e-15*(mag(a.x()) + mag(a.y()) + mag(a.z()));
        if
        (
            mag(n & (a - mesh_.faceCentres()[facei])) > round
         || (n & ((b - a)^(c - b))) < -1e-12*area
        )
        {
            return false;
        }
    }
    return true;
}


void Foam::dew::cellOverlap::add(const label facei, const label celli) const
{
    const face& f = mesh_.faces()[facei];
    const pointField& points = mesh_.points();
    const bool owner = mesh_.faceOwner()[facei] == celli;
    const label n = f.size();

    if (flat_.test(facei))
    {
        point x[ballPolyhedron::maxCorners];
        for (label k = 0; k < n; k++)
        {
            x[k] = points[f[owner ? k : n - 1 - k]];
        }
        const vector& S = mesh_.faceAreas()[facei];
        ball_.add(x, n, (owner ? 1 : -1)*S/mag(S));
        return;
    }

    for (label k = 0; k < n; k++)
    {
        const point& a = points[f[k]];
        const point& b = points[f[f.fcIndex(k)]];
        const point x[3] =
        {
            mesh_.faceCentres()[facei], owner ? a : b, owner ? b : a
        };
        const vector S((x[1] - x[0])^(x[2] - x[0]));
        const scalar magS = mag(S);
        if (magS > 0)
        {
            ball_.add(x, 3, S/magS);
        }
    }
}


bool Foam::dew::cellOverlap::inside(const point& c, const label celli) const
{
    const pointField& points = mesh_.points();

    // 4 pi inside, 0 outside
    scalar angle = 0;
    for (const label facei : mesh_.cells()[celli])
    {
        const face& f = mesh_.faces()[facei];
        const scalar sign = mesh_.faceOwner()[facei] == celli ? 1 : -1;
        const vector m(mesh_.faceCentres()[facei] - c);
        forAll(f, k)
        {
            const vector a(points[f[k]] - c);
            const vector b(points[f[f.fcIndex(k)]] - c);
            const scalar la = mag(a), lb = mag(b), lm = mag(m);
            angle += 2*sign*atan2
            (
                m & (a^b),
                lm*la*lb + (m & a)*lb + (a & b)*lm + (b & m)*la
            );
        }
    }
    return angle > 2*pi;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::cellOverlap::correct()
{
    flat_.clear();
    flat_.resize(mesh_.nFaces());
    for (label facei = 0; facei < mesh_.nFaces(); facei++)
    {
        flat_.set(facei, flat(facei));
    }
}


Foam::scalar Foam::dew::cellOverlap::volume
(
    const point& c,
    const scalar R,
    const label celli
) const
{
    const pointField& points = mesh_.points();
    const cell& faces = mesh_.cells()[celli];

    // With faces that are not flat, its volume depends on their triangles
    scalar farthest = 0;
    for (const label facei : faces)
    {
        if (!flat_.test(facei))
        {
            farthest = GREAT;
            break;
        }
        for (const label pointi : mesh_.faces()[facei])
        {
            farthest = max(farthest, magSqr(points[pointi] - c));
        }
    }
    if (farthest <= sqr(R))
    {
        return mesh_.cellVolumes()[celli];
    }

    // A ball is the sphere of a cap with a right angle
    const sphericalCap ball(c, vector(0, 0, 1), R, 0.5*pi);
    ball_.begin(ball);
    for (const label facei : faces)
    {
        // Flat faces that the ball does not reach add nothing
        const vector& S = mesh_.faceAreas()[facei];
        if
        (
           !flat_.test(facei)
         || sqr(S & (mesh_.faceCentres()[facei] - c)) < sqr(R)*magSqr(S)
        )
        {
            add(facei, celli);
        }
    }

    return ball_.volume([&]() { return inside(c, celli); });
}
