/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "hostCells.H"
#include "polyMesh.H"
#include "PstreamBuffers.H"
#include "PstreamReduceOps.H"
#include "rankMessages.H"

#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::hostCells::hostCells(const polyMesh& mesh)
:
    mesh_(mesh),
    symmetry_(mesh),
    planes_(mesh),
    nOutside_(0)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::hostCells::step
(
    walker w,
    List<DynamicList<walker>>& travelling,
    DynamicList<walker>& unresolved
)
{
    const label face = planes_.walk(w.p, w.cell);

    if (face == cellPlanes::inside)
    {
        if (planes_.ambiguous(w.p, w.cell))
        {
            unresolved.append(w);
        }
        else
        {
            keys_.append(w.key);
            cells_.append(w.cell);
        }
        return;
    }

    if (face >= 0)
    {
        // Positions are absolute: a cyclic does not lead to another place
        const cellPlanes::crossing& to = planes_.beyond(face);
        if (to.rank >= 0 && to.shift == vector::zero && w.hops < 64)
        {
            w.cell = to.cell;
            w.hops++;
            travelling[to.rank].append(w);
            return;
        }
    }

    unresolved.append(w);
}


void Foam::dew::hostCells::search(const UList<walker>& unresolved)
{
    const label me = Pstream::myProcNo();

    List<boundBox> ranks(Pstream::nProcs());
    ranks[me] = boundBox(mesh_.points(), false);
    Pstream::gatherList(ranks);
    Pstream::scatterList(ranks);

    (void)mesh_.tetBasePtIs();      // built by all ranks together

    List<DynamicList<walker>> questions(Pstream::nProcs());
    List<DynamicList<label>> asked(Pstream::nProcs());
    forAll(ranks, rank)
    {
        boundBox wide(ranks[rank]);
        if (!wide.valid())
        {
            continue;
        }
        wide.min() -= 1e-9*wide.mag()*vector::one;
        wide.max() += 1e-9*wide.mag()*vector::one;

        forAll(unresolved, i)
        {
            if (wide.contains(unresolved[i].p))
            {
                questions[rank].append(unresolved[i]);
                asked[rank].append(i);
            }
        }
    }

    List<List<walker>> received;
    exchangeLists(questions, received);

    List<DynamicList<label>> answers(Pstream::nProcs());
    forAll(received, rank)
    {
        for (const walker& w : received[rank])
        {
            answers[rank].append(mesh_.findCell(symmetry_.offAxis(w.p)));
        }
    }
    List<labelList> replies;
    exchangeLists(answers, replies);

    // The lowest rank that knows the cell is the host
    List<DynamicList<walker>> chosen(Pstream::nProcs());
    labelList found(unresolved.size(), Zero);
    forAll(replies, rank)
    {
        forAll(replies[rank], a)
        {
            const label i = asked[rank][a];
            if (!found[i] && replies[rank][a] >= 0)
            {
                found[i] = 1;
                walker w(unresolved[i]);
                w.cell = replies[rank][a];
                chosen[rank].append(w);
            }
        }
    }
    for (const label one : found)
    {
        nOutside_ += !one;
    }

    exchangeLists(chosen, received);
    for (const List<walker>& part : received)
    {
        for (const walker& w : part)
        {
            keys_.append(w.key);
            cells_.append(w.cell);
        }
    }
}


void Foam::dew::hostCells::sortByKey()
{
    if (std::is_sorted(keys_.begin(), keys_.end()))
    {
        return;
    }

    labelList order(keys_.size());
    forAll(order, i)
    {
        order[i] = i;
    }
    std::sort
    (
        order.begin(),
        order.end(),
        [this](const label a, const label b) { return keys_[a] < keys_[b]; }
    );

    const List<particleKey> keys(keys_);
    const labelList cells(cells_);
    forAll(order, i)
    {
        keys_[i] = keys[order[i]];
        cells_[i] = cells[order[i]];
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::hostCells::correct(const UList<point>& x)
{
    const label me = Pstream::myProcNo();

    if (mesh_.changing())
    {
        planes_.correct();
    }
    if (mesh_.topoChanging())
    {
        guess_.clear();
    }

    // New positions begin where the one before them was
    const label nOld = guess_.size();
    guess_.setSize(x.size());
    for (label i = nOld; i < x.size(); i++)
    {
        guess_[i] = i ? guess_[i-1] : host{me, 0};
    }

    keys_.clear();
    cells_.clear();
    nOutside_ = 0;

    List<DynamicList<walker>> travelling(Pstream::nProcs());
    DynamicList<walker> unresolved;

    label last = 0;
    forAll(x, i)
    {
        const host& from = guess_[i];
        walker w{{me, i}, symmetry_.fold(x[i]), from.cell, 0};

        if (from.rank != me)
        {
            travelling[from.rank].append(w);
        }
        else if (mesh_.nCells() == 0)
        {
            unresolved.append(w);
        }
        else
        {
            if (i >= nOld)
            {
                w.cell = last;
            }
            step(w, travelling, unresolved);
            last = cells_.size() ? cells_.last() : 0;
        }
    }

    while (Pstream::parRun() && anyList(travelling))
    {
        List<List<walker>> arrived;
        exchangeLists(travelling, arrived);
        for (DynamicList<walker>& part : travelling)
        {
            part.clear();
        }
        for (const List<walker>& part : arrived)
        {
            for (const walker& w : part)
            {
                step(w, travelling, unresolved);
            }
        }
    }

    if (returnReduce(unresolved.size() > 0, orOp<bool>()))
    {
        search(unresolved);
        reduce(nOutside_, sumOp<label>());
    }

    sortByKey();
    map_.correct(keys_);

    // The owners' next guesses
    List<host> found(cells_.size());
    forAll(found, k)
    {
        found[k] = host{me, cells_[k]};
    }
    map_.reverse(found, [](host& to, const host& from){ to = from; }, guess_);
}


std::size_t Foam::dew::hostCells::bytes() const
{
    return
        map_.bytes() + guess_.size()*sizeof(host)
      + keys_.capacity()*sizeof(particleKey)
      + cells_.capacity()*sizeof(label);
}
