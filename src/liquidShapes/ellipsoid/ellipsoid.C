/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "ellipsoid.H"
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
    defineTypeName(ellipsoid);
    addToRunTimeSelectionTable(liquidShape, ellipsoid, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //
Foam::dew::liquidShapes::ellipsoid::ellipsoid
(
    const Time&,
    const meshSymmetry& symmetry,
    const dictionary& dict
)
:
    liquidShape(symmetry),
    c_(userEntry::point(dict, "centre", dimLength)),
    semi_(userEntry::point(dict, "semiAxes", dimLength)),
    e_{vector(1, 0, 0), vector(0, 1, 0), vector(0, 0, 1)}
{
    onlyThese(dict, {"centre", "semiAxes", "e1", "e2"});
    if (cmptMin(semi_) <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "semiAxes " << semi_ << " m in " << dict.dictName()
            << " must be above zero" << exit(FatalIOError);
    }
    if (dict.found("e1") || dict.found("e2"))
    {
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

    // The axis of the wedge must be one of these, the two others equal
    bool round = false;
    for (direction i = 0; i < 3; i++)
    {
        const scalar a = semi_[(i + 1) % 3], b = semi_[(i + 2) % 3];
        round = round || (onAxis(c_, e_[i]) && mag(a - b) <= 1e-10*a);
    }
    checkAxis(dict, round || !symmetry.wedge());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::liquidShapes::ellipsoid::depth(const point& x) const
{
    const vector d(x - c_);
    const vector y(d & e_[0], d & e_[1], d & e_[2]);
    return cmptMin(semi_)*(1 - mag(cmptDivide(y, semi_)));
}


Foam::scalar Foam::dew::liquidShapes::ellipsoid::volumeIn
(
    const convexPiece& piece
) const
{
    if (symmetry_.wedge())
    {
        return smoothVolume
        (
            piece, [&](const point& x) { return depth(x); }, Zero,
            sqr(cmptMin(semi_))/cmptMax(semi_)
        );
    }

    const point middle(piece.centre());
    const scalar r = piece.radius(middle), d = depth(middle);
    if (mag(d) >= r)
    {
        return d > 0 ? piece.volume() : 0;
    }

    convexPiece stretched;
    DynamicList<point> y;
    for (label facei = 0; facei < piece.nFaces(); facei++)
    {
        y.clear();
        for (const point& x : piece.face(facei))
        {
            const vector d(x - c_);
            y.append
            (
                cmptDivide(vector(d & e_[0], d & e_[1], d & e_[2]), semi_)
            );
        }
        stretched.addFace(y);
    }
    return cmptProduct(semi_)*ballInPiece(stretched, Zero, 1);
}


Foam::scalar Foam::dew::liquidShapes::ellipsoid::volume() const
{
    return 4*constant::mathematical::pi/3*cmptProduct(semi_);
}


Foam::scalar Foam::dew::liquidShapes::ellipsoid::volume(const boundBox& b) const
{
    vector half;
    for (direction i = 0; i < 3; i++)
    {
        const vector reach(e_[0][i], e_[1][i], e_[2][i]);
        half[i] = mag(cmptMultiply(reach, semi_));
    }
    const scalar share = shareInBox(b, c_, half);

    // A plane through the centre halves it, two planes need not quarter it
    return
        share > 0.4 || (share > 0 && mag(e_[0][0]*e_[1][1]*e_[2][2]) > 1 - 1e-10)
      ? share*volume()
      : -1;
}
