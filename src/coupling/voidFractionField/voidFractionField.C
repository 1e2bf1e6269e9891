/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "voidFractionField.H"
#include "exchangeLedger.H"
#include "inletOutletFvPatchFields.H"
#include "particleMesh.H"
#include "particleState.H"
#include "smoothing.H"
#include "Time.H"
#include "userEntry.H"
#include "voidFractionModel.H"
#include "wallPolyPatch.H"

#include <cmath>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::voidFractionField::voidFractionField
(
    const dictionary& dict,
    const voidFractionModel& model,
    const smoothing& smoothing,
    const particleMesh& map,
    const fvMesh& mesh
)
:
    mesh_(mesh),
    dict_(dict),
    model_(model),
    smoothing_(smoothing),
    map_(map),
    alphacMin_
    (
        dict.found("alphacMin")
      ? userEntry::within(dict, "alphacMin", 1e-6, 1)
      : 0.2
    ),
    time_
    (
        dict.found("alphacTime")
      ? userEntry::positive(dict, "alphacTime", dimTime)
      : 0
    ),
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
        // Not from a tmp, which would leave the old time level behind
        read(mesh)()
    )
{
    if (time_ > 0 && !model.displaces())
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'alphacTime' needs particles that displace fluid, but"
            << " voidFraction is of type " << model.type() << nl
            << "Choose another voidFraction model, or remove the entry"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::volScalarField>
Foam::dew::voidFractionField::read(const fvMesh& mesh)
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


Foam::tmp<Foam::scalarField> Foam::dew::voidFractionField::occupied
(
    const particleState& state,
    exchangeLedger& ledger
) const
{
    tmp<scalarField> tsolid(new scalarField(mesh_.nCells(), Zero));
    scalarField& solid = tsolid.ref();
    scalar held = 0;

    {
        List<scalar> volume(state.size());
        forAll(volume, i)
        {
            volume[i] = state.volume(i);
            held += volume[i];
        }
        if (model_.displaces())
        {
            map_.scatter(volume, solid);
            smoothing_.spread(solid);
        }
    }

    const scalarField& V = mesh_.V();
    scalar clipped = 0, most = 0;

    ledger.clippedCell = -1;
    forAll(solid, celli)
    {
        const scalar room = (1 - alphacMin_)*V[celli];
        const scalar refused = solid[celli] - room;
        if (refused > 0)
        {
            clipped += refused;
            if (refused > most)
            {
                most = refused;
                ledger.clippedCell = celli;
                ledger.clippedAt = mesh_.cellCentres()[celli];
                ledger.clippedAlphac = 1 - solid[celli]/V[celli];
            }
            solid[celli] = room;
        }
    }

    ledger.held = returnReduce(held, sumOp<scalar>());
    ledger.clipped =
        map_.symmetry().ringFactor()*returnReduce(clipped, sumOp<scalar>());
    ledger.mostClipped(most);

    return tsolid;
}


void Foam::dew::voidFractionField::checkSize(const particleState& state) const
{
    if (!model_.displaces() || smoothing_.active())
    {
        return;
    }

    label cell = -1;
    const scalar share = largestOccupation(state, cell);

    if (share > 1 - alphacMin_)
    {
        // On this rank only: no collective call on the way out
        FatalIOErrorInFunction(dict_)
            << "Particles do not fit the void fraction model '"
            << model_.type() << "': one of them fills " << share
            << " of cell " << cell << " at " << mesh_.cellCentres()[cell]
            << ", alphacMin " << alphacMin_ << " leaves room for "
            << 1 - alphacMin_ << nl
            << "Use a coarser mesh, smoothing, or another voidFraction model"
            << " (valid: divided from about one particle diameter a cell,"
            << " Gaussian and bigParticle also for smaller cells, none"
            << " for particles that displace nothing)"
            << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::voidFractionField::largestOccupation
(
    const particleState& state,
    label& celli
) const
{
    List<scalar> volume(state.size());
    forAll(volume, i)
    {
        volume[i] = state.volume(i);
    }
    return map_.largestShare(volume, mesh_.V(), celli);
}


void Foam::dew::voidFractionField::start
(
    const particleState& state,
    const bool goesOn,
    exchangeLedger& ledger
)
{
    checkSize(state);
    ledger.delayed = time_ > 0;

    const tmp<scalarField> solid(occupied(state, ledger));
    if (!time_ || !goesOn)
    {
        alphac_.primitiveFieldRef() = 1 - solid/mesh_.V().field();
    }
    alphac_.correctBoundaryConditions();
    alphac_.oldTime();
}


void Foam::dew::voidFractionField::update
(
    const particleState& state,
    exchangeLedger& ledger
)
{
    // As mapped, a particle would leave its old cell for a part of it within
    // the next step, and push the fluid to the other parts
    if (!time_)
    {
        alphac_.primitiveFieldRef() = 1 - occupied(state, ledger)/mesh_.V().field();
        alphac_.correctBoundaryConditions();
        alphac_.oldTime() == alphac_;
    }
}


void Foam::dew::voidFractionField::correct
(
    const particleState& state,
    exchangeLedger& ledger
)
{
    // Stores the old time level first
    scalarField& alphac = alphac_.primitiveFieldRef();
    const scalarField& V = mesh_.V();

    const tmp<scalarField> tsolid(occupied(state, ledger));
    const scalarField& solid = tsolid();
    scalar represented = 0, lagging = 0;

    if (time_ > 0)
    {
        const scalarField& V0 = mesh_.moving() ? mesh_.V0() : mesh_.V();
        const scalarField& alphac0 = alphac_.oldTime();
        const scalar stays = std::exp(-mesh_.time().deltaTValue()/time_);

        forAll(alphac, celli)
        {
            const scalar behind =
                stays*(solid[celli] - (1 - alphac0[celli])*V0[celli]);
            alphac[celli] = 1 - (solid[celli] - behind)/V[celli];
            lagging += behind;
        }
    }
    else
    {
        alphac = 1 - solid/V;
    }
    alphac_.correctBoundaryConditions();

    forAll(alphac, celli)
    {
        represented += (1 - alphac[celli])*V[celli];
    }
    const scalar ring = map_.symmetry().ringFactor();
    ledger.represented = ring*returnReduce(represented, sumOp<scalar>());
    ledger.lagging = ring*returnReduce(lagging, sumOp<scalar>());
}
