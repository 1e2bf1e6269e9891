/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "wave.H"
#include "addToRunTimeSelectionTable.H"
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
    defineTypeName(wave);
    addToRunTimeSelectionTable(liquidShape, wave, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //
Foam::dew::liquidShapes::wave::wave
(
    const Time&,
    const meshSymmetry& symmetry,
    const dictionary& dict
)
:
    liquidShape(symmetry),
    x_(userEntry::point(dict, "point", dimLength)),
    n_(normalised(userEntry::direction(dict, "normal"))),
    d_(normalised(userEntry::direction(dict, "direction"))),
    k_
    (
        constant::mathematical::twoPi
       /userEntry::positive(dict, "wavelength", dimLength)
    ),
    a_(userEntry::positive(dict, "amplitude", dimLength)),
    phi_
    (
        dict.found("phase")
      ? degToRad(userEntry::number(dict, "phase", dimless))
      : 0
    )
{
    onlyThese
    (
        dict,
        {"point", "normal", "direction", "wavelength", "amplitude", "phase"}
    );
    if (mag(n_ & d_) > 1e-6)
    {
        FatalIOErrorInFunction(dict)
            << "normal and direction in " << dict.dictName()
            << " are not perpendicular" << exit(FatalIOError);
    }
    checkAxis(dict, !symmetry.wedge());
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dew::liquidShapes::wave::above(const point& x) const
{
    const vector r(x - x_);
    return (r & n_) - a_*Foam::cos(k_*(r & d_) + phi_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::liquidShapes::wave::depth(const point& x) const
{
    return -above(x)/Foam::sqrt(1 + sqr(a_*k_));
}


Foam::scalar Foam::dew::liquidShapes::wave::volumeIn
(
    const convexPiece& piece
) const
{
    // Half a wave has two radii of curvature, at least
    return smoothVolume
    (
        piece, [&](const point& x) { return depth(x); }, n_ ^ d_,
        1/max(a_*sqr(k_), 0.3*k_)
    );
}


Foam::scalar Foam::dew::liquidShapes::wave::volume() const
{
    return -1;
}


Foam::scalar Foam::dew::liquidShapes::wave::volume(const boundBox& b) const
{
    direction in = 3, id = 3;
    for (direction i = 0; i < 3; i++)
    {
        in = mag(n_[i]) > 1 - 1e-12 ? i : in;
        id = mag(d_[i]) > 1 - 1e-12 ? i : id;
    }
    if (in == 3 || id == 3)
    {
        return -1;
    }

    // Height of the mean level above the bottom, along the normal
    const scalar room = b.span()[in];
    const scalar h =
        n_[in] > 0 ? x_[in] - b.min()[in] : b.max()[in] - x_[in];
    if (h - a_ < 0 || h + a_ > room)
    {
        return -1;
    }
    const scalar s0 = d_[id]*(b.min()[id] - x_[id]);
    const scalar s1 = d_[id]*(b.max()[id] - x_[id]);
    return
        b.span()[3 - in - id]
       *(
            h*b.span()[id]
          + d_[id]*a_/k_*(Foam::sin(k_*s1 + phi_) - Foam::sin(k_*s0 + phi_))
        );
}
