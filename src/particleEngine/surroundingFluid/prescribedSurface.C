/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "prescribedSurface.H"
#include "Enum.H"
#include "surfaceFilmEntries.H"
#include "unitConversion.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

bool isSphere(const Foam::dictionary& dict)
{
    return
        Foam::Enum<bool>({{false, "plane"}, {true, "sphere"}})
       .get("type", dict);
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::prescribedSurface::prescribedSurface(const dictionary& dict)
:
    sphere_(isSphere(dict)),
    origin_(userEntry::point(dict, sphere_ ? "centre" : "point", dimLength)),
    normal_(sphere_ ? vector(Zero) : userEntry::direction(dict, "normal")),
    radius_(sphere_ ? userEntry::positive(dict, "radius", dimLength) : 0),
    speed_
    (
        dict.found("speed")
      ? userEntry::number(dict, "speed", dimVelocity)
      : 0
    ),
    stiffness_(0),
    tension_(0),
    angle_(0),
    plane_(false)
{
    wordList known
    ({
        "type", "speed", "stiffness", "surfaceTension", "contactAngle", "pull",
        "film"
    });
    known.append
    (
        sphere_ ? wordList({"centre", "radius"}) : wordList({"point", "normal"})
    );
    userEntry::onlyThese(dict, known);

    if (dict.found("stiffness") == dict.found("surfaceTension"))
    {
        FatalIOErrorInFunction(dict)
            << "The surface of the liquid needs one force on particles: entry"
            << " 'stiffness' of an elastic skin, or 'surfaceTension' with"
            << " 'contactAngle'; there are "
            << (dict.found("stiffness") ? "both" : "none") << nl
            << "Keep one of them: stiffness 4e-4; or surfaceTension 0.072;"
            << " contactAngle 30;"
            << exit(FatalIOError);
    }
    if (dict.found("film"))
    {
        film_ = readSurfaceFilm(userEntry::subDict(dict, "film"));
    }
    if (dict.found("stiffness"))
    {
        for (const word& key : wordList({"contactAngle", "pull"}))
        {
            if (dict.found(key))
            {
                FatalIOErrorInFunction(dict)
                    << "Entry '" << key << "' is of no use with 'stiffness'"
                    << nl << "Remove it, or use 'surfaceTension'"
                    << exit(FatalIOError);
            }
        }
        stiffness_ =
            userEntry::positive(dict, "stiffness", dimForce/dimLength);
    }
    else
    {
        tension_ =
            userEntry::positive(dict, "surfaceTension", dimForce/dimLength);
        angle_ = degToRad(userEntry::within(dict, "contactAngle", 0, 180));
        plane_ =
            Enum<bool>({{false, "contactLine"}, {true, "plane"}})
           .getOrDefault("pull", dict, false);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dew::prescribedSurface::radius(const scalar t) const
{
    const scalar r = radius_ + speed_*t;

    if (r <= 0)
    {
        FatalErrorInFunction
            << "The sphere of liquid has shrunk to nothing at time " << t
            << " s: radius " << radius_ << " m, speed " << speed_ << " m/s"
            << nl << "End the run before, in system/controlDict"
            << exit(FatalError);
    }
    return r;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::prescribedSurface::foot Foam::dew::prescribedSurface::nearest
(
    const point& x,
    const scalar t
) const
{
    foot f;

    if (sphere_)
    {
        const scalar R = radius(t);
        const vector y(x - origin_);
        const scalar r = mag(y);

        // At the centre any direction will do
        f.n = r > 0 ? y/r : vector(0, 0, 1);
        f.X = origin_ + R*f.n;
        f.curvature = 1/R;
        f.distance = r - R;
    }
    else
    {
        f.n = normal_;
        f.distance = ((x - origin_) & normal_) - speed_*t;
        f.X = x - f.distance*normal_;
        f.curvature = 0;
    }

    return f;
}
