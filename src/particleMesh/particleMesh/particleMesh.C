/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleMesh.H"
#include "PstreamReduceOps.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleMesh::particleMesh
(
    const polyMesh& mesh,
    autoPtr<particleSupport>&& support
)
:
    support_(std::move(support)),
    hosts_(mesh)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::particleMesh::normalise(const label n)
{
    const label nHosted = hosts_.cells().size();

    // What of each particle has found a cell
    const auto sum = [](const auto& cells, scalar& total)
    {
        total = 0;
        cells([&](const label, const scalar w) { total += w; });
    };
    List<scalar> total(n, scalar(1));
    gather
    (
        total,
        [&](const label, const point&, const auto& cells, scalar& value)
        {
            sum(cells, value);
        },
        sum,
        [](scalar& value, const scalar& other) { value += other; }
    );

    bool all = true;
    for (scalar& t : total)
    {
        // Equal shares sum up to one within some ulp
        const bool complete = mag(t - 1) < 1e-12;
        all = all && complete;
        t = complete || t <= 0 ? 1 : 1/t;
    }
    if (returnReduce(all, andOp<bool>()))
    {
        return;
    }

    const List<scalar> hosted(hosts_.map().forward(total));
    const List<scalar> other(guests_.forward(total));
    for (label k = 0; k < cells_.size(); k++)
    {
        cells_.scale(k, k < nHosted ? hosted[k] : other[k - nHosted]);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::particleMesh::correct
(
    const UList<point>& x,
    const UList<scalar>& d
)
{
    hosts_.correct(x);
    x_ = hosts_.map().forward(x);
    if (symmetry().wedge())
    {
        owned_ = x;
    }

    cells_.clear();
    DynamicList<particleKey> keysOfGuests;
    if (!support_->find(hosts_, x_, d, cells_, keysOfGuests))
    {
        return;
    }

    guests_.correct(keysOfGuests);
    normalise(x.size());
}


Foam::scalar Foam::dew::particleMesh::largestShare
(
    const UList<scalar>& values,
    const UList<scalar>& size,
    label& celli
) const
{
    scalar largest = 0;
    share
    (
        values,
        [&](const label c, const scalar w, const scalar value)
        {
            if (w*value > largest*size[c])
            {
                largest = w*value/size[c];
                celli = c;
            }
        }
    );
    return largest;
}


std::size_t Foam::dew::particleMesh::bytes() const
{
    return
        hosts_.bytes() + guests_.bytes()
      + (x_.size() + owned_.size())*sizeof(point)
      + cells_.bytes();
}


std::size_t Foam::dew::particleMesh::sent() const
{
    return hosts_.map().sent() + guests_.sent();
}
