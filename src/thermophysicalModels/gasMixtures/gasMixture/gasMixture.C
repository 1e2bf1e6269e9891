/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "gasMixture.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeNameAndDebug(gasMixture, 0);
    defineRunTimeSelectionTable(gasMixture, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::gasMixture::gasMixture
(
    const scalar p0,
    const liquidMixture& liquids,
    const scalar Wc
)
:
    p0_(p0),
    names_(liquids.names()),
    W_(liquids.W()),
    Wc_(Wc)
{}
