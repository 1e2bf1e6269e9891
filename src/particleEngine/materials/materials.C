/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "materials.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::materials::materials
(
    const dictionary& materialsDict,
    const dictionary& contactsDict,
    const bool heat
)
:
    names_(materialsDict.toc()),
    E_(names_.size()),
    nu_(names_.size()),
    rho_(names_.size()),
    k_(names_.size(), Zero),
    cp_(names_.size(), Zero),
    contacts_(contactsDict)
{
    static const dimensionSet dimCp(dimEnergy/dimMass/dimTemperature);
    static const dimensionSet dimK(dimPower/dimLength/dimTemperature);

    for (const entry& e : contacts_)
    {
        // A pair's name is material.material
        const word& key = e.keyword();
        const auto dot = key.find('.');

        if
        (
            e.isDict() && key != "default"
         && (
                dot == word::npos
             || !names_.found(key.substr(0, dot))
             || !names_.found(key.substr(dot + 1))
            )
        )
        {
            FatalIOErrorInFunction(contacts_)
                << "Sub-dictionary '" << key << "' of " << contacts_.dictName()
                << " names no pair of materials" << nl
                << "Valid names: default, and material.material with the"
                << " materials " << flatOutput(names_)
                << exit(FatalIOError);
        }
    }

    if (names_.empty())
    {
        FatalIOErrorInFunction(materialsDict)
            << "No material in " << materialsDict.dictName() << nl
            << "Give at least one sub-dictionary with youngsModulus,"
            << " poissonsRatio and density"
            << exit(FatalIOError);
    }

    forAll(names_, i)
    {
        const dictionary& dict = userEntry::subDict(materialsDict, names_[i]);

        userEntry::onlyThese
        (
            dict,
            {
                "youngsModulus", "poissonsRatio", "density",
                "thermalConductivity", "heatCapacity"
            }
        );

        E_[i] = userEntry::positive(dict, "youngsModulus", dimPressure);
        nu_[i] = userEntry::within(dict, "poissonsRatio", 0, 0.5);
        rho_[i] = userEntry::positive(dict, "density", dimDensity);

        if (heat)
        {
            k_[i] = userEntry::notNegative(dict, "thermalConductivity", dimK);
            cp_[i] = userEntry::positive(dict, "heatCapacity", dimCp);
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::dictionary& Foam::dew::materials::pairDict
(
    const label i,
    const label j
) const
{
    const word ij(names_[i] + '.' + names_[j]);
    const word ji(names_[j] + '.' + names_[i]);

    for (const word& key : {ij, ji, word("default")})
    {
        const dictionary* dict = contacts_.findDict(key, keyType::LITERAL);
        if (dict)
        {
            return *dict;
        }
    }

    FatalIOErrorInFunction(contacts_)
        << "No contact coefficients for the pair " << ij << nl
        << "Add a sub-dictionary " << ij << " { restitution ...; friction"
        << " ...; } or default { ... } to " << contacts_.dictName()
        << exit(FatalIOError);

    return contacts_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::label Foam::dew::materials::index
(
    const dictionary& dict,
    const word& key
) const
{
    const word name(dict.get<word>(key));
    const label i = names_.find(name);

    if (i < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Unknown material " << name << " in entry '" << key << "' of "
            << dict.dictName() << nl
            << "Known materials: " << flatOutput(names_)
            << exit(FatalIOError);
    }

    return i;
}


Foam::scalar Foam::dew::materials::effectiveModulus
(
    const label i,
    const label j
) const
{
    return 1/((1 - sqr(nu_[i]))/E_[i] + (1 - sqr(nu_[j]))/E_[j]);
}


Foam::scalar Foam::dew::materials::pair
(
    const word& key,
    const dimensionSet& dims,
    const label i,
    const label j,
    const scalar above,
    const scalar high
) const
{
    const dictionary& dict = pairDict(i, j);
    const scalar value = userEntry::notNegative(dict, key, dims);

    if (!(value > above) || value > high)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << key << "' in " << dict.dictName() << " is "
            << value << nl << "It must be greater than " << above;
        if (high < GREAT)
        {
            FatalIOError<< " and not exceed " << high;
        }
        FatalIOError<< exit(FatalIOError);
    }

    return value;
}
