/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "cylinder.H"
#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace liquidShapes
{
    defineTypeName(cylinder);
    addToRunTimeSelectionTable(liquidShape, cylinder, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //
Foam::dew::liquidShapes::cylinder::cylinder
(
    const Time&,
    const meshSymmetry& symmetry,
    const dictionary& dict
)
:
    liquidShape(symmetry),
    c_(userEntry::point(dict, "centre", dimLength)),
    axis_(normalised(userEntry::direction(dict, "axis"))),
    R_(userEntry::positive(dict, "radius", dimLength)),
    half_
    (
        dict.found("length")
      ? 0.5*userEntry::positive(dict, "length", dimLength)
      : GREAT
    )
{
    onlyThese(dict, {"centre", "axis", "radius", "length"});
    checkAxis(dict, onAxis(c_, axis_));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::liquidShapes::cylinder::depth(const point& x) const
{
    return min(R_ - fromAxis(x), half_ - mag((x - c_) & axis_));
}


Foam::scalar Foam::dew::liquidShapes::cylinder::volumeIn
(
    const convexPiece& piece
) const
{
    convexPiece held(piece);
    if (half_ < GREAT)
    {
        convexPiece below, above, rest;
        piece.split(c_ + half_*axis_, axis_, below, rest);
        below.split(c_ - half_*axis_, axis_, rest, held);
    }
    return
        held.empty()
      ? 0
      : smoothVolume
        (
            held, [&](const point& x) { return R_ - fromAxis(x); }, axis_, R_
        );
}


Foam::scalar Foam::dew::liquidShapes::cylinder::volume() const
{
    return
        half_ < GREAT ? 2*half_*constant::mathematical::pi*sqr(R_) : -1;
}


Foam::scalar Foam::dew::liquidShapes::cylinder::volume(const boundBox& b) const
{
    for (direction i = 0; i < 3; i++)
    {
        if (mag(axis_[i]) > 1 - 1e-12)
        {
            const scalar length =
                min(c_[i] + half_, b.max()[i]) - max(c_[i] - half_, b.min()[i]);

            // Room across
            boundBox room(b);
            room.min()[i] = -GREAT;
            room.max()[i] = GREAT;
            vector half(R_*vector::one);
            half[i] = 0;
            const scalar share = shareInBox(room, c_, half);

            return
                share > 0
              ? share*max(length, scalar(0))*constant::mathematical::pi*sqr(R_)
              : -1;
        }
    }
    return -1;
}
