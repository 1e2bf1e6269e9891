/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "closedSurface.H"
#include "addToRunTimeSelectionTable.H"
#include "OSspecific.H"
#include "Time.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace liquidShapes
{
    defineTypeName(closedSurface);
    addToRunTimeSelectionTable(liquidShape, closedSurface, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::liquidShapes::closedSurface::closedSurface
(
    const Time& runTime,
    const meshSymmetry& symmetry,
    const dictionary& dict
)
:
    liquidShape(symmetry),
    volume_(0)
{
    onlyThese(dict, {"file", "scale"});
    checkAxis(dict, !symmetry.wedge());

    const fileName path
    (
        runTime.globalPath()/runTime.constant()/"triSurface"
       /dict.get<fileName>("file")
    );
    if (!isFile(path))
    {
        FatalIOErrorInFunction(dict)
            << "There is no file " << path << nl
            << "The surface in " << dict.dictName()
            << " must be in constant/triSurface" << exit(FatalIOError);
    }
    surface_ = triSurface(path);
    surface_.scalePoints(userEntry::positiveOr(dict, "scale", dimless, 1));
    check(dict, path);
    search_.reset(new triSurfaceSearch(surface_));
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::liquidShapes::closedSurface::check
(
    const dictionary& dict,
    const fileName& path
)
{
    label nOpen = 0;
    for (const labelList& faces : surface_.edgeFaces())
    {
        nOpen += faces.size() != 2;
    }

    const point o(boundBox(surface_.points(), false).midpoint());
    for (const labelledTri& f : surface_)
    {
        const triPointRef t(f.tri(surface_.points()));
        volume_ += ((t.a() - o) & ((t.b() - o)^(t.c() - o)))/6;
    }

    if (nOpen > 0 || surface_.empty() || volume_ == 0)
    {
        FatalIOErrorInFunction(dict)
            << "The surface in " << path << " is not closed: "
            << surface_.size() << " triangles, " << nOpen
            << " edges without two triangles" << nl
            << "See surfaceCheck" << exit(FatalIOError);
    }
    if (volume_ < 0)
    {
        triSurface turned(surface_);
        for (labelledTri& f : turned)
        {
            f.flip();
        }
        surface_ = triSurface(turned, surface_.patches(), surface_.points());
        volume_ = -volume_;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::liquidShapes::closedSurface::depth
(
    const point& x
) const
{
    const auto& tree = search_->tree();
    const pointIndexHit nearest(tree.findNearest(x, GREAT));
    const scalar distance = mag(nearest.rawPoint() - x);

    return
        tree.getVolumeType(x) == volumeType::INSIDE ? distance : -distance;
}


Foam::scalar Foam::dew::liquidShapes::closedSurface::volumeIn
(
    const convexPiece& piece
) const
{
    const point c(piece.centre());
    const scalar d = depth(c);
    if (mag(d) >= piece.radius(c))
    {
        return d > 0 ? piece.volume() : 0;
    }

    const vector e(0, 0, 1);
    const boundBox bounds(piece.corners(), false);
    scalar sum = 0;
    convexPiece held, rest, next;
    for (const labelledTri& f : surface_)
    {
        point x[3];
        boundBox room;
        for (label i = 0; i < 3; i++)
        {
            x[i] = surface_.points()[f[i]];
            room.add(x[i]);
        }
        if
        (
            room.min().x() >= bounds.max().x()
         || room.max().x() <= bounds.min().x()
         || room.min().y() >= bounds.max().y()
         || room.max().y() <= bounds.min().y()
         || room.max().z() <= bounds.min().z()
        )
        {
            continue;
        }

        vector n((x[1] - x[0])^(x[2] - x[0]));
        const scalar sign = n.z() < 0 ? -1 : 1;
        if (mag(n.z()) <= 1e-14*mag(n))
        {
            continue;
        }
        n *= sign;

        piece.split(x[0], n, held, rest);
        for (label i = 0; i < 3 && !held.empty(); i++)
        {
            const vector outward(sign*((x[(i + 1) % 3] - x[i])^e));
            held.split(x[i], outward, next, rest);
            held = next;
        }
        sum += sign*held.volume();
    }
    return sum;
}


Foam::scalar Foam::dew::liquidShapes::closedSurface::volume
(
    const boundBox& b
) const
{
    return b.contains(boundBox(surface_.points(), false)) ? volume_ : -1;
}
