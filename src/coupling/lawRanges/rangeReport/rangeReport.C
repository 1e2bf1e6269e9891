/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "rangeReport.H"
#include "Pstream.H"
#include "PstreamReduceOps.H"

#include <sstream>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::rangeReport::add(const word& name, const lawRanges& ranges)
{
    if (ranges.empty())
    {
        return;
    }

    law watched;
    watched.name = name;
    watched.bounds.setSize(ranges.size());
    forAll(ranges, i)
    {
        watched.bounds[i].range = ranges[i];
    }
    laws_.append(watched);
}


void Foam::dew::rangeReport::restart()
{
    for (law& l : laws_)
    {
        l.now = 0;
    }
}


void Foam::dew::rangeReport::print()
{
    for (law& l : laws_)
    {
        const int64_t sum = returnReduce(l.sum, sumOp<int64_t>());
        if (sum == 0)
        {
            continue;
        }

        std::ostringstream os;
        os.precision(4);
        os  << "Law " << l.name << " outside its range: "
            << returnReduce(l.now, sumOp<label>()) << " particles, " << sum
            << " evaluations since the last report";

        for (bound& b : l.bounds)
        {
            const lawRange& r = b.range;
            const scalar least = returnReduce(b.least, minOp<scalar>());
            const scalar most = returnReduce(b.most, maxOp<scalar>());

            if (most > r.upper)
            {
                os << "; " << r.quantity << " up to " << most;
            }
            if (least < r.lower)
            {
                os << "; " << r.quantity << " down to " << least;
            }
            if (least < r.lower || most > r.upper)
            {
                os << " (" << r.lower << " to " << r.upper << ')';
            }
            b.least = GREAT;
            b.most = -GREAT;
        }
        Info<< os.str().c_str() << endl;

        l.sum = 0;
    }
}
