/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "PengRobinson.H"
#include "gasConstant.H"
#include "mathematicalConstants.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::PengRobinson::PengRobinson
(
    const scalarField& Tc,
    const scalarField& pc,
    const scalarField& omega
)
:
    Tc_(Tc),
    k_(0.37464 + omega*(1.54226 - 0.26992*omega)),
    ac_(0.45724*sqr(gasConstant*Tc)/pc),
    b_(0.07780*gasConstant*Tc/pc),
    rootA_(Tc.size())
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dew::PengRobinson::Z(const scalar A, const scalar B)
{
    // Z^3 + c2 Z^2 + c1 Z + c0 = 0
    const scalar c2 = B - 1;
    const scalar c1 = A - B*(3*B + 2);
    const scalar c0 = -B*(A - B*(1 + B));

    const scalar q = (sqr(c2) - 3*c1)/9;
    const scalar r = (c2*(2*sqr(c2) - 9*c1) + 27*c0)/54;
    if (sqr(r) < q*q*q)
    {
        const scalar angle = std::acos(r/std::sqrt(q*q*q));
        return
            -2*std::sqrt(q)
           *std::cos((angle + constant::mathematical::twoPi)/3) - c2/3;
    }
    const scalar s =
        -sign(r)*std::cbrt(mag(r) + std::sqrt(sqr(r) - q*q*q));
    return s + (s == 0 ? 0 : q/s) - c2/3;
}


Foam::scalar Foam::dew::PengRobinson::lnPhi
(
    const scalar Z,
    const scalar A,
    const scalar B,
    const scalar bRatio,
    const scalar aRatio
)
{
    const scalar root2 = std::sqrt(2.0);
    return
        bRatio*(Z - 1) - std::log(Z - B)
      - A/(2*root2*B)*(2*aRatio - bRatio)
       *std::log((Z + (1 + root2)*B)/(Z + (1 - root2)*B));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::PengRobinson::lnPhi
(
    const scalar p,
    const scalar T,
    const UList<scalar>& y,
    UList<scalar>& result
) const
{
    scalar rootA = 0, b = 0, total = 0;
    forAll(Tc_, i)
    {
        rootA_[i] = std::sqrt(a(i, T));
        rootA += y[i]*rootA_[i];
        b += y[i]*b_[i];
        total += y[i];
    }
    rootA /= total;
    b /= total;

    const scalar A = sqr(rootA/(gasConstant*T))*p, B = b*p/(gasConstant*T);
    const scalar z = Z(A, B);
    forAll(Tc_, i)
    {
        result[i] = lnPhi(z, A, B, b_[i]/b, rootA_[i]/rootA);
    }
}


Foam::scalar Foam::dew::PengRobinson::lnPhi
(
    const label i,
    const scalar p,
    const scalar T
) const
{
    const scalar A = a(i, T)*p/sqr(gasConstant*T);
    const scalar B = b_[i]*p/(gasConstant*T);
    return lnPhi(Z(A, B), A, B, 1, 1);
}
