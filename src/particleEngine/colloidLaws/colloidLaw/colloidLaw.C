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


//- Refuse a sub-dictionary that would not be read
void checkName
(
    const dictionary& dict,
    const word& key,
    const wordList& names,
    const dew::entriesOf entries
)
{
    const auto dot = key.find('.');
    const bool pair = dot != word::npos;
    const word one(key.substr(0, dot));
    const word other(pair ? key.substr(dot + 1) : "");
    const bool pairs = entries == dew::entriesOf::pairs;

    std::string wrong;
    if (!names.found(one) || (pair && !names.found(other)))
    {
        wrong = " names no material and no pair of materials";
    }
    else if (pair != pairs)
    {
        wrong =
            pairs
          ? " names a material, but these entries belong to a pair"
          : " names a pair, but these entries belong to a material";
    }
    else if (pair && one != other && dict.found(other + '.' + one))
    {
        wrong = " is of the same pair as '" + other + '.' + one + "'";
    }

    if (!wrong.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Sub-dictionary '" << key << "' of " << dict.dictName()
            << wrong.c_str() << nl << "Give one "
            << (pairs ? "material.material a pair" : "a material")
            << ", of the materials " << flatOutput(names)
            << exit(FatalIOError);
    }
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
    const materials& mats,
    const entriesOf entries
)
:
    cutOff_(medium.cutOff()),
    n_(mats.size())
{
    for (const entry& e : dict)
    {
        if (e.isDict())
        {
            checkName(dict, e.keyword(), mats.names(), entries);
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
        wordList known;
        for (const HamakerMedium& medium : HamakerMedium::media())
        {
            known.append(medium.name);
        }
        FatalIOErrorInFunction(dict)
            << "Entry 'media' in " << dict.dictName() << " is "
            << flatOutput(names) << nl
            << "It takes three: one body, the liquid, the other body, of "
            << flatOutput(known) << "; for others give hamaker"
            << exit(FatalIOError);
    }
    return HamakerConstant(*m[0], *m[2], *m[1], medium.T());
}


Foam::scalar Foam::dew::colloidLaw::attraction
(
    const dictionary& dict,
    const colloidMedium& medium
)
{
    const scalar A = hamaker(dict, medium);
    if (A <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "The Hamaker constant of " << dict.dictName() << " is " << A
            << " J, but atoms that repel each other near contact attract each"
            << " other further off" << nl
            << "Give 'hamaker' above 0, 1e-21 to 1e-19 J is usual"
            << exit(FatalIOError);
    }
    return A;
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
