/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "liquidPhase.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::liquidPhase::liquidPhase(const liquidMixture& liquids)
:
    liquids_(liquids),
    X_(scalarField(liquids.size(), 1.0/liquids.size())),
    x_(X_.standard())
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::liquidPhase::Tboil(const scalar p) const
{
    scalar T = 0;
    for (const liquidModel& liquid : liquids_.liquids())
    {
        T = max(T, liquid.Tboil(p));
    }
    return T;
}


// ************************************************************************* //
