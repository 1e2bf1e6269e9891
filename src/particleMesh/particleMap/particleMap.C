/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleMap.H"
#include "PstreamBuffers.H"
#include "PstreamReduceOps.H"
#include "DynamicList.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleMap::particleMap()
:
    start_(1, Zero),
    active_(false),
    sent_(0)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::particleMap::exchange
(
    const labelList& to,
    const List<List<char>>& out,
    const labelList& from,
    List<List<char>>& in
) const
{
    const label startOfRequests = Pstream::nRequests();

    forAll(from, k)
    {
        if (in[k].size())
        {
            UIPstream::read
            (
                Pstream::commsTypes::nonBlocking,
                from[k], in[k].data(), in[k].size()
            );
        }
    }
    forAll(to, k)
    {
        if (out[k].size())
        {
            sent_ += out[k].size();
            UOPstream::write
            (
                Pstream::commsTypes::nonBlocking,
                to[k], out[k].cdata(), out[k].size()
            );
        }
    }

    Pstream::waitRequests(startOfRequests);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::particleMap::correct(const UList<particleKey>& places)
{
    const label me = Pstream::myProcNo();

    DynamicList<label> owners, start;
    forAll(places, j)
    {
        if (j == 0 || places[j].owner != places[j-1].owner)
        {
            owners.append(places[j].owner);
            start.append(j);
        }
    }
    start.append(places.size());
    owners_.transfer(owners);
    start_.transfer(start);

    // Tell the owners which of theirs are held here
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    List<labelList> theirs(Pstream::nProcs());

    forAll(owners_, k)
    {
        labelList indices(start_[k+1] - start_[k]);
        forAll(indices, j)
        {
            indices[j] = places[start_[k] + j].index;
        }

        if (owners_[k] == me)
        {
            theirs[me].transfer(indices);
        }
        else
        {
            sent_ += indices.byteSize();
            UOPstream toOwner(owners_[k], buffers);
            toOwner << indices;
        }
    }

    if (Pstream::parRun())
    {
        labelList sizes;
        buffers.finishedSends(sizes);
        forAll(sizes, rank)
        {
            if (rank != me && sizes[rank])
            {
                UIPstream fromHolder(rank, buffers);
                fromHolder >> theirs[rank];
            }
        }
    }

    DynamicList<label> holders;
    forAll(theirs, rank)
    {
        if (theirs[rank].size())
        {
            holders.append(rank);
        }
    }
    holders_.transfer(holders);
    send_.setSize(holders_.size());
    forAll(holders_, k)
    {
        send_[k].transfer(theirs[holders_[k]]);
    }

    active_ = returnReduce(places.size() > 0, orOp<bool>());
}


std::size_t Foam::dew::particleMap::bytes() const
{
    std::size_t n =
        holders_.byteSize() + owners_.byteSize() + start_.byteSize();
    for (const labelList& part : send_)
    {
        n += part.byteSize();
    }
    return n;
}
