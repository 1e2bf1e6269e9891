/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleMesh.H"
#include "polyMesh.H"
#include "rankMessages.H"

#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleMesh::particleMesh
(
    const polyMesh& mesh,
    const supportStencil& stencil
)
:
    mesh_(mesh),
    stencil_(stencil),
    hosts_(mesh)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::particleMesh::add(const label celli, const scalar weight)
{
    for (label e = start_.last(); e < cell_.size(); e++)
    {
        if (cell_[e] == celli)
        {
            weight_[e] += weight;
            return;
        }
    }
    cell_.append(celli);
    weight_.append(weight);
}


bool Foam::dew::particleMesh::step
(
    walker& w,
    List<DynamicList<walker>>& travelling
) const
{
    while (true)
    {
        const label face = hosts_.planes().walk(w.p, w.cell);

        if (face == cellPlanes::inside)
        {
            return true;
        }
        if (face == cellPlanes::lost)
        {
            return false;
        }

        const cellPlanes::crossing& to = hosts_.planes().beyond(face);
        if (to.rank < 0 || w.hops == 64)
        {
            return false;
        }

        w.p += to.shift;
        w.cell = to.cell;
        w.hops++;

        if (to.rank != Pstream::myProcNo())
        {
            travelling[to.rank].append(w);
            return false;
        }
    }
}


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
        // Shares of 1/29 sum up to one within some ulp
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
    for (label k = 0; k + 1 < start_.size(); k++)
    {
        const scalar factor = k < nHosted ? hosted[k] : other[k - nHosted];
        for (label e = start_[k]; e < start_[k+1]; e++)
        {
            weight_[e] *= factor;
        }
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

    const cellPlanes& planes = hosts_.planes();
    const labelUList& hostCell = hosts_.cells();
    const label nHosted = hostCell.size();

    start_.clear();
    cell_.clear();
    weight_.clear();

    if (stencil_.size() == 1)
    {
        for (label k = 0; k < nHosted; k++)
        {
            start_.append(k);
            cell_.append(hostCell[k]);
            weight_.append(1);
        }
        start_.append(nHosted);
        return;
    }

    const List<scalar> diameters(hosts_.map().forward(d));
    const scalar reach = stencil_.reach();
    const UList<particleKey>& keys = hosts_.keys();

    List<DynamicList<walker>> travelling(Pstream::nProcs());
    DynamicList<portion> shares;
    DynamicList<cellPlanes::cut> near(32);

    for (label k = 0; k < nHosted; k++)
    {
        start_.append(cell_.size());
        const scalar radius = 0.5*diameters[k];
        const point centre(symmetry().fold(x_[k]));

        // Turned to the middle plane, the same at any azimuth
        const point turned(symmetry().unfold(centre, centre));

        planes.cuts(centre, hostCell[k], reach*radius, near);
        if (near.empty())
        {
            cell_.append(hostCell[k]);
            weight_.append(1);
            continue;
        }

        // Most points are in the cell of the centre
        scalar inHost = 0;
        forAll(stencil_.offset, s)
        {
            vector away(radius*stencil_.offset[s]);
            if (symmetry().wedge())
            {
                away = symmetry().fold(turned + away) - centre;
            }
            bool inside = true;
            for (const cellPlanes::cut& plane : near)
            {
                inside = inside && (plane.n & away) <= plane.distance;
            }
            if (inside)
            {
                inHost += stencil_.weight[s];
                continue;
            }

            walker w
            {
                keys[k], centre + away, hostCell[k], stencil_.weight[s], 0
            };
            if (step(w, travelling))
            {
                add(w.cell, w.weight);
            }
        }
        if (inHost > 0)
        {
            add(hostCell[k], inHost);
        }
    }

    // Points in cells of other ranks
    while (Pstream::parRun() && anyList(travelling))
    {
        List<List<walker>> arrived;
        exchangeLists(travelling, arrived);
        for (DynamicList<walker>& part : travelling)
        {
            part.clear();
        }
        for (List<walker>& part : arrived)
        {
            for (walker& w : part)
            {
                if (step(w, travelling))
                {
                    shares.append({w.key, w.cell, w.weight});
                }
            }
        }
    }

    std::sort(shares.begin(), shares.end());
    DynamicList<particleKey> keysOfGuests;
    forAll(shares, i)
    {
        if (i == 0 || !(shares[i].key == shares[i-1].key))
        {
            keysOfGuests.append(shares[i].key);
            start_.append(cell_.size());
        }
        add(shares[i].cell, shares[i].weight);
    }
    start_.append(cell_.size());

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
      + (start_.capacity() + cell_.capacity())*sizeof(label)
      + weight_.capacity()*sizeof(scalar);
}


std::size_t Foam::dew::particleMesh::sent() const
{
    return hosts_.map().sent() + guests_.sent();
}
