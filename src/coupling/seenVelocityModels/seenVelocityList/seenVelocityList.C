/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "seenVelocityList.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::seenVelocityList::seenVelocityList
(
    const dictionary& dict,
    const lawNeeds& offered
)
{
    if (!dict.found("seenVelocity"))
    {
        return;
    }
    const dictionary& models = userEntry::subDict(dict, "seenVelocity");
    models_.setSize(models.size());
    memoryStart_.setSize(models.size());

    label n = 0;
    for (const entry& e : models)
    {
        const dictionary& one = userEntry::dictOf(models, e);
        models_.set(n, seenVelocityModel::New(one).ptr());
        memoryStart_[n] = needs_.memory;
        needs_.add(models_[n].needs());
        needs_.refuse(models_[n].type(), one, offered);
        n++;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::seenVelocityList::correct(particle p, carrier& c) const
{
    scalar* const memory = p.memory;

    forAll(models_, k)
    {
        p.memory = memory + memoryStart_[k];
        models_[k].correct(p, c);
    }
}
