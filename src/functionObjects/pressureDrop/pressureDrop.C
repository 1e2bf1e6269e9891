/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "pressureDrop.H"
#include "addToRunTimeSelectionTable.H"
#include "surfaceFields.H"
#include "Time.H"
#include "userEntry.H"
#include "volFields.H"
#include "wordRes.H"

// Needs the fields first
#include "cuttingPlane.H"

#include <sstream>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(pressureDrop);
    addToRunTimeSelectionTable(functionObject, pressureDrop, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::pressureDrop::pressureDrop
(
    const word& name,
    const Time& time,
    const dictionary& dict
)
:
    functionObjects::regionFunctionObject(name, time, dict),
    averageStart_(time.value()),
    last_(time.value()),
    duration_(0),
    drop_(0),
    mean_(0),
    file_("pressureDrop.dat")
{
    read(dict);

    // Of this time, or of one that was written without it
    const scalar written = getProperty<scalar>("time", -GREAT);
    if (mag(written - time.value()) < 0.5*time.deltaTValue())
    {
        duration_ = getProperty<scalar>("duration");
        mean_ = getProperty<scalar>("mean");
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::fvMesh& Foam::dew::pressureDrop::mesh() const
{
    return refCast<const fvMesh>(obr_);
}


Foam::scalar Foam::dew::pressureDrop::toPa(const volScalarField& p) const
{
    if (p.dimensions() == dimPressure)
    {
        return 1;
    }
    if (p.dimensions() != sqr(dimVelocity))
    {
        FatalIOErrorInFunction(dict_)
            << "Field '" << field_ << "' has the dimensions " << p.dimensions()
            << ": neither Pa nor m2/s2" << nl
            << "Name a pressure in the entry 'field'" << exit(FatalIOError);
    }

    const IOdictionary* transport =
        obr_.cfindObject<IOdictionary>("transportProperties");

    const dictionary& from =
        dict_.found("rho") || !transport ? dict_ : *transport;
    if (!from.found("rho"))
    {
        FatalIOErrorInFunction(dict_)
            << "Field '" << field_ << "' is a pressure over density, and there"
            << " is no density" << nl << "Add the entry 'rho' [kg/m3]"
            << exit(FatalIOError);
    }
    return userEntry::positive(from, "rho", dimDensity);
}


void Foam::dew::pressureDrop::addPatches
(
    const dictionary& dict,
    const volScalarField& p,
    scalar& sum,
    scalar& area
) const
{
    const polyBoundaryMesh& patches = mesh().boundaryMesh();

    for (const wordRe& pattern : dict.get<wordRes>("patches"))
    {
        const labelHashSet found
        (
            patches.patchSet(List<wordRe>(1, pattern), false)
        );
        if (found.empty())
        {
            // Those of processors are not the user's
            const wordList names
            (
                SubList<word>(patches.names(), patches.nNonProcessor())
            );
            FatalIOErrorInFunction(dict)
                << "Unknown patch '" << pattern << "'" << nl
                << "Patches are " << flatOutput(names) << exit(FatalIOError);
        }
        for (const label patchi : found)
        {
            const fvsPatchScalarField& S =
                mesh().magSf().boundaryField()[patchi];
            sum += Foam::sum(S*p.boundaryField()[patchi]);
            area += Foam::sum(S);
        }
    }
}


void Foam::dew::pressureDrop::addPlane
(
    const dictionary& dict,
    const volScalarField& p,
    scalar& sum,
    scalar& area
) const
{
    const dictionary& entries = userEntry::subDict(dict, "plane");
    userEntry::onlyThese(entries, {"point", "normal"});

    const vector normal(userEntry::direction(entries, "normal"));

    // Off points and faces of the mesh: a plane through them loses cells
    const point origin
    (
        userEntry::point(entries, "point", dimLength)
      + 1e-6*mesh().bounds().mag()*normal
    );
    const cuttingPlane cut(plane(origin, normal), mesh(), false);
    forAll(cut.surfFaces(), facei)
    {
        const scalar S = cut.surfFaces()[facei].mag(cut.points());
        sum += S*p[cut.meshCells()[facei]];
        area += S;
    }
}


void Foam::dew::pressureDrop::addPoint
(
    const dictionary& dict,
    const volScalarField& p,
    scalar& sum,
    scalar& area
) const
{
    const label celli = mesh().findCell
    (
        userEntry::point(dict, "point", dimLength)
    );
    if (celli >= 0)
    {
        sum += p[celli];
        area++;
    }
}


Foam::scalar Foam::dew::pressureDrop::at
(
    const word& place,
    const volScalarField& p
) const
{
    const dictionary& dict = userEntry::subDict(dict_, place);
    scalar sum = 0, area = 0;

    if (dict.size() != 1)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << place << "' has " << dict.size() << " entries"
            << nl << "Give it one of: patches, point, plane"
            << exit(FatalIOError);
    }
    userEntry::onlyThese(dict, {"patches", "point", "plane"});

    if (dict.found("patches"))
    {
        addPatches(dict, p, sum, area);
    }
    else if (dict.found("plane"))
    {
        addPlane(dict, p, sum, area);
    }
    else
    {
        addPoint(dict, p, sum, area);
    }

    reduce(sum, sumOp<scalar>());
    reduce(area, sumOp<scalar>());

    if (area <= 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry '" << place << "': there is no cell of the mesh" << nl
            << "The mesh is within " << mesh().bounds() << exit(FatalIOError);
    }
    return sum/area;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dew::pressureDrop::read(const dictionary& dict)
{
    regionFunctionObject::read(dict);

    dict_ = dict;
    field_ = dict.getOrDefault<word>("field", "p");
    if (dict.found("averageStart"))
    {
        averageStart_ = userEntry::number(dict, "averageStart", dimTime);
    }

    if (!isA<fvMesh>(obr_))
    {
        // A plain error would only be a warning here
        FatalIOErrorInFunction(dict)
            << "Function object " << name() << " of type " << typeName
            << " finds no fluid" << nl << "Use it with a solver that has one"
            << exit(FatalIOError);
    }
    userEntry::subDict(dict, "from");
    userEntry::subDict(dict, "to");

    userEntry::onlyThese
    (
        dict,
        seriesFile::entries({"from", "to", "field", "rho", "averageStart"})
    );

    return true;
}


bool Foam::dew::pressureDrop::execute()
{
    const auto* p = obr_.cfindObject<volScalarField>(field_);
    if (!p)
    {
        FatalIOErrorInFunction(dict_)
            << "Unknown field '" << field_ << "'" << nl << "Fields are "
            << flatOutput(obr_.sortedNames<volScalarField>())
            << exit(FatalIOError);
    }

    const scalar factor = toPa(*p);
    const scalar from = factor*at("from", *p), to = factor*at("to", *p);
    drop_ = from - to;

    const scalar t = time_.value();
    const scalar dt = min(t - last_, t - averageStart_);
    last_ = t;
    if (dt > 0)
    {
        mean_ = (duration_*mean_ + dt*drop_)/(duration_ + dt);
        duration_ += dt;
    }

    if (Pstream::master())
    {
        file_.line
        (
            time_, name(),
            "p from [Pa], p to [Pa], difference [Pa], its mean [Pa]",
            scalarList({from, to, drop_, mean_})
        );
    }
    return true;
}


bool Foam::dew::pressureDrop::write()
{
    // Six digits are enough to read
    std::ostringstream os;
    os  << name() << ": pressure drop " << drop_ << " Pa, mean " << mean_
        << " Pa over " << duration_ << " s";
    Info<< os.str().c_str() << nl << endl;

    setProperty("time", time_.value());
    setProperty("duration", duration_);
    setProperty("mean", mean_);

    return true;
}
