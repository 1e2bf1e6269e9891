/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "tableSurfaceTension.H"
#include "addToRunTimeSelectionTable.H"
#include "Tuple2.H"
#include "userEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace mixtureSurfaceTensions
{
    defineTypeName(tableSurfaceTension);
    addToRunTimeSelectionTable
    (
        mixtureSurfaceTension, tableSurfaceTension, dictionary
    );
}
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

bool byMass(const Foam::dictionary& dict)
{
    const Foam::word fraction(dict.get<Foam::word>("fraction"));
    if (fraction != "mass" && fraction != "mole")
    {
        FatalIOErrorInFunction(dict)
            << "Fraction " << fraction << Foam::nl << "It is mass or mole"
            << Foam::exit(Foam::FatalIOError);
    }
    return fraction == "mass";
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::mixtureSurfaceTensions::tableSurfaceTension::tableSurfaceTension
(
    const dictionary& dict,
    const wordList& names,
    const PtrList<liquidModel>& liquids
)
:
    mixtureSurfaceTension(liquids),
    of_(names.find(dict.get<word>("of"))),
    mass_(byMass(dict)),
    Tref_(userEntry::positive(dict, "Tref", dimTemperature))
{
    userEntry::onlyThese(dict, {"type", "of", "fraction", "Tref", "values"});
    if (names.size() != 2 || of_ < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Table of the surface tension of " << dict.get<word>("of")
            << " in " << names << nl << "It is for one of two liquids"
            << exit(FatalIOError);
    }

    const List<Tuple2<scalar, scalar>> values
    (
        dict.get<List<Tuple2<scalar, scalar>>>("values")
    );
    bool good =
        values.size() > 1 && values.first().first() == 0
     && values.last().first() == 1;
    z_.setSize(values.size());
    values_.setSize(values.size());
    forAll(values, i)
    {
        z_[i] = values[i].first();
        values_[i] = values[i].second();
        good = good && values_[i] > 0 && (!i || z_[i] > z_[i - 1]);
    }
    if (!good)
    {
        FatalIOErrorInFunction(dict)
            << "Values " << values << nl << "Give pairs (z sigma), z rising"
            << " from 0 to 1 and sigma positive, in N/m" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::mixtureSurfaceTensions::tableSurfaceTension::sigma
(
    const scalar p,
    const scalar T,
    const UList<scalar>& x
) const
{
    scalar z = x[of_];
    if (mass_)
    {
        const scalar m = x[of_]*liquids_[of_].W();
        z = m/(m + x[1 - of_]*liquids_[1 - of_].W());
    }
    label i = 1;
    while (i < z_.size() - 1 && z > z_[i])
    {
        i++;
    }
    const scalar share = (z - z_[i - 1])/(z_[i] - z_[i - 1]);
    const scalar measured =
        values_[i - 1] + share*(values_[i] - values_[i - 1]);
    return measured*ideal(p, T, x)/ideal(p, Tref_, x);
}
