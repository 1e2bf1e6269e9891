/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "bulkForces.H"
#include "error.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::bulkForces::check(const label n) const
{
    const label sizes[] =
    {
        Su.size(), Sp.size(), U.size(),
        Tu.size(), Tp.size(), Omega.size(),
        Qu.size(), Qp.size(), Tf.size(),
        Sn.size(), kick.size(), heatKick.size()
    };
    static const char* names[] =
    {
        "Su", "Sp", "U", "Tu", "Tp", "Omega", "Qu", "Qp", "Tf",
        "Sn", "kick", "heatKick"
    };

    for (label k = 0; k < 12; k++)
    {
        if (sizes[k] != 0 && sizes[k] != n)
        {
            FatalErrorInFunction
                << "Bulk forces: " << names[k] << " has " << sizes[k]
                << " entries for " << n << " particles"
                << exit(FatalError);
        }
        if (k < 9 && k % 3 == 1 && sizes[k] != sizes[k + 1])
        {
            FatalErrorInFunction
                << "Bulk forces: " << names[k] << " without "
                << names[k + 1]
                << exit(FatalError);
        }
    }
}
