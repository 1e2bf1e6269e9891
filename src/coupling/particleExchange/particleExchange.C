/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleExchange.H"
#include "Time.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeNameAndDebug(particleExchange, 0);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleExchange::particleExchange
(
    const fvMesh& mesh,
    const dictionary& particleProperties,
    const carrierFields& fluid,
    const particleState& state,
    const vector& g
)
:
    regIOobject
    (
        IOobject
        (
            "particleExchange",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        )
    ),
    mesh_(mesh),
    dict_(userEntry::subDict(particleProperties, "coupling")),
    fluid_(fluid),
    state_(state),
    g_(g),
    linear_
    (
        Enum<bool>({{true, "linear"}, {false, "cell"}}).getOrDefault
        (
            "interpolation", dict_, true
        )
    ),
    carrierVelocity_(dict_.getOrDefault<Switch>("carrierVelocity", true)),
    voidFraction_
    (
        voidFractionModel::New(userEntry::subDict(dict_, "voidFraction"))
    ),
    laws_(dict_, fluid.offered()),
    seenVelocity_(dict_, fluid.offered()),
    needs_(laws_.needs()),
    map_(mesh, voidFraction_->support(mesh)),
    smoothing_(smoothing::New(dict_, mesh)),
    alphac_(dict_, voidFraction_(), smoothing_(), map_, mesh),
    momentum_(dict_, map_, smoothing_(), fluid.U),
    kicked_(false),
    ledger_(mesh.time(), map_.symmetry().wedge()),
    relaxation_(0),
    mapTime_(0),
    exchangeTime_(0)
{
    userEntry::onlyThese
    (
        dict_,
        {
            "model", "voidFraction", "alphacMin", "alphacTime", "smoothing",
            "interpolation", "carrierVelocity", "seenVelocity", "momentum",
            "heat", "forces",
            "heatTransfer", "scalars"
        }
    );

    needs_.add(seenVelocity_.needs());

    if (particleProperties.found("fluid"))
    {
        FatalIOErrorInFunction(particleProperties)
            << "Entry 'fluid' is for particles alone (demFoam): this solver has"
            << " a fluid of its own" << nl << "Remove the entry"
            << exit(FatalIOError);
    }
    if (particleProperties.found("frameAcceleration"))
    {
        frameAcceleration_ =
            Function1<vector>::New("frameAcceleration", particleProperties);
    }

    if (dict_.found("heat") && !dict_.found("heatTransfer"))
    {
        FatalIOErrorInFunction(dict_)
            << "Entry 'heat' needs the entry 'heatTransfer'" << nl
            << "Add a law, e.g. heatTransfer { type RanzMarshall; }, or remove"
            << " 'heat'" << exit(FatalIOError);
    }
    if (dict_.found("heatTransfer"))
    {
        if (!state_.thermal)
        {
            FatalIOErrorInFunction(dict_)
                << "Entry 'heatTransfer' needs particles with a temperature"
                << nl << "Add 'heat on;' to " << particleProperties.name()
                << ", or remove the entry" << exit(FatalIOError);
        }
        if (!fluid_.T || !fluid_.kappa || !fluid_.Cp)
        {
            FatalIOErrorInFunction(dict_)
                << "Entry 'heatTransfer' needs a fluid with a temperature"
                << " that gives heat to particles" << nl
                << "In cfdDemFoam add a field T to the start time, and Cp and"
                << " kappa to constant/transportProperties; in"
                << " interEvapDemFoam set 'energy on;' in"
                << " constant/phaseChangeProperties; else remove the entry"
                << exit(FatalIOError);
        }
        heatTransfer_ =
            heatTransferModel::New(userEntry::subDict(dict_, "heatTransfer"));
        heat_.reset
        (
            new heatExchange(dict_, map_, smoothing_(), *fluid_.T)
        );
    }
    ledger_.thermal = bool(heat_);

    scalars_ =
        scalarExchange::all(dict_, fluid_, map_, smoothing_(), state_);
    const label nLaws = needs_.memory;
    needs_.memory += scalarExchange::N_VALUES*scalars_.size();
    forAll(scalars_, k)
    {
        scalars_[k].place
        (
            nLaws + scalarExchange::N_VALUES*k, needs_.memory
        );
    }

    for (const particleForce& law : laws_.laws())
    {
        ranges_.add(law.type(), law.ranges());
    }
    if (heatTransfer_)
    {
        ranges_.add(heatTransfer_->type(), heatTransfer_->ranges());
    }

    if
    (
        state_.overdamped
     && momentum_.scheme() == momentumExchange::schemes::semiImplicit
    )
    {
        FatalIOErrorInFunction(dict_)
            << "Entry 'momentum' is semiImplicit, but particles in overdamped"
            << " dynamics have no inertia: nothing that the fluid's step owes"
            << " them could be given to them" << nl
            << "Set 'momentum explicit;' or 'momentum none;', or dynamics of"
            << " type inertial" << exit(FatalIOError);
    }

    if (needs().memory > bulkForces::maxMemory)
    {
        FatalIOErrorInFunction(dict_)
            << "Laws, seenVelocity and scalars keep " << needs().memory
            << " values with each particle, the engine carries at most "
            << bulkForces::maxMemory << nl
            << "Lower 'intervals' of the law 'history'" << exit(FatalIOError);
    }

    if (state_.overdamped && laws_.needs().addedMass)
    {
        FatalIOErrorInFunction(dict_)
            << "A law in 'forces' has an added mass, but particles in overdamped"
            << " dynamics have no inertia" << nl
            << "Remove virtualMass and history, or set dynamics of type inertial"
            << exit(FatalIOError);
    }

    if (!carrierVelocity_ && twoWay())
    {
        FatalIOErrorInFunction(dict_)
            << "Entry 'carrierVelocity' is off: particles see a fluid at rest,"
            << " and the moving one would feel the force of another" << nl
            << "Set 'momentum none;', or remove 'carrierVelocity'"
            << exit(FatalIOError);
    }

    if (map_.symmetry().wedge() && needs().gradU)
    {
        Info<< "WARNING: a law needs the gradient of the velocity, which on a"
            << " wedge is that in its plane: without the terms of swirl and"
            << " of the rings (U/r)" << nl << endl;
    }

    findMap();
    const bool goesOn = readKicks();
    alphac_.start(state_, goesOn, ledger_);
    readMemory(goesOn);
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::particleExchange::findMap()
{
    const clockTime clock;
    map_.correct(state_.x, state_.d);
    smoothing_->correct(state_.d);
    ledger_.outside = map_.nOutside();
    mapTime_ += clock.elapsedTime();
}


void Foam::dew::particleExchange::updateKicks() const
{
    if (!kicked_)
    {
        momentum_.kicks(kick_);
        if (heat_)
        {
            heat_->kicks(heatKick_);
        }
        for (const scalarExchange& s : scalars_)
        {
            s.updateKicks();
        }
        kicked_ = true;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::particleExchange::update()
{
    // What is pending belongs to the mesh before
    if (!kicked_)
    {
        FatalErrorInFunction
            << "The mesh changed before the balance of the step was made"
            << abort(FatalError);
    }
    smoothing_->update();
    if (mesh_.topoChanging())
    {
        findMap();
        alphac_.update(state_, ledger_);
    }
}


const Foam::dew::bulkForces& Foam::dew::particleExchange::forces()
{
    const clockTime clock;

    checkFinite();
    {
        const tmp<tensorField> gradU(velocityGradient());
        gatherHere(gradU.valid() ? &gradU() : nullptr);
        if (seesSurface())
        {
            gatherSurfaces();
        }
        if (needs().spread)
        {
            gatherSpread();
        }
        if (needs().motion())
        {
            gatherMotion(gradU());
        }
        for (scalarExchange& s : scalars_)
        {
            s.gather(linear_);
        }
    }
    updateKicks();
    evaluateLaws();

    forces_.kick = kick_;
    if (heat_)
    {
        forces_.heatKick = heatKick_;
    }

    exchangeTime_ += clock.elapsedTime();

    return forces_;
}


void Foam::dew::particleExchange::correct()
{
    findMap();

    const clockTime clock;

    alphac_.correct(state_, ledger_);
    momentum_.correct
    (
        state_.impulse, state_.impulseSp, alphac_.field(), fluid_.rho
    );
    if (heat_)
    {
        heat_->correct(state_.heat, state_.heatSp);
    }
    for (scalarExchange& s : scalars_)
    {
        s.correct(memory());
    }
    keepLastForce();
    kicked_ = false;

    exchangeTime_ += clock.elapsedTime();
}


void Foam::dew::particleExchange::keepLastForce()
{
    lastForce_.setSize(needs().lastForce ? state_.size() : 0);
    // A fluid that does not feel it is not disturbed
    const scalar perStep = twoWay()/mesh_.time().deltaTValue();

    forAll(lastForce_, i)
    {
        lastForce_[i] = perStep*state_.impulse[i];
    }
}


Foam::tmp<Foam::surfaceScalarField>
Foam::dew::particleExchange::pressureShare
(
    const surfaceScalarField& alphacf
) const
{
    if (laws_.model() == particleForceList::models::A)
    {
        tmp<surfaceScalarField> share
        (
            new surfaceScalarField("pressureShare", alphacf)
        );

        // The pressure at an open boundary is that just inside
        for (fvsPatchScalarField& patch : share.ref().boundaryFieldRef())
        {
            if (!patch.patch().coupled())
            {
                patch ==
                    alphac().boundaryField()[patch.patch().index()]
                   .patchInternalField();
            }
        }

        return share;
    }

    return tmp<surfaceScalarField>::New
    (
        IOobject("pressureShare", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar("one", dimless, 1)
    );
}


Foam::scalar Foam::dew::particleExchange::largestRelaxation() const
{
    return returnReduce(relaxation_, maxOp<scalar>());
}


void Foam::dew::particleExchange::report()
{
    const clockTime clock;

    updateKicks();

    ledger_.received = Zero;
    ledger_.scale = 0;
    ledger_.heatReceived = 0;
    ledger_.heatScale = 0;

    for (label i = 0; twoWay() && i < state_.size(); i++)
    {
        const vector J(state_.impulse[i] + kick_[i]);
        ledger_.received += map_.toMesh(J, i);
        ledger_.scale += mag(state_.impulse[i]) + mag(kick_[i]);
    }
    for (label i = 0; heat_ && heat_->twoWay() && i < state_.size(); i++)
    {
        ledger_.heatReceived += state_.heat[i] + heatKick_[i];
        ledger_.heatScale += mag(state_.heat[i]) + mag(heatKick_[i]);
    }

    reduce(ledger_.received, sumOp<vector>());
    reduce(ledger_.scale, sumOp<scalar>());
    ledger_.received = map_.symmetry().components(ledger_.received);
    ledger_.lost = map_.symmetry().components(momentum_.source().lost());
    if (heat_)
    {
        reduce(ledger_.heatReceived, sumOp<scalar>());
        reduce(ledger_.heatScale, sumOp<scalar>());
        ledger_.heatLost = heat_->source().lost();
    }
    ledger_.scalars.clear();
    for (const scalarExchange& s : scalars_)
    {
        ledger_.scalars.append(s.balance(memory()));
    }

    ledger_.print();
    ledger_.write();
    if (mesh_.time().writeTime())
    {
        ranges_.print();
        for (scalarExchange& s : scalars_)
        {
            s.printRanges();
        }
    }

    exchangeTime_ += clock.elapsedTime();
}
