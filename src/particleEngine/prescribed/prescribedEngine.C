/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "prescribedEngine.H"
#include "addToRunTimeSelectionTable.H"
#include "exponentialRelaxation.H"
#include "impulseSensitivity.H"
#include "particleRecord.H"
#include "polyMesh.H"
#include "PstreamReduceOps.H"
#include "sphereGrid.H"
#include "Time.H"
#include "timeIntegral.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(prescribedEngine);
    addToRunTimeSelectionTable(particleEngine, prescribedEngine, dictionary);
}
}

namespace
{
    // Particles dealt to one rank before the next one's turn
    constexpr Foam::label block = 64;
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::prescribedEngine::prescribedEngine
(
    const polyMesh& mesh,
    const dictionary& dict
)
:
    particleEngine(mesh, dict),
    displacement_
    (
        restarted() ? restart_.get<vector>("displacement") : vector(Zero)
    )
{
    userEntry::onlyThese
    (
        dict,
        {
            "FoamFile", "engine", "periodic", "heat", "overlapTolerance",
            "materials", "insertion", "velocity", "coupling", "output"
        }
    );

    if (!materials_)
    {
        FatalIOErrorInFunction(dict)
            << "No materials: add the sub-dictionaries materials and insertion"
            << exit(FatalIOError);
    }

    for (const insertionModel& model : insertion_)
    {
        if (model.attempts() > 0)
        {
            FatalIOErrorInFunction(model.dict())
                << "Insertion '" << model.name() << "' lets particles in"
                << " during the run; prescribed particles are there from the"
                << " start" << nl << "Use insertion of type file or packed, or"
                << " the engine liggghts"
                << exit(FatalIOError);
        }
    }

    if (dict.found("velocity"))
    {
        velocity_ = Function1<vector>::New("velocity", dict);
    }

    // Those of a restart are the same ones, further on their path
    nextId_ = 1;
    ledger_.insertedTotal = 0;
    insertInitial();

    if (restarted() && heat_)
    {
        readTemperatures();
    }

    const scalar t = mesh.time().value();
    advance(bulkForces(), t, t);
    pull();
    account();

    Info<< "Particles: " << ledger_.particles << ", prescribed" << nl << endl;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::prescribedEngine::readTemperatures()
{
    if (!restart_.found("temperatures"))
    {
        FatalIOErrorInFunction(restart_)
            << "The restart was written without temperatures, the case has"
            << " heat on" << nl
            << "Switch heat off, or start from the beginning"
            << exit(FatalIOError);
    }

    const fileName path(restartFolder_/restart_.get<fileName>("temperatures"));
    boolList found;
    state_.T = particleRecord::read(path, state_.id, 1, found);

    label missing = 0;
    for (const bool one : found)
    {
        missing += !one;
    }
    reduce(missing, sumOp<label>());

    // One message: it ends the run on all ranks
    if (missing && Pstream::master())
    {
        FatalIOErrorInFunction(restart_)
            << "No temperature of " << missing << " particles in " << path
            << nl << "The insertion is another than before the restart: bring"
            << " it back, or start from the beginning"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::label Foam::dew::prescribedEngine::place
(
    const particleList& list,
    const label id
)
{
    for (label i = 0; i < list.size(); i++)
    {
        if (((id + i - 1)/block) % Pstream::nProcs() != Pstream::myProcNo())
        {
            continue;
        }

        state_.id.append(id + i);
        state_.type.append(list.type[i]);
        state_.d.append(list.d[i]);
        state_.rho.append(materials_->density(list.type[i]));
        if (heat_)
        {
            state_.T.append(list.T[i]);
        }
        x0_.append(list.x[i]);
    }
    state_.x = x0_;
    state_.setSize(x0_.size());

    return list.size();
}


void Foam::dew::prescribedEngine::overlapping
(
    const particleList& list,
    const scalar share,
    boolList& hit
) const
{
    scalar r = 0;
    forAll(list.d, i)
    {
        r = max(r, 0.5*list.d[i]);
    }
    forAll(state_.d, i)
    {
        r = max(r, 0.5*state_.d[i]);
    }

    sphereGrid grid(box_, returnReduce(r, maxOp<scalar>()));
    forAll(x0_, i)
    {
        grid.append(x0_[i], 0.5*state_.d[i]);
    }

    forAll(hit, i)
    {
        hit[i] = grid.overlapping(list.x[i], 0.5*list.d[i], share) >= 0;
    }
    Pstream::listCombineGather(hit, orEqOp<bool>());
    Pstream::listCombineScatter(hit);
}


Foam::label Foam::dew::prescribedEngine::advance
(
    const bulkForces& b,
    const scalar t0,
    const scalar t1
)
{
    const scalar dt = t1 - t0;
    const vector v(velocity_ ? velocity_->value(t1) : vector(Zero));

    if (velocity_ && t1 > t0)
    {
        displacement_ += timeIntegral(velocity_(), t0, t1);
    }

    state_.nMemory = b.nMemory;
    state_.memory = b.memory;

    forAll(x0_, i)
    {
        state_.x[i] = box_.wrapped(x0_[i] + displacement_);
        state_.v[i] = v;
        state_.omega[i] = Zero;

        state_.impulse[i] = Zero;
        state_.angularImpulse[i] = Zero;

        if (b.Su.size()) state_.impulse[i] += dt*b.Su[i];
        if (b.Sp.size()) state_.impulse[i] += dt*b.Sp[i]*(b.U[i] - v);
        if (b.Tu.size()) state_.angularImpulse[i] += dt*b.Tu[i];
        if (b.Tp.size()) state_.angularImpulse[i] += dt*b.Tp[i]*b.Omega[i];

        state_.impulseSp[i] = b.Sp.size() ? b.Sp[i]*dt : 0;

        if (heat_)
        {
            const scalar mc =
                state_.mass(i)*materials_->heatCapacity(state_.type[i]);
            const scalar Qp = b.Qp.size() ? b.Qp[i] : 0;

            if (b.heatKick.size()) state_.T[i] += b.heatKick[i]/mc;

            scalar Q = 0;
            if (b.Qu.size()) Q += b.Qu[i];
            if (b.Qp.size()) Q += Qp*(b.Tf[i] - state_.T[i]);

            state_.heat[i] = Q*dt*phi1(Qp*dt/mc);
            state_.heatSp[i] = impulseSensitivity(mc, Qp, dt, 0);
            state_.T[i] += state_.heat[i]/mc;
        }
    }

    return 0;
}


void Foam::dew::prescribedEngine::pull()
{
    // Nothing leaves
}


void Foam::dew::prescribedEngine::writeRestart
(
    dictionary& dict,
    const fileName& path
) const
{
    dict.add("displacement", displacement_);

    if (heat_)
    {
        const fileName file("temperatures");
        particleRecord::write(path/file, state_.id, state_.T, 1);
        dict.add("temperatures", file);
    }
}
