/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleForceList.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

const Foam::Enum<Foam::dew::particleForceList::models>
Foam::dew::particleForceList::modelNames
({
    {models::A, "A"},
    {models::B, "B"}
});


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleForceList::particleForceList(const dictionary& dict)
:
    model_(modelNames.getOrDefault("model", dict, models::A))
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
    }

    if (model_ == models::A && n > 0 && !pressure)
    {
        Info<< "WARNING: model A without pressureGradientForce in "
            << laws.name() << ": nobody carries the particles' share of the"
            << " pressure gradient, and they have no buoyancy" << nl << endl;
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
    }

    return result;
}
