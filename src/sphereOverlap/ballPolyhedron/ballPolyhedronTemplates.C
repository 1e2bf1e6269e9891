/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

template<class InsideOp>
Foam::scalar Foam::dew::ballPolyhedron::volume
(
    const InsideOp& centreInside
) const
{
    using constant::mathematical::pi;

    const scalar R3 = pow3(cap_->radius()), ball = 4*pi/3*R3;

    scalar angle = arcs_.empty() ? circles_ : solidAngle(bestOrigin());
    angle -= 4*pi*round(angle/(4*pi));
    const scalar held = (cones_ + R3*angle)/3;

    // Nearly nothing, or nearly all of it
    if (mag(held) < 1e-9*ball)
    {
        return centreInside() ? min(held + ball, ball) : max(held, scalar(0));
    }
    return held < 0 ? held + ball : held;
}
