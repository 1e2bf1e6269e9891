/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "idealGasMixture.H"
#include "addToRunTimeSelectionTable.H"
#include "gasConstant.H"
#include "speciesPairs.H"
#include "userEntry.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace gasMixtures
{
    defineTypeName(idealGasMixture);
    addToRunTimeSelectionTable(gasMixture, idealGasMixture, dictionary);
}
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::gasMixtures::idealGasMixture::readVapours
(
    const dictionary& dict,
    const liquidMixture& liquids
)
{
    if (dict.found("vapour") && (size() != 1 || dict.found("vapours")))
    {
        FatalIOErrorInFunction(dict)
            << "vapour is for one liquid; here are " << names() << nl
            << "Give vapours { " << names()[0] << " { ... } ... }"
            << exit(FatalIOError);
    }
    const dictionary& all = userEntry::optionalDict(dict, "vapours");
    userEntry::onlyThese(all, names());

    dictionary ofLiquid(dict, dictionary(fileName("vapour")));
    ofLiquid.add("type", word("ofLiquid"));

    vapours_.setSize(size());
    forAll(vapours_, i)
    {
        const dictionary& vapour =
            dict.found("vapour") ? userEntry::subDict(dict, "vapour")
          : all.found(names()[i]) ? userEntry::subDict(all, names()[i])
          : ofLiquid;
        vapours_.set(i, pureGas::New(vapour, liquids.liquid(i)).ptr());
    }
}


void Foam::dew::gasMixtures::idealGasMixture::readDiffusivities
(
    const dictionary& dict,
    const liquidMixture& liquids
)
{
    const dictionary& pairs = userEntry::optionalDict(dict, "pairs");
    wordList known(names());
    known.append("carrier");
    speciesPairs::onlyThese(pairs, known, {});

    const label n = size();
    D_.setSize((n + 1)*n);
    for (label i = 0; i <= n; i++)
    {
        for (label j = 0; j < min(i, n); j++)
        {
            bool swapped = false;
            const word key
            (
                speciesPairs::key(pairs, known[i], known[j], swapped)
            );
            const dictionary& of =
                pairs.found(key) ? userEntry::subDict(pairs, key) : dict;

            const pureGas::part vapour{liquids.liquid(j).name(), W(j), 1};
            if (i == n)
            {
                D_.set
                (
                    n*n + j,
                    binaryDiffusivity::New(of, vapour, carrier_->parts()).ptr()
                );
                continue;
            }
            if (&of == &dict && !dict.found("type"))
            {
                FatalIOErrorInFunction(dict)
                    << "No diffusivity of " << key << " in "
                    << dict.dictName() << nl << "Give pairs { " << key
                    << " { D0 ...; Tref ...; pRef ...; } }, or type Fuller"
                    << exit(FatalIOError);
            }
            const pureGas::part other{liquids.liquid(i).name(), W(i), 1};
            D_.set(i*n + j, binaryDiffusivity::New(of, vapour, other).ptr());
        }
    }

    factors_.setSize(D_.size(), -1);
    forAll(D_, ij)
    {
        if (D_.set(ij))
        {
            factors_[ij] = D_[ij].factor();
        }
    }
}


void Foam::dew::gasMixtures::idealGasMixture::mixture
(
    const UList<scalar>& Y
) const
{
    const scalar mean = W(Y);
    const label n = size();

    x_[n] = 1;
    for (label i = 0; i < n; i++)
    {
        x_[i] = Y[i]*mean/W(i);
        x_[n] -= x_[i];
    }
}


void Foam::dew::gasMixtures::idealGasMixture::prepare
(
    const scalar T,
    const UList<scalar>& Y
) const
{
    mixture(Y);
    forAll(vapours_, i)
    {
        mu_[i] = vapours_[i].mu(T);
    }
    mu_[size()] = carrier_->mu(T);
}


Foam::scalar Foam::dew::gasMixtures::idealGasMixture::mixed
(
    const label i,
    const scalar p,
    const scalar T,
    const scalar Tn
) const
{
    constexpr scalar trace = 1e-12;
    const label n = size();

    scalar others = x_[n] + trace, resistance = others/D(n, i, p, T, Tn);
    for (label j = 0; j < n; j++)
    {
        if (j != i)
        {
            const scalar x = x_[j] + trace;
            others += x;
            resistance += x/D(max(i, j), min(i, j), p, T, Tn);
        }
    }
    return others/resistance;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::gasMixtures::idealGasMixture::idealGasMixture
(
    const dictionary& dict,
    const liquidMixture& liquids,
    autoPtr<pureGas> carrier
)
:
    gasMixture
    (
        userEntry::positive(dict, "p0", dimPressure), liquids, carrier->W()
    ),
    carrier_(std::move(carrier)),
    x_(size() + 1),
    mu_(size() + 1),
    kappa_(size() + 1)
{
    userEntry::onlyThese
    (
        dict, {"type", "p0", "carrier", "vapour", "vapours", "diffusivity"}
    );
    readVapours(dict, liquids);
    readDiffusivities(userEntry::subDict(dict, "diffusivity"), liquids);

    scalarField masses(size() + 1, Wc());
    for (label i = 0; i < size(); i++)
    {
        masses[i] = W(i);
    }
    rule_.reset(new Wilke(masses));
}


Foam::dew::gasMixtures::idealGasMixture::idealGasMixture
(
    const dictionary& dict,
    const liquidMixture& liquids
)
:
    idealGasMixture
    (
        dict,
        liquids,
        pureGas::New(userEntry::subDict(dict, "carrier"), liquids.liquid(0))
    )
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::gasMixtures::idealGasMixture::rho
(
    const scalar p,
    const scalar T,
    const UList<scalar>& Y
) const
{
    return p*W(Y)/(gasConstant*T);
}


Foam::scalar Foam::dew::gasMixtures::idealGasMixture::Dc
(
    const label i,
    const scalar p,
    const scalar T
) const
{
    return D_[size()*size() + i].D(p, T);
}


Foam::scalar Foam::dew::gasMixtures::idealGasMixture::DY
(
    const label i,
    const scalar p,
    const scalar T,
    const UList<scalar>& Y
) const
{
    if (size() == 1)
    {
        return Dc(0, p, T);
    }
    mixture(Y);
    return mixed(i, p, T, std::pow(T, 1.75));
}


void Foam::dew::gasMixtures::idealGasMixture::DY
(
    const scalar p,
    const scalar T,
    const UList<scalar>& Y,
    UList<scalar>& result
) const
{
    mixture(Y);
    const scalar Tn = std::pow(T, 1.75);
    forAll(vapours_, i)
    {
        result[i] = mixed(i, p, T, Tn);
    }
}


Foam::scalar Foam::dew::gasMixtures::idealGasMixture::Dx
(
    const label i,
    const scalar p,
    const scalar T,
    const UList<scalar>& Y
) const
{
    // (1 - Y_i)/(1 - x_i) is the ratio of the molar mass of the others to that
    // of the mixture
    const scalar mean = W(Y);
    const scalar xi = Y[i]*mean/W(i);
    const scalar ratio =
        1 - xi > 1e-9 ? (1 - Y[i])/(1 - xi) : Wc()/mean;
    return ratio*DY(i, p, T, Y);
}


Foam::scalar Foam::dew::gasMixtures::idealGasMixture::Cp
(
    const scalar T,
    const UList<scalar>& Y
) const
{
    scalar sum = 0, Yc = 1;
    forAll(vapours_, i)
    {
        sum += Y[i]*vapours_[i].Cp(T);
        Yc -= Y[i];
    }
    return sum + Yc*carrier_->Cp(T);
}


Foam::scalar Foam::dew::gasMixtures::idealGasMixture::kappa
(
    const scalar T,
    const UList<scalar>& Y
) const
{
    prepare(T, Y);
    forAll(vapours_, i)
    {
        kappa_[i] = vapours_[i].kappa(T);
    }
    kappa_[size()] = carrier_->kappa(T);
    return rule_->mean(x_, mu_, kappa_);
}


Foam::scalar Foam::dew::gasMixtures::idealGasMixture::mu
(
    const scalar T,
    const UList<scalar>& Y
) const
{
    prepare(T, Y);
    return rule_->mean(x_, mu_, mu_);
}
