/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "speciesPairs.H"
#include "DynamicList.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * * * Functions  * * * * * * * * * * * * * * * * //

Foam::word Foam::dew::speciesPairs::key
(
    const dictionary& dict,
    const word& a,
    const word& b,
    bool& swapped
)
{
    const word forward(a + '-' + b), backward(b + '-' + a);
    swapped = dict.found(backward);
    if (swapped && dict.found(forward))
    {
        FatalIOErrorInFunction(dict)
            << "Both " << forward << " and " << backward << " in "
            << dict.dictName() << nl << "Remove one of them"
            << exit(FatalIOError);
    }
    return swapped ? backward : forward;
}


void Foam::dew::speciesPairs::onlyThese
(
    const dictionary& dict,
    const wordList& species,
    const wordList& others
)
{
    DynamicList<word> known(others);
    for (const word& a : species)
    {
        for (const word& b : species)
        {
            if (a != b)
            {
                known.append(word(a + '-' + b));
            }
        }
    }
    userEntry::onlyThese(dict, wordList(std::move(known)));
}
