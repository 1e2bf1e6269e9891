/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "flows.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::closedFlow::closedFlow(const dictionary& dict)
:
    type_(dict.get<word>("type")),
    uniform_(dict.getOrDefault<vector>("U", Zero)),
    centre_(dict.getOrDefault<vector>("centre", Zero)),
    length_(dict.getOrDefault<scalar>("length", 1)),
    speed_(dict.getOrDefault<scalar>("speed", 1)),
    period_(dict.getOrDefault<scalar>("period", GREAT))
{}


Foam::dew::movingLayer::movingLayer(const dictionary& dict)
:
    depth_(dict.get<scalar>("depth")),
    width_(dict.get<scalar>("width")),
    centre_(dict.get<scalar>("centre")),
    speed_(dict.get<scalar>("speed")),
    length_(dict.get<scalar>("length"))
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::dew::closedFlow::unitVelocity(const point& p) const
{
    const scalar x = p.x(), y = p.y(), z = p.z();

    if (type_ == "uniform")
    {
        return uniform_;
    }
    if (type_ == "rotation")
    {
        return vector(centre_.y() - y, x - centre_.x(), 0);
    }
    if (type_ == "vortex")
    {
        return vector
        (
            -sqr(sin(pi*x))*sin(2*pi*y), sin(2*pi*x)*sqr(sin(pi*y)), 0
        );
    }
    if (type_ == "deformation")
    {
        return vector
        (
            2*sqr(sin(pi*x))*sin(2*pi*y)*sin(2*pi*z),
           -sin(2*pi*x)*sqr(sin(pi*y))*sin(2*pi*z),
           -sin(2*pi*x)*sin(2*pi*y)*sqr(sin(pi*z))
        );
    }
    if (type_ == "strain")
    {
        return vector(-0.5*x, -0.5*y, z);
    }
    FatalErrorInFunction << "No flow " << type_ << exit(FatalError);
    return Zero;
}


Foam::vector Foam::dew::closedFlow::unitPotential(const point& p) const
{
    const scalar x = p.x(), y = p.y(), z = p.z();

    if (type_ == "uniform")
    {
        return
            uniform_.z()*vector(-0.5*y, 0.5*x, 0)
          + vector(0, 0, uniform_.x()*y - uniform_.y()*x);
    }
    if (type_ == "rotation")
    {
        return vector
        (
            0, 0, -0.5*(sqr(x - centre_.x()) + sqr(y - centre_.y()))
        );
    }
    if (type_ == "vortex")
    {
        return vector(0, 0, -sqr(sin(pi*x)*sin(pi*y))/pi);
    }
    if (type_ == "deformation")
    {
        return vector
        (
            0,
            cos(2*pi*x)*sin(2*pi*y)*sqr(sin(pi*z)),
           -cos(2*pi*x)*sqr(sin(pi*y))*sin(2*pi*z) - cos(2*pi*y)*sin(2*pi*z)
        )/(2*pi);
    }
    return 0.5*z*vector(-y, x, 0);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::closedFlow::factor(const scalar t) const
{
    return period_ < GREAT ? cos(pi*t/period_) : 1;
}


Foam::scalar Foam::dew::movingLayer::below
(
    const scalar x,
    const scalar t
) const
{
    scalar sum = 0;
    for (label image = -3; image <= 3; image++)
    {
        const scalar from = centre_ + image*length_ + speed_*t;
        sum += 1 + erf((x - from)/width_);
    }
    return 0.5*depth_*width_*sqrt(pi)*sum;
}
