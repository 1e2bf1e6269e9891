/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "liquidShape.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(liquidShape);
    defineRunTimeSelectionTable(liquidShape, dictionary);
}
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dew::liquidShape::smoothVolume
(
    const convexPiece& piece,
    const std::function<scalar(const point&)>& f,
    const vector& along,
    const scalar radius
) const
{
    return sectionIntegral
    (
        [&](const point& x) { return f(inSection(x)); },
        symmetry_.wedge() ? symmetry_.azimuth() : along,
        radius
    ).volume(piece);
}


Foam::scalar Foam::dew::liquidShape::shareInBox
(
    const boundBox& box,
    const point& c,
    const vector& halfSpan
)
{
    const scalar little = 1e-10*cmptMax(halfSpan);
    scalar share = 1;
    for (direction i = 0; i < 3; i++)
    {
        for (const scalar room : {c[i] - box.min()[i], box.max()[i] - c[i]})
        {
            if (mag(room) <= little)
            {
                share *= 0.5;
            }
            else if (room < halfSpan[i] - little)
            {
                return -1;
            }
        }
    }
    return share;
}


bool Foam::dew::liquidShape::onAxis
(
    const point& x,
    const vector& direction
) const
{
    if (!symmetry_.wedge())
    {
        return true;
    }
    const vector d(x - symmetry_.origin());
    return
        mag(d - (d & symmetry_.axis())*symmetry_.axis())
     <= 1e-8*symmetry_.bounds().mag()
     && mag(direction ^ symmetry_.axis()) <= 1e-8*mag(direction);
}


void Foam::dew::liquidShape::checkAxis
(
    const dictionary& dict,
    const bool good
) const
{
    if (!good)
    {
        FatalIOErrorInFunction(dict)
            << "The shape in " << dict.dictName()
            << " is not a body of revolution about the axis of the wedge"
            << " patches" << nl
            << "Put its centre on the line through " << symmetry_.origin()
            << " along " << symmetry_.axis()
            << " and turn it along this line, or use a mesh without wedge"
            << " patches" << exit(FatalIOError);
    }
}


void Foam::dew::liquidShape::onlyThese(const dictionary& dict, wordList known)
{
    known.append(wordList({"type", "action", "outside"}));
    userEntry::onlyThese(dict, known);
}
