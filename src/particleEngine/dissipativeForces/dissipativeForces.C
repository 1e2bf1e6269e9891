/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "dissipativeForces.H"
#include "colloidConstants.H"
#include "engineText.H"
#include "mathematicalConstants.H"
#include "particleBox.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::dissipativeForces::dissipativeForces
(
    const dictionary& dict,
    const materials& mats,
    const particleBox& box
)
:
    materials_(mats),
    T_(userEntry::notNegative(dict, "temperature", dimTemperature)),
    range_(userEntry::positive(dict, "range", dimLength)),
    exponent_(userEntry::positiveOr(dict, "exponent", dimless, 1)),
    a_(mats.size()*mats.size()),
    gamma_(a_.size())
{
    readPairs(dict);
    check(dict, box);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::dissipativeForces::readPairs(const dictionary& dict)
{
    const auto conservative = [](const dictionary& d)
    {
        return userEntry::notNegative(d, "conservative", dimForce);
    };
    const auto friction = [](const dictionary& d)
    {
        return userEntry::notNegative(d, "friction", dimMass/dimTime);
    };

    wordList known
    ({
        "temperature", "range", "exponent", "conservative", "friction"
    });
    const wordList& names = materials_.names();
    const label n = names.size();
    const scalar a = conservative(dict);
    const scalar gamma = friction(dict);

    for (label i = 0; i < n; i++)
    {
        for (label j = 0; j < n; j++)
        {
            const word ij(names[i] + '.' + names[j]);
            const word ji(names[j] + '.' + names[i]);
            known.append(ij);

            if (i != j && dict.found(ij) && dict.found(ji))
            {
                FatalIOErrorInFunction(dict)
                    << "Sub-dictionaries '" << ij << "' and '" << ji << "' of "
                    << dict.dictName() << " are of the same pair" << nl
                    << "Remove one of them"
                    << exit(FatalIOError);
            }

            const word& key = dict.found(ij) ? ij : ji;
            const label p = n*i + j;
            a_[p] = a;
            gamma_[p] = gamma;
            if (dict.found(key))
            {
                const dictionary& own = userEntry::subDict(dict, key);
                userEntry::onlyThese(own, {"conservative", "friction"});
                a_[p] = own.found("conservative") ? conservative(own) : a;
                gamma_[p] = own.found("friction") ? friction(own) : gamma;
            }
        }
    }

    userEntry::onlyThese(dict, known);
}


void Foam::dew::dissipativeForces::check
(
    const dictionary& dict,
    const particleBox& box
) const
{
    const scalar most = max(gamma_);
    if ((T_ > 0) != (most > 0))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'temperature' in " << dict.dictName() << " is " << T_
            << ", the largest friction " << most << " N s/m: friction and"
            << " noise hold the temperature together" << nl
            << "Give both, or set both to 0 for the conservative force alone"
            << exit(FatalIOError);
    }

    box.refuseRange(dict, "range", range_);
}


template<class Function>
Foam::scalar Foam::dew::dissipativeForces::least
(
    const scalar R,
    const Function& time
) const
{
    const label n = materials_.size();
    const scalar V = 4.0/3.0*constant::mathematical::pi*pow3(R);
    scalar result = GREAT;

    for (label i = 0; i < n; i++)
    {
        for (label j = 0; j < n; j++)
        {
            const scalar mi = V*materials_.density(i);
            const scalar mj = V*materials_.density(j);
            result = min(result, time(n*i + j, mi*mj/(mi + mj)));
        }
    }
    return result;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::dissipativeForces::frictionTime(const scalar R) const
{
    return least
    (
        R,
        [this](const label p, const scalar mu)
        {
            return gamma_[p] > 0 ? mu/gamma_[p] : GREAT;
        }
    );
}


Foam::scalar Foam::dew::dissipativeForces::stiffnessTime(const scalar R) const
{
    return least
    (
        R,
        [this](const label p, const scalar mu)
        {
            return a_[p] > 0 ? 2*sqrt(mu*range_/a_[p]) : GREAT;
        }
    );
}


std::string Foam::dew::dissipativeForces::engineArguments
(
    const engineUnits& units
) const
{
    const scalar energy = units.force()*units.length;
    const scalar perSpeed = units.mass/units.time;

    std::string line
    (
        engineText(range_/units.length) + ' ' + engineText(exponent_) + ' '
      + engineText(colloidConstants::boltzmann*T_/energy)
    );
    forAll(a_, p)
    {
        line +=
            ' ' + engineText(a_[p]/units.force())
          + ' ' + engineText(gamma_[p]/perSpeed);
    }
    return line;
}
