/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "ChapmanEnskog.H"
#include "addToRunTimeSelectionTable.H"
#include "speciesData.H"
#include "Tuple2.H"
#include "userEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace binaryDiffusivities
{
    defineTypeName(ChapmanEnskog);
    addToRunTimeSelectionTable(binaryDiffusivity, ChapmanEnskog, dictionary);
}
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Collision integral; t is the temperature over the depth
scalar collisions(const scalar t)
{
    return
        1.06036*std::pow(t, -0.15610) + 0.19300*std::exp(-0.47635*t)
      + 1.03587*std::exp(-1.52996*t) + 1.76474*std::exp(-3.89411*t);
}


//- Diameter and depth
Tuple2<scalar, scalar> potential(const dictionary& dict, const word& name)
{
    const dictionary& potentials =
        dew::userEntry::optionalDict(dict, "potentials");
    if (!potentials.found(name))
    {
        const dew::speciesData& species =
            dew::speciesData::get(name, "Lennard-Jones potential", dict);
        return {species.diameter, species.depth};
    }

    const Tuple2<scalar, scalar> given
    (
        potentials.get<Tuple2<scalar, scalar>>(name)
    );
    if (!(given.first() > 0 && given.second() > 0))
    {
        FatalIOErrorInFunction(potentials)
            << "Potential of " << name << ": " << given << nl
            << "Give a diameter in 1e-10 m and a depth in K, both positive"
            << exit(FatalIOError);
    }
    return given;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::binaryDiffusivities::ChapmanEnskog::ChapmanEnskog
(
    const dictionary& dict,
    const pureGas::part& a,
    const pureGas::part& b
)
{
    userEntry::onlyThese(dict, {"type", "potentials", "pairs"});

    const auto ofA = potential(dict, a.name);
    const auto ofB = potential(dict, b.name);
    const scalar M = 2e3/(1/a.W + 1/b.W);
    factor_ =
        0.0266/(std::sqrt(M)*sqr(0.5*(ofA.first() + ofB.first())));
    depth_ = std::sqrt(ofA.second()*ofB.second());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::binaryDiffusivities::ChapmanEnskog::D
(
    const scalar p,
    const scalar T
) const
{
    return factor_*T*std::sqrt(T)/(p*collisions(T/depth_));
}
