/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "mixtureSurfaceTension.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeNameAndDebug(mixtureSurfaceTension, 0);
    defineRunTimeSelectionTable(mixtureSurfaceTension, dictionary);
}
}
