/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// What the user gave, and the restart

#include "film.H"
#include "addToRunTimeSelectionTable.H"
#include "fvMesh.H"
#include "Time.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace surfaceMotions
{
    defineTypeName(film);
    addToRunTimeSelectionTable(surfaceMotion, film, dictionary);
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

Foam::dew::surfaceMotions::film::record::record(const film& motion)
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


Foam::dew::surfaceMotions::film::film
(
    const fvMesh& mesh,
    const dictionary& surfaceProperties
)
:
    surfaceShape(mesh, surfaceProperties),
    substrate_(mesh, dict_),
    h_(userEntry::positive(dict_, "thickness", dimLength)),
    before_(h_),
    dt_(0),
    near_(1e-9*Foam::cbrt(gMin(mesh.V().field()))),
    wetFaces_("wetFaces", alphaf_)
{
    userEntry::onlyThese(dict_, {"type", "substrate", "thickness"});
    substrate_.checkFlat(fits*max(h_, Foam::sqrt(substrate_.area())));

    if
    (
        symmetry_.wedge()
     && mag(substrate_.normal() ^ symmetry_.axis()) > fits
    )
    {
        FatalIOErrorInFunction(dict_)
            << "The patch " << substrate_.name() << ", entry 'substrate' in "
            << dict_.dictName()
            << ", is not at right angles to the axis of the wedge, "
            << symmetry_.axis() << nl
            << "Its normal is " << substrate_.normal() << exit(FatalIOError);
    }

    record_.reset(new record(*this));
    const dictionary& saved = record_();
    const scalar held = heldVolume();

    if (saved.found("thickness"))
    {
        h_ = userEntry::notNegative(saved, "thickness", dimLength);
        before_ = userEntry::notNegative(saved, "thicknessBefore", dimLength);
        dt_ = userEntry::notNegative(saved, "deltaT", dimTime);
    }
    else if (held == 0)
    {
        Info<< "Filling " << alpha_.name() << " up to " << h_ << " m above "
            << substrate_.name() << endl;
    }

    if
    (
        (saved.found("thickness") || held != 0)
     && mag(held - volume())
      > 10*fits*substrate_.area()*max(h_, before_)
    )
    {
        FatalIOErrorInFunction(dict_)
            << "The volume of " << alpha_.name() << ", " << held
            << " m3, is not that of a film of thickness " << h_ << " m, "
            << volume() << " m3" << nl
            << "At the start set alpha to 0 everywhere: the film is filled in."
            << " To continue, start from a time of which alpha and "
            << saved.name() << " were kept"
            << exit(FatalIOError);
    }

    // Without a step before, its start is the present
    const scalar now = h_;
    if (dt_ > 0)
    {
        h_ = before_;
        overlap();
    }
    const surfaceScalarField wetBefore("wetBefore", wetFaces_);
    h_ = now;
    overlap();
    alphaf_ = dt_ > 0 ? 0.5*(wetBefore + wetFaces_) : 1*wetFaces_;
    alpha_.oldTime();
    correctGeometry();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dew::surfaceMotions::film::record::writeData(Ostream& os) const
{
    // All digits, so that a continued run is the uninterrupted one
    const int digits = os.precision(17);
    os.writeEntry("thickness", motion_.h_);
    os.writeEntry("thicknessBefore", motion_.before_);
    os.writeEntry("deltaT", motion_.dt_);
    os.precision(digits);
    return os.good();
}


// ************************************************************************* //
