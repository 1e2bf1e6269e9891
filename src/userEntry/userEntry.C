/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "userEntry.H"
#include "ITstream.H"
#include "hashedWordList.H"

#include <cmath>

namespace Foam
{
namespace dew
{
namespace userEntry
{

//- The value behind optional dimensions
template<class Type>
Type value(const dictionary& dict, const word& key, const dimensionSet& dims)
{
    const entry* found = dict.findEntry(key, keyType::LITERAL);

    if (!found || !found->isStream())
    {
        FatalIOErrorInFunction(dict)
            << "Missing entry '" << key << "' in " << dict.dictName() << nl
            << "Add: " << key << "  <value in SI>;  of dimensions " << dims
            << exit(FatalIOError);
    }

    ITstream& is = found->stream();

    // "key key [dims] value" is the old way to write a dimensioned entry
    is.rewind();
    token first(is);
    if (!first.isWord() || first.wordToken() != key)
    {
        is.putBack(first);
    }

    token open(is);
    is.putBack(open);
    if (open == token::BEGIN_SQR)
    {
        dimensionSet given(dimless);
        scalar multiplier = 1;
        given.read(is, multiplier);

        if (given != dims)
        {
            FatalIOErrorInFunction(dict)
                << "Wrong dimensions of '" << key << "' in "
                << dict.dictName() << ": " << given << nl
                << "Expected: " << dims
                << exit(FatalIOError);
        }
    }

    token look(is);
    is.putBack(look);
    if (pTraits<Type>::nComponents == 1 && !look.isNumber())
    {
        FatalIOErrorInFunction(dict)
            << "Not a number in '" << key << "' of " << dict.dictName()
            << ": " << look << nl
            << "Give a value in SI"
            << exit(FatalIOError);
    }

    Type result;
    is >> result;

    if (is.nRemainingTokens())
    {
        is.rewind();
        FatalIOErrorInFunction(dict)
            << "More than one value in '" << key << "' of "
            << dict.dictName() << ':';
        for (const token& t : is)
        {
            FatalIOError<< ' ' << t;
        }
        FatalIOError
            << nl
            << "Give one value in SI, with a decimal point"
            << exit(FatalIOError);
    }

    for (Foam::direction k = 0; k < pTraits<Type>::nComponents; k++)
    {
        if (!std::isfinite(component(result, k)))
        {
            FatalIOErrorInFunction(dict)
                << "Not a finite number in '" << key << "' of "
                << dict.dictName() << ": " << result
                << exit(FatalIOError);
        }
    }

    return result;
}


[[noreturn]] void refuse
(
    const dictionary& dict,
    const word& key,
    const scalar value,
    const char* expected
)
{
    FatalIOErrorInFunction(dict)
        << "Entry '" << key << "' in " << dict.dictName() << " is " << value
        << nl << "It must be " << expected
        << exit(FatalIOError);

    ::abort();      // never reached: exit() ends the run
}

} // End namespace userEntry
} // End namespace dew
} // End namespace Foam


// * * * * * * * * * * * * * * * * Functions  * * * * * * * * * * * * * * * * //

Foam::scalar Foam::dew::userEntry::number
(
    const dictionary& dict,
    const word& key,
    const dimensionSet& dims
)
{
    return value<scalar>(dict, key, dims);
}


Foam::scalar Foam::dew::userEntry::positive
(
    const dictionary& dict,
    const word& key,
    const dimensionSet& dims
)
{
    const scalar x = value<scalar>(dict, key, dims);
    if (!(x > 0))
    {
        refuse(dict, key, x, "greater than zero");
    }
    return x;
}


Foam::scalar Foam::dew::userEntry::notNegative
(
    const dictionary& dict,
    const word& key,
    const dimensionSet& dims
)
{
    const scalar x = value<scalar>(dict, key, dims);
    if (!(x >= 0))
    {
        refuse(dict, key, x, "zero or greater");
    }
    return x;
}


Foam::scalar Foam::dew::userEntry::within
(
    const dictionary& dict,
    const word& key,
    const scalar low,
    const scalar high
)
{
    const scalar x = value<scalar>(dict, key, dimless);
    if (!(x >= low && x <= high))
    {
        const std::string range
        (
            "between " + std::to_string(low) + " and " + std::to_string(high)
        );
        refuse(dict, key, x, range.c_str());
    }
    return x;
}


Foam::vector Foam::dew::userEntry::point
(
    const dictionary& dict,
    const word& key,
    const dimensionSet& dims
)
{
    return value<vector>(dict, key, dims);
}


Foam::vector Foam::dew::userEntry::direction
(
    const dictionary& dict,
    const word& key
)
{
    const vector n(value<vector>(dict, key, dimless));
    if (!(mag(n) > 0))
    {
        refuse(dict, key, mag(n), "a vector of length greater than zero");
    }
    return n/mag(n);
}


Foam::label Foam::dew::userEntry::count
(
    const dictionary& dict,
    const word& key
)
{
    const scalar x = positive(dict, key, dimless);
    if (x > 2e9 || x != std::floor(x))
    {
        refuse(dict, key, x, "a whole number from 1 to 2e9");
    }
    return label(x);
}


const Foam::dictionary& Foam::dew::userEntry::dictOf
(
    const dictionary& parent,
    const entry& e
)
{
    if (!e.isDict())
    {
        FatalIOErrorInFunction(parent)
            << "Entry '" << e.keyword() << "' in " << parent.dictName()
            << " is not a dictionary" << nl
            << "Write: " << e.keyword() << " { ... }"
            << exit(FatalIOError);
    }
    return e.dict();
}


const Foam::dictionary& Foam::dew::userEntry::subDict
(
    const dictionary& dict,
    const word& key
)
{
    const entry* e = dict.findEntry(key, keyType::LITERAL);
    if (!e)
    {
        FatalIOErrorInFunction(dict)
            << "Missing sub-dictionary '" << key << "' in "
            << dict.dictName() << nl << "Add: " << key << " { ... }"
            << exit(FatalIOError);
    }
    return dictOf(dict, *e);
}


const Foam::dictionary& Foam::dew::userEntry::optionalDict
(
    const dictionary& dict,
    const word& key
)
{
    const entry* e = dict.findEntry(key, keyType::LITERAL);
    return e ? dictOf(dict, *e) : dictionary::null;
}


Foam::scalar Foam::dew::userEntry::positiveOr
(
    const dictionary& dict,
    const word& key,
    const dimensionSet& dims,
    const scalar deflt
)
{
    return dict.found(key) ? positive(dict, key, dims) : deflt;
}


Foam::scalar Foam::dew::userEntry::notNegativeOr
(
    const dictionary& dict,
    const word& key,
    const dimensionSet& dims,
    const scalar deflt
)
{
    return dict.found(key) ? notNegative(dict, key, dims) : deflt;
}


Foam::vector Foam::dew::userEntry::pointOr
(
    const dictionary& dict,
    const word& key,
    const dimensionSet& dims,
    const vector& deflt
)
{
    return dict.found(key) ? point(dict, key, dims) : deflt;
}


void Foam::dew::userEntry::onlyThese
(
    const dictionary& dict,
    const wordList& known
)
{
    const hashedWordList valid(known);

    for (const entry& e : dict)
    {
        if (!e.keyword().isPattern() && !valid.found(e.keyword()))
        {
            FatalIOErrorInFunction(dict)
                << "Unknown entry '" << e.keyword() << "' in "
                << dict.dictName() << nl
                << "Valid entries: " << flatOutput(known)
                << exit(FatalIOError);
        }
    }
}
