/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "planesAround.H"
#include "globalMeshData.H"
#include "globalIndex.H"
#include "globalIndexAndTransform.H"
#include "mapDistribute.H"
#include "FixedList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- x, n and area (area 0 0) of a plane
using packed = FixedList<vector, 3>;

//- Behind a periodic boundary
struct movePlanes
{
    void operator()
    (
        const vectorTensorTransform& move,
        const bool forward,
        List<packed>& planes
    ) const
    {
        for (packed& p : planes)
        {
            p[0] =
                forward
              ? move.transformPosition(p[0])
              : move.invTransformPosition(p[0]);
            p[1] = forward ? (move.R() & p[1]) : (p[1] & move.R());
        }
    }
};

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::labelUList& Foam::dew::planesAround::cellPoints
(
    const label celli
) const
{
    points_.clear();
    for (const label facei : mesh_.cells()[celli])
    {
        for (const label pointi : mesh_.faces()[facei])
        {
            if (!points_.found(pointi))
            {
                points_.append(pointi);
            }
        }
    }
    return points_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::planesAround::correct(const interfacePlanes& planes)
{
    planes_ = &planes;

    coupled_ = false;
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        coupled_ = coupled_ || patch.coupled();
    }
    coupled_ = returnReduce(coupled_, orOp<bool>());
    if (!coupled_)
    {
        return;
    }

    const globalMeshData& global = mesh_.globalData();
    const labelList& cells = global.boundaryCells();

    nOwnShared_ = cells.size();
    List<packed> sent(nOwnShared_, packed(vector::zero));
    forAll(cells, i)
    {
        const label p = planes.of(cells[i]);
        if (p >= 0)
        {
            sent[i][0] = planes.x()[p];
            sent[i][1] = planes.n()[p];
            sent[i][2].x() = planes.area()[p];
        }
    }
    global.globalPointBoundaryCellsMap().distribute
    (
        global.globalTransforms(), sent, movePlanes()
    );
    shared_.setSize(sent.size());
    forAll(sent, i)
    {
        shared_[i] = {sent[i][0], sent[i][1], sent[i][2].x()};
    }
}


void Foam::dew::planesAround::find
(
    const label celli,
    DynamicList<plane>& found
) const
{
    const labelListList& pointCells = mesh_.pointCells();
    found.clear();
    seen_.clear();

    const auto take = [&](const label p)
    {
        if (p >= 0 && !seen_.found(p))
        {
            seen_.append(p);
            found.append
            (
                plane{planes_->x()[p], planes_->n()[p], planes_->area()[p]}
            );
        }
    };
    take(planes_->of(celli));

    const labelUList& points = cellPoints(celli);
    for (const label pointi : points)
    {
        for (const label next : pointCells[pointi])
        {
            take(planes_->of(next));
        }
    }
    if (!coupled_)
    {
        return;
    }

    // Slots behind the planes of this rank in seen_
    const globalMeshData& global = mesh_.globalData();
    const Map<label>& coupledPoints = global.coupledPatch().meshPointMap();
    const label first = planes_->size();
    const auto takeShared = [&](const label slot)
    {
        if
        (
            slot >= nOwnShared_ && shared_[slot].area > 0
         && !seen_.found(first + slot)
        )
        {
            seen_.append(first + slot);
            found.append(shared_[slot]);
        }
    };
    for (const label pointi : points)
    {
        const label p = coupledPoints.lookup(pointi, -1);
        if (p >= 0)
        {
            for (const label slot : global.globalPointBoundaryCells()[p])
            {
                takeShared(slot);
            }
            for
            (
                const label slot :
                global.globalPointTransformedBoundaryCells()[p]
            )
            {
                takeShared(slot);
            }
        }
    }
}


void Foam::dew::planesAround::findNextTo
(
    labelList& marked,
    DynamicList<label>& cells
) const
{
    const labelListList& pointCells = mesh_.pointCells();
    cells.clear();

    const auto mark = [&](const label pointi)
    {
        for (const label next : pointCells[pointi])
        {
            if (!marked[next])
            {
                marked[next] = 1;
                cells.append(next);
            }
        }
    };
    for (const label celli : planes_->cell())
    {
        for (const label pointi : cellPoints(celli))
        {
            mark(pointi);
        }
    }
    if (!coupled_)
    {
        return;
    }

    const globalMeshData& global = mesh_.globalData();
    const labelList& meshPoints = global.coupledPatch().meshPoints();
    const auto near = [&](const labelList& slots)
    {
        for (const label slot : slots)
        {
            if (shared_[slot].area > 0)
            {
                return true;
            }
        }
        return false;
    };
    forAll(meshPoints, p)
    {
        if
        (
            near(global.globalPointBoundaryCells()[p])
         || near(global.globalPointTransformedBoundaryCells()[p])
        )
        {
            mark(meshPoints[p]);
        }
    }
}
