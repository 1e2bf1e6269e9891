/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "carrierDiffusivity.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::carrierDiffusivity::carrierDiffusivity
(
    const dictionary& dict,
    const pureGas::part& vapour,
    const List<pureGas::part>& carrier
)
:
    diffusivities_(carrier.size()),
    x_(carrier.size())
{
    forAll(carrier, k)
    {
        diffusivities_.set
        (
            k, binaryDiffusivity::New(dict, vapour, carrier[k]).ptr()
        );
        x_[k] = carrier[k].x;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::carrierDiffusivity::D
(
    const scalar p,
    const scalar T
) const
{
    scalar resistance = 0;
    forAll(diffusivities_, k)
    {
        resistance += x_[k]/diffusivities_[k].D(p, T);
    }
    return 1/resistance;
}


Foam::scalar Foam::dew::carrierDiffusivity::factor() const
{
    scalar resistance = 0;
    forAll(diffusivities_, k)
    {
        const scalar one = diffusivities_[k].factor();
        if (one < 0)
        {
            return -1;
        }
        resistance += x_[k]/one;
    }
    return 1/resistance;
}
