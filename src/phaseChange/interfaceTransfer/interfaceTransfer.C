/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "interfaceTransfer.H"
#include "gasModel.H"
#include "liquidModel.H"
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
    const liquidModel& liquid,
    const gasModel& gas,
    const dictionary& phaseChangeProperties
)
:
    mesh_(mesh),
    surface_(surface),
    liquid_(liquid),
    gas_(gas),
    law_
    (
        evaporationLaw::New
        (
            userEntry::subDict(phaseChangeProperties, "evaporation"),
            liquid,
            gas
        )
    ),
    faces_(mesh, surface),
    areaScale_(1),
    vapourSu_(noSource("vapourSu", mesh, dimDensity/dimTime)),
    vapourSp_(noSource("vapourSp", mesh, dimDensity/dimTime)),
    mDot_(noSource("mDot", mesh, dimDensity/dimTime)),
    rate_(0),
    change_(GREAT)
{
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


Foam::scalar Foam::dew::interfaceTransfer::latentHeat
(
    const filmFlux& f,
    const scalar Ts
) const
{
    // The gas may be hotter than any liquid where nothing evaporates
    return f.N == 0 && f.dNdTs == 0 ? 0 : liquid_.hv(gas_.p0(), Ts);
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
        << film.Ts << " K, and " << liquid_.name() << " boils at "
        << law_->TsMax() << " K at p0 = " << gas_.p0() << " Pa" << nl
        << "Boiling is not modelled: lower the temperature of the substrate"
        << " or the liquid in 0/T, raise p0 in constant/gasProperties, or"
        << " switch the energy equation on so that evaporation cools the"
        << " surface (energy on; in constant/phaseChangeProperties)"
        << exit(FatalError);
}


Foam::scalar Foam::dew::interfaceTransfer::findTs
(
    const label k,
    const gasFilm& film0
) const
{
    // What arrives by conduction, less what evaporation takes: it falls with
    // Ts, and below the boiling point it crosses zero
    gasFilm film(film0);
    const scalar S = faces_.faces()[k].S;
    const scalar K = KG_[k] + KL_[k];
    const scalar arriving = KG_[k]*film.T + KL_[k]*TN_[k];

    scalar low = 0.5*min(min(film.T, TN_[k]), law_->TsMax());
    scalar high = min(2*max(film.T, TN_[k]), law_->TsMax()*(1 - 1e-12));

    scalar Ts = min(max(film.Ts, low), high);
    for (label iter = 0; iter < 200; iter++)
    {
        film.Ts = Ts;
        const filmFlux f = law_->flux(film);
        const scalar hv = latentHeat(f, Ts);
        const scalar excess = arriving - K*Ts - f.N*hv*S;

        (excess > 0 ? low : high) = Ts;

        scalar next = Ts + excess/(K + hv*f.dNdTs*S);
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
    dTsdY_.setSize(n);
    Y0_.setSize(n);
    flux_.setSize(n);
    N0_.setSize(n);
    N_.setSize(n);
    Ts_ = 0;
    dTsdY_ = 0;
    Y0_ = 0;
    N0_ = 0;
    N_ = 0;
    flux_ = filmFlux();
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
    const volScalarField* Y,
    const bool energy
)
{
    const scalar p0 = gas_.p0();
    const auto& faces = faces_.faces();

    TN_ = faces_.ofLiquid(T);
    scalarField& Su = vapourSu_;
    scalarField& Sp = vapourSp_;
    Su = 0;
    Sp = 0;
    change_ = 0;
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

        gasFilm film;
        // An iteration may overshoot pure vapour
        film.Y = Y ? min((*Y)[face.gas], 1 - 1e-6) : 0;
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
            KG_[k] = gas_.kappa(film.Y, Tf)*face.S/face.dG;
            KL_[k] = liquid_.kappa(p0, TN_[k])*face.S/face.dL;

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
        flux_[k] = law_->flux(film);
        Y0_[k] = film.Y;
        dTsdY_[k] = 0;
        if (fixedTs > 0)
        {
            flux_[k].N =
                (
                    KG_[k]*(film.T - fixedTs) + KL_[k]*(TN_[k] - fixedTs)
                )
               /(liquid_.hv(p0, fixedTs)*face.S);
        }
        else if (energy)
        {
            // More vapour, less evaporates, the surface gets warmer
            filmFlux& f = flux_[k];
            const scalar K = KG_[k] + KL_[k];
            const scalar hvS = latentHeat(f, Ts_[k])*face.S;
            const scalar sum = K + hvS*f.dNdTs;
            dTsdY_[k] = -hvS*f.dNdY/sum;
            f.dNdY *= K/sum;
        }
        // The first time nothing is known to have come to rest
        change_ =
            max(change_, before > 0 ? mag(Ts_[k] - before)/Ts_[k] : 1);

        const scalar V = mesh_.V()[face.gas];
        const filmFlux& f = flux_[k];
        Su[face.gas] += (f.N - f.dNdY*film.Y)*face.S/V;
        Sp[face.gas] -= f.dNdY*face.S/V;
        N0_[k] = f.N - f.dNdY*film.Y;
    }
    reduce(change_, maxOp<scalar>());
}


void Foam::dew::interfaceTransfer::assemble(const volScalarField* Y)
{
    const auto& faces = faces_.faces();

    rate_ = 0;
    scalar most = 0, moved = 0;
    forAll(faces, k)
    {
        const interfaceFace& face = faces[k];
        const scalar before = N_[k];
        N_[k] = N0_[k] + (Y ? flux_[k].dNdY*(*Y)[face.gas] : 0);
        if (Y)
        {
            // Far from the solution the tangent may leave what a liquid can be
            const scalar Ts = Ts_[k] + dTsdY_[k]*((*Y)[face.gas] - Y0_[k]);
            const scalar highest = max(Ts_[k], 0.9999*law_->TsMax());
            Ts_[k] = max(min(Ts, highest), 0.5*Ts_[k]);
        }
        rate_ += N_[k]*face.S;
        most += mag(flux_[k].N)*face.S;
        moved += mag(N_[k] - (Y ? flux_[k].N : before))*face.S;
    }
    reduce(rate_, sumOp<scalar>());
    reduce(most, sumOp<scalar>());
    reduce(moved, sumOp<scalar>());
    change_ = max(change_, most > 0 ? moved/most : 0);
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
