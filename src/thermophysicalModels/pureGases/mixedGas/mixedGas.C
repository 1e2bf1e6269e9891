/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "mixedGas.H"
#include "addToRunTimeSelectionTable.H"
#include "air.H"
#include "libraryGas.H"
#include "steam.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace pureGases
{
    defineTypeName(mixedGas);
    addToRunTimeSelectionTable(pureGas, mixedGas, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::pureGas>
Foam::dew::pureGases::mixedGas::species
(
    const word& name,
    const dictionary& dict
)
{
    const word known(speciesData::nameOf(name));
    if (known == "air")
    {
        return autoPtr<pureGas>(new air);
    }
    if (known == "H2O" || known == "steam")
    {
        return autoPtr<pureGas>(new steam);
    }
    return autoPtr<pureGas>(new libraryGas(known, dict));
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::pureGases::mixedGas::mixedGas
(
    const dictionary& dict,
    const liquidModel&
)
{
    userEntry::onlyThese(dict, {"type", "x", "Y"});
    const bool byMass = dict.found("Y");
    if (byMass == dict.found("x"))
    {
        FatalIOErrorInFunction(dict)
            << (byMass ? "Both" : "Neither") << " of x and Y in "
            << dict.dictName() << nl << "Give mole fractions x { N2 0.79; ... }"
            << " or mass fractions Y { ... }" << exit(FatalIOError);
    }

    const dictionary& fractions = userEntry::subDict(dict, byMass ? "Y" : "x");
    const wordList names(fractions.toc());
    x_.setSize(names.size());
    gases_.setSize(names.size());
    scalarField W(names.size());
    forAll(names, i)
    {
        x_[i] = userEntry::within(fractions, names[i], 0, 1);
        gases_.set(i, species(names[i], fractions).ptr());
        W[i] = gases_[i].W();
    }
    if (mag(sum(x_) - 1) > 1e-3)
    {
        FatalIOErrorInFunction(fractions)
            << "The fractions in " << fractions.dictName() << " have the sum "
            << sum(x_) << nl << "Give fractions of sum 1"
            << exit(FatalIOError);
    }
    if (byMass)
    {
        x_ /= W;
    }
    x_ /= sum(x_);
    W_ = sum(x_*W);
    rule_.reset(new Wilke(W));
    mu_.setSize(names.size());
    property_.setSize(names.size());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::dew::pureGas::part>
Foam::dew::pureGases::mixedGas::parts() const
{
    List<part> parts(gases_.size());
    forAll(gases_, i)
    {
        parts[i] = part{gases_[i].name(), gases_[i].W(), x_[i]};
    }
    return parts;
}


Foam::scalar Foam::dew::pureGases::mixedGas::Cp(const scalar T) const
{
    scalar sum = 0;
    forAll(gases_, i)
    {
        sum += x_[i]*gases_[i].W()*gases_[i].Cp(T);
    }
    return sum/W_;
}


Foam::scalar Foam::dew::pureGases::mixedGas::kappa(const scalar T) const
{
    forAll(gases_, i)
    {
        mu_[i] = gases_[i].mu(T);
        property_[i] = gases_[i].kappa(T);
    }
    return rule_->mean(x_, mu_, property_);
}


Foam::scalar Foam::dew::pureGases::mixedGas::mu(const scalar T) const
{
    forAll(gases_, i)
    {
        mu_[i] = gases_[i].mu(T);
    }
    return rule_->mean(x_, mu_, mu_);
}
