/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "depositStatistics.H"
#include "addToRunTimeSelectionTable.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "Time.H"
#include "userEntry.H"

#include <sstream>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(depositStatistics);
    addToRunTimeSelectionTable(functionObject, depositStatistics, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::depositStatistics::depositStatistics
(
    const word& name,
    const Time& time,
    const dictionary& dict
)
:
    functionObjects::regionFunctionObject(name, time, dict)
{
    read(dict);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

const Foam::dew::particleState& Foam::dew::depositStatistics::particles() const
{
    const particleEngine* engine = obr_.cfindObject<particleEngine>("particles");
    if (!engine)
    {
        FatalErrorInFunction
            << "Function object " << name() << " of type " << typeName
            << " finds no particles" << nl
            << "Use it with a solver that has them"
            << exit(FatalError);
    }
    return engine->state();
}


Foam::OFstream& Foam::dew::depositStatistics::file
(
    autoPtr<OFstream>& stream,
    const word& name,
    const string& columns
) const
{
    if (!stream)
    {
        const fileName folder
        (
            time_.globalPath()/"postProcessing"/this->name()
           /time_.timeName(time_.startTime().value())
        );
        mkDir(folder);
        stream.reset(new OFstream(folder/name));
        stream->precision(12);
        *stream << columns.c_str() << endl;
    }
    return *stream;
}


Foam::string Foam::dew::depositStatistics::ringColumns() const
{
    std::ostringstream os;
    os.precision(8);
    os << "# time [s], number density [1/m2] in the rings between r =";
    for (label k = 0; k <= nRings_; k++)
    {
        os << ' ' << radius_*k/nRings_;
    }
    os << " [m], number beyond";
    return os.str();
}


void Foam::dew::depositStatistics::writeRings
(
    autoPtr<OFstream>& stream,
    const word& name,
    const labelList& n
) const
{
    OFstream& os = file(stream, name, ringColumns());
    os << time_.value();
    for (label k = 0; k < nRings_; k++)
    {
        // pi (r1^2 - r0^2) of a ring
        const scalar area =
            constant::mathematical::pi*sqr(radius_/nRings_)*(2*k + 1);
        os << ' ' << n[k]/area;
    }
    os << ' ' << n[nRings_] << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dew::depositStatistics::read(const dictionary& dict)
{
    regionFunctionObject::read(dict);

    centre_ = userEntry::point(dict, "centre", dimLength);
    normal_ = userEntry::direction(dict, "normal");
    radius_ = userEntry::positive(dict, "contactRadius", dimLength);
    gap_ = userEntry::positiveOr(dict, "gap", dimLength, 50e-9);
    rim_ = dict.found("rim") ? userEntry::within(dict, "rim", 0, 1) : 0.9;
    nRings_ = dict.found("rings") ? userEntry::count(dict, "rings") : 20;

    userEntry::onlyThese
    (
        dict,
        {
            "type", "libs", "functionObjectLibs", "region", "subRegion",
            "enabled", "log", "timeStart", "timeEnd",
            "executeControl", "executeInterval",
            "writeControl", "writeInterval",
            "centre", "normal", "contactRadius", "gap", "rim", "rings"
        }
    );

    return true;
}


bool Foam::dew::depositStatistics::execute()
{
    const particleState& s = particles();

    // Numbers: all, deposited, of each those beyond the rim; sums of r
    labelList n(4, Zero);
    scalarList r(2, Zero);

    for (label i = 0; i < s.size(); i++)
    {
        const scalar ri = distance(s, i);
        const bool outer = ri > rim_*radius_;

        n[0]++;
        n[2] += outer;
        r[0] += ri;
        if (deposited(s, i))
        {
            n[1]++;
            n[3] += outer;
            r[1] += ri;
        }
    }
    Pstream::listCombineGather(n, plusEqOp<label>());
    Pstream::listCombineGather(r, plusEqOp<scalar>());

    if (Pstream::master())
    {
        const auto share = [](const scalar part, const label whole)
        {
            return whole ? part/whole : 0;
        };
        file
        (
            file_,
            "deposit.dat",
            "# time [s], particles, share deposited, share beyond the rim of"
            " all, of those deposited, mean radius of all [m], of those"
            " deposited [m]"
        )   << time_.value() << ' ' << n[0]
            << ' ' << share(n[1], n[0])
            << ' ' << share(n[2], n[0]) << ' ' << share(n[3], n[1])
            << ' ' << share(r[0], n[0]) << ' ' << share(r[1], n[1]) << endl;
    }
    return true;
}


bool Foam::dew::depositStatistics::write()
{
    const particleState& s = particles();

    // The last entry is what is beyond the rings
    labelList all(nRings_ + 1, Zero), those(nRings_ + 1, Zero);
    for (label i = 0; i < s.size(); i++)
    {
        const scalar ring = distance(s, i)/radius_*nRings_;
        const label k = ring < nRings_ ? label(ring) : nRings_;
        all[k]++;
        those[k] += deposited(s, i);
    }
    Pstream::listCombineGather(all, plusEqOp<label>());
    Pstream::listCombineGather(those, plusEqOp<label>());

    if (Pstream::master())
    {
        writeRings(density_, "density.dat", all);
        writeRings(depositedDensity_, "depositedDensity.dat", those);
    }
    return true;
}
