/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "kineticGas.H"
#include "addToRunTimeSelectionTable.H"
#include "gasConstant.H"
#include "LennardJones.H"
#include "mathematicalConstants.H"
#include "userEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace pureGases
{
    defineTypeName(kineticGas);
    addToRunTimeSelectionTable(pureGas, kineticGas, dictionary);
}
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Parker's dependence of the relaxation on temperature
scalar relaxation(const scalar s)
{
    const scalar p = std::pow(constant::mathematical::pi, 1.5);
    return
        1 + 0.5*p/std::sqrt(s) + (0.25*sqr(constant::mathematical::pi) + 2)/s
      + p/(s*std::sqrt(s));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::pureGases::kineticGas::kineticGas(const word& species)
:
    species_(speciesData::get(species, "molecule")),
    heatCapacity_(NASAPolynomial::get(species_.name)),
    W_(1e-3*species_.W)
{}


Foam::dew::pureGases::kineticGas::kineticGas
(
    const dictionary& dict,
    const liquidModel&
)
:
    kineticGas(dict.get<word>("species"))
{
    userEntry::onlyThese(dict, {"type", "species"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::pureGases::kineticGas::Cp(const scalar T) const
{
    return heatCapacity_(T)*gasConstant/W_;
}


Foam::scalar Foam::dew::pureGases::kineticGas::mu(const scalar T) const
{
    return
        2.6696e-6*std::sqrt(species_.W*T)
       /(sqr(species_.diameter)*LennardJones::viscosity(T/species_.depth));
}


Foam::scalar Foam::dew::pureGases::kineticGas::kappa(const scalar T) const
{
    const scalar t = T/species_.depth;
    const scalar f = 1.2*LennardJones::viscosity(t)/LennardJones::diffusion(t);

    // Over Ru
    const scalar rotation = 0.5*species_.rotations;
    const scalar vibration = heatCapacity_(T) - 2.5 - rotation;

    const scalar twoByPi = 2/constant::mathematical::pi;
    const scalar Z =
        species_.relaxation*relaxation(298/species_.depth)/relaxation(t);
    const scalar A = 2.5 - f;
    const scalar B = Z + twoByPi*(5.0/3*rotation + f);
    const scalar exchanged = rotation > 0 ? twoByPi*A/B : 0;

    return
        mu(T)*gasConstant/W_
       *(
            2.5*(1.5 - exchanged*rotation) + f*(1 + exchanged)*rotation
          + f*vibration
        );
}
