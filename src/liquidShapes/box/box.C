/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "box.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace liquidShapes
{
    defineTypeName(box);
    addToRunTimeSelectionTable(liquidShape, box, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //
Foam::dew::liquidShapes::box::box
(
    const Time&,
    const meshSymmetry& symmetry,
    const dictionary& dict
)
:
    liquidShape(symmetry),
    e_{vector(1, 0, 0), vector(0, 1, 0), vector(0, 0, 1)}
{
    onlyThese(dict, {"min", "max", "centre", "span", "e1", "e2"});
    const bool corners = dict.found("min") || dict.found("max");
    if (corners)
    {
        const point low(userEntry::point(dict, "min", dimLength));
        const point high(userEntry::point(dict, "max", dimLength));
        centre_ = 0.5*(low + high);
        half_ = 0.5*(high - low);
    }
    else
    {
        centre_ = userEntry::point(dict, "centre", dimLength);
        half_ = 0.5*userEntry::point(dict, "span", dimLength);
        readFrame(dict);
    }
    if
    (
        cmptMin(half_) <= 0
     || (corners && (dict.found("centre") || dict.found("span")))
    )
    {
        FatalIOErrorInFunction(dict)
            << "The box in " << dict.dictName() << " has edges of "
            << 2*half_ << " m, or is given twice" << nl
            << "Give min and max, with max > min in each direction, or centre"
            << " and a positive span" << exit(FatalIOError);
    }
    checkAxis(dict, !symmetry.wedge());
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::liquidShapes::box::readFrame(const dictionary& dict)
{
    if (!dict.found("e1") && !dict.found("e2"))
    {
        return;
    }
    e_[0] = normalised(userEntry::direction(dict, "e1"));
    e_[1] = normalised(userEntry::direction(dict, "e2"));
    if (mag(e_[0] & e_[1]) > 1e-6)
    {
        FatalIOErrorInFunction(dict)
            << "e1 and e2 in " << dict.dictName()
            << " are not perpendicular" << exit(FatalIOError);
    }
    e_[1] = normalised(e_[1] - (e_[1] & e_[0])*e_[0]);
    e_[2] = e_[0] ^ e_[1];
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::liquidShapes::box::depth(const point& x) const
{
    scalar least = GREAT;
    for (direction i = 0; i < 3; i++)
    {
        least = min(least, half_[i] - mag((x - centre_) & e_[i]));
    }
    return least;
}


Foam::scalar Foam::dew::liquidShapes::box::volumeIn
(
    const convexPiece& piece
) const
{
    convexPiece held(piece), in, out;
    for (label i = 0; i < 6; i++)
    {
        point x;
        vector n;
        bound(i, x, n);
        held.split(x, -n, in, out);
        held = in;
    }
    return held.volume();
}


void Foam::dew::liquidShapes::box::bound
(
    const label i,
    point& x,
    vector& inward
) const
{
    const scalar sign = i % 2 ? 1 : -1;
    inward = -sign*e_[i/2];
    x = centre_ + sign*half_[i/2]*e_[i/2];
}


Foam::scalar Foam::dew::liquidShapes::box::volume() const
{
    return 8*cmptProduct(half_);
}


Foam::scalar Foam::dew::liquidShapes::box::volume(const boundBox& b) const
{
    return volumeIn(convexPiece(b));
}
