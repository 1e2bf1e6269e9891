/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "heatExchange.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::dew::heatExchange::schemes>
Foam::dew::heatExchange::schemeNames
({
    {schemes::semiImplicit, "semiImplicit"},
    {schemes::none, "none"}
});


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::heatExchange::heatExchange
(
    const dictionary& dict,
    const particleMesh& map,
    const smoothing& smoothing,
    const volScalarField& T
)
:
    scheme_(schemeNames.getOrDefault("heat", dict, schemes::semiImplicit)),
    source_("heat", map, smoothing, T, dimEnergy)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::heatExchange::correct
(
    const UList<scalar>& heat,
    const UList<scalar>& heatSp
)
{
    if (twoWay())
    {
        sensitivity_.setSize(heat.size());
        sensitivity_ = heatSp;
        source_.correct(heat, heatSp);
    }
    else
    {
        const List<scalar> nothing(heat.size(), scalar(0));
        sensitivity_ = nothing;
        source_.correct(nothing, nothing);
    }
}
