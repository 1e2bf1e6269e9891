/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "liggghtsEngine.H"
#include "addToRunTimeSelectionTable.H"
#include "fileChecksum.H"
#include "polyMesh.H"
#include "PstreamReduceOps.H"
#include "Time.H"

#include <cmath>
#include <cstring>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(liggghtsEngine);
    addToRunTimeSelectionTable(particleEngine, liggghtsEngine, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

template<class List>
const double* data(const List& list)
{
    return
        list.empty()
      ? nullptr
      : reinterpret_cast<const double*>(list.cdata());
}


template<class List>
double* data(List& list)
{
    return
        list.empty() ? nullptr : reinterpret_cast<double*>(list.data());
}

} // End anonymous namespace

static_assert(sizeof(Foam::label) == sizeof(int), "built for 32-bit labels");
static_assert(sizeof(Foam::vector) == 3*sizeof(double), "built for double");


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dew::newParticles Foam::dew::liggghtsEngine::converted
(
    const particleList& list,
    const label id
) const
{
    newParticles p;
    const label n = list.size();

    const auto copy = [n](const UList<vector>& from, std::vector<double>& to)
    {
        to.resize(3*n);
        if (n)
        {
            std::memcpy(to.data(), from.cdata(), 3*n*sizeof(double));
        }
    };

    copy(list.x, p.x);
    copy(list.v, p.v);
    copy(list.omega, p.omega);
    p.d.assign(list.d.begin(), list.d.end());
    p.T.assign(list.T.begin(), list.T.end());

    for (label i = 0; i < n; i++)
    {
        p.id.push_back(id + i);
        p.type.push_back(list.type[i] + 1);
        p.rho.push_back(materials_->density(list.type[i]));
    }

    return p;
}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

Foam::label Foam::dew::liggghtsEngine::place
(
    const particleList& list,
    const label id
)
{
    needsSetup_ = true;
    const newParticles p(converted(list, id));

    return library_.call
    (
        "placing particles",
        [&p](liggghtsBinding& e) { return label(e.add(p)); }
    );
}


void Foam::dew::liggghtsEngine::overlapping
(
    const particleList& list,
    const scalar share,
    boolList& hit
) const
{
    const newParticles p(converted(list, 1));
    std::vector<char> found;

    library_.call
    (
        "looking for overlaps",
        [&](liggghtsBinding& e) { e.overlapping(p, share, found); }
    );

    forAll(hit, i)
    {
        hit[i] = found[i];
    }
}


Foam::label Foam::dew::liggghtsEngine::advance
(
    const bulkForces& b,
    const scalar t0,
    const scalar t1
)
{
    const scalar steps = (t1 - t0)/deltaT_;
    const label n = label(std::round(steps));

    if (n < 1 || mag(steps - n) > 1e-6*max(steps, scalar(1)))
    {
        FatalErrorInFunction
            << "The time step " << t1 - t0 << " s is " << steps
            << " sub-steps of " << deltaT_ << " s; it must be a whole number"
            << nl << "Change deltaT in system/controlDict, or timeStep.deltaT"
            << " in constant/particleProperties"
            << exit(FatalError);
    }

    if (immersion_ && b.surfaceTension.empty() && state_.size())
    {
        // On this rank only: no collective call on the way out
        immersion_->refuse();
    }

    bulkForcesView view;
    view.Su = data(b.Su);
    view.Sp = data(b.Sp);
    view.U = data(b.U);
    view.Tu = data(b.Tu);
    view.Tp = data(b.Tp);
    view.Omega = data(b.Omega);
    view.Qu = data(b.Qu);
    view.Qp = data(b.Qp);
    view.Tf = data(b.Tf);
    view.Sn = data(b.Sn);
    view.kick = data(b.kick);
    view.heatKick = data(b.heatKick);
    view.kT = data(b.kT);
    view.surfaceX = data(b.surfaceX);
    view.surfaceN = data(b.surfaceN);
    view.surfaceSpeed = data(b.surfaceSpeed);
    view.surfaceCurvature = data(b.surfaceCurvature);
    view.surfaceK = data(b.surfaceK);
    view.surfaceTension = data(b.surfaceTension);
    view.contactAngle = data(b.contactAngle);
    view.planePull = data(b.planePull);
    view.film = b.film;
    view.filmViscosity = data(b.filmViscosity);
    view.addedMass = data(b.addedMass);
    view.nMemory = b.nMemory;
    view.memory = data(b.memory);
    state_.nMemory = b.nMemory;

    library_.call
    (
        "advancing to time " + mesh_.time().timeName(),
        [&](liggghtsBinding& e)
        {
            // In the state's order: pull() has set the engine up
            e.push(view);
            e.run(n);
        }
    );

    return n;
}


void Foam::dew::liggghtsEngine::pull()
{
    library_.call
    (
        "reading the state",
        [this](liggghtsBinding& e)
        {
            if (needsSetup_)
            {
                e.setup();
                needsSetup_ = false;
            }

            state_.setSize(e.size());

            stateView s;
            s.id = state_.id.data();
            s.type = state_.type.data();
            s.x = data(state_.x);
            s.v = data(state_.v);
            s.omega = data(state_.omega);
            s.d = data(state_.d);
            s.rho = data(state_.rho);
            s.T = data(state_.T);
            s.impulse = data(state_.impulse);
            s.angularImpulse = data(state_.angularImpulse);
            s.heat = data(state_.heat);
            s.impulseSp = data(state_.impulseSp);
            s.heatSp = data(state_.heatSp);
            s.memory = data(state_.memory);
            e.pull(s);

            for (label& type : state_.type)
            {
                type--;
            }

            // The engine wraps only when it rebuilds its lists
            if (box_.anyPeriodic())
            {
                for (point& x : state_.x)
                {
                    x = box_.wrapped(x);
                }
            }

            label n = 0;
            scalar mass = 0, volume = 0;
            vector impulse(Zero);
            scalar heat = 0;
            for (const departedParticle& p : e.departed())
            {
                n++;
                mass += p.mass;
                volume += p.volume;
                impulse += vector(p.impulse[0], p.impulse[1], p.impulse[2]);
                heat += p.heat;
            }
            ledger_.colloidEnergy =
                returnReduce(e.colloidEnergy(), sumOp<scalar>());
            ledger_.departed = returnReduce(n, sumOp<label>());
            ledger_.departedMass = returnReduce(mass, sumOp<scalar>());
            ledger_.departedVolume = returnReduce(volume, sumOp<scalar>());
            ledger_.departedImpulse = returnReduce(impulse, sumOp<vector>());
            ledger_.departedHeat = returnReduce(heat, sumOp<scalar>());
            ledger_.wallHeat = returnReduce(e.wallHeat(), sumOp<scalar>());
            ledger_.departedTotal += ledger_.departed;
            ledger_.impulse += ledger_.departedImpulse;
            ledger_.heat += ledger_.departedHeat;

            for (const std::string& warning : e.warnings())
            {
                if (Pstream::master())
                {
                    Info<< "Particle engine warns: " << warning.c_str()
                        << endl;
                }
            }
        }
    );
}


void Foam::dew::liggghtsEngine::writeRestart
(
    dictionary& dict,
    const fileName& path
) const
{
    const fileName file("liggghts.restart");

    library_.call
    (
        "writing the restart",
        [&](liggghtsBinding& e) { e.writeRestart(path/file); }
    );

    std::pair<long, unsigned long> written(0, 0);
    if (Pstream::master())
    {
        written = fileChecksum(path/file);
    }

    dict.add("file", file);
    dict.add("bytes", string(std::to_string(written.first)));
    dict.add("crc32", string(std::to_string(written.second)));
    dict.add("deltaT", deltaT_);
    dict.add("unitLength", units_.length);
    dict.add("unitMass", units_.mass);
    dict.add("unitTime", units_.time);
    dict.add("boxMin", engineBox_.min());
    dict.add("boxMax", engineBox_.max());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dew::liggghtsEngine::contacts
(
    List<scalar>& number,
    List<symmTensor>& moment
) const
{
    number.setSize(state_.size());
    moment.setSize(state_.size());

    contactView view;
    view.number = number.data();
    view.moment = data(moment);

    library_.call
    (
        "looking at the contacts",
        [&view](liggghtsBinding& e) { e.contacts(view); }
    );

    return true;
}
