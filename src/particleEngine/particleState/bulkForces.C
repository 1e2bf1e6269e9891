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
        Sn.size(), kick.size(), heatKick.size(), kT.size(),
        surfaceX.size(), surfaceN.size(), surfaceSpeed.size(),
        surfaceCurvature.size(), surfaceK.size(), addedMass.size(),
        nMemory ? memory.size()/nMemory : 0,
        surfaceTension.size(), contactAngle.size(), planePull.size(),
        filmViscosity.size()
    };
    static const char* names[] =
    {
        "Su", "Sp", "U", "Tu", "Tp", "Omega", "Qu", "Qp", "Tf",
        "Sn", "kick", "heatKick", "kT", "surfaceX", "surfaceN",
        "surfaceSpeed", "surfaceCurvature", "surfaceK", "addedMass", "memory",
        "surfaceTension", "contactAngle", "planePull", "filmViscosity"
    };

    for (label k = 0; k < 24; k++)
    {
        if (sizes[k] != 0 && sizes[k] != n)
        {
            FatalErrorInFunction
                << "Bulk forces: " << names[k] << " has " << sizes[k]
                << " entries for " << n << " particles"
                << exit(FatalError);
        }

        // Sp, Tp, Qp; noise belongs to a friction; the surface is whole
        const label partner =
            k < 9 && k % 3 == 1 ? k + 1
          : k == 12 && sizes[k] ? 1
          : k > 12 && k < 18 ? 13
          : k == 20 ? 21
          : k == 21 && sizes[k] ? 13
          : k == 22 && sizes[k] ? 20
          : k == 23 && sizes[k] ? 13
          : k;

        if (sizes[k] != sizes[partner])
        {
            FatalErrorInFunction
                << "Bulk forces: " << names[k] << " and " << names[partner]
                << " go together"
                << exit(FatalError);
        }
    }
}
