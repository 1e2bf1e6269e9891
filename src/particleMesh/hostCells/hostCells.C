/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "hostCells.H"
#include "polyMesh.H"
#include "PstreamBuffers.H"
#include "PstreamReduceOps.H"
#include "UIndirectList.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::hostCells::hostCells(const polyMesh& mesh)
:
    mesh_(mesh),
    ranks_(Pstream::nProcs()),
    send_(Pstream::nProcs()),
    cells_(Pstream::nProcs()),
    found_(Pstream::nProcs()),
    nOutside_(0)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dew::hostCells::wellInside
(
    const point& p,
    const label celli
) const
{
    // Near a face the guess must not decide: the answer would depend on where
    // the particle came from
    const scalar margin = 1e-3;

    for (const label facei : mesh_.cells()[celli])
    {
        const vector& Sf = mesh_.faceAreas()[facei];
        const scalar outward = mesh_.faceOwner()[facei] == celli ? 1 : -1;
        const scalar area = mag(Sf);

        if
        (
            outward*((p - mesh_.faceCentres()[facei]) & Sf)
          > -margin*area*sqrt(area)
        )
        {
            return false;
        }
    }

    return true;
}


Foam::label Foam::dew::hostCells::cellOf
(
    const point& p,
    const label guess
) const
{
    if (guess >= 0 && guess < mesh_.nCells())
    {
        if (wellInside(p, guess))
        {
            return guess;
        }
        for (const label celli : mesh_.cellCells()[guess])
        {
            if (wellInside(p, celli))
            {
                return celli;
            }
        }
    }

    return mesh_.findCell(p);
}


void Foam::dew::hostCells::correct(const UList<point>& x)
{
    const label me = Pstream::myProcNo();

    (void)mesh_.tetBasePtIs();      // built by all ranks together

    ranks_[me] = boundBox(mesh_.points(), false);
    Pstream::gatherList(ranks_);
    Pstream::scatterList(ranks_);

    // 1. Ask every rank whose box holds the position
    labelListList asked(Pstream::nProcs());
    {
        List<DynamicList<label>> candidates(Pstream::nProcs());
        forAll(ranks_, rank)
        {
            const boundBox& bb = ranks_[rank];
            const scalar margin = 1e-9*bb.mag();
            const boundBox wide
            (
                bb.min() - margin*vector::one,
                bb.max() + margin*vector::one
            );
            forAll(x, i)
            {
                if (bb.valid() && wide.contains(x[i]))
                {
                    candidates[rank].append(i);
                }
            }
            asked[rank].transfer(candidates[rank]);
        }
    }

    PstreamBuffers questions(Pstream::commsTypes::nonBlocking);
    forAll(asked, rank)
    {
        if (rank != me && asked[rank].size())
        {
            UOPstream to(rank, questions);
            to << List<point>(UIndirectList<point>(x, asked[rank]));
        }
    }
    labelList sizes;
    questions.finishedSends(sizes);

    // 2. The owner of the cell answers
    labelListList answers(Pstream::nProcs());
    labelListList theirs(Pstream::nProcs());
    PstreamBuffers replies(Pstream::commsTypes::nonBlocking);

    forAll(asked, rank)
    {
        List<point> points;
        if (rank == me)
        {
            points = UIndirectList<point>(x, asked[me]);
        }
        else if (sizes[rank])
        {
            UIPstream from(rank, questions);
            from >> points;
        }

        // First guess: the cell of the same place in the last list, else of
        // the position before
        labelList& found = found_[rank];
        const label nOld = found.size();
        found.setSize(points.size());
        forAll(points, i)
        {
            const label guess = i < nOld ? found[i] : i ? found[i - 1] : -1;
            found[i] = cellOf(points[i], guess);
        }
        theirs[rank] = found;

        if (rank == me)
        {
            answers[me] = theirs[me];
        }
        else if (points.size())
        {
            UOPstream to(rank, replies);
            to << theirs[rank];
        }
    }
    replies.finishedSends();

    // 3. The lowest rank that knows the cell is the host
    host_.setSize(x.size());
    host_ = -1;
    forAll(asked, rank)
    {
        if (rank != me && asked[rank].size())
        {
            UIPstream from(rank, replies);
            from >> answers[rank];
        }
        forAll(asked[rank], a)
        {
            const label i = asked[rank][a];
            if (host_[i] < 0 && answers[rank][a] >= 0)
            {
                host_[i] = rank;
            }
        }
    }

    // 4. Tell the hosts which of those they were asked for are theirs
    PstreamBuffers chosen(Pstream::commsTypes::nonBlocking);
    labelListList mine(Pstream::nProcs());

    forAll(asked, rank)
    {
        DynamicList<label> send, cells;
        forAll(asked[rank], a)
        {
            const label i = asked[rank][a];
            if (host_[i] == rank)
            {
                send.append(i);
                cells.append(answers[rank][a]);
            }
        }
        send_[rank].transfer(send);

        if (rank == me)
        {
            mine[me].transfer(cells);
        }
        else if (cells.size())
        {
            UOPstream to(rank, chosen);
            to << labelList(cells);
        }
    }
    chosen.finishedSends(sizes);

    forAll(mine, rank)
    {
        if (rank != me && sizes[rank])
        {
            UIPstream from(rank, chosen);
            from >> mine[rank];
        }
        cells_[rank].transfer(mine[rank]);
    }

    nOutside_ = 0;
    for (const label rank : host_)
    {
        nOutside_ += (rank < 0);
    }
}


Foam::labelList Foam::dew::hostCells::cells() const
{
    DynamicList<label> all;
    for (const labelList& part : cells_)
    {
        all.append(part);
    }
    return labelList(std::move(all));
}
