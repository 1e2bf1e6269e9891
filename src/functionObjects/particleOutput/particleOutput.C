/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleOutput.H"
#include "clockTime.H"
#include "IOField.H"
#include "OSspecific.H"
#include "particleExchange.H"
#include "passiveParticleCloud.H"
#include "IOPosition.H"
#include "polyMesh.H"
#include "Time.H"
#include "tetBarycentric.H"

#include <fstream>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(particleOutput);
}
}

static const Foam::word cloudName("particles");


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleOutput::particleOutput
(
    const polyMesh& mesh,
    const particleEngine& particles
)
:
    regIOobject
    (
        IOobject
        (
            "particleOutput",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        )
    ),
    mesh_(mesh),
    particles_(particles),
    cloud_(false),
    vtk_(false),
    csv_(false),
    hosts_(mesh),
    series_(mesh.time().globalPath()/"VTK", cloudName),
    time_(0)
{
    const dictionary& dict = particles.properties();
    const wordList formats
    (
        dict.getOrDefault<wordList>("output", wordList({"cloud", "vtk"}))
    );

    for (const word& format : formats)
    {
        if (format == "cloud") cloud_ = true;
        else if (format == "vtk") vtk_ = true;
        else if (format == "csv") csv_ = true;
        else
        {
            FatalIOErrorInFunction(dict)
                << "Unknown format " << format << " in entry 'output'" << nl
                << "Valid formats: cloud vtk csv"
                << exit(FatalIOError);
        }
    }

    if (vtk_)
    {
        series_.resume(mesh.time().value());
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

std::vector<Foam::dew::vtkSeries::column>
Foam::dew::particleOutput::scalars() const
{
    std::vector<vtkSeries::column> result;
    const auto* exchange =
        mesh_.findObject<particleExchange>("particleExchange");

    if (exchange)
    {
        for (const scalarExchange& s : exchange->scalars())
        {
            result.push_back({s.name(), exchange->values(s)});
        }
    }
    return result;
}


void Foam::dew::particleOutput::writeCloud
(
    IOstream::streamFormat fmt,
    IOstream::versionNumber ver,
    IOstream::compressionType cmp
) const
{
    const particleState& s = particles_.state();

    // The cloud lives where the cells are
    hosts_.correct(s.x);
    const labelUList& cells = hosts_.cells();
    const meshSymmetry& symmetry = hosts_.symmetry();
    List<point> x(hosts_.map().forward(s.x));
    const label n = cells.size();
    const List<point> inSpace(symmetry.wedge() ? x : List<point>());
    for (point& p : x)
    {
        p = symmetry.fold(p);
    }

    const label outside = hosts_.nOutside();
    if (outside)
    {
        Info<< "    outside the mesh, and not in the cloud: " << outside
            << " particles" << endl;
    }

    passiveParticleCloud parcels(mesh_, cloudName, IDLList<passiveParticle>());
    tetBarycentric tets(mesh_);
    for (label i = 0; i < n; i++)
    {
        parcels.addParticle(new passiveParticle(tets.inCell(x[i], cells[i])));
    }

    // Without the fields of a cloud's own that nobody has use for
    for
    (
        const auto form
      : {cloud::geometryType::COORDINATES, cloud::geometryType::POSITIONS}
    )
    {
        IOPosition<passiveParticleCloud>(parcels, form).writeObject
        (
            fmt, ver, cmp, n > 0
        );
    }

    const auto writeHosted = [&](const word& name, const auto& values)
    {
        typedef typename std::decay<decltype(values)>::type::value_type Type;

        IOField<Type> field
        (
            IOobject
            (
                name,
                mesh_.time().timeName(),
                parcels,
                IOobject::NO_READ,
                IOobject::NO_WRITE,
                false
            ),
            Field<Type>(values)
        );
        field.writeObject(fmt, ver, cmp, n > 0);
    };
    const auto write = [&](const word& name, const auto& values)
    {
        writeHosted(name, hosts_.map().forward(values));
    };
    const auto writeVector = [&](const word& name, const auto& values)
    {
        List<vector> hosted(hosts_.map().forward(values));
        for (label i = 0; symmetry.wedge() && i < n; i++)
        {
            hosted[i] = symmetry.foldVector(hosted[i], inSpace[i]);
        }
        writeHosted(name, hosted);
    };

    writeVector("U", s.v);
    writeVector("omega", s.omega);
    if (symmetry.wedge())
    {
        writeHosted("inSpace", inSpace);
    }
    write("d", s.d);
    write("rho", s.rho);
    write("typeId", s.type);
    write("id", s.id);
    if (s.thermal)
    {
        write("T", s.T);
    }
    for (const vtkSeries::column& c : scalars())
    {
        write(c.name, c.values);
    }
}


void Foam::dew::particleOutput::writeCsv() const
{
    // Rank after rank, so that nobody holds more than one rank's particles
    const fileName path
    (
        mesh_.time().globalPath()/mesh_.time().timeName()/"particles.csv"
    );
    const particleState& s = particles_.state();
    const wordList& names = particles_.materialNames();
    const std::vector<vtkSeries::column> further(scalars());

    for (label rank = 0; rank < Pstream::nProcs(); rank++)
    {
        if (rank == Pstream::myProcNo())
        {
            if (rank == 0)
            {
                mkDir(path.path());
            }

            std::ofstream os(path, rank ? std::ios::app : std::ios::trunc);
            os.precision(17);
            if (rank == 0)
            {
                os  << "id,x,y,z,d,vx,vy,vz,wx,wy,wz"
                    << (s.thermal ? ",T" : "");
                for (const vtkSeries::column& c : further)
                {
                    os << ',' << c.name.c_str();
                }
                os << (names.size() ? ",material" : "") << '\n';
            }

            for (label i = 0; i < s.size(); i++)
            {
                const vector &x = s.x[i], &v = s.v[i], &w = s.omega[i];
                os  << s.id[i]
                    << ',' << x.x() << ',' << x.y() << ',' << x.z()
                    << ',' << s.d[i]
                    << ',' << v.x() << ',' << v.y() << ',' << v.z()
                    << ',' << w.x() << ',' << w.y() << ',' << w.z();
                if (s.thermal) os << ',' << s.T[i];
                for (const vtkSeries::column& c : further)
                {
                    os << ',' << c.values[i];
                }
                if (names.size()) os << ',' << names[s.type[i]].c_str();
                os << '\n';
            }
        }

        label turn = rank;
        reduce(turn, maxOp<label>());
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::particleOutput::writeStart() const
{
    if (vtk_)
    {
        series_.write(mesh_.time(), particles_.state(), scalars());
    }
}


bool Foam::dew::particleOutput::writeObject
(
    IOstream::streamFormat fmt,
    IOstream::versionNumber ver,
    IOstream::compressionType cmp,
    const bool
) const
{
    const clockTime clock;

    if (cloud_)
    {
        writeCloud(fmt, ver, cmp);
    }
    if (vtk_)
    {
        series_.write(mesh_.time(), particles_.state(), scalars());
    }
    if (csv_)
    {
        writeCsv();
    }

    time_ += clock.elapsedTime();

    return true;
}
