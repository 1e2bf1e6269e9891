/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "heightFunction.H"
#include "transportedSurface.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

bool Foam::dew::curvatureModels::heightFunction::atContactLine
(
    const cellColumns&,
    const label,
    const label,
    const label,
    const FixedList<column, 3>&,
    scalar&
) const
{
    return false;
}
