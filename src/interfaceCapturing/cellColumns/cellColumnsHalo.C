/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "cellColumns.H"
#include "DynamicList.H"
#include "globalIndex.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::cellColumns::addHalo()
{
    const label nOwn = mesh_.nCells();
    const globalIndex numbers(nOwn);

    // Number here of the cells of others
    Map<label> copies;
    DynamicList<label> wanted;

    if (Pstream::parRun())
    {
        List<FixedList<label, 6>> seen(next_);
        for (label layer = 0; layer < depth; layer++)
        {
            DynamicList<label> fresh;
            for (const FixedList<label, 6>& around : seen)
            {
                for (const label cell : around)
                {
                    if (cell >= 0 && !numbers.isLocal(cell))
                    {
                        if (copies.insert(cell, nOwn + copies.size()))
                        {
                            fresh.append(cell);
                        }
                    }
                }
            }
            wanted.append(fresh);

            labelList elements(fresh);
            List<Map<label>> compact;
            const mapDistribute map(numbers, elements, compact);
            List<FixedList<label, 6>> fetched(next_);
            map.distribute(fetched);
            seen.setSize(elements.size());
            forAll(elements, i)
            {
                seen[i] = fetched[elements[i]];
            }
        }

        // All of them in one map, in the order in which they were met
        labelList elements(wanted);
        List<Map<label>> compact;
        halo_.reset(new mapDistribute(numbers, elements, compact));
        halo_->distribute(next_);
        halo_->distribute(width_);
        halo_->distribute(inner_);
        copies.clear();
        forAll(elements, i)
        {
            copies.insert(wanted[i], elements[i]);
        }
    }

    for (FixedList<label, 6>& around : next_)
    {
        for (label& cell : around)
        {
            if (cell >= 0)
            {
                cell =
                    numbers.isLocal(cell)
                  ? numbers.toLocal(cell)
                  : copies.lookup(cell, none);
            }
        }
    }
}
