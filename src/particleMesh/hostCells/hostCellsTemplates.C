/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "PstreamBuffers.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::List<Type> Foam::dew::hostCells::distribute
(
    const UList<Type>& values
) const
{
    PstreamBuffers buffers(Pstream::commsTypes::nonBlocking);
    DynamicList<Type> result;
    List<List<Type>> received(Pstream::nProcs());

    forAll(send_, rank)
    {
        List<Type> part(UIndirectList<Type>(values, send_[rank]));

        if (rank == Pstream::myProcNo())
        {
            received[rank].transfer(part);
        }
        else if (part.size())
        {
            UOPstream to(rank, buffers);
            to << part;
        }
    }

    buffers.finishedSends();

    forAll(received, rank)
    {
        if (rank != Pstream::myProcNo() && cells_[rank].size())
        {
            UIPstream from(rank, buffers);
            from >> received[rank];
        }
        result.append(received[rank]);
    }

    return List<Type>(std::move(result));
}
