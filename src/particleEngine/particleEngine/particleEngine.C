/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleEngine.H"
#include "clockTime.H"
#include "IStringStream.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "polyMesh.H"
#include "sphereGrid.H"
#include "Time.H"
#include "userEntry.H"

#include <cmath>
#include <fstream>
#include <sstream>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(particleEngine);
    defineRunTimeSelectionTable(particleEngine, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleEngine::particleEngine
(
    const polyMesh& mesh,
    const dictionary& dict
)
:
    regIOobject
    (
        IOobject
        (
            "particles",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        )
    ),
    mesh_(mesh),
    dict_(dict),
    symmetry_(mesh),
    box_(mesh, symmetry_, dict),
    heat_(dict.getOrDefault<Switch>("heat", Switch(false))),
    nextId_(1),
    engineTime_(0),
    writeTime_(0)
{
    state_.thermal = heat_;

    if (!(mesh.time().deltaTValue() > 0))
    {
        FatalErrorInFunction
            << "Entry 'deltaT' in system/controlDict is "
            << mesh.time().deltaTValue() << nl
            << "It must be greater than zero"
            << exit(FatalError);
    }

    if (dict.found("materials"))
    {
        materials_.reset
        (
            new materials
            (
                userEntry::subDict(dict, "materials"),
                userEntry::optionalDict(dict, "contacts"),
                heat_
            )
        );

        const dictionary& insertionDict =
            userEntry::optionalDict(dict, "insertion");
        insertion_.setSize(insertionDict.size());
        label n = 0;

        for (const entry& e : insertionDict)
        {
            insertion_.set
            (
                n++,
                insertionModel::New
                (
                    e.keyword(),
                    userEntry::dictOf(insertionDict, e),
                    materials_(),
                    box_,
                    mesh.time()
                )
            );
        }
    }

    readRestart();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::fileName Foam::dew::particleEngine::restartPath
(
    const fileName& timePath
) const
{
    return timePath/"uniform"/"particles";
}


void Foam::dew::particleEngine::readRestart()
{
    // The master's processor directory, where decomposePar links "uniform";
    // it does not where it had no fields to decompose
    const fileName timeName(mesh_.time().timeName());
    fileName path(restartPath(mesh_.time().path()/timeName));
    bool found = Pstream::master() && isFile(path/"engine");

    if (Pstream::master() && !isDir(path))
    {
        path = restartPath(mesh_.time().globalPath()/timeName);
        found = isFile(path/"engine");
    }
    Pstream::scatter(found);
    Pstream::scatter(path);

    if (!found)
    {
        // Something of a restart, but not the dictionary that is written last
        bool part = Pstream::master() && isDir(path);
        Pstream::scatter(part);
        if (part)
        {
            FatalErrorInFunction
                << "The restart of the particles is incomplete: no file "
                << path/"engine" << nl
                << "Start from an earlier time, or remove the directory to"
                << " begin anew at this time"
                << exit(FatalError);
        }
        return;
    }

    restartFolder_ = path;

    // As text: every rank reads the same numbers
    string text;
    if (Pstream::master())
    {
        std::ifstream is(path/"engine");
        std::ostringstream os;
        os << is.rdbuf();
        text = os.str();
    }
    Pstream::scatter(text);

    // The last entry tells that all of it is there, before it is parsed
    if (text.find("complete") == std::string::npos)
    {
        FatalErrorInFunction
            << "The restart of the particles in " << path/"engine"
            << " is truncated" << nl
            << "Start from an earlier time, or from the beginning"
            << exit(FatalError);
    }

    IStringStream is(text);
    is.name() = path/"engine";
    restart_ = dictionary(is);
    restart_.name() = path/"engine";

    const wordList names(restart_.get<wordList>("materials"));
    if (materials_ && names != materials_->names())
    {
        FatalIOErrorInFunction(restart_)
            << "The restart was written with the materials "
            << flatOutput(names) << ", the case has "
            << flatOutput(materials_->names()) << nl
            << "Keep the materials and their order, or start from the"
            << " beginning"
            << exit(FatalIOError);
    }

    if (restart_.get<word>("engine") != dict_.get<word>("engine"))
    {
        FatalIOErrorInFunction(restart_)
            << "The restart was written by the engine "
            << restart_.get<word>("engine") << ", the case asks for "
            << dict_.get<word>("engine")
            << exit(FatalIOError);
    }

    nextId_ = restart_.get<label>("nextId");
    ledger_.insertedTotal = restart_.get<label>("inserted");
    ledger_.departedTotal = restart_.get<label>("departed");

    for (insertionModel& model : insertion_)
    {
        const dictionary* dict =
            restart_.subDict("insertion").findDict(model.name());
        if (dict)
        {
            model.read(*dict);
        }
    }
}


void Foam::dew::particleEngine::checkInside
(
    const insertionModel& model,
    const particleList& list
) const
{
    (void)mesh_.tetBasePtIs();      // built by all ranks together

    // The axis of a wedge is on its bounds
    boundBox local(mesh_.points(), false);
    local.inflate(1e-9);
    labelList inside(list.size(), Zero);

    forAll(inside, i)
    {
        const point x(symmetry_.fold(list.x[i]));
        inside[i] =
            local.contains(x) && mesh_.findCell(symmetry_.offAxis(x)) >= 0;
    }
    Pstream::listCombineGather(inside, maxEqOp<label>());

    if (!Pstream::master())
    {
        return;
    }

    label outside = 0, first = -1;
    forAll(inside, i)
    {
        if (!inside[i])
        {
            outside++;
            first = first < 0 ? i : first;
        }
    }

    if (outside)
    {
        FatalIOErrorInFunction(model.dict())
            << outside << " particles of insertion '" << model.name()
            << "' lie outside the mesh; the first at " << list.x[first]
            << nl << "The mesh spans " << box_.bounds() << nl
            << "Move them, or change the region or the mesh"
            << exit(FatalIOError);
    }
}


void Foam::dew::particleEngine::insertInitial()
{
    const scalar share = userEntry::notNegativeOr
    (
        dict_, "overlapTolerance", dimless, 0.05
    );

    for (insertionModel& model : insertion_)
    {
        particleList list;

        while (model.initial(list))
        {
            for (point& x : list.x)
            {
                x = box_.wrapped(x);
            }
            checkInside(model, list);

            // Among themselves, and with those placed before
            boolList hit(list.size(), false);
            overlapping(list, share, hit);

            sphereGrid grid(box_, 0.5*model.maxDiameter());
            forAll(list.x, i)
            {
                const scalar r = 0.5*list.d[i];
                const label j = grid.overlapping(list.x[i], r, share);
                grid.append(list.x[i], r);

                if (hit[i] || j >= 0)
                {
                    FatalIOErrorInFunction(model.dict())
                        << "Particle " << nextId_ + i << " of insertion '"
                        << model.name() << "' at " << list.x[i] << " with d "
                        << list.d[i] << " overlaps with ";
                    if (j >= 0)
                    {
                        FatalIOError
                            << "particle " << nextId_ + j << " at "
                            << list.x[j] << " with d " << list.d[j];
                    }
                    else
                    {
                        FatalIOError<< "one placed before it";
                    }
                    FatalIOError
                        << nl << "by more than overlapTolerance (" << share
                        << ") of the smaller radius. Move them, or raise"
                        << " overlapTolerance in particleProperties"
                        << exit(FatalIOError);
                }
            }

            const label n = place(list, nextId_);

            if (n != list.size())
            {
                FatalIOErrorInFunction(model.dict())
                    << "Of " << list.size() << " particles only " << n
                    << " lie in the engine's box; the mesh spans "
                    << box_.bounds() << exit(FatalIOError);
            }
            nextId_ += n;
            ledger_.insertedTotal += n;
        }
    }
}


void Foam::dew::particleEngine::insertDuring(const scalar t0, const scalar t1)
{
    ledger_.inserted = 0;
    ledger_.waiting = 0;

    for (insertionModel& model : insertion_)
    {
        particleList list;
        scalar from = t0;

        for (label attempt = 0; attempt < model.attempts(); attempt++)
        {
            model.propose(from, t1, list);
            from = t1;

            if (list.size() == 0)
            {
                if (model.waiting() == 0)
                {
                    break;
                }
                continue;
            }
            for (point& x : list.x)
            {
                x = box_.wrapped(x);
            }

            boolList hit(list.size(), false);
            overlapping(list, 0, hit);

            boolList in(hit.size());
            forAll(in, i)
            {
                in[i] = !hit[i];
            }
            model.placed(in);
            list.subset(in);

            const label n = list.size() ? place(list, nextId_) : 0;
            nextId_ += list.size();
            ledger_.inserted += n;

            if (n != list.size())
            {
                FatalIOErrorInFunction(model.dict())
                    << "The region of insertion '" << model.name()
                    << "' reaches out of the engine's box; the mesh spans "
                    << box_.bounds() << exit(FatalIOError);
            }
        }

        ledger_.waiting += model.waiting();
    }

    ledger_.insertedTotal += ledger_.inserted;
}


void Foam::dew::particleEngine::account()
{
    const label bad = state_.findNotFinite();
    if (bad >= 0)
    {
        // On this rank only: no collective call on the way out
        FatalErrorInFunction
            << "Particle " << state_.id[bad] << " is not finite at time "
            << mesh_.time().timeName() << nl
            << "position " << state_.x[bad] << " velocity " << state_.v[bad]
            << " impulse received " << state_.impulse[bad] << nl
            << "Look for a time step, a force or a velocity that is too large"
            << exit(FatalError);
    }

    scalar energy = 0;
    vector impulse(Zero);
    scalar heat = 0;

    for (label i = 0; i < state_.size(); i++)
    {
        energy += state_.kineticEnergy(i);
        impulse += state_.impulse[i];
        heat += heat_ ? state_.heat[i] : 0;
    }

    const label before = ledger_.particles;
    ledger_.particles = returnReduce(state_.size(), sumOp<label>());

    const label expected = before + ledger_.inserted - ledger_.departed;
    const label surplus = ledger_.particles - expected;

    if (ledger_.subSteps > 0 && surplus > 0)
    {
        // The engine's own insertion, from native commands
        ledger_.inserted += surplus;
        ledger_.insertedTotal += surplus;

        label last = nextId_ - 1;
        for (const label id : state_.id)
        {
            last = max(last, id);
        }
        nextId_ = returnReduce(last, maxOp<label>()) + 1;
    }
    if (ledger_.subSteps > 0 && surplus < 0)
    {
        FatalErrorInFunction
            << "The engine lost " << -surplus << " of "
            << expected << " particles at time " << mesh_.time().timeName()
            << nl << "A particle that crosses the domain, or a rank's part of"
            << " it, within one sub-step cannot be followed. Look for a"
            << " velocity or a sub-step that is too large"
            << exit(FatalError);
    }
    ledger_.kineticEnergy = returnReduce(energy, sumOp<scalar>());
    ledger_.impulse += returnReduce(impulse, sumOp<vector>());
    ledger_.heat += returnReduce(heat, sumOp<scalar>());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::wordList& Foam::dew::particleEngine::materialNames() const
{
    return materials_ ? materials_->names() : wordList::null();
}


void Foam::dew::particleEngine::evolve(const bulkForces& forces)
{
    const scalar t1 = mesh_.time().value();
    const scalar t0 = t1 - mesh_.time().deltaTValue();
    const clockTime clock;

    forces.check(state_.size());

    ledger_.impulse = Zero;
    ledger_.heat = 0;

    ledger_.subSteps = advance(forces, t0, t1);
    insertDuring(t0, t1);
    pull();

    engineTime_ += clock.elapsedTime();

    account();
}


bool Foam::dew::particleEngine::writeObject
(
    IOstream::streamFormat,
    IOstream::versionNumber,
    IOstream::compressionType,
    const bool
) const
{
    const clockTime clock;
    const fileName path
    (
        restartPath(mesh_.time().path()/mesh_.time().timeName())
    );

    if (Pstream::master())
    {
        mkDir(path);
        rm(path/"engine");
    }

    // Entries pass through text: no digit may be lost
    const unsigned int precision = IOstream::defaultPrecision(17);

    dictionary dict;
    dict.add("engine", dict_.get<word>("engine"));
    dict.add("materials", materialNames());
    dict.add("nextId", nextId_);
    dict.add("inserted", ledger_.insertedTotal);
    dict.add("departed", ledger_.departedTotal);

    dictionary insertionDict;
    for (const insertionModel& model : insertion_)
    {
        dictionary one;
        model.write(one);
        insertionDict.add(model.name(), one);
    }
    dict.add("insertion", insertionDict);

    writeRestart(dict, path);

    // Last: without it the restart does not exist
    dict.add("complete", true);

    if (Pstream::master())
    {
        OFstream os(path/"engine");
        dict.write(os, false);
    }

    IOstream::defaultPrecision(precision);
    writeTime_ += clock.elapsedTime();

    return true;
}
