/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "scalarExchange.H"
#include "OSspecific.H"
#include "particleRecord.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::scalarExchange::read
(
    const fileName& path,
    const bool goesOn,
    UList<scalar>& memory
)
{
    // Nothing is pending: what was is in the values written
    const label n = state_.size();
    sensitivity_.setSize(n, scalar(0));
    kick_.setSize(n, scalar(0));

    bool found = isFile(path);
    Pstream::scatter(found);
    if (!found)
    {
        if (goesOn)
        {
            Info<< "WARNING: no values of the scalar " << name_
                << " in the restart: all particles start with 'initial'. No"
                << " file " << path << nl << endl;
        }
        return;
    }

    boolList known;
    const List<scalar> values(particleRecord::read(path, state_.id, 1, known));
    for (label i = 0; i < n; i++)
    {
        if (known[i])
        {
            scalar* m = memory.data() + stride_*i + first_;
            m[KNOWN] = 1;
            m[CP] = values[i];
        }
    }
}


void Foam::dew::scalarExchange::write
(
    const fileName& path,
    const UList<scalar>& memory
) const
{
    particleRecord::write(path, state_.id, values(memory), 1);
}
