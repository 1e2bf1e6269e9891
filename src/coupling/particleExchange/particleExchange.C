/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleExchange.H"
#include "inletOutletFvPatchFields.H"
#include "Time.H"
#include "userEntry.H"
#include "wallPolyPatch.H"

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
    alphacMin_
    (
        dict_.found("alphacMin")
      ? userEntry::within(dict_, "alphacMin", 1e-6, 1)
      : 0.2
    ),
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
    laws_
    (
        dict_, fluid.T,
        fluid.psi && fluid.n && fluid.surfaceSpeed && fluid.curvature
    ),
    map_(mesh, voidFraction_->support(mesh)),
    alphac_
    (
        IOobject
        (
            "alphac",
            mesh.time().timeName(),
            mesh,
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        ),
        voidFractionField(mesh)
    ),
    momentum_(dict_, map_, fluid.U),
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
            "model", "voidFraction", "alphacMin", "interpolation",
            "carrierVelocity", "momentum", "heat", "forces", "heatTransfer"
        }
    );

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
                << " kappa to constant/transportProperties; else remove the"
                << " entry"
                << exit(FatalIOError);
        }
        heatTransfer_ =
            heatTransferModel::New(userEntry::subDict(dict_, "heatTransfer"));
        heat_.reset(new heatExchange(dict_, map_, *fluid_.T));
    }
    ledger_.thermal = bool(heat_);

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

    if (!carrierVelocity_ && twoWay())
    {
        FatalIOErrorInFunction(dict_)
            << "Entry 'carrierVelocity' is off: particles see a fluid at rest,"
            << " and the moving one would feel the force of another" << nl
            << "Set 'momentum none;', or remove 'carrierVelocity'"
            << exit(FatalIOError);
    }

    findMap();
    checkSize();
    occupy();
    alphac_.oldTime();
    readKicks();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::volScalarField>
Foam::dew::particleExchange::voidFractionField(const fvMesh& mesh)
{
    IOobject io
    (
        "alphac",
        mesh.time().timeName(),
        mesh,
        IOobject::READ_IF_PRESENT,
        IOobject::NO_WRITE,
        false
    );

    if (io.typeHeaderOk<volScalarField>(true))
    {
        return tmp<volScalarField>::New(io, mesh);
    }

    wordList types(mesh.boundary().size(), "zeroGradient");
    forAll(types, patchi)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];
        if (polyPatch::constraintType(patch.type()))
        {
            types[patchi] = patch.type();
        }
        else if (!isA<wallPolyPatch>(patch))
        {
            types[patchi] = inletOutletFvPatchScalarField::typeName;
        }
    }

    tmp<volScalarField> talphac
    (
        new volScalarField(io, mesh, dimensionedScalar("one", dimless, 1), types)
    );

    // There are no particles beyond an inlet
    for (fvPatchScalarField& patch : talphac.ref().boundaryFieldRef())
    {
        if (isA<inletOutletFvPatchScalarField>(patch))
        {
            refCast<inletOutletFvPatchScalarField>(patch).refValue() = 1;
        }
    }

    return talphac;
}


void Foam::dew::particleExchange::findMap()
{
    const clockTime clock;
    map_.correct(state_.x, state_.d);
    ledger_.outside = map_.nOutside();
    mapTime_ += clock.elapsedTime();
}


Foam::scalar Foam::dew::particleExchange::largestOccupation
(
    label& celli
) const
{
    List<scalar> volume(state_.size());
    forAll(volume, i)
    {
        volume[i] = state_.volume(i);
    }
    return map_.largestShare(volume, mesh_.V(), celli);
}


void Foam::dew::particleExchange::checkSize() const
{
    if (!voidFraction_->displaces())
    {
        return;
    }

    label cell = -1;
    const scalar share = largestOccupation(cell);

    if (share > 1 - alphacMin_)
    {
        // On this rank only: no collective call on the way out
        FatalIOErrorInFunction(dict_)
            << "Particles do not fit the void fraction model '"
            << voidFraction_->type() << "': one of them fills " << share
            << " of cell " << cell << " at " << mesh_.cellCentres()[cell]
            << ", alphacMin " << alphacMin_ << " leaves room for "
            << 1 - alphacMin_ << nl
            << "Use a coarser mesh, or another voidFraction model (valid: "
            << "divided from about one particle diameter a cell, Gaussian and"
            << " bigParticle also for smaller cells, none for particles that"
            << " displace nothing)"
            << exit(FatalIOError);
    }
}


void Foam::dew::particleExchange::occupy()
{
    scalarField solid(mesh_.nCells(), Zero);
    scalar held = 0;

    {
        List<scalar> volume(state_.size());
        forAll(volume, i)
        {
            volume[i] = state_.volume(i);
            held += volume[i];
        }
        if (voidFraction_->displaces())
        {
            map_.scatter(volume, solid);
        }
    }

    scalarField& alphac = alphac_.primitiveFieldRef();
    const scalarField& V = mesh_.V();
    scalar represented = 0, clipped = 0, most = 0;

    ledger_.clippedCell = -1;
    forAll(alphac, celli)
    {
        alphac[celli] = 1 - solid[celli]/V[celli];

        if (alphac[celli] < alphacMin_)
        {
            const scalar refused = (alphacMin_ - alphac[celli])*V[celli];
            clipped += refused;
            if (refused > most)
            {
                most = refused;
                ledger_.clippedCell = celli;
                ledger_.clippedAt = mesh_.cellCentres()[celli];
                ledger_.clippedAlphac = alphac[celli];
            }
            alphac[celli] = alphacMin_;
        }
        represented += (1 - alphac[celli])*V[celli];
    }
    alphac_.correctBoundaryConditions();

    ledger_.held = returnReduce(held, sumOp<scalar>());
    const scalar ring = map_.symmetry().ringFactor();
    ledger_.represented = ring*returnReduce(represented, sumOp<scalar>());
    ledger_.clipped = ring*returnReduce(clipped, sumOp<scalar>());
    ledger_.mostClipped(most);
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
    findMap();
}


const Foam::dew::bulkForces& Foam::dew::particleExchange::forces()
{
    const clockTime clock;

    checkFinite();
    gatherCarriers();
    evaluateLaws();

    updateKicks();
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

    occupy();
    momentum_.correct
    (
        map_, state_.impulse, state_.impulseSp, alphac_, fluid_.rho
    );
    if (heat_)
    {
        heat_->correct(state_.heat, state_.heatSp);
    }
    kicked_ = false;

    exchangeTime_ += clock.elapsedTime();
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
                    alphac_.boundaryField()[patch.patch().index()]
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

    ledger_.print();
    ledger_.write();

    exchangeTime_ += clock.elapsedTime();
}
