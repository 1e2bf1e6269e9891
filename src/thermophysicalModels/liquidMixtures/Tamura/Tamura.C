/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "Tamura.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace mixtureSurfaceTensions
{
    defineTypeName(Tamura);
    addToRunTimeSelectionTable(mixtureSurfaceTension, Tamura, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::mixtureSurfaceTensions::Tamura::Tamura
(
    const dictionary& dict,
    const wordList& names,
    const PtrList<liquidModel>& liquids
)
:
    mixtureSurfaceTension(liquids),
    w_(-1),
    q_(userEntry::positive(dict, "q", dimless))
{
    userEntry::onlyThese(dict, {"type", "q"});
    forAll(liquids, i)
    {
        if (liquids[i].name() == "H2O")
        {
            w_ = i;
        }
    }
    if (names.size() != 2 || w_ < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Surface tension by Tamura of " << names << nl
            << "It is for one organic liquid in water (H2O of type library)"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::mixtureSurfaceTensions::Tamura::sigma
(
    const scalar p,
    const scalar T,
    const UList<scalar>& x
) const
{
    const liquidModel& water = liquids_[w_];
    const liquidModel& other = liquids_[1 - w_];
    const scalar sw = water.sigma(p, T), so = other.sigma(p, T);
    const scalar xw = x[w_], xo = x[1 - w_];
    if (!(xw > SMALL && xo > SMALL))
    {
        return xo > xw ? so : sw;
    }

    const scalar Vw = 1e6*water.W()/water.rho(p, T);
    const scalar Vo = 1e6*other.W()/other.rho(p, T);
    const scalar C =
        q_*std::log(xw*Vw) - std::log(xo*Vo)
      + (1 - q_)*std::log(xw*Vw + xo*Vo)
      + std::log(10.0)*0.441*q_/T
       *1e3*(so*std::pow(Vo, 2.0/3)/q_ - sw*std::pow(Vw, 2.0/3));

    // q ln f - ln(1 - f) = C grows with f: Newton on f/(1 - f) in logarithms
    scalar z = C/(q_ > 1 ? q_ : 1);
    for (label iter = 0; iter < 100; iter++)
    {
        // ln f = -ln(1 + exp(-z)), ln(1 - f) = -ln(1 + exp(z))
        const scalar error =
            std::log1p(std::exp(z)) - q_*std::log1p(std::exp(-z)) - C;
        const scalar f = 1/(1 + std::exp(-z));
        const scalar step = error/(f + q_*(1 - f));
        z -= step;
        if (mag(step) < 1e-12)
        {
            break;
        }
    }
    const scalar f = 1/(1 + std::exp(-z));
    return pow4(f*std::pow(sw, 0.25) + (1 - f)*std::pow(so, 0.25));
}
