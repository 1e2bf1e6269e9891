/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "liquidDiffusivity.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeNameAndDebug(liquidDiffusivity, 0);
    defineRunTimeSelectionTable(liquidDiffusivity, dictionary);
}
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::liquidDiffusivity::D
(
    const label i,
    const scalar p,
    const scalar T,
    const UList<scalar>& x
) const
{
    if (liquids_.size() < 2)
    {
        FatalErrorInFunction
            << "Diffusivity of " << liquids_[i].name() << " in itself" << nl
            << "A single liquid has none" << exit(FatalError);
    }

    // A pure species has the diffusivity of its first traces of others
    constexpr scalar trace = 1e-12;
    scalar others = 0, resistance = 0;
    forAll(liquids_, j)
    {
        if (j != i)
        {
            const scalar share = 0.5*(1 + x[j] - x[i]);
            const scalar Dij =
                std::pow(infinite(i, j, p, T), share)
               *std::pow(infinite(j, i, p, T), 1 - share);
            others += x[j] + trace;
            resistance += (x[j] + trace)/Dij;
        }
    }
    return others/resistance;
}
