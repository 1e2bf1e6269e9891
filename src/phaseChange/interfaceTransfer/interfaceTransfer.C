/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "interfaceTransfer.H"
#include "gasMixture.H"
#include "liquidPhase.H"
#include "surfaceMotion.H"
#include "Time.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::volScalarField::Internal noSource
(
    const Foam::word& name,
    const Foam::fvMesh& mesh,
    const Foam::dimensionSet& dims
)
{
    return Foam::volScalarField::Internal
    (
        Foam::IOobject(name, mesh.time().timeName(), mesh),
        mesh,
        Foam::dimensionedScalar(name, dims, Foam::Zero)
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::interfaceTransfer::interfaceTransfer
(
    const fvMesh& mesh,
    const surfaceMotion& surface,
    const liquidPhase& liquid,
    const gasMixture& gas,
    const scalar& p0,
    const dictionary& phaseChangeProperties
)
:
    mesh_(mesh),
    surface_(surface),
    liquid_(liquid),
    gas_(gas),
    p0_(p0),
    law_
    (
        evaporationLaw::New
        (
            userEntry::subDict(phaseChangeProperties, "evaporation"),
            liquid.liquids(),
            gas
        )
    ),
    faces_(mesh, surface),
    areaScale_(1),
    vapourSu_(gas.size()),
    vapourSp_(gas.size()),
    mDot_(noSource("mDot", mesh, dimDensity/dimTime)),
    rate_(0),
    rates_(gas.size(), Zero),
    change_(1),
    lastChange_(1)
{
    const dimensionSet dims(dimDensity/dimTime);
    forAll(vapourSu_, i)
    {
        vapourSu_.set
        (
            i, new volScalarField::Internal(noSource("vapourSu", mesh, dims))
        );
        vapourSp_.set
        (
            i, new volScalarField::Internal(noSource("vapourSp", mesh, dims))
        );
    }
    for
    (
        scalarField* f
      : {
            &YP_, &film_.Y, &film_.X, &film_.gL, &flux_.N, &flux_.dNdY, &flux_.dNdTs,
            &flux_.dNdX, &flux_.Xs
        }
    )
    {
        f->setSize(size());
    }
    if (law_->adjacentFilm())
    {
        adjacent_.reset(new adjacentGas(faces_, surface_));
    }
    move();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dew::interfaceTransfer::cosine
(
    const interfaceFace& face
) const
{
    return max(face.n & face.e, scalar(0));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::interfaceTransfer::move()
{
    faces_.correct();

    const label n = faces_.faces().size();
    Ts_.setSize(n);
    KG_.setSize(n);
    KL_.setSize(n);
    total_.setSize(n);
    for
    (
        scalarField* f
      : {
            &dTsdY_, &Y0_, &dNdY_, &dNdYatTs_, &dNdTs_, &dNdX_, &N0_, &N_, &Xs_
        }
    )
    {
        f->setSize(n*size());
        *f = 0;
    }
    total_ = 0;
    Ts_ = 0;
    change_ = 1;
    lastChange_ = 1;
    area_ = cellArea();
    if (adjacent_.valid())
    {
        adjacent_->correct();
    }

    scalar projected = 0;
    for (const interfaceFace& face : faces_.faces())
    {
        projected += face.S*cosine(face);
    }
    reduce(projected, sumOp<scalar>());
    areaScale_ = projected > 0 ? gSum(area_)/projected : 1;
}


void Foam::dew::interfaceTransfer::assemble(const speciesFields& Y)
{
    const auto& faces = faces_.faces();
    const label n = size();
    rates_ = 0;
    scalar most = 0, moved = 0;
    forAll(faces, k)
    {
        const interfaceFace& face = faces[k];
        const scalar before = total_[k];
        scalar tangent = 0, Ts = Ts_[k];
        total_[k] = 0;
        for (label i = 0; i < n; i++)
        {
            const label ki = k*n + i;
            N_[ki] = N0_[ki];
            if (Y.solved())
            {
                const scalar Yi = Y[i][face.gas];
                N_[ki] += dNdY_[ki]*Yi;
                Ts += dTsdY_[ki]*(Yi - Y0_[ki]);
            }
            total_[k] += N_[ki];
            tangent += N0_[ki] + dNdY_[ki]*Y0_[ki];
            rates_[i] += N_[ki]*face.S;
        }
        if (Y.solved())
        {
            // Far from the solution the tangent may leave what a liquid can be
            const scalar highest = max(Ts_[k], 0.9999*law_->TsMax());
            Ts_[k] = max(min(Ts, highest), 0.5*Ts_[k]);
        }
        moved += mag(total_[k] - before)*face.S;
        most += mag(tangent)*face.S;
    }
    forAll(rates_, i)
    {
        reduce(rates_[i], sumOp<scalar>());
    }
    rate_ = sum(rates_);
    reduce(most, sumOp<scalar>());
    reduce(moved, sumOp<scalar>());
    change_ = max(change_, most > 0 ? moved/most : 0);
}


Foam::scalar Foam::dew::interfaceTransfer::error() const
{
    // Two changes make a ratio
    return
        lastChange_ < 1 && change_ < lastChange_
      ? change_*change_/(lastChange_ - change_)
      : change_;
}


void Foam::dew::interfaceTransfer::giveWay
(
    const label i,
    const scalarField& diagonal
)
{
    const auto& faces = faces_.faces();
    const auto rest = [&](const label celli)
    {
        return (diagonal[celli] - vapourSp_[i][celli])*mesh_.V()[celli];
    };
    scalarField byTs(mesh_.nCells(), Zero), byY(mesh_.nCells(), Zero);
    forAll(faces, k)
    {
        byTs[faces[k].gas] += dNdTs_[k*size() + i]*faces[k].S;
        byY[faces[k].gas] -= dNdYatTs_[k*size() + i]*faces[k].S;
    }

    // How far Ts goes with the liquid, if the vapour gives way to this face
    scalarField follows(faces.size());
    scalarField sum(mesh_.nCells(), Zero);
    forAll(faces, k)
    {
        const interfaceFace& face = faces[k];
        const label ki = k*size() + i;
        const scalar all = rest(face.gas) + byY[face.gas];
        scalar slope = 0;
        if (dNdTs_[ki] != 0)
        {
            slope =
                dNdTs_[ki]*face.S*(1 + dNdYatTs_[ki]*face.S/all)
               *liquid_.liquids().liquid(i).hv(p0_, Ts_[k]);
        }
        follows[k] =
            (KL_[k] + VSMALL)/(KL_[k] + KG_[k] + slope + VSMALL);
        sum[face.gas] += follows[k]*dNdTs_[ki]*face.S;
    }

    // The faces of a cell share its vapour, and Ts of all move together
    forAll(faces, k)
    {
        const interfaceFace& face = faces[k];
        const label ki = k*size() + i;
        const scalar own = dNdTs_[ki]*face.S;
        const scalar others =
            min(sum[face.gas]/follows[k], byTs[face.gas]) - own;
        dNdTs_[ki] +=
            dNdYatTs_[ki]*(own + max(others, scalar(0)))
           /(rest(face.gas) + byY[face.gas]);
    }
}


Foam::tmp<Foam::volScalarField::Internal>
Foam::dew::interfaceTransfer::vapourSource(const speciesFields& Y) const
{
    tmp<volScalarField::Internal> tsource(1.0*vapourSu_[0]);
    forAll(vapourSu_, i)
    {
        if (i > 0)
        {
            tsource.ref() += vapourSu_[i];
        }
        if (Y.solved())
        {
            tsource.ref() -= vapourSp_[i]*Y[i]();
        }
    }
    return tsource;
}


void Foam::dew::interfaceTransfer::surfaceTemperature
(
    scalar& mean,
    scalar& least,
    scalar& most
) const
{
    scalar sum = 0, area = 0;
    least = GREAT;
    most = -GREAT;

    forAll(Ts_, k)
    {
        const interfaceFace& face = faces_.faces()[k];
        const scalar A = face.S*cosine(face);
        sum += A*Ts_[k];
        area += A;
        least = min(least, Ts_[k]);
        most = max(most, Ts_[k]);
    }
    reduce(sum, sumOp<scalar>());
    reduce(area, sumOp<scalar>());
    reduce(least, minOp<scalar>());
    reduce(most, maxOp<scalar>());
    mean = area > 0 ? sum/area : 0;
}


// ************************************************************************* //
