/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "colloidLaw.H"
#include "HamakerConstant.H"
#include "selectVariant.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(colloidLaw);
    defineRunTimeSelectionTable(colloidLaw, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- The entries of a dictionary without its sub-dictionaries, and with those of
//  one of them where it is found
dictionary merged(const dictionary& dict, const wordList& parts)
{
    dictionary result(fileName(dict.name()));
    for (const entry& e : dict)
    {
        if (!e.isDict())
        {
            result.add(e);
        }
    }
    for (const word& part : parts)
    {
        const dictionary* found = dict.findDict(part, keyType::LITERAL);
        if (found)
        {
            for (const entry& e : *found)
            {
                // One of two ways to say the same replaces the other
                for (const auto& two : {"hamaker media", "zeta charge"})
                {
                    const std::string names(two);
                    const auto gap = names.find(' ');
                    const word one(names.substr(0, gap));
                    const word other(names.substr(gap + 1));
                    if (e.keyword() == one || e.keyword() == other)
                    {
                        result.remove(one);
                        result.remove(other);
                    }
                }
            }
            result.merge(*found);
            result.name() = found->name();
            break;
        }
    }
    return result;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::colloidLaw> Foam::dew::colloidLaw::New
(
    const dictionary& dict,
    const colloidMedium& medium,
    const materials& mats
)
{
    return selectVariant<colloidLaw>(dict, "type", "colloid law")
    (
        dict, medium, mats
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::colloidLaw::colloidLaw
(
    const dictionary& dict,
    const colloidMedium& medium,
    const materials& mats
)
:
    cutOff_(medium.cutOff()),
    n_(mats.size())
{
    for (const entry& e : dict)
    {
        const word& key = e.keyword();
        const auto dot = key.find('.');
        if
        (
            e.isDict()
         && (
                !mats.names().found(key.substr(0, dot))
             || (
                    dot != word::npos
                 && !mats.names().found(key.substr(dot + 1))
                )
            )
        )
        {
            FatalIOErrorInFunction(dict)
                << "Sub-dictionary '" << key << "' of " << dict.dictName()
                << " names no material and no pair of materials" << nl
                << "Valid names: material or material.material with the"
                << " materials " << flatOutput(mats.names())
                << exit(FatalIOError);
        }
    }
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::dictionary Foam::dew::colloidLaw::ofPair
(
    const dictionary& dict,
    const materials& mats,
    const label i,
    const label j
)
{
    const word& a = mats.names()[i];
    const word& b = mats.names()[j];
    return merged(dict, {a + '.' + b, b + '.' + a});
}


Foam::dictionary Foam::dew::colloidLaw::ofMaterial
(
    const dictionary& dict,
    const materials& mats,
    const label i
)
{
    return merged(dict, {mats.names()[i]});
}


Foam::scalar Foam::dew::colloidLaw::hamaker
(
    const dictionary& dict,
    const colloidMedium& medium
)
{
    if (dict.found("hamaker") == dict.found("media"))
    {
        FatalIOErrorInFunction(dict)
            << "Give one of the entries 'hamaker' [J] and 'media' in "
            << dict.dictName() << nl
            << "media (silica water silica) is both bodies with the liquid"
            << " between them"
            << exit(FatalIOError);
    }
    if (dict.found("hamaker"))
    {
        return userEntry::number(dict, "hamaker", dimEnergy);
    }

    const wordList names(dict.get<wordList>("media"));
    const HamakerMedium* m[3] = {nullptr, nullptr, nullptr};
    for (label k = 0; k < 3 && names.size() == 3; k++)
    {
        m[k] = HamakerMedium::medium(names[k].c_str());
    }
    if (!m[0] || !m[1] || !m[2])
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'media' in " << dict.dictName() << " is "
            << flatOutput(names) << nl
            << "It takes three: one body, the liquid, the other body, of"
            << " vacuum air water octane cyclohexane benzene acetone ethanol"
            << " polystyrene PTFE silica mica alumina; for others give hamaker"
            << exit(FatalIOError);
    }
    return HamakerConstant(*m[0], *m[2], *m[1], medium.T());
}


void Foam::dew::colloidLaw::onlyThese
(
    const dictionary& dict,
    const wordList& known
)
{
    wordList all(known);
    all.append(word("type"));
    userEntry::onlyThese(dict, all);
}
