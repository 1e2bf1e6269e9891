/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Set-up: units, the engine's commands, and its start

#include "liggghtsEngine.H"
#include "fileChecksum.H"
#include "OSspecific.H"
#include "polyMesh.H"
#include "Time.H"
#include "userEntry.H"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

const Foam::fileName folder("dem");


Foam::dew::liggghtsOptions options(const Foam::polyMesh& mesh)
{
    const Foam::fileName path(mesh.time().globalPath()/folder);
    if (Foam::Pstream::master())
    {
        Foam::mkDir(path);
    }

    Foam::dew::liggghtsOptions result;
    result.logFile = path/"log.liggghts";
    result.caller = "dew";
    return result;
}


double powerOfTwo(const double x)
{
    return std::exp2(std::round(std::log2(x)));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::liggghtsEngine::liggghtsEngine
(
    const polyMesh& mesh,
    const dictionary& dict
)
:
    particleEngine(mesh, dict),
    native_(dict.found("input")),
    viscosity_(0),
    seed_(1),
    deltaT_(0),
    stableDeltaT_(0),
    library_(dict, options(mesh)),
    g_(Zero),
    needsSetup_(true),
    maxDiameter_(0)
{
    userEntry::onlyThese
    (
        dict,
        {
            "FoamFile", "engine", "periodic", "heat", "overlapTolerance",
            "materials", "contacts", "walls", "insertion", "timeStep", "skin",
            "processors", "commands", "input", "library", "frameAcceleration",
            "coupling", "output", "dynamics", "conduction", "lubrication",
            "fluid", "colloids", "dissipative", "immersion"
        }
    );

    readGravity();
    readDynamics();
    checkPairLaws();

    if (native_)
    {
        for
        (
            const word& key
          : wordList
            ({
                "materials", "contacts", "walls", "insertion", "skin",
                "processors", "frameAcceleration", "heat", "conduction",
                "lubrication", "colloids", "dissipative", "immersion"
            })
        )
        {
            if (dict.found(key))
            {
                FatalIOErrorInFunction(dict)
                    << "Entries 'input' and '" << key << "' exclude each"
                    << " other: the input file brings its own" << nl
                    << "Remove one of them"
                    << exit(FatalIOError);
            }
        }

        deltaT_ = userEntry::positive
        (
            userEntry::subDict(dict, "timeStep"), "deltaT", dimTime
        );

        DynamicList<std::string> lines;
        nativeInput(lines);
        execute(lines);
    }
    else
    {
        if (!materials_)
        {
            FatalIOErrorInFunction(dict)
                << "No materials: add the sub-dictionaries materials, contacts"
                << " and insertion, or the entry 'input'"
                << exit(FatalIOError);
        }
        for (const insertionModel& model : insertion_)
        {
            maxDiameter_ = max(maxDiameter_, model.maxDiameter());
        }
        if (maxDiameter_ <= 0)
        {
            FatalIOErrorInFunction(dict)
                << "No particles: the sub-dictionary insertion is empty"
                << exit(FatalIOError);
        }

        readColloids();
        readDissipative();
        readImmersion();

        liggghtsCommands commands
        (
            dict_, materials_(), heat_, state_.overdamped
        );
        chooseTimeStep(commands);
        chooseUnits();
        generated(commands);
        execute(commands.lines());
    }

    library_.call
    (
        "setting up",
        [this](liggghtsBinding& e)
        {
            e.units(units_);
            e.expect(0.5*maxDiameter_, heat_);
            e.dynamics(seed_, viscosity_);
            hinder(e);
            if (colloids_)
            {
                e.colloids(colloids_());
            }

            if (mag(e.deltaT()/deltaT_ - 1) > 1e-9)
            {
                FatalIOErrorInFunction(dict_)
                    << "The native input sets a timestep of " << e.deltaT()
                    << " s, timeStep.deltaT is " << deltaT_ << " s" << nl
                    << "Make them the same"
                    << exit(FatalIOError);
            }

            if (!native_)
            {
                // The engine counts from its first step, also across restarts
                const scalar start =
                    mesh_.time().value() - e.step()*deltaT_;

                e.gravity
                (
                    [this, start](double t, double* g)
                    {
                        vector value(g_);
                        if (frameAcceleration_)
                        {
                            value -= frameAcceleration_->value(start + t);
                        }
                        std::memcpy(g, &value, 3*sizeof(double));
                    }
                );
            }
        }
    );

    if (restarted())
    {
        library_.call
        (
            "going on from the restart",
            [](liggghtsBinding& e) { e.setup(); }
        );
        needsSetup_ = false;
    }
    else
    {
        insertInitial();
    }

    pull();
    account();
    printSetup();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::liggghtsEngine::chooseUnits()
{
    if (restarted())
    {
        units_.length = restart_.get<scalar>("unitLength");
        units_.mass = restart_.get<scalar>("unitMass");
        units_.time = restart_.get<scalar>("unitTime");

        if (dict_.found("commands") && units_.length != 1)
        {
            FatalIOErrorInFunction(dict_)
                << "Entry 'commands' in " << dict_.dictName() << " is in SI,"
                << " but the restart was written without it, in units of "
                << units_.length << " m" << nl
                << "Start from the beginning, or remove the entry"
                << exit(FatalIOError);
        }
        return;
    }

    if (dict_.found("commands"))
    {
        // Lines of the user are in SI, so all of them are
        return;
    }

    units_.length = powerOfTwo(maxDiameter_);
    units_.mass =
        powerOfTwo(materials_->density(0)*pow3(maxDiameter_));
    units_.time = powerOfTwo(1024*deltaT_);
}


void Foam::dew::liggghtsEngine::generated(liggghtsCommands& commands)
{
    commands.units(units_);
    commands.begin(g_);

    // Walls may reach beyond the mesh, the engine's box must hold them
    PtrList<particleWall> walls;
    List<List<wallShape>> shapes;
    boundBox wide(box_.bounds());

    const dictionary& wallDict = userEntry::optionalDict(dict_, "walls");
    for (const entry& e : wallDict)
    {
        walls.append
        (
            particleWall::New
            (
                e.keyword(),
                userEntry::dictOf(wallDict, e),
                materials_(),
                mesh_
            ).ptr()
        );
        const particleWall& w = walls.last();
        shapes.append(w.shapes());

        for (const wallShape& shape : shapes.last())
        {
            boundBox own(shape.corners, false);
            own.reduce();

            // Planes and cylinders are endless: where they cross the box
            if (shape.what != wallShape::triangles)
            {
                point low(box_.bounds().min()), high(box_.bounds().max());
                for (direction k = 0; k < 3; k++)
                {
                    const bool along = (k == direction(shape.axis));
                    if (along == (shape.what == wallShape::plane))
                    {
                        low[k] = shape.position[k] - shape.radius;
                        high[k] = shape.position[k] + shape.radius;
                    }
                }
                own = boundBox(low, high);
            }
            if (own.valid())
            {
                wide.add
                (
                    w.motion().swept(own, mesh_.time().endTime().value())
                );
            }
        }
    }

    // A particle leaves when its centre is a radius beyond the last of them
    for (direction k = 0; k < 3; k++)
    {
        if (box_.periodic(k))
        {
            wide.min()[k] = box_.bounds().min()[k];
            wide.max()[k] = box_.bounds().max()[k];
        }
        else
        {
            wide.min()[k] -= 0.5*maxDiameter_;
            wide.max()[k] += 0.5*maxDiameter_;
        }
    }

    if (restarted())
    {
        // The engine's box is that of the first start
        const boundBox first
        (
            restart_.get<point>("boxMin"), restart_.get<point>("boxMax")
        );
        boundBox inflated(first);
        inflated.inflate(1e-9);

        if (!inflated.contains(wide))
        {
            FatalIOErrorInFunction(dict_)
                << "Walls reach out to " << wide << " until endTime, the"
                << " engine's box is " << first << " since the first start"
                << nl << "Start from the beginning with this endTime, or end"
                << " earlier"
                << exit(FatalIOError);
        }
        wide = first;

        commands.readRestart(checkedRestartFile());
    }
    else
    {
        commands.box(box_, wide, materials_->size());
    }

    engineBox_ = wide;

    const lubricationProperties lubrication
    (
        dict_, smallestRadius(), 0.5*maxDiameter_
    );
    neighbourLists(commands, lubrication, !walls.empty());

    const fileName path(mesh_.time().globalPath()/folder);
    forAll(walls, i)
    {
        forAll(shapes[i], part)
        {
            const word name
            (
                walls[i].name() + (part ? "_" + Foam::name(part) : "")
            );
            commands.wallOf
            (
                walls[i], name, shapes[i][part], path/(name + ".stl")
            );
        }
    }

    commands.meshWalls();
    if (lubrication.on() || colloids_ || heat_)
    {
        commands.wallContacts();
    }
    if (heat_)
    {
        const autoPtr<conductionModel> model
        (
            conductionModel::New(dict_, materials_())
        );
        checkConduction(model());
        commands.conduction(293.15, model());
    }
    if (colloids_)
    {
        commands.colloids();
    }
    if (dissipative_)
    {
        commands.dissipative(dissipative_(), seed_);
    }
    if (immersion_)
    {
        commands.immersion(immersion_());
    }
    commands.end(deltaT_);

    if (dict_.found("commands"))
    {
        commands.native(dict_.get<List<string>>("commands"));
    }
    commands.lubrication(lubrication);
    commands.integrator();
}


void Foam::dew::liggghtsEngine::neighbourLists
(
    liggghtsCommands& commands,
    const lubricationProperties& lubrication,
    const bool walls
) const
{
    scalar skin =
        0.5*maxDiameter_*userEntry::positiveOr(dict_, "skin", dimless, 0.3);
    if (dissipative_ && !dict_.found("skin"))
    {
        skin = max(skin, dissipative_->skin());
    }
    if (lubrication.on())
    {
        // The lists of flat walls reach as far as half of it, and no further
        skin = max(skin, 2.2*lubrication.maxGap());
    }

    // Gaps that laws need, of pairs and at walls
    const scalar narrow = lubrication.on() ? lubrication.maxGap() : 0;
    scalar pairs = 0, atWalls = 0;
    if (colloids_)
    {
        pairs = atWalls = max(colloids_->cutOff(), narrow);
    }
    if (dissipative_)
    {
        const scalar open = dissipative_->range() - 2*smallestRadius();
        pairs = max(pairs, max(open, narrow));
    }
    if (immersion_)
    {
        const scalar open = immersion_->range() - 2*smallestRadius();
        pairs = max(pairs, max(open, narrow));
    }
    if (!walls)
    {
        atWalls = 0;
    }
    const scalar margin = 0.5*max(skin, colloids_ ? pairs : 0);
    if (pairs > 0)
    {
        skin = max(pairs + 2*margin, 2*(atWalls + margin));
    }
    commands.contact(skin);
    if (pairs > 0)
    {
        commands.listReach(pairs, margin, 1 + 1.01*atWalls/smallestRadius());
    }
}


void Foam::dew::liggghtsEngine::nativeInput(DynamicList<std::string>& lines)
{
    if (restarted())
    {
        FatalIOErrorInFunction(dict_)
            << "A case with the entry 'input' cannot go on from a restart:"
            << " its input file starts from the beginning" << nl
            << "Use the generated set-up, or start at time 0"
            << exit(FatalIOError);
    }

    fileName path(dict_.get<fileName>("input"));
    path.expand();
    if (!path.isAbsolute())
    {
        path = mesh_.time().globalPath()/path;
    }

    bool found = Pstream::master() && isFile(path);
    Pstream::scatter(found);
    if (!found)
    {
        FatalIOErrorInFunction(dict_)
            << "No file " << path << " (entry 'input')" << nl
            << "The path counts from the case"
            << exit(FatalIOError);
    }

    lines.append("include \"" + path + '"');
    if (dict_.found("commands"))
    {
        for (const string& line : dict_.get<List<string>>("commands"))
        {
            lines.append(line);
        }
    }
    lines.append("fix integrate all dew/integrate");
}


void Foam::dew::liggghtsEngine::execute(const UList<std::string>& lines)
{
    if (Pstream::master())
    {
        std::ofstream os(mesh_.time().globalPath()/folder/"in.particles");
        os.precision(17);
        os  << "# Made from constant/particleProperties\n# One engine unit: "
            << units_.length << " m, " << units_.mass << " kg, "
            << units_.time << " s\n";

        for (const std::string& line : lines)
        {
            os << line << '\n';
        }
    }

    // The user's own are the last but the integrator and what goes with it
    const label nAfter = dict_.found("lubrication") ? 2 : 1;
    const label nOwn =
        dict_.found("commands")
      ? dict_.get<List<string>>("commands").size()
      : 0;

    forAll(lines, i)
    {
        const std::string& line = lines[i];
        const std::string origin
        (
            i < lines.size() - nAfter - nOwn || i >= lines.size() - nAfter
          ? "made from constant/particleProperties, see dem/in.particles"
          : "entry 'commands' in constant/particleProperties"
        );

        library_.call
        (
            "command '" + line + "' (" + origin + ')',
            [&line](liggghtsBinding& e) { e.command(line); }
        );
    }
}


void Foam::dew::liggghtsEngine::printSetup() const
{
    Info<< "Particles: " << ledger_.particles;
    if (maxDiameter_ > 0)
    {
        Info<< ", up to d " << maxDiameter_ << " m";
    }
    Info<< ", sub-step " << deltaT_ << " s";
    if (stableDeltaT_ > 0)
    {
        // Above a quarter, crowds may rattle
        Info<< ", " << label(round(100*deltaT_/stableDeltaT_))
            << " % of the stability limit";
    }
    if (restarted())
    {
        Info<< ", continued from the restart of time "
            << mesh_.time().timeName();
    }
    Info<< nl << "Engine: " << library_.engine().version().c_str()
        << ", one unit is " << units_.length << " m, " << units_.mass
        << " kg, " << units_.time << " s" << nl
        << "Gravity: ";
    if (native_)
    {
        Info<< "as in the input file";
    }
    else
    {
        Info<< g_ << (frameAcceleration_ ? " and a shaken frame" : "");
    }
    Info<< nl << endl;
}


Foam::fileName Foam::dew::liggghtsEngine::checkedRestartFile() const
{
    // The master reads it for all ranks
    const fileName path(restartFolder_/restart_.get<fileName>("file"));

    if (Pstream::master())
    {
        const std::pair<long, unsigned long> found(fileChecksum(path));
        // strto..., not sto...: a damaged number is a wrong one, no exception
        const long length =
            std::strtol(restart_.get<string>("bytes").c_str(), nullptr, 10);
        const unsigned long crc =
            std::strtoul(restart_.get<string>("crc32").c_str(), nullptr, 10);

        if (found.first != length || found.second != crc)
        {
            FatalIOErrorInFunction(restart_)
                << "The restart file " << path << " is damaged: "
                << found.first << " bytes, checksum " << found.second
                << "; written were " << length << " bytes, checksum " << crc
                << nl << "Start from an earlier time, or from the beginning"
                << exit(FatalIOError);
        }
    }

    return path;
}
