/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "plane.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace liquidShapes
{
    defineTypeName(plane);
    addToRunTimeSelectionTable(liquidShape, plane, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //
Foam::dew::liquidShapes::plane::plane
(
    const Time&,
    const meshSymmetry& symmetry,
    const dictionary& dict
)
:
    liquidShape(symmetry),
    x_(userEntry::point(dict, "point", dimLength)),
    n_(normalised(userEntry::direction(dict, "normal")))
{
    onlyThese(dict, {"point", "normal"});
    checkAxis(dict, onAxis(symmetry.origin(), n_));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::liquidShapes::plane::depth(const point& x) const
{
    return (x_ - x) & n_;
}


Foam::scalar Foam::dew::liquidShapes::plane::volumeIn
(
    const convexPiece& piece
) const
{
    convexPiece below, above;
    piece.split(x_, n_, below, above);
    return below.volume();
}


Foam::scalar Foam::dew::liquidShapes::plane::volume() const
{
    return -1;
}


Foam::scalar Foam::dew::liquidShapes::plane::volume(const boundBox& b) const
{
    return symmetry_.wedge() ? -1 : volumeIn(convexPiece(b));
}
