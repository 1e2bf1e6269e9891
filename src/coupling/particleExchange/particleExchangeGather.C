/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// What the particles see of the fluid

#include "particleExchange.H"
#include "linearGradient.H"
#include "sphereInSurface.H"
#include "surfaceSpring.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::tensorField>
Foam::dew::particleExchange::velocityGradient() const
{
    const bool any = returnReduce(state_.size(), sumOp<label>()) > 0;
    if ((any && linear_ && carrierVelocity_) || needs().motion())
    {
        return linearGradient(velocityWithWallLayers()(), map_.symmetry());
    }
    return tmp<tensorField>();
}


void Foam::dew::particleExchange::gatherHere(const tensorField* gradU)
{
    const volVectorField& U = fluid_.Uc;
    const vectorField& C = mesh_.C();
    const bool shared = laws_.model() == particleForceList::models::A;
    const bool thermal = bool(heatTransfer_) || needs().T;

    tmp<vectorField> gradT;
    if (linear_ && thermal)
    {
        gradT = linearGradient(*fluid_.T, map_.symmetry());
    }

    // As the particles share it: what they take of the pressure the fluid loses
    vectorField gradp;
    if (shared)
    {
        gradp = fluid_.gradp.primitiveField();
        smoothing_->average(gradp);
    }
    const scalarField& alphac = alphac_.field();

    const auto shares = [&](const auto& cells, fluidHere& c)
    {
        c.alphac = 0;
        c.gradp = Zero;
        cells
        (
            [&](const label celli, const scalar w)
            {
                c.alphac += w*alphac[celli];
                if (shared)
                {
                    c.gradp += w*gradp[celli];
                }
            }
        );
    };

    here_.setSize(state_.size());
    UList<fluidHere>& here = here_;
    here = fluidHere();

    map_.gather
    (
        here,
        [&](const label celli, const point& x, const auto& cells, fluidHere& c)
        {
            const vector away(x - C[celli]);

            c.U = carrierVelocity_ ? U[celli] : vector::zero;
            c.rho = fluid_.rho[celli];
            c.mu = fluid_.mu[celli];
            if (thermal)
            {
                c.T = (*fluid_.T)[celli];
            }
            if (heatTransfer_)
            {
                c.kappa = (*fluid_.kappa)[celli];
                c.Cp = (*fluid_.Cp)[celli];
            }
            if (linear_ && carrierVelocity_)
            {
                c.U += away & (*gradU)[celli];
            }
            if (linear_ && thermal)
            {
                c.T += away & gradT()[celli];
            }
            shares(cells, c);
        },
        shares,
        [](fluidHere& c, const fluidHere& other)
        {
            c.alphac += other.alphac;
            c.gradp += other.gradp;
        }
    );
}


void Foam::dew::particleExchange::gatherSurfaces()
{
    const vectorField& C = mesh_.C();
    const bool two = fluid_.twoFluids();

    surfaces_.setSize(state_.size());
    UList<liquidSurface>& surfaces = surfaces_;
    surfaces = liquidSurface();

    map_.gatherHosted
    (
        surfaces,
        [&](const label celli, const point&, liquidSurface& s)
        {
            s.n = (*fluid_.n)[celli];
            s.X = C[celli] + (*fluid_.psi)[celli]*s.n;
            s.speed = (*fluid_.surfaceSpeed)[celli];
            s.curvature = (*fluid_.curvature)[celli];
            if (two)
            {
                s.mu1 = (*fluid_.mu1)[celli];
                s.mu2 = (*fluid_.mu2)[celli];
            }
            if (heatTransfer_ && fluid_.kappa1)
            {
                s.kappa1 = (*fluid_.kappa1)[celli];
                s.kappa2 = (*fluid_.kappa2)[celli];
                s.Cp1 = (*fluid_.Cp1)[celli];
                s.Cp2 = (*fluid_.Cp2)[celli];
            }
            if (carrierVelocity_ && fluid_.Ugas)
            {
                s.dU = (*fluid_.Ugas)[celli] - fluid_.Uc[celli];
            }
            if (fluid_.sigma)
            {
                s.sigma = (*fluid_.sigma)[celli];
            }
        }
    );
}


void Foam::dew::particleExchange::gatherMotion(const tensorField& gradU)
{
    const lawNeeds& need = needs();
    const volVectorField& U = fluid_.Uc;
    const bool shared = laws_.model() == particleForceList::models::A;

    motions_.setSize(state_.size());
    UList<fluidMotion>& motions = motions_;
    motions = fluidMotion();

    map_.gatherHosted
    (
        motions,
        [&](const label celli, const point&, fluidMotion& m)
        {
            m.gradU = gradU[celli];
            if (need.DUDt)
            {
                m.DUDt = (*fluid_.dUdt)[celli] + (U[celli] & gradU[celli]);
            }
            if (need.divTau && shared)
            {
                m.divTau = (*fluid_.divTau)[celli];
            }
            if (need.turbulence)
            {
                m.k = (*fluid_.k)[celli];
                m.epsilon = (*fluid_.epsilon)[celli];
            }
        }
    );
}


void Foam::dew::particleExchange::gatherSpread()
{
    const scalarField& V = mesh_.V();

    const auto sum = [&](const auto& cells, scalar& s)
    {
        s = 0;
        cells([&](const label c, const scalar w) { s += w*w/V[c]; });
    };

    spread_.setSize(state_.size());
    UList<scalar>& spread = spread_;
    spread = 0;

    map_.gather
    (
        spread,
        [&](const label, const point&, const auto& cells, scalar& s)
        {
            sum(cells, s);
        },
        sum,
        [](scalar& s, const scalar other) { s += other; }
    );
    // On a wedge that of the ring
    const scalar ring = map_.symmetry().ringFactor();
    for (scalar& s : spread_)
    {
        s = s > 0 ? ring/s : 0;
    }
}


void Foam::dew::particleExchange::cut(const label i, carrier& c) const
{
    const liquidSurface& s = c.surface;
    if (s.n == vector::zero)
    {
        return;
    }

    // At the middle of the step: a particle that floats keeps its energy
    const vector y
    (
        state_.x[i] - s.X + 0.5*c.deltaT*(state_.v[i] - s.speed*s.n)
    );
    vector m;
    const scalar delta =
        surfaceDistance(y.cdata(), s.n.cdata(), s.curvature, m.data());
    const scalar share = shareInLiquid(2*delta/state_.d[i]);

    const scalar rho1 = fluid_.rho1->value();
    const scalar rho2 = fluid_.rho2->value();
    c.rho = rho2 + share*(rho1 - rho2);
    c.mu = s.mu2 + share*(s.mu1 - s.mu2);
    // As each of them drags at it
    c.U += (1 - share)*s.mu2/c.mu*s.dU;
    if (heatTransfer_ && fluid_.kappa1)
    {
        c.kappa = s.kappa2 + share*(s.kappa1 - s.kappa2);
        c.Cp =
            (share*rho1*s.Cp1 + (1 - share)*rho2*s.Cp2)/c.rho;
    }
}


Foam::dew::carrier Foam::dew::particleExchange::around
(
    const label i,
    const vector& g
) const
{
    const meshSymmetry& symmetry = map_.symmetry();

    carrier c(here_[i]);
    c.g = g;
    c.deltaT = mesh_.time().deltaTValue();
    if (needs().spread)
    {
        c.spread = spread_[i];
    }
    if (seesSurface())
    {
        c.surface = surfaces_[i];
    }
    if (needs().motion())
    {
        c.motion = motions_[i];
    }

    if (symmetry.wedge())
    {
        c.U = map_.toSpace(c.U, i);
        c.gradp = map_.toSpace(c.gradp, i);
        c.surface.X = symmetry.unfold(c.surface.X, state_.x[i]);
        c.surface.n = map_.toSpace(c.surface.n, i);
        c.surface.dU = map_.toSpace(c.surface.dU, i);
        c.motion.gradU = map_.toSpace(c.motion.gradU, i);
        c.motion.DUDt = map_.toSpace(c.motion.DUDt, i);
        c.motion.divTau = map_.toSpace(c.motion.divTau, i);
    }
    if (seesSurface() && fluid_.twoFluids())
    {
        cut(i, c);
    }

    return c;
}

