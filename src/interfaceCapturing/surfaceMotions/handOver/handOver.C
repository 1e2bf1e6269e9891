/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "handOver.H"
#include "mathematicalConstants.H"
#include "sphericalCap.H"
#include "substrate.H"
#include "transportedSurface.H"
#include "unitConversion.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::handOver::handOver
(
    const transportedSurface& surface,
    const dictionary& surfaceProperties
)
:
    surface_(surface),
    properties_(surfaceProperties),
    dict_(surfaceProperties.subOrEmptyDict("handOver")),
    a_(0),
    share_(1),
    height_(0)
{
    if (!surfaceProperties.found("handOver"))
    {
        return;
    }

    userEntry::onlyThese
    (
        dict_, {"substrate", "contactRadius", "contactLine", "cells", "share"}
    );
    userEntry::subDict(dict_, "contactLine");
    a_ = userEntry::positive(dict_, "contactRadius", dimLength);
    share_ =
        userEntry::positiveOr
        (
            dict_, "share", dimless, 1/surface.wholeFactor()
        );

    const fvMesh& mesh = surface.mesh();
    const substrate wall(mesh, dict_);
    const fvPatch& patch = mesh.boundary()[wall.name()];
    scalar V = 0;
    for (const label celli : patch.faceCells())
    {
        V += mesh.V()[celli];
    }
    reduce(V, sumOp<scalar>());
    height_ =
        userEntry::positiveOr(dict_, "cells", dimless, 1)*V/wall.area();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dew::handOver::angle() const
{
    return sphericalCap::angle(surface_.volume()/share_, a_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dew::handOver::due() const
{
    return
        height_ > 0
     && surface_.volume() > 0
     && a_*Foam::tan(0.5*angle()) < height_;
}


Foam::dictionary Foam::dew::handOver::shape() const
{
    const scalar theta = angle();
    if (theta > constant::mathematical::piByTwo)
    {
        FatalIOErrorInFunction(dict_)
            << "The drop of " << surface_.volume()/share_
            << " m3 has a contact angle of " << radToDeg(theta)
            << " degrees on contactRadius " << a_ << ", and is lower than the"
            << " cells: that is no thin cap" << nl
            << "Give the radius of its contact line, or fewer cells"
            << exit(FatalIOError);
    }

    dictionary motion;
    motion.add("type", "quasiStatic");
    motion.add("substrate", dict_.get<word>("substrate"));
    motion.add("contactRadius", a_);
    motion.add("contactAngle", radToDeg(theta));
    motion.add("contactLine", dict_.subDict("contactLine"));

    dictionary shape(properties_.dictName());
    shape.add("liquid", properties_.get<word>("liquid"));
    shape.add("surfaceMotion", motion);
    return shape;
}


// ************************************************************************* //
