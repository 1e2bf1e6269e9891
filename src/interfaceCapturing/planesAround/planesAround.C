/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "planesAround.H"
#include "globalMeshData.H"
#include "mathematicalConstants.H"
#include "globalIndex.H"
#include "globalIndexAndTransform.H"
#include "mapDistribute.H"
#include "FixedList.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- x, n, (area 0 0), end, conormal, rows of the bend of a plane
using packed = FixedList<vector, 8>;

//- Behind a periodic boundary
struct movePlanes
{
    void operator()
    (
        const vectorTensorTransform& move,
        const bool forward,
        List<List<packed>>& lists
    ) const
    {
        for (List<packed>& planes : lists)
        {
            for (packed& p : planes)
            {
                one(move, forward, p);
            }
        }
    }

private:

    static void one
    (
        const vectorTensorTransform& move,
        const bool forward,
        packed& p
    )
    {
        p[0] =
            forward
          ? move.transformPosition(p[0])
          : move.invTransformPosition(p[0]);
        p[3] =
            forward
          ? move.transformPosition(p[3])
          : move.invTransformPosition(p[3]);
        p[1] = forward ? (move.R() & p[1]) : (p[1] & move.R());
        p[4] = forward ? (move.R() & p[4]) : (p[4] & move.R());
        const tensor R(forward ? move.R() : move.R().T());
        const tensor bend(R & tensor(p[5], p[6], p[7]) & R.T());
        p[5] = bend.x();
        p[6] = bend.y();
        p[7] = bend.z();
    }
};

//- Those of both sides
struct join
{
    void operator()(List<packed>& x, const List<packed>& y) const
    {
        x.append(y);
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


void Foam::dew::planesAround::findEnd
(
    const label celli,
    const contactAngles& angles,
    plane& p
) const
{
    for (const label facei : mesh_.cells()[celli])
    {
        const label patchi =
            mesh_.isInternalFace(facei)
          ? -1 : mesh_.boundaryMesh().whichPatch(facei);
        if
        (
            patchi < 0 || mesh_.boundaryMesh()[patchi].coupled()
         || polyPatch::constraintType(mesh_.boundaryMesh()[patchi].type())
        )
        {
            continue;
        }

        bool in = false;
        bool out = false;
        for (const label pointi : mesh_.faces()[facei])
        {
            ((p.n & (mesh_.points()[pointi] - p.x)) > 0 ? out : in) = true;
        }
        const vector m(normalised(mesh_.faceAreas()[facei]));
        const vector along(p.n - (p.n & m)*m);
        const scalar slope = mag(along);
        if (!in || !out || slope < 1e-6)
        {
            continue;
        }

        // Along the plane to the wall; there by the angle
        const scalar theta =
            angles.has(patchi)
          ? angles.theta(patchi)[facei - mesh_.boundaryMesh()[patchi].start()]
          : 0.5*constant::mathematical::pi;
        const vector t(along/slope);
        const vector down((m - (m & p.n)*p.n)/slope);
        p.end = p.x + ((mesh_.faceCentres()[facei] - p.x) & m)/slope*down;
        p.conormal = m*Foam::sin(theta) + t*Foam::cos(theta);
        return;
    }
}


void Foam::dew::planesAround::share()
{
    const globalMeshData& global = mesh_.globalData();
    const labelList& meshPoints = global.coupledPatch().meshPoints();
    const labelListList& pointCells = mesh_.pointCells();

    List<List<packed>> sent(meshPoints.size());
    forAll(meshPoints, i)
    {
        for (const label celli : pointCells[meshPoints[i]])
        {
            const label number = planes_->of(celli);
            if (number >= 0)
            {
                const plane& p = own_[number];
                const tensor bend(p.bend);
                packed s;
                s[0] = p.x;
                s[1] = p.n;
                s[2] = vector(p.area, 0, 0);
                s[3] = p.end;
                s[4] = p.conormal;
                s[5] = bend.x();
                s[6] = bend.y();
                s[7] = bend.z();
                sent[i].append(s);
            }
        }
    }
    globalMeshData::syncData
    (
        sent, global.globalPointSlaves(), global.globalPointTransformedSlaves(),
        global.globalPointSlavesMap(), global.globalTransforms(), join(),
        movePlanes()
    );
    sent.setSize(meshPoints.size());

    shared_.setSize(sent.size());
    forAll(sent, i)
    {
        shared_[i].setSize(sent[i].size());
        forAll(sent[i], j)
        {
            const packed& s = sent[i][j];
            shared_[i][j] =
                {
                    s[0], s[1], s[2].x(), s[3], s[4],
                    symm(tensor(s[5], s[6], s[7]))
                };
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::planesAround::correct
(
    const interfacePlanes& planes,
    const contactAngles& angles
)
{
    planes_ = &planes;

    own_.setSize(planes.size());
    forAll(own_, i)
    {
        own_[i] =
            {
                planes.x()[i], planes.n()[i], planes.area()[i], Zero, Zero, Zero
            };
        findEnd(planes.cell()[i], angles, own_[i]);
    }

    coupled_ = false;
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        coupled_ = coupled_ || patch.coupled();
    }
    coupled_ = returnReduce(coupled_, orOp<bool>());
    if (coupled_)
    {
        share();
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
            found.append(own_[p]);
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

    const Map<label>& coupledPoints =
        mesh_.globalData().coupledPatch().meshPointMap();
    for (const label pointi : points)
    {
        const label i = coupledPoints.lookup(pointi, -1);
        if (i < 0)
        {
            continue;
        }
        for (const plane& p : shared_[i])
        {
            // Of this rank, or seen from another point
            bool known = false;
            for (const plane& q : found)
            {
                known = known || magSqr(p.x - q.x) < 1e-16*p.area;
            }
            if (!known)
            {
                found.append(p);
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

    const labelList& meshPoints =
        mesh_.globalData().coupledPatch().meshPoints();
    forAll(meshPoints, i)
    {
        if (!shared_[i].empty())
        {
            mark(meshPoints[i]);
        }
    }
}
