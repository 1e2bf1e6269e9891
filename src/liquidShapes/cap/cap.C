/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "cap.H"
#include "addToRunTimeSelectionTable.H"
#include "ballInPiece.H"
#include "mathematicalConstants.H"
#include "unitConversion.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace liquidShapes
{
    defineTypeName(cap);
    addToRunTimeSelectionTable(liquidShape, cap, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //
Foam::dew::liquidShapes::cap::cap
(
    const Time&,
    const meshSymmetry& symmetry,
    const dictionary& dict
)
:
    liquidShape(symmetry),
    cap_(read(dict))
{
    checkAxis(dict, onAxis(cap_.base(), cap_.normal()));
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dew::sphericalCap Foam::dew::liquidShapes::cap::read
(
    const dictionary& dict
)
{
    onlyThese
    (
        dict, {"base", "normal", "contactRadius", "volume", "contactAngle"}
    );
    const point base(userEntry::point(dict, "base", dimLength));
    const vector normal(normalised(userEntry::direction(dict, "normal")));
    const scalar theta
    (
        degToRad(userEntry::within(dict, "contactAngle", 1e-3, 180 - 1e-3))
    );
    if (dict.found("contactRadius") == dict.found("volume"))
    {
        FatalIOErrorInFunction(dict)
            << "Give contactRadius or volume in " << dict.dictName()
            << ", one of them" << exit(FatalIOError);
    }
    return sphericalCap
    (
        base,
        normal,
        dict.found("volume")
      ? sphericalCap::contactRadius
        (
            userEntry::positive(dict, "volume", dimVolume), theta
        )
      : userEntry::positive(dict, "contactRadius", dimLength),
        theta
    );
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::liquidShapes::cap::depth(const point& x) const
{
    return min(cap_.psi(x), (x - cap_.base()) & cap_.normal());
}


Foam::scalar Foam::dew::liquidShapes::cap::volumeIn
(
    const convexPiece& piece
) const
{
    convexPiece below, above;
    piece.split(cap_.base(), cap_.normal(), below, above);
    if (above.empty())
    {
        return 0;
    }
    return
        symmetry_.wedge()
      ? smoothVolume
        (
            above, [&](const point& x) { return cap_.psi(x); }, Zero,
            cap_.radius()
        )
      : ballInPiece(above, cap_.centre(), cap_.radius());
}


Foam::scalar Foam::dew::liquidShapes::cap::volume() const
{
    return cap_.volume();
}


Foam::scalar Foam::dew::liquidShapes::cap::volume(const boundBox& b) const
{
    // Room across as for the ball, along the normal from the base to the apex
    const vector& n = cap_.normal();
    const point apex(cap_.base() + cap_.height()*n);
    const scalar little = 1e-10*cap_.radius();
    const scalar reach =
        cap_.depth() < 0 ? cap_.radius() : cap_.contactRadius();
    boundBox room(b);
    vector half(reach*vector::one);
    bool along = false;
    for (direction i = 0; i < 3; i++)
    {
        if (mag(n[i]) > 1 - 1e-12)
        {
            along =
                min(cap_.base()[i], apex[i]) >= b.min()[i] - little
             && max(cap_.base()[i], apex[i]) <= b.max()[i] + little;
            room.min()[i] = -GREAT;
            room.max()[i] = GREAT;
            half[i] = 0;
        }
    }
    const scalar share =
        along ? shareInBox(room, cap_.base(), half) : -1;
    return share > 0 ? share*volume() : -1;
}
