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

        checkBeside(n - 1, laws_[n - 1], laws.subDict(e.keyword()));
        add(laws_[n - 1], laws.subDict(e.keyword()), temperature, surface);
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
    for (label i = 0; i < n; i++)
    {
        const particleForce& other = laws_[i];
        const bool drags = isA<dragModel>(law) && isA<dragModel>(other);

        if
        (
            drags || law.type() == other.type()
         || (law.needsSurface() && other.needsSurface())
        )
        {
            FatalIOErrorInFunction(dict)
                << "A second " << (drags ? "drag law " : "law ") << law.type()
                << " beside " << other.type() << ", whose forces would add: "
                << dict.name() << nl << "Remove one of the two"
                << exit(FatalIOError);
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
    const bool temperature,
    const bool surface
)
{
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

    brownian_ = brownian_ || isA<particleForces::Brownian>(law);
    needsTemperature_ = needsTemperature_ || law.needsTemperature();
    needsSurface_ = needsSurface_ || law.needsSurface();
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
