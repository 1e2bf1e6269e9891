/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "liquidMixture.H"
#include "IOdictionary.H"
#include "speciesPairs.H"
#include "Time.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- A family's dictionary, or its standard variant
dictionary withType
(
    const dictionary& dict,
    const word& key,
    const word& standard
)
{
    dictionary of(dew::userEntry::optionalDict(dict, key));
    of.name() = dict.name() + '.' + key;
    if (!of.found("type"))
    {
        of.add("type", standard);
    }
    return of;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::liquidMixture::readLiquids(const dictionary& dict)
{
    const dictionary& all = userEntry::subDict(dict, "liquids");
    if (all.empty())
    {
        FatalIOErrorInFunction(dict)
            << "No liquids in " << all.dictName() << nl
            << "Give, e.g., liquids { water { type library; } }"
            << exit(FatalIOError);
    }
    names_ = all.toc();
    liquids_.setSize(names_.size());
    forAll(names_, i)
    {
        dictionary of(userEntry::subDict(all, names_[i]));
        const word key
        (
            of.getOrDefault<word>("type", "") == "library" ? "liquid" : "name"
        );
        if (!of.found(key))
        {
            of.add(key, names_[i]);
        }
        liquids_.set(i, liquidModel::New(of).ptr());
    }
}


void Foam::dew::liquidMixture::readPairs
(
    const dictionary& dict,
    List<scalarList>& coefficients
) const
{
    speciesPairs::onlyThese(dict, names_, {});

    const label n = size();
    coefficients.setSize(n*n);
    for (label i = 0; i < n; i++)
    {
        for (label j = i + 1; j < n; j++)
        {
            bool swapped = false;
            const word key
            (
                speciesPairs::key(dict, names_[i], names_[j], swapped)
            );
            if (dict.found(key))
            {
                scalarList& c = coefficients[i*n + j];
                dict.readEntry(key, c);
                for (label k = 1; k < c.size() && swapped; k += 2)
                {
                    c[k] *= -1;
                }
            }
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::liquidMixture::liquidMixture(const dictionary& dict)
:
    equilibrium_(dict.subOrEmptyDict("equilibrium"))
{
    if (dict.found("type"))
    {
        // One liquid
        dictionary only(dict);
        only.remove("equilibrium");
        liquids_.setSize(1);
        liquids_.set(0, liquidModel::New(only).ptr());
        names_ = wordList(1, liquids_[0].name());
    }
    else
    {
        userEntry::onlyThese
        (
            dict,
            {
                "FoamFile", "liquids", "surfaceTension", "diffusivity",
                "viscosity", "excessVolume", "equilibrium"
            }
        );
        readLiquids(dict);
    }

    W_.setSize(names_.size());
    forAll(W_, i)
    {
        W_[i] = liquids_[i].W();
    }
    work_.setSize(2*size());

    const dictionary none;
    const dictionary& more = dict.found("type") ? none : dict;
    readPairs(userEntry::optionalDict(more, "viscosity"), G_);
    readPairs(userEntry::optionalDict(more, "excessVolume"), a_);
    surfaceTension_ = mixtureSurfaceTension::New
    (
        withType(more, "surfaceTension", "ideal"), names_, liquids_
    );
    diffusivity_ = liquidDiffusivity::New
    (
        withType(more, "diffusivity", "WilkeChang"), liquids_
    );
}


Foam::autoPtr<Foam::dew::liquidMixture> Foam::dew::liquidMixture::New
(
    const objectRegistry& registry
)
{
    return autoPtr<liquidMixture>
    (
        new liquidMixture
        (
            IOdictionary
            (
                IOobject
                (
                    "liquidProperties",
                    registry.time().constant(),
                    registry,
                    IOobject::MUST_READ,
                    IOobject::NO_WRITE,
                    false
                )
            )
        )
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::dew::liquidMixture::index(const word& name) const
{
    const label i = names_.find(name);
    if (i < 0)
    {
        FatalErrorInFunction
            << "No liquid " << name << nl << "The liquids are " << names_
            << exit(FatalError);
    }
    return i;
}


Foam::scalar Foam::dew::liquidMixture::Tmin() const
{
    scalar T = 0;
    for (const liquidModel& l : liquids_)
    {
        T = max(T, l.Tmin());
    }
    return T;
}


Foam::scalar Foam::dew::liquidMixture::Tmax() const
{
    scalar T = GREAT;
    for (const liquidModel& l : liquids_)
    {
        T = min(T, l.Tmax());
    }
    return T;
}
