/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// What the user gave, and the restart

#include "quasiStatic.H"
#include "addToRunTimeSelectionTable.H"
#include "fvMesh.H"
#include "substrate.H"
#include "Time.H"
#include "unitConversion.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace surfaceMotions
{
    defineTypeName(quasiStatic);
    addToRunTimeSelectionTable(surfaceMotion, quasiStatic, dictionary);
}
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Of positions and volumes that were written with six digits
constexpr Foam::scalar fits = 1e-6;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::surfaceMotions::quasiStatic::record::record
(
    const quasiStatic& motion
)
:
    IOdictionary
    (
        IOobject
        (
            "surface",
            motion.mesh_.time().timeName(),
            "uniform",
            motion.mesh_,
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    ),
    motion_(motion)
{}


Foam::dew::surfaceMotions::quasiStatic::quasiStatic
(
    const fvMesh& mesh,
    const dictionary& surfaceProperties
)
:
    surfaceShape(mesh, surfaceProperties),
    line_
    (
        contactLine::New
        (
            userEntry::subDict(dict_, "contactLine"),
            degToRad(userEntry::within(dict_, "contactAngle", 0.01, 179))
        )
    ),
    overlap_(mesh, symmetry_),
    base_(Zero),
    normal_(Zero),
    share_(1),
    dt_(0),
    wetFaces_("wetFaces", alphaf_),
    warned_(false)
{
    const sphericalCap start(capAtStart(mesh, symmetry_, dict_));
    base_ = start.base();
    normal_ = start.normal();

    record_.reset(new record(*this));
    const dictionary& saved = record_();
    const bool restart = saved.found("volume");
    const scalar held = heldVolume();

    if (restart)
    {
        const auto read = [&](const word& key)
        {
            return userEntry::notNegative(saved, key, dimless);
        };
        share_ = read("share");
        now_ = {read("volume"), read("contactRadius"), read("contactAngle")};
        before_ =
        {
            read("volumeBefore"), read("contactRadiusBefore"),
            read("contactAngleBefore")
        };
        dt_ = read("deltaT");

        if (mag(held - volume()) > 10*fits*share_*max(now_.V, before_.V))
        {
            FatalIOErrorInFunction(saved)
                << "The volume of " << alpha_.name() << ", " << held
                << " m3, is not that of the drop in " << saved.name() << ", "
                << volume() << " m3" << nl
                << "Start from a time of which both were kept, or remove this"
                << " file to start anew"
                << exit(FatalIOError);
        }
    }
    else
    {
        if (!(held > 0))
        {
            FatalIOErrorInFunction(dict_)
                << "There is no liquid: the volume of "
                << alpha_.objectPath() << " is " << held << " m3" << nl
                << "Run setSphericalCap first"
                << exit(FatalIOError);
        }

        now_ = {start.volume(), start.contactRadius(), start.angle()};
        before_ = now_;
        share_ = shareInMesh(symmetry_, held, now_.V);
        if (share_ == 0)
        {
            FatalIOErrorInFunction(dict_)
                << "contactRadius and contactAngle do not fit the volume of "
                << alpha_.name() << nl
                << "Their cap has "
                << now_.V/(symmetry_.wedge() ? symmetry_.ringFactor() : 1)
                << " m3"
                << (
                       symmetry_.wedge()
                     ? " in this wedge, "
                     : " (or half, or a quarter of it, between symmetry"
                       " planes), "
                   )
                << alpha_.name() << " has " << held << " m3" << nl
                << "Run setSphericalCap; the cap must not leave the mesh"
                << exit(FatalIOError);
        }
    }

    // Without a step before, its start is the present
    if (dt_ > 0)
    {
        cap_ = makeCap(before_);
        overlap();
    }
    const surfaceScalarField wetBefore("wetBefore", wetFaces_);
    cap_ = makeCap(now_);
    overlap();
    alphaf_ = dt_ > 0 ? 0.5*(wetBefore + wetFaces_) : 1*wetFaces_;
    alpha_.oldTime();
    correctGeometry();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dew::surfaceMotions::quasiStatic::record::writeData
(
    Ostream& os
) const
{
    // All digits, so that a continued run is the uninterrupted one
    const int digits = os.precision(17);
    os.writeEntry("share", motion_.share_);
    os.writeEntry("volume", motion_.now_.V);
    os.writeEntry("contactRadius", motion_.now_.a);
    os.writeEntry("contactAngle", motion_.now_.theta);
    os.writeEntry("volumeBefore", motion_.before_.V);
    os.writeEntry("contactRadiusBefore", motion_.before_.a);
    os.writeEntry("contactAngleBefore", motion_.before_.theta);
    os.writeEntry("deltaT", motion_.dt_);
    os.precision(digits);
    return os.good();
}


Foam::scalar Foam::dew::surfaceMotions::quasiStatic::shareInMesh
(
    const meshSymmetry& symmetry,
    const scalar held,
    const scalar whole
)
{
    for (const scalar cut : {scalar(1), scalar(0.5), scalar(0.25)})
    {
        const scalar share =
            symmetry.wedge() ? 1/symmetry.ringFactor() : cut;
        if (mag(held - share*whole) < fits*share*whole)
        {
            return share;
        }
    }
    return 0;
}


Foam::dew::sphericalCap Foam::dew::surfaceMotions::quasiStatic::capAtStart
(
    const fvMesh& mesh,
    const meshSymmetry& symmetry,
    const dictionary& dict
)
{
    userEntry::onlyThese
    (
        dict,
        {
            "type", "substrate", "centre", "contactRadius", "contactAngle",
            "contactLine"
        }
    );

    const substrate plane(mesh, dict);
    const vector& normal = plane.normal();
    const point centre(userEntry::pointOr(dict, "centre", dimLength, Zero));
    const scalar a = userEntry::positive(dict, "contactRadius", dimLength);
    const scalar theta =
        degToRad(userEntry::within(dict, "contactAngle", 0.01, 179));

    const scalar off = plane.off(centre);
    if (off > fits*a)
    {
        FatalIOErrorInFunction(dict)
            << "The patch " << plane.name() << " is not flat, or 'centre' "
            << centre << " in " << dict.dictName() << " is not on it" << nl
            << "Its points are up to " << off
            << " m away from the plane through the centre"
            << exit(FatalIOError);
    }

    if (symmetry.wedge())
    {
        const vector fromAxis(centre - symmetry.origin());
        if
        (
            mag(fromAxis ^ symmetry.axis()) > fits*a
         || mag(normal ^ symmetry.axis()) > fits
        )
        {
            FatalIOErrorInFunction(dict)
                << "The drop of " << dict.dictName()
                << " is not a body of revolution about the axis of the wedge"
                << nl << "'centre' " << centre << " must be on the axis "
                << symmetry.axis() << " through " << symmetry.origin()
                << ", and the patch " << plane.name() << " at right angles to it"
                << exit(FatalIOError);
        }
        return sphericalCap
        (
            symmetry.origin() + (fromAxis & symmetry.axis())*symmetry.axis(),
            (normal & symmetry.axis()) > 0 ? symmetry.axis() : -symmetry.axis(),
            a,
            theta
        );
    }

    return sphericalCap(centre, normal, a, theta);
}
