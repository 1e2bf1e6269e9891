/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class Type, class AddOp>
void Foam::dew::particleMesh::share
(
    const UList<Type>& values,
    const AddOp& add
) const
{
    const label nHosted = hosts_.cells().size();
    const List<Type> hosted(hosts_.map().forward(values));
    const scalar part = 1/symmetry().ringFactor();

    for (label k = 0; k < nHosted; k++)
    {
        cells_.each
        (
            k,
            [&](const label c, const scalar w) { add(c, part*w, hosted[k]); }
        );
    }

    if (guests_.active())
    {
        const List<Type> other(guests_.forward(values));
        forAll(other, g)
        {
            cells_.each
            (
                nHosted + g,
                [&](const label c, const scalar w)
                {
                    add(c, part*w, other[g]);
                }
            );
        }
    }
}


template<class Type>
void Foam::dew::particleMesh::scatter
(
    const UList<Type>& values,
    UList<Type>& sums
) const
{
    const auto add =
        [&sums](const label celli, const scalar w, const Type& value)
        {
            sums[celli] += w*value;
        };

    if (symmetry().wedge())
    {
        List<Type> turned(values.size());
        forAll(turned, i)
        {
            turned[i] = toMesh(values[i], i);
        }
        share(turned, add);
    }
    else
    {
        share(values, add);
    }
}


template<class Type>
void Foam::dew::particleMesh::average
(
    const UList<Type>& field,
    UList<Type>& values
) const
{
    const auto mean = [&field](Type& value, const auto& cells)
    {
        value = Zero;
        cells
        (
            [&](const label celli, const scalar w)
            {
                value += w*field[celli];
            }
        );
    };

    const bool wedge = symmetry().wedge();
    for (label i = 0; wedge && i < values.size(); i++)
    {
        values[i] = toMesh(values[i], i);
    }

    gather
    (
        values,
        [&](const label, const point&, const auto& cells, Type& value)
        {
            mean(value, cells);
        },
        [&](const auto& cells, Type& value) { mean(value, cells); },
        [](Type& value, const Type& other) { value += other; }
    );

    for (label i = 0; wedge && i < values.size(); i++)
    {
        values[i] = toSpace(values[i], i);
    }
}


template<class Type, class HostOp, class GuestOp, class MergeOp>
void Foam::dew::particleMesh::gather
(
    UList<Type>& values,
    const HostOp& hosted,
    const GuestOp& guest,
    const MergeOp& merge
) const
{
    const labelUList& hostCell = hosts_.cells();
    const label nHosted = hostCell.size();

    const auto cellsOf = [this](const label k)
    {
        return [this, k](const auto& op) { cells_.each(k, op); };
    };

    List<Type> held(nHosted);
    for (label k = 0; k < nHosted; k++)
    {
        hosted(hostCell[k], symmetry().fold(x_[k]), cellsOf(k), held[k]);
    }
    hosts_.map().reverse
    (
        held, [](Type& to, const Type& from) { to = from; }, values
    );

    if (guests_.active())
    {
        held.setSize(guests_.nPlaces());
        forAll(held, g)
        {
            guest(cellsOf(nHosted + g), held[g]);
        }
        guests_.reverse(held, merge, values);
    }
}


template<class Type, class HostOp>
void Foam::dew::particleMesh::gatherHosted
(
    UList<Type>& values,
    const HostOp& hosted
) const
{
    const labelUList& hostCell = hosts_.cells();

    List<Type> held(hostCell.size());
    forAll(held, k)
    {
        hosted(hostCell[k], symmetry().fold(x_[k]), held[k]);
    }
    hosts_.map().reverse
    (
        held, [](Type& to, const Type& from) { to = from; }, values
    );
}
