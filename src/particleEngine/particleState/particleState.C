/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleState.H"

#include <cmath>

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::particleState::setSize(const label n)
{
    id.setSize(n);
    type.setSize(n);
    x.setSize(n);
    v.setSize(n);
    omega.setSize(n);
    d.setSize(n);
    rho.setSize(n);
    T.setSize(thermal ? n : 0);
    impulse.setSize(n);
    angularImpulse.setSize(n);
    heat.setSize(thermal ? n : 0);
    impulseSp.setSize(n);
    heatSp.setSize(thermal ? n : 0);
    memory.setSize(nMemory*n, scalar(0));
}


Foam::scalar Foam::dew::particleState::kineticEnergy(const label i) const
{
    return 0.5*mass(i)*(magSqr(v[i]) + 0.1*sqr(d[i])*magSqr(omega[i]));
}


Foam::label Foam::dew::particleState::findNotFinite() const
{
    for (label i = 0; i < size(); i++)
    {
        const scalar sum =
            cmptSum(cmptMag(x[i])) + cmptSum(cmptMag(v[i]))
          + cmptSum(cmptMag(omega[i])) + d[i] + rho[i]
          + cmptSum(cmptMag(impulse[i])) + cmptSum(cmptMag(angularImpulse[i]))
          + impulseSp[i]
          + (thermal ? mag(T[i]) + mag(heat[i]) + heatSp[i] : 0);

        // Squares of what passes are finite, too. Unlike <, isless does not
        // end in a trap for a NaN
        if (!std::isless(sum, 1e100))
        {
            return i;
        }
    }

    return -1;
}
