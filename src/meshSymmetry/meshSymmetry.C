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

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::meshSymmetry::meshSymmetry(const polyMesh& mesh)
:
    wedge_(false),
    origin_(Zero),
    axis_(0, 0, 1),
    radial_(1, 0, 0),
    azimuth_(0, 1, 0),
    cosHalf_(1),
    ringFactor_(1)
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

    const vector along = sides[0]->axis();

    // The point of both planes that is nearest to the origin
    const tensor rows(n[0], n[1], along);
    origin_ = inv(rows) & vector(n[0] & c[0], n[1] & c[1], 0);

    const vector away = 0.5*(c[0] + c[1]) - origin_;
    radial_ = away - along*(away & along);
    radial_ /= mag(radial_);

    // Towards the positive coordinate, whichever way the patches were named
    const vector absolute(mag(along.x()), mag(along.y()), mag(along.z()));
    axis_ = (along & absolute) < 0 ? -along : along;
    azimuth_ = axis_ ^ radial_;

    // From the small one of the two, which an average over faces leaves all
    // its digits
    const scalar sinHalf = 0.5*mag(n[0]/mag(n[0]) + n[1]/mag(n[1]));
    cosHalf_ = sqrt(1 - sqr(sinHalf));
    ringFactor_ = constant::mathematical::pi/(sinHalf*cosHalf_);
    wedge_ = true;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::dew::meshSymmetry::outward(const point& x) const
{
    vector r(x - origin_);
    r -= axis_*(axis_ & r);
    const scalar magR = mag(r);
    return magR > VSMALL ? r/magR : radial_;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::point Foam::dew::meshSymmetry::fold(const point& x) const
{
    if (!wedge_)
    {
        return x;
    }
    const vector r(x - origin_);
    const scalar z = axis_ & r;
    return origin_ + cosHalf_*mag(r - z*axis_)*radial_ + z*axis_;
}


Foam::point Foam::dew::meshSymmetry::unfold
(
    const point& inMesh,
    const point& x
) const
{
    return
        wedge_
      ? origin_ + radius(inMesh)*outward(x) + height(inMesh)*axis_
      : inMesh;
}


Foam::vector Foam::dew::meshSymmetry::foldVector
(
    const vector& v,
    const point& x
) const
{
    if (!wedge_)
    {
        return v;
    }
    const vector out(outward(x));
    return
        (v & out)*radial_ + (v & (axis_ ^ out))*azimuth_ + (v & axis_)*axis_;
}


Foam::vector Foam::dew::meshSymmetry::unfoldVector
(
    const vector& inMesh,
    const point& x
) const
{
    if (!wedge_)
    {
        return inMesh;
    }
    const vector out(outward(x));
    return
        (inMesh & radial_)*out + (inMesh & azimuth_)*(axis_ ^ out)
      + (inMesh & axis_)*axis_;
}


// ************************************************************************* //
