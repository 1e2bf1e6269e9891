/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "sphericalCap.H"
#include "error.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::sphericalCap::sphericalCap
(
    const point& base,
    const vector& normal,
    const scalar a,
    const scalar theta
)
:
    base_(base),
    normal_(normal/mag(normal)),
    a_(a),
    T_(tan(0.5*theta)),
    depth_(0.5*a*(1 - sqr(T_))/T_)
{
    if (!(a > 0 && theta > 0 && theta < pi))
    {
        FatalErrorInFunction
            << "A spherical cap of contact radius " << a << " m and angle "
            << theta << " rad" << nl
            << "The radius must be above zero, the angle between zero and pi"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::sphericalCap::angle(const scalar V, const scalar a)
{
    if (!(V > 0 && a > 0))
    {
        FatalErrorInFunction
            << "A spherical cap of volume " << V << " m3 and contact radius "
            << a << " m" << nl << "Both must be above zero"
            << exit(FatalError);
    }
    return 2*atan(2*sinh(asinh(3*V/(pi*pow3(a)))/3));
}


Foam::scalar Foam::dew::sphericalCap::contactRadius
(
    const scalar V,
    const scalar theta
)
{
    if (!(V > 0 && theta > 0 && theta < pi))
    {
        FatalErrorInFunction
            << "A spherical cap of volume " << V << " m3 and contact angle "
            << theta << " rad" << nl
            << "The volume must be above zero, the angle between zero and pi"
            << exit(FatalError);
    }
    const scalar T = tan(0.5*theta);
    return cbrt(6*V/(pi*T*(3 + sqr(T))));
}


Foam::scalar Foam::dew::sphericalCap::angle() const
{
    return 2*atan(T_);
}


Foam::scalar Foam::dew::sphericalCap::volume() const
{
    return pi/6*pow3(a_)*T_*(3 + sqr(T_));
}


Foam::scalar Foam::dew::sphericalCap::psi(const point& x) const
{
    return power(x)/(radius() + mag(x - base_ + depth_*normal_));
}


Foam::vector Foam::dew::sphericalCap::outward(const point& x) const
{
    const vector r(x - base_ + depth_*normal_);
    const scalar magR = mag(r);
    return magR > ROOTVSMALL*a_ ? r/magR : normal_;
}


Foam::scalar Foam::dew::sphericalCap::leaves
(
    const scalar sa,
    const scalar sb,
    const scalar L2
)
{
    // s(t) = sa + g t - L2 t^2, its larger root, without cancellation
    const scalar g = sb - sa + L2;
    const scalar root = sqrt(max(sqr(g) + 4*L2*sa, scalar(0)));

    // A tangent that begins on the sphere leaves at once
    const scalar t =
        g > 0 ? (g + root)/(2*L2) : root > g ? 2*sa/(root - g) : 0;
    return min(max(t, scalar(0)), scalar(1));
}


bool Foam::dew::sphericalCap::inside
(
    const scalar sa,
    const scalar sb,
    const scalar L2,
    scalar& t0,
    scalar& t1
)
{
    t0 = 0;
    t1 = 1;

    // By the sign at the ends alone: edges that share a vertex agree about it
    if (sa >= 0 && sb >= 0)
    {
        return true;
    }
    if (sa >= 0)
    {
        t1 = leaves(sa, sb, L2);
        return true;
    }
    if (sb >= 0)
    {
        t0 = 1 - leaves(sb, sa, L2);
        return true;
    }

    const scalar g = sb - sa + L2;
    const scalar discriminant = sqr(g) + 4*L2*sa;
    if (!(g > 0 && g < 2*L2 && discriminant > 0))
    {
        return false;
    }
    const scalar sum = g + sqrt(discriminant);
    t0 = -2*sa/sum;
    t1 = sum/(2*L2);
    return t0 < t1;
}
