/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleForceList.H"
#include "Brownian.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::dew::particleForceList::models>
Foam::dew::particleForceList::modelNames
({
    {models::A, "A"},
    {models::B, "B"}
});


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleForceList::particleForceList
(
    const dictionary& dict,
    const lawNeeds& offered
)
:
    model_(modelNames.getOrDefault("model", dict, models::A)),
    brownian_(false)
{
    const dictionary& laws = userEntry::subDict(dict, "forces");
    laws_.setSize(laws.size());
    memoryStart_.setSize(laws.size(), Zero);

    label n = 0;
    bool pressure = false;
    for (const entry& e : laws)
    {
        laws_.set
        (
            n++,
            particleForce::New(userEntry::dictOf(laws, e)).ptr()
        );
        pressure =
            pressure
         || laws_[n - 1].reaction() == particleForce::reactions::sharedPressure;

        memoryStart_[n - 1] = needs_.memory;
        add(laws_[n - 1], laws.subDict(e.keyword()), offered);
    }

    if (model_ == models::A && n > 0 && !pressure)
    {
        Info<< "WARNING: model A without pressureGradientForce in "
            << laws.name() << ": nobody carries the particles' share of the"
            << " pressure gradient, and they have no buoyancy" << nl << endl;
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::particleForceList::add
(
    const particleForce& law,
    const dictionary& dict,
    const lawNeeds& offered
)
{
    const lawNeeds needs(law.needs());
    const bool brownian = isA<particleForces::Brownian>(law);

    if ((brownian && brownian_) || (needs.surface && needs_.surface))
    {
        FatalIOErrorInFunction(dict)
            << "A second law " << law.type() << ": " << dict.name() << nl
            << "Remove one of the two" << exit(FatalIOError);
    }
    needs.refuse(law.type(), dict, offered);

    brownian_ = brownian_ || brownian;
    needs_.add(needs);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::particleForceList::sum Foam::dew::particleForceList::total
(
    particle p,
    const carrier& c
) const
{
    sum result;
    scalar* const memory = p.memory;

    forAll(laws_, k)
    {
        const particleForce& law = laws_[k];
        p.memory = memory + memoryStart_[k];
        const forceSuSp f(law.force(p, c));

        if (law.reaction() == particleForce::reactions::fluid)
        {
            const particleForce::conventions written = law.convention();
            const scalar factor =
                model_ == models::B && written == particleForce::conventions::A
              ? 1/c.alphac
              : model_ == models::A && written == particleForce::conventions::B
              ? c.alphac
              : 1;

            result.Su += factor*f.Su;
            result.Sp += factor*f.Sp;
            result.addedMass += f.addedMass;
        }
        else
        {
            result.Sn += f.Su + f.Sp*(c.U - p.U);
        }
        result.kT += f.kT;
        result.surfaceK += f.surfaceK;
        result.Tu += f.Tu;
        result.Tp += f.Tp;
    }

    return result;
}
