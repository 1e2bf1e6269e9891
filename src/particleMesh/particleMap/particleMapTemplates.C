/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "Pstream.H"

#include <cstring>
#include <type_traits>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type>
Foam::List<Type> Foam::dew::particleMap::forward
(
    const UList<Type>& values
) const
{
    const label me = Pstream::myProcNo();

    List<Type> result(nPlaces());
    List<List<char>> out(holders_.size()), in(owners_.size());

    forAll(holders_, k)
    {
        const labelList& indices = send_[k];

        if (holders_[k] == me)
        {
            Type* to = result.data() + start_[owners_.find(me)];
            forAll(indices, j)
            {
                to[j] = values[indices[j]];
            }
        }
        else
        {
            out[k].setSize(indices.size()*sizeof(Type));
            Type* to = reinterpret_cast<Type*>(out[k].data());
            forAll(indices, j)
            {
                to[j] = values[indices[j]];
            }
        }
    }

    if (Pstream::parRun())
    {
        forAll(owners_, k)
        {
            if (owners_[k] != me)
            {
                in[k].setSize((start_[k+1] - start_[k])*sizeof(Type));
            }
        }

        exchange(holders_, out, owners_, in);

        forAll(owners_, k)
        {
            const Type* from = reinterpret_cast<const Type*>(in[k].cdata());
            const label n = in[k].size()/sizeof(Type);
            std::copy(from, from + n, result.begin() + start_[k]);
        }
    }

    return result;
}


template<class Type, class CombineOp>
void Foam::dew::particleMap::reverse
(
    const UList<Type>& held,
    const CombineOp& op,
    UList<Type>& values
) const
{
    const label me = Pstream::myProcNo();

    List<List<char>> out(owners_.size()), in(holders_.size());

    if (Pstream::parRun())
    {
        forAll(owners_, k)
        {
            if (owners_[k] != me)
            {
                const label n = start_[k+1] - start_[k];
                out[k].setSize(n*sizeof(Type));
                std::copy
                (
                    held.begin() + start_[k],
                    held.begin() + start_[k+1],
                    reinterpret_cast<Type*>(out[k].data())
                );
            }
        }
        forAll(holders_, k)
        {
            if (holders_[k] != me)
            {
                in[k].setSize(send_[k].size()*sizeof(Type));
            }
        }

        exchange(owners_, out, holders_, in);
    }

    forAll(holders_, k)
    {
        const labelList& indices = send_[k];
        const Type* from =
            holders_[k] == me
          ? held.cdata() + start_[owners_.find(me)]
          : reinterpret_cast<const Type*>(in[k].cdata());

        forAll(indices, j)
        {
            op(values[indices[j]], from[j]);
        }
    }
}
