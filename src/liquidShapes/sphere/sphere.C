/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sphere.H"
#include "addToRunTimeSelectionTable.H"
#include "ballInPiece.H"
#include "mathematicalConstants.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace liquidShapes
{
    defineTypeName(sphere);
    addToRunTimeSelectionTable(liquidShape, sphere, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //
Foam::dew::liquidShapes::sphere::sphere
(
    const Time&,
    const meshSymmetry& symmetry,
    const dictionary& dict
)
:
    liquidShape(symmetry),
    c_(userEntry::point(dict, "centre", dimLength)),
    R_(userEntry::positive(dict, "radius", dimLength))
{
    onlyThese(dict, {"centre", "radius"});
    checkAxis(dict, onAxis(c_, Zero));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::liquidShapes::sphere::depth(const point& x) const
{
    return R_ - mag(x - c_);
}


Foam::scalar Foam::dew::liquidShapes::sphere::volumeIn
(
    const convexPiece& piece
) const
{
    return
        symmetry_.wedge()
      ? smoothVolume
        (
            piece, [&](const point& x) { return depth(x); }, Zero, R_
        )
      : ballInPiece(piece, c_, R_);
}


Foam::scalar Foam::dew::liquidShapes::sphere::volume() const
{
    return 4*constant::mathematical::pi/3*pow3(R_);
}


Foam::scalar Foam::dew::liquidShapes::sphere::volume(const boundBox& b) const
{
    return shareInBox(b, c_, R_*vector::one)*volume();
}
