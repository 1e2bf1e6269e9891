/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/


// Temperature of the surface and flux on each face, at the present fields

#include "interfaceTransfer.H"
#include "gasMixture.H"
#include "liquidPhase.H"
#include "Time.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

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
        const scalar Y = YP_[i];
        dNdTs_[ki] = flux_.dNdTs[i];
        dTsdY_[ki] = 0;
        scalar dNdY = flux_.dNdY[i];
        dNdYatTs_[ki] = dNdY;
        if (heat && size() == 1 && (dNdY != 0 || flux_.dNdTs[i] != 0))
        {
            // More vapour, less evaporates, the surface gets warmer. Of
            // several one may take the place of another, at one Ts
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

void Foam::dew::interfaceTransfer::linearise
(
    const volScalarField& T,
    const speciesFields& Y,
    const volScalarField& fluidShare,
    const bool energy
)
{
    law_->correct(p0_);
    const auto& faces = faces_.faces();

    TN_ = faces_.ofLiquid(T);
    const scalarField shareN(faces_.ofLiquid(fluidShare));
    liquid_.onFaces(faces_, XN_);
    forAll(vapourSu_, i)
    {
        vapourSu_[i].field() = 0;
        vapourSp_[i].field() = 0;
    }
    lastChange_ = change_;
    change_ = 0;
    const label n = size();
    List<scalarField> YG(adjacent_.valid() ? n : 0);
    forAll(YG, i)
    {
        YG[i] = adjacent_->Y(Y[i]);
    }
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
        YP_ = film.Y;
        film.L = face.dG;
        if (adjacent_.valid() && adjacent_->L()[k] > 0)
        {
            film.L = adjacent_->L()[k];
            forAll(film.Y, i)
            {
                film.Y[i] = YG[i][k];
            }
        }
        film.X = SubList<scalar>(XN_, n, k*n);
        flux_.Xs = SubList<scalar>(before > 0 ? Xs_ : XN_, n, k*n);
        liquid_.conductances(p0_, TN_[k], film.X, face.dL, film.gL);
        film.T = T[face.gas];
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
            KG_[k] =
                fluidShare[face.gas]*gas_.kappa(Tf, film.Y)*face.S/face.dG;
            KL_[k] =
                shareN[k]
               *liquid_.liquids().kappa
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

        // The first time nothing is known to have come to rest
        change_ =
            max(change_, before > 0 ? mag(Ts_[k] - before)/Ts_[k] : 1);
    }
    reduce(change_, maxOp<scalar>());
}


// ************************************************************************* //
