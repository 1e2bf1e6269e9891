/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "meshSymmetry.H"
#include "DynamicList.H"
#include "mathematicalConstants.H"
#include "polyMesh.H"
#include "SubField.H"
#include "tensor.H"
#include "wedgePolyPatch.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::meshSymmetry::meshSymmetry(const polyMesh& mesh)
:
    wedge_(false),
    origin_(Zero),
    axis_(0, 0, 1),
    radial_(1, 0, 0),
    azimuth_(0, 1, 0),
    cosHalf_(1),
    ringFactor_(1),
    outer_(0),
    hole_(0),
    bounds_(mesh.bounds())
{
    DynamicList<const wedgePolyPatch*> sides;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<wedgePolyPatch>(patch))
        {
            sides.append(&refCast<const wedgePolyPatch>(patch));
        }
    }

    if (sides.empty())
    {
        return;
    }
    if (sides.size() != 2)
    {
        FatalErrorInFunction
            << "The mesh has " << sides.size() << " wedge patches" << nl
            << "A body of revolution needs two of them, one on each side"
            << exit(FatalError);
    }

    // The planes of the sides, also where this rank has no face of them
    vector n[2], c[2];
    for (label k = 0; k < 2; k++)
    {
        const SubField<vector> centres(sides[k]->faceCentres());
        n[k] = sides[k]->n();
        c[k] =
            returnReduce(sum(centres), sumOp<vector>())
           /returnReduce(sides[k]->size(), sumOp<label>());
    }

    // wedgePolyPatch has them along the coordinates, to round-off
    vector normal(sides[0]->centreNormal()), along(sides[0]->axis());
    for (direction k = 0; k < 3; k++)
    {
        normal[k] = std::round(normal[k]);
        along[k] = std::round(along[k]);
    }

    // The point of both planes that is nearest to the origin
    const tensor rows(n[0], n[1], along);
    origin_ = inv(rows) & vector(n[0] & c[0], n[1] & c[1], 0);

    radial_ = normal ^ along;
    if ((radial_ & (0.5*(c[0] + c[1]) - origin_)) < 0)
    {
        radial_ = -radial_;
    }

    // Towards the positive coordinate, whichever way the patches were named
    const vector absolute(mag(along.x()), mag(along.y()), mag(along.z()));
    axis_ = (along & absolute) < 0 ? -along : along;
    // No minus before a zero that is printed
    axis_ += vector::zero;
    azimuth_ = axis_ ^ radial_;

    if
    (
        mag(mag(n[0] & radial_) - mag(n[1] & radial_))
      > 1e-6*mag(n[0] & radial_)
    )
    {
        FatalErrorInFunction
            << "The wedge patches " << sides[0]->name() << " and "
            << sides[1]->name() << " are not at the same angle to the plane"
            << " normal to " << normal << nl
            << "Make the mesh symmetric about that plane"
            << exit(FatalError);
    }

    // From the small one of the two, which an average over faces leaves all
    // its digits
    const scalar sinHalf = 0.5*mag(n[0]/mag(n[0]) + n[1]/mag(n[1]));
    cosHalf_ = sqrt(1 - sqr(sinHalf));
    ringFactor_ = constant::mathematical::pi/(sinHalf*cosHalf_);
    wedge_ = true;

    scalar inner = GREAT;
    for (const point& p : mesh.points())
    {
        const scalar r = radial_ & (p - origin_);
        inner = min(inner, r);
        outer_ = max(outer_, r);
    }
    reduce(inner, minOp<scalar>());
    reduce(outer_, maxOp<scalar>());
    for (direction k = 0; k < 3; k++)
    {
        origin_[k] = mag(origin_[k]) < 1e-12*outer_ ? 0 : origin_[k];
    }
    hole_ = inner > 0 && inner < 1e-4*outer_ ? inner : 0;

    // The axis is one of the coordinates'
    for (direction k = 0; k < 3; k++)
    {
        if (mag(axis_[k]) < 0.5)
        {
            bounds_.min()[k] = origin_[k] - outer_/cosHalf_;
            bounds_.max()[k] = origin_[k] + outer_/cosHalf_;
        }
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::dew::meshSymmetry::outward(const point& x) const
{
    vector r(x - origin_);
    r -= axis_*(axis_ & r);
    const scalar magR = mag(r);
    return magR > VSMALL ? r/magR : radial_;
}



Foam::point Foam::dew::meshSymmetry::folded(const point& x) const
{
    const vector r(x - origin_);
    const scalar z = axis_ & r;
    return
        origin_ + max(cosHalf_*mag(r - z*axis_), hole_)*radial_ + z*axis_;
}


Foam::point Foam::dew::meshSymmetry::unfolded
(
    const point& inMesh,
    const point& x
) const
{
    return origin_ + radius(inMesh)*outward(x) + height(inMesh)*axis_;
}


Foam::vector Foam::dew::meshSymmetry::foldedVector
(
    const vector& v,
    const point& x
) const
{
    const vector out(outward(x));
    return
        (v & out)*radial_ + (v & (axis_ ^ out))*azimuth_ + (v & axis_)*axis_;
}


Foam::vector Foam::dew::meshSymmetry::unfoldedVector
(
    const vector& inMesh,
    const point& x
) const
{
    const vector out(outward(x));
    return
        (inMesh & radial_)*out + (inMesh & azimuth_)*(axis_ ^ out)
      + (inMesh & axis_)*axis_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::point Foam::dew::meshSymmetry::offAxis(const point& inMesh) const
{
    const scalar small = 1e-9*outer_;
    if (!wedge_ || radius(inMesh) > small)
    {
        return inMesh;
    }
    const bool up = height(inMesh) < height(bounds_.midpoint());
    return inMesh + small*(radial_ + (up ? 1 : -1)*axis_);
}


// ************************************************************************* //
