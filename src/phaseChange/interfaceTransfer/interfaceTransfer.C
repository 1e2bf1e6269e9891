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
    change_(GREAT)
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
            &film_.Y, &film_.X, &film_.gL, &flux_.N, &flux_.dNdY, &flux_.dNdTs,
            &flux_.dNdX, &flux_.Xs
        }
    )
    {
        f->setSize(size());
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


void Foam::dew::interfaceTransfer::latent
(
    const UList<scalar>& N,
    const UList<scalar>& dNdTs,
    const scalar Ts,
    scalar& heat,
    scalar& slope
) const
{
    heat = 0;
    slope = 0;
    forAll(N, i)
    {
        // The gas may be hotter than any liquid where nothing evaporates
        if (N[i] != 0 || dNdTs[i] != 0)
        {
            const scalar hv = liquid_.liquids().liquid(i).hv(p0_, Ts);
            heat += hv*N[i];
            slope += hv*dNdTs[i];
        }
    }
}


void Foam::dew::interfaceTransfer::keep(const label k, const bool heat)
{
    const interfaceFace& face = faces_.faces()[k];
    const scalar V = mesh_.V()[face.gas];
    const scalar K = KG_[k] + KL_[k];
    forAll(flux_.N, i)
    {
        const label ki = k*size() + i;
        const scalar Y = film_.Y[i];
        dNdTs_[ki] = flux_.dNdTs[i];
        dTsdY_[ki] = 0;
        scalar dNdY = flux_.dNdY[i];
        if (heat && (dNdY != 0 || flux_.dNdTs[i] != 0))
        {
            // More vapour, less evaporates, the surface gets warmer
            const scalar hvS =
                liquid_.liquids().liquid(i).hv(p0_, Ts_[k])*face.S;
            const scalar sum = K + hvS*flux_.dNdTs[i];
            dTsdY_[ki] = -hvS*dNdY/sum;
            dNdY *= K/sum;
        }
        dNdY_[ki] = dNdY;
        Y0_[ki] = Y;
        N0_[ki] = flux_.N[i] - dNdY*Y;
        Xs_[ki] = flux_.Xs[i];
        dNdX_[ki] = flux_.dNdX[i];
        vapourSu_[i][face.gas] += N0_[ki]*face.S/V;
        vapourSp_[i][face.gas] -= dNdY*face.S/V;
    }
}


void Foam::dew::interfaceTransfer::boils
(
    const label k,
    const gasFilm& film
) const
{
    const interfaceFace& face = faces_.faces()[k];

    FatalErrorInFunction
        << "The surface of the liquid boils at time "
        << mesh_.time().timeName() << ": at "
        << mesh_.cellCentres()[face.gas] << " it would be at "
        << film.Ts << " K, and " << liquid_.liquids().names() << " boils at "
        << law_->TsMax() << " K at p0 = " << p0_ << " Pa" << nl
        << "Boiling is not modelled: lower the temperature of the substrate"
        << " or the liquid in 0/T, raise p0 in constant/gasProperties, or"
        << " switch the energy equation on so that evaporation cools the"
        << " surface (energy on; in constant/phaseChangeProperties)"
        << exit(FatalError);
}


Foam::scalar Foam::dew::interfaceTransfer::findTs
(
    const label k,
    gasFilm& film
)
{
    // What arrives by conduction, less what evaporation takes: it falls with
    // Ts, and below the boiling point it crosses zero
    const scalar S = faces_.faces()[k].S;
    const scalar K = KG_[k] + KL_[k];
    const scalar arriving = KG_[k]*film.T + KL_[k]*TN_[k];

    scalar low = 0.5*min(min(film.T, TN_[k]), law_->TsMax());
    scalar high = min(2*max(film.T, TN_[k]), law_->TsMax()*(1 - 1e-12));

    scalar Ts = min(max(film.Ts, low), high);
    for (label iter = 0; iter < 200; iter++)
    {
        film.Ts = Ts;
        law_->fluxes(film, flux_);
        scalar heat, slope;
        latent(flux_.N, flux_.dNdTs, Ts, heat, slope);
        const scalar excess = arriving - K*Ts - heat*S;

        (excess > 0 ? low : high) = Ts;

        scalar next = Ts + excess/(K + slope*S);
        if (!(next > low && next < high))
        {
            next = 0.5*(low + high);
        }
        if (mag(next - Ts) < 1e-11*Ts)
        {
            break;
        }
        Ts = next;
    }

    if (high - low > 0 && Ts > law_->TsMax()*(1 - 1e-10))
    {
        film.Ts = Ts;
        boils(k, film);
    }

    return Ts;
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
    for (scalarField* f : {&dTsdY_, &Y0_, &dNdY_, &dNdTs_, &dNdX_, &N0_, &N_, &Xs_})
    {
        f->setSize(n*size());
        *f = 0;
    }
    total_ = 0;
    Ts_ = 0;
    change_ = GREAT;
    area_ = surface_.area();

    scalar projected = 0;
    for (const interfaceFace& face : faces_.faces())
    {
        projected += face.S*cosine(face);
    }
    reduce(projected, sumOp<scalar>());
    const scalar area = gSum(area_);
    areaScale_ = projected > 0 ? area/projected : 1;
}


void Foam::dew::interfaceTransfer::linearise
(
    const volScalarField& T,
    const speciesFields& Y,
    const bool energy
)
{
    law_->correct(p0_);
    const auto& faces = faces_.faces();

    TN_ = faces_.ofLiquid(T);
    liquid_.onFaces(faces_, XN_);
    forAll(vapourSu_, i)
    {
        vapourSu_[i].field() = 0;
        vapourSp_[i].field() = 0;
    }
    change_ = 0;
    const label n = size();
    const scalar fixedTs = law_->fixedTs();
    if (fixedTs > 0 && !energy)
    {
        FatalErrorInFunction
            << "Evaporation by " << law_->type() << " follows from heat, and"
            << " the energy equation is off" << nl
            << "Set 'energy on;' in constant/phaseChangeProperties"
            << exit(FatalError);
    }

    forAll(faces, k)
    {
        const interfaceFace& face = faces[k];
        const scalar before = Ts_[k];

        gasFilm& film = film_;
        film.Y = Y.cell(face.gas);
        // An iteration may overshoot pure vapour
        const scalar vapours = sum(film.Y);
        if (vapours > 1 - 1e-6)
        {
            film.Y *= (1 - 1e-6)/vapours;
        }
        film.X = SubList<scalar>(XN_, n, k*n);
        flux_.Xs = SubList<scalar>(before > 0 ? Xs_ : XN_, n, k*n);
        liquid_.conductances(p0_, TN_[k], film.X, face.dL, film.gL);
        film.T = T[face.gas];
        film.L = face.dG;
        film.cosine = cosine(face)*areaScale_;
        film.Ts = before;
        if (film.Ts <= 0)
        {
            film.Ts = (face.dL*film.T + face.dG*TN_[k])/(face.dL + face.dG);
            film.Ts = min(film.Ts, 0.9999*law_->TsMax());
        }

        if (energy)
        {
            const scalar Tf = 0.5*(film.T + film.Ts);
            KG_[k] = gas_.kappa(Tf, film.Y)*face.S/face.dG;
            KL_[k] =
                liquid_.liquids().kappa
                (
                    p0_, TN_[k], liquid_.x(film.X)
                )
               *face.S/face.dL;

            // A wall that gives no heat does not hold the film's temperature
            if
            (
                face.wall
             && !T.boundaryField()[face.patch].fixesValue()
            )
            {
                KL_[k] = 0;
            }
            film.Ts = fixedTs > 0 ? fixedTs : findTs(k, film);
        }
        else
        {
            film.Ts = (face.dL*film.T + face.dG*TN_[k])/(face.dL + face.dG);
            if (film.Ts >= law_->TsMax())
            {
                boils(k, film);
            }
        }

        Ts_[k] = film.Ts;
        law_->fluxes(film, flux_);
        if (fixedTs > 0)
        {
            flux_.N[0] =
                (
                    KG_[k]*(film.T - fixedTs) + KL_[k]*(TN_[k] - fixedTs)
                )
               /(liquid_.liquids().liquid(0).hv(p0_, fixedTs)*face.S);
        }
        else if (sum(flux_.N) > 0.1*ROOTVGREAT)
        {
            boils(k, film);
        }
        keep(k, energy && fixedTs <= 0);
        if (before > 0)
        {
            change_ = max(change_, mag(Ts_[k] - before)/Ts_[k]);
        }
    }
    reduce(change_, maxOp<scalar>());
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
                moved += mag(dNdY_[ki]*(Yi - Y0_[ki]))*face.S;
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
        else
        {
            moved += mag(total_[k] - before)*face.S;
        }
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
