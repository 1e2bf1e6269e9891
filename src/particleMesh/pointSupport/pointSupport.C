/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "pointSupport.H"
#include "polyMesh.H"
#include "rankMessages.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::dew::pointSupport::step
(
    const cellPlanes& planes,
    walker& w,
    List<DynamicList<walker>>& travelling
)
{
    while (true)
    {
        const label face = planes.walk(w.p, w.cell);

        if (face == cellPlanes::inside)
        {
            return true;
        }
        if (face == cellPlanes::lost)
        {
            return false;
        }

        const cellPlanes::crossing& to = planes.beyond(face);
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


void Foam::dew::pointSupport::share
(
    const cellPlanes& planes,
    const particleKey& key,
    const point& centre,
    const label host,
    supportCells& cells,
    List<DynamicList<walker>>& travelling
)
{
    // Most points are in the cell of the centre
    scalar inHost = 0;
    forAll(away_, s)
    {
        bool inside = true;
        for (const cellPlanes::cut& plane : near_)
        {
            inside = inside && (plane.n & away_[s]) <= plane.distance;
        }
        if (inside)
        {
            inHost += weight_[s];
        }
        else if (weight_[s] > 0)
        {
            walker w{key, centre + away_[s], host, weight_[s], 0};
            if (step(planes, w, travelling))
            {
                cells.add(w.cell, w.weight);
            }
        }
    }
    if (inHost > 0)
    {
        cells.add(host, inHost);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dew::pointSupport::find
(
    const hostCells& hosts,
    const UList<point>& hosted,
    const UList<scalar>& d,
    supportCells& cells,
    DynamicList<particleKey>& guests
)
{
    if (hosts.mesh().changing())
    {
        update();
    }

    const cellPlanes& planes = hosts.planes();
    const meshSymmetry& symmetry = hosts.symmetry();
    const labelUList& hostCell = hosts.cells();
    const List<scalar> diameters(hosts.map().forward(d));

    List<DynamicList<walker>> travelling(Pstream::nProcs());
    shares_.clear();

    forAll(hostCell, k)
    {
        cells.begin();
        const point centre(symmetry.fold(hosted[k]));

        planes.cuts(centre, hostCell[k], reach(diameters[k]), near_);
        if (near_.empty())
        {
            cells.append(hostCell[k], 1);
            continue;
        }
        place(symmetry, centre, diameters[k], hostCell[k]);
        share
        (
            planes, hosts.keys()[k], centre, hostCell[k], cells, travelling
        );
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
                if (step(planes, w, travelling))
                {
                    shares_.append({w.key, w.cell, w.weight});
                }
            }
        }
    }

    cells.close(shares_, guests);
    return true;
}
