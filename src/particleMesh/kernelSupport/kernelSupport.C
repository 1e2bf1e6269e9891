/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "kernelSupport.H"
#include "polyMesh.H"
#include "rankMessages.H"

#include <algorithm>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::kernelSupport::kernelSupport(autoPtr<cellKernel>&& kernel)
:
    kernel_(std::move(kernel)),
    flood_(0),
    most_(-1),
    same_(0),
    travelling_(Pstream::nProcs())
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::kernelSupport::prepare(const hostCells& hosts)
{
    const polyMesh& mesh = hosts.mesh();

    if (mesh.changing())
    {
        kernel_->update();
    }
    if (most_ < 0 || mesh.changing())
    {
        const scalar period = hosts.planes().period();
        most_ = min(cmptMax(mesh.bounds().span()), 0.5*period);
        same_ = 1e-6*period;
    }

    const label nBoundary = mesh.nFaces() - mesh.nInternalFaces();
    if
    (
        seen_.size() != mesh.nCells() || entered_.size() != nBoundary
     || flood_ > labelMax/2
    )
    {
        flood_ = 0;
        seen_.setSize(mesh.nCells());
        entered_.setSize(nBoundary);
        seen_ = 0;
        entered_ = 0;
    }
}


void Foam::dew::kernelSupport::begin()
{
    flood_++;
    queue_.clear();
}


template<class AddOp>
bool Foam::dew::kernelSupport::flood
(
    const cellPlanes& planes,
    const traveller& t,
    const AddOp& add
)
{
    const scalar reach = kernel_->reach(t.d);
    bool stays = true;

    for (label q = 0; q < queue_.size(); q++)
    {
        const label celli = queue_[q];
        planes.eachFace(celli, t.x, [&](const label next, const scalar far)
        {
            if (far >= reach)
            {
                return;
            }
            if (next < 0)
            {
                // Where it came from it has been
                const label face = -1 - next;
                const cellPlanes::crossing& to = planes.beyond(face);
                if
                (
                    to.rank >= 0
                 && entered_[planes.boundaryIndex(face)] != flood_
                )
                {
                    travelling_[to.rank].append
                    (
                        traveller{t.key, to.face, t.x + to.shift, t.d}
                    );
                    stays = false;
                }
            }
            else if (seen_[next] != flood_)
            {
                seen_[next] = flood_;
                const scalar w = kernel_->weight(t.x, t.d, next);
                if (w > 0)
                {
                    add(next, w);
                    queue_.append(next);
                }
            }
        });
    }

    return stays;
}


void Foam::dew::kernelSupport::hostShare
(
    const hostCells& hosts,
    const label k,
    const point& centre,
    const scalar d,
    supportCells& cells
)
{
    const scalar reach = kernel_->reach(d);
    if (reach > most_)
    {
        kernel_->tooWide(reach, most_);
    }

    const label host = hosts.cells()[k];
    begin();
    cells.begin();
    seen_[host] = flood_;
    queue_.append(host);

    const bool stays = flood
    (
        hosts.planes(), traveller{hosts.keys()[k], -1, centre, d},
        [&](const label celli, const scalar w) { cells.append(celli, w); }
    );

    if (stays && !cells.nLast())
    {
        cells.append(host, 1);
        return;
    }

    // At least something, for a kernel that misses all cells
    cells.append
    (
        host,
        max
        (
            kernel_->weight(centre, d, host),
            1e-100*hosts.mesh().cellVolumes()[host]
        )
    );
    if (stays)
    {
        cells.scaleLast(1/cells.lastSum());
    }
}


void Foam::dew::kernelSupport::enter
(
    const hostCells& hosts,
    const UList<point>& hosted,
    const supportCells& cells,
    const label from,
    const label to,
    const label nOld
)
{
    const traveller& t = incoming_[from];
    const cellPlanes& planes = hosts.planes();
    begin();

    // What this image has had here, as a guest and around its centre
    const auto byKey = [](const share& a, const particleKey& key)
    {
        return a.part.key < key;
    };
    share* old =
        std::lower_bound(shares_.begin(), shares_.begin() + nOld, t.key, byKey);
    for (; old != shares_.begin() + nOld && old->part.key == t.key; ++old)
    {
        if (mag(old->x - t.x) < same_)
        {
            seen_[old->part.cell] = flood_;
        }
    }
    const UList<particleKey>& keys = hosts.keys();
    const label k =
        std::lower_bound(keys.begin(), keys.end(), t.key) - keys.begin();
    if
    (
        k < keys.size() && keys[k] == t.key
     && mag(hosts.symmetry().fold(hosted[k]) - t.x) < same_
    )
    {
        cells.each
        (
            k, [this](const label c, const scalar) { seen_[c] = flood_; }
        );
    }

    const auto add = [&](const label celli, const scalar w)
    {
        shares_.append(share{{t.key, celli, w}, t.x});
    };

    for (label i = from; i < to; i++)
    {
        const label face = incoming_[i].face;
        entered_[planes.boundaryIndex(face)] = flood_;

        const label celli = hosts.mesh().faceOwner()[face];
        if (seen_[celli] != flood_)
        {
            seen_[celli] = flood_;
            const scalar w = kernel_->weight(t.x, t.d, celli);
            if (w > 0)
            {
                add(celli, w);
                queue_.append(celli);
            }
        }
    }
    flood(planes, t, add);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dew::kernelSupport::find
(
    const hostCells& hosts,
    const UList<point>& hosted,
    const UList<scalar>& d,
    supportCells& cells,
    DynamicList<particleKey>& guests
)
{
    prepare(hosts);

    const List<scalar> diameters(hosts.map().forward(d));
    shares_.clear();

    forAll(hosted, k)
    {
        hostShare
        (
            hosts, k, hosts.symmetry().fold(hosted[k]), diameters[k], cells
        );
    }

    while (anyList(travelling_))
    {
        List<List<traveller>> arrived;
        exchangeLists(travelling_, arrived);
        incoming_.clear();
        for (DynamicList<traveller>& part : travelling_)
        {
            part.clear();
        }
        for (const List<traveller>& part : arrived)
        {
            incoming_.append(part);
        }
        std::sort
        (
            incoming_.begin(), incoming_.end(),
            [](const traveller& a, const traveller& b)
            {
                return a.key == b.key ? a.face < b.face : a.key < b.key;
            }
        );

        const label nOld = shares_.size();
        for (label from = 0; from < incoming_.size();)
        {
            // The others of the same image to the front
            const traveller first(incoming_[from]);
            label end = from;
            while (end < incoming_.size() && incoming_[end].key == first.key)
            {
                end++;
            }
            const label to = std::stable_partition
            (
                incoming_.begin() + from, incoming_.begin() + end,
                [&](const traveller& t)
                {
                    return mag(t.x - first.x) < same_;
                }
            ) - incoming_.begin();

            enter(hosts, hosted, cells, from, to, nOld);
            from = to;
        }

        std::sort
        (
            shares_.begin(), shares_.end(),
            [](const share& a, const share& b) { return a.part < b.part; }
        );
    }

    portions_.clear();
    for (const share& s : shares_)
    {
        portions_.append(s.part);
    }
    cells.close(portions_, guests);
    return true;
}
