/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleForceList.H"
#include "Brownian.H"
#include "dragModel.H"
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
        checkBeside(n - 1, laws_[n - 1], laws.subDict(e.keyword()));
        add(laws_[n - 1], laws.subDict(e.keyword()), offered);
    }

    if (n > 0)
    {
        tellPressure(pressure, laws.name());
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::particleForceList::checkBeside
(
    const label n,
    const particleForce& law,
    const dictionary& dict
) const
{
    // At the surface of the liquid, which a film does not
    const auto holds = [](const particleForce& f)
    {
        return f.needs().surface && !f.film();
    };

    for (label i = 0; i < n; i++)
    {
        const particleForce& other = laws_[i];
        const bool drags = isA<dragModel>(law) && isA<dragModel>(other);

        if
        (
            drags || law.type() == other.type()
         || (holds(law) && holds(other))
        )
        {
            FatalIOErrorInFunction(dict)
                << "A second " << (drags ? "drag law " : "law ") << law.type()
                << " beside " << other.type() << ", whose forces would add: "
                << dict.name() << nl << "Remove one of the two"
                << exit(FatalIOError);
        }
    }

    for (label i = 0; i < n; i++)
    {
        const particleForce& other = laws_[i];
        const auto both = [&](const word& a, const word& b)
        {
            return law.type() == a && other.type() == b;
        };
        if (both("Brownian", "history") || both("history", "Brownian"))
        {
            FatalIOErrorInFunction(dict)
                << "Laws Brownian and history together: the noise is that of"
                << " the drag alone, the friction of the history force would"
                << " have none: " << dict.name() << nl
                << "Remove one of the two" << exit(FatalIOError);
        }
    }

    if (model_ == models::B && !law.inModelB())
    {
        FatalIOErrorInFunction(dict)
            << "Law " << law.type() << " does nothing in model B, where"
            << " particles see no pressure gradient, as it is set: "
            << dict.name() << nl
            << "Remove it, set 'buoyancy on;' in it, or 'model A;'"
            << exit(FatalIOError);
    }
}


void Foam::dew::particleForceList::add
(
    const particleForce& law,
    const dictionary& dict,
    const lawNeeds& offered
)
{
    const lawNeeds needs(law.needs());
    needs.refuse(law.type(), dict, offered);

    if (law.film())
    {
        film_ = *law.film();
    }
    brownian_ = brownian_ || isA<particleForces::Brownian>(law);
    needs_.add(needs);
}


void Foam::dew::particleForceList::tellPressure
(
    const bool pressure,
    const fileName& where
) const
{
    if (model_ == models::A && !pressure)
    {
        Info<< "WARNING: model A without pressureGradientForce in " << where
            << ": nobody carries the particles' share of the"
            << " pressure gradient, and they have no buoyancy" << nl << endl;
    }
    if (model_ == models::B && pressure)
    {
        Info<< "WARNING: model B with pressureGradientForce in " << where
            << ": only its buoyancy acts, the pressure gradient of the flow is"
            << " in the drag" << nl << endl;
    }
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
        // Of one law at most: a second surface is refused
        result.surfaceK += f.surfaceK;
        result.surfaceTension += f.surfaceTension;
        result.contactAngle += f.contactAngle;
        result.planePull += f.planePull;
        result.filmViscosity += f.filmViscosity;
        result.Tu += f.Tu;
        result.Tp += f.Tp;
    }

    return result;
}
