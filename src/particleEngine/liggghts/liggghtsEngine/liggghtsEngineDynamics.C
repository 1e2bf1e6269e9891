/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// What moves the particles: gravity, dynamics, laws of pairs, the sub-step

#include "liggghtsEngine.H"
#include "Enum.H"
#include "gravity.H"
#include "liggghtsTimeStep.H"
#include "polyMesh.H"
#include "Time.H"
#include "userEntry.H"

#include <cmath>

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::liggghtsEngine::readGravity()
{
    g_ = gravity(mesh_);

    if (dict_.found("frameAcceleration"))
    {
        frameAcceleration_ =
            Function1<vector>::New("frameAcceleration", dict_);
    }
}


void Foam::dew::liggghtsEngine::readDynamics()
{
    const Enum<bool> types({{false, "inertial"}, {true, "overdamped"}});
    const dictionary& dict = userEntry::optionalDict(dict_, "dynamics");

    userEntry::onlyThese(dict, {"type", "viscosity", "seed"});
    state_.overdamped = types.getOrDefault("type", dict, false);
    seed_ = label(userEntry::notNegativeOr(dict, "seed", dimless, 1));

    if (state_.overdamped)
    {
        viscosity_ =
            userEntry::positive(dict, "viscosity", dimDynamicViscosity);

        if (native_)
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'input' and dynamics of type overdamped exclude each"
                << " other: its contacts would have dashpots" << nl
                << "Remove one of them"
                << exit(FatalIOError);
        }
    }
    else if (dict.found("viscosity"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'viscosity' in " << dict.dictName() << " is of no use for"
            << " dynamics of type inertial" << nl
            << "Remove it, or set 'type overdamped;'"
            << exit(FatalIOError);
    }
}


void Foam::dew::liggghtsEngine::hinder(liggghtsBinding& e) const
{
    const dictionary& fluid = userEntry::optionalDict(dict_, "fluid");
    if (!fluid.found("hindered"))
    {
        return;
    }
    const dictionary& dict = userEntry::subDict(fluid, "hindered");
    userEntry::onlyThese(dict, {"walls", "minGap"});

    if (fluid.found("surface") || fluid.found("velocity"))
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'hindered' is for a fluid at rest without a surface" << nl
            << "Remove it, or the entries surface and velocity"
            << exit(FatalIOError);
    }

    const scalar minGap = userEntry::positive(dict, "minGap", dimLength);
    const dictionary& walls = userEntry::optionalDict(dict_, "walls");
    std::vector<double> planes;

    for (const word& name : dict.get<wordList>("walls"))
    {
        const dictionary& wall = userEntry::subDict(walls, name);
        if (wall.get<word>("type") != "plane" || wall.found("motion"))
        {
            FatalIOErrorInFunction(wall)
                << "Wall '" << name << "' cannot hinder mobility: only walls of"
                << " type plane at rest can" << nl
                << "Remove it from fluid.hindered.walls"
                << exit(FatalIOError);
        }
        const vector x(userEntry::point(wall, "point", dimLength));
        const vector n(userEntry::direction(wall, "normal"));
        planes.insert(planes.end(), {x.x(), x.y(), x.z(), n.x(), n.y(), n.z()});
    }

    if (planes.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'walls' in " << dict.dictName() << " is empty" << nl
            << "Name walls of type plane, or remove the entry 'hindered'"
            << exit(FatalIOError);
    }
    e.hinderingWalls(planes, minGap);
}


Foam::scalar Foam::dew::liggghtsEngine::smallestRadius() const
{
    scalar least = GREAT;
    for (const insertionModel& model : insertion_)
    {
        least = min(least, 0.5*model.minDiameter());
    }
    return least;
}


void Foam::dew::liggghtsEngine::readColloids()
{
    if (dict_.found("colloids"))
    {
        colloids_.reset
        (
            new colloidForces
            (
                userEntry::subDict(dict_, "colloids"),
                materials_(),
                smallestRadius()
            )
        );
    }
}


void Foam::dew::liggghtsEngine::readDissipative()
{
    if (dict_.found("dissipative"))
    {
        dissipative_.reset
        (
            new dissipativeForces
            (
                userEntry::subDict(dict_, "dissipative"), materials_(), box_
            )
        );
    }
}


void Foam::dew::liggghtsEngine::readImmersion()
{
    if (dict_.found("immersion"))
    {
        immersion_.reset
        (
            new immersionForces
            (
                userEntry::subDict(dict_, "immersion"), box_, maxDiameter_
            )
        );
    }
}


void Foam::dew::liggghtsEngine::checkPairLaws() const
{
    if (dict_.found("dissipative") && state_.overdamped)
    {
        FatalIOErrorInFunction(dict_)
            << "Entry 'dissipative' and dynamics of type overdamped exclude"
            << " each other: its friction and noise act on velocities, which"
            << " are those of inertia" << nl
            << "Remove one of them"
            << exit(FatalIOError);
    }
    if (dict_.found("conduction") && !heat_)
    {
        FatalIOErrorInFunction(dict_)
            << "Entry 'conduction' is of no use without temperatures" << nl
            << "Remove it, or set 'heat on;'"
            << exit(FatalIOError);
    }
    if (dict_.found("lubrication") && state_.overdamped)
    {
        FatalIOErrorInFunction(dict_)
            << "Entry 'lubrication' and dynamics of type overdamped exclude"
            << " each other: the drag of a step is not known before it" << nl
            << "Remove one of them"
            << exit(FatalIOError);
    }
}


void Foam::dew::liggghtsEngine::checkConduction
(
    const conductionModel& model
) const
{
    if (state_.overdamped && model.needsInertia())
    {
        FatalIOErrorInFunction(dict_)
            << "Conduction " << model.type() << " and dynamics of type"
            << " overdamped exclude each other: there are no impacts" << nl
            << "Use conduction contact, BatchelorOBrien or none"
            << exit(FatalIOError);
    }
}


void Foam::dew::liggghtsEngine::chooseTimeStep(const liggghtsCommands& commands)
{
    const dictionary& dict = userEntry::optionalDict(dict_, "timeStep");
    userEntry::onlyThese(dict, {"fraction", "deltaT"});

    const scalar usual = state_.overdamped ? 0.2 : 0.1;
    const scalar fraction =
        userEntry::positiveOr(dict, "fraction", dimless, usual);

    // Any material may come in the smallest size
    const scalar Rmin = smallestRadius();

    scalar stable = GREAT, wanted = GREAT;
    for (label i = 0; i < materials_->size(); i++)
    {
        if (state_.overdamped)
        {
            const scalar limit = commands.overdampedTimeStep
            (
                i, Rmin, viscosity_
            );
            stable = min(stable, limit);
            wanted = min(wanted, fraction*limit);
            continue;
        }
        stable = min(stable, commands.stableTimeStep(i, Rmin));
        wanted = min(wanted, commands.timeStep(i, Rmin, fraction));
    }

    string cause("contacts");
    if (colloids_)
    {
        const scalar limit = colloids_->stableTimeStep(Rmin, viscosity_);
        cause = limit < stable ? string("colloidal forces") : cause;
        stable = min(stable, limit);
        wanted = min(wanted, fraction*limit);
    }

    if (dissipative_)
    {
        const scalar friction = dissipative_->frictionTime(Rmin);
        const scalar limit = min(friction, dissipative_->stiffnessTime(Rmin));
        if (limit < stable)
        {
            cause =
                limit == friction
              ? "friction of dissipative pairs, mu/gamma,"
              : "conservative force of dissipative pairs, 2 sqrt(mu rc/a),";
        }
        stable = min(stable, limit);
        wanted = min(wanted, fraction*limit);
    }

    stableDeltaT_ = stable;

    const scalar step = mesh_.time().deltaTValue();

    if (restarted())
    {
        deltaT_ = restart_.get<scalar>("deltaT");

        const scalar asked =
            userEntry::positiveOr(dict, "deltaT", dimTime, deltaT_);
        if (mag(asked/deltaT_ - 1) > 1e-9)
        {
            FatalIOErrorInFunction(dict)
                << "Entry 'deltaT' in " << dict.dictName() << " is " << asked
                << ", the restart was made with a sub-step of " << deltaT_
                << nl << "The sub-step is constant for a run: remove the entry,"
                << " or start from the beginning"
                << exit(FatalIOError);
        }
    }
    else if (dict.found("deltaT"))
    {
        deltaT_ = userEntry::positive(dict, "deltaT", dimTime);
    }
    else
    {
        // The first of adjustable steps says nothing of those to come
        const bool adjustable =
            mesh_.time().controlDict().getOrDefault<bool>
            (
                "adjustTimeStep", false
            );
        deltaT_ =
            adjustable
          ? wanted
          : step/std::ceil(step/wanted*(1 - 1e-12));
    }

    if (deltaT_ > stable)
    {
        FatalIOErrorInFunction(dict_)
            << "The sub-step " << deltaT_ << " s is above the stability limit "
            << stable << " s of the " << cause.c_str() << " (smallest radius "
            << Rmin << " m)" << nl
            << "Lower timeStep.deltaT (or fraction, now " << fraction
            << "; recommended " << usual << ": " << wanted*usual/fraction
            << " s)"
            << exit(FatalIOError);
    }
}
