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
    const bool temperature,
    const bool surface
)
:
    model_(modelNames.getOrDefault("model", dict, models::A)),
    needsTemperature_(false),
    needsSurface_(false),
    brownian_(false)
{
    const dictionary& laws = userEntry::subDict(dict, "forces");
    laws_.setSize(laws.size());

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

        add(laws_[n - 1], laws.subDict(e.keyword()), temperature, surface);
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
    const bool temperature,
    const bool surface
)
{
    const bool brownian = isA<particleForces::Brownian>(law);

    if ((brownian && brownian_) || (law.needsSurface() && needsSurface_))
    {
        FatalIOErrorInFunction(dict)
            << "A second law " << law.type() << ": " << dict.name() << nl
            << "Remove one of the two" << exit(FatalIOError);
    }
    if (law.needsTemperature() && !temperature)
    {
        FatalIOErrorInFunction(dict)
            << "Law " << law.type() << " needs a temperature, and the fluid has"
            << " none: " << dict.name() << nl
            << "Add the entry 'T', e.g. T 298.15; or a field T to the start"
            << " time" << exit(FatalIOError);
    }
    if (law.needsSurface() && !surface)
    {
        FatalIOErrorInFunction(dict)
            << "Law " << law.type() << " needs a solver with a liquid surface: "
            << dict.name() << nl
            << "Use a solver of drops, or remove the law" << exit(FatalIOError);
    }

    brownian_ = brownian_ || brownian;
    needsTemperature_ = needsTemperature_ || law.needsTemperature();
    needsSurface_ = needsSurface_ || law.needsSurface();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::particleForceList::sum Foam::dew::particleForceList::total
(
    const particle& p,
    const carrier& c
) const
{
    sum result;

    for (const particleForce& law : laws_)
    {
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
        }
        else
        {
            result.Sn += f.Su + f.Sp*(c.U - p.U);
        }
        result.kT += f.kT;
        result.surfaceK += f.surfaceK;
    }

    return result;
}
