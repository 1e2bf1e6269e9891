/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// What the particles see of the fluid, and the laws

#include "particleExchange.H"
#include "linearGradient.H"
#include "Time.H"

#include <cmath>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

template<class Type>
void findNotFinite
(
    const Foam::GeometricField<Type, Foam::fvPatchField, Foam::volMesh>& field
)
{
    const Foam::Field<Type>& values = field.primitiveField();

    forAll(values, celli)
    {
        // Not by a comparison, which a trap would end without a message
        bool finite = true;
        for (Foam::direction k = 0; k < Foam::pTraits<Type>::nComponents; k++)
        {
            finite =
                finite && std::isfinite(Foam::component(values[celli], k));
        }

        if (!finite)
        {
            FatalErrorInFunction
                << "Field " << field.name() << " is not finite in cell "
                << celli << " at " << field.mesh().cellCentres()[celli] << ", time "
                << field.time().timeName() << ": " << values[celli] << Foam::nl
                << "Look for a time step that is too large, or for boundary"
                << " conditions that contradict each other"
                << Foam::exit(Foam::FatalError);
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::particleExchange::gatherCarriers()
{
    const volVectorField& U = fluid_.Uc;
    const vectorField& C = mesh_.C();
    const bool shared = laws_.model() == particleForceList::models::A;
    const bool thermal = bool(heatTransfer_) || laws_.needsTemperature();

    vector g(g_);
    if (frameAcceleration_)
    {
        g -= frameAcceleration_->value(mesh_.time().value());
    }

    const meshSymmetry& symmetry = map_.symmetry();

    tmp<tensorField> gradU;
    tmp<vectorField> gradT;
    if (linear_ && carrierVelocity_)
    {
        gradU = linearGradient(U, symmetry);
    }
    if (linear_ && thermal)
    {
        gradT = linearGradient(*fluid_.T, symmetry);
    }

    // As the particles share it: what they take of the pressure the fluid loses
    vectorField gradp;
    if (shared)
    {
        gradp = fluid_.gradp.primitiveField();
        smoothing_->average(gradp);
    }
    const scalarField& alphac = alphac_.field();

    const auto shares = [&](const auto& cells, carrier& c)
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

    carriers_.setSize(state_.size());
    UList<carrier>& carriers = carriers_;
    carriers = carrier();

    map_.gather
    (
        carriers,
        [&](const label celli, const point& x, const auto& cells, carrier& c)
        {
            c.U = carrierVelocity_ ? U[celli] : vector::zero;
            c.rho = fluid_.rho[celli];
            c.mu = fluid_.mu[celli];
            c.g = g;
            if (thermal)
            {
                c.T = (*fluid_.T)[celli];
            }
            if (heatTransfer_)
            {
                c.kappa = (*fluid_.kappa)[celli];
                c.Cp = (*fluid_.Cp)[celli];
            }
            if (laws_.needsSurface())
            {
                liquidSurface& s = c.surface;
                s.n = (*fluid_.n)[celli];
                s.X = C[celli] + (*fluid_.psi)[celli]*s.n;
                s.speed = (*fluid_.surfaceSpeed)[celli];
                s.curvature = (*fluid_.curvature)[celli];
            }
            if (linear_)
            {
                const vector away(x - C[celli]);
                if (carrierVelocity_)
                {
                    c.U += away & gradU()[celli];
                }
                if (thermal)
                {
                    c.T += away & gradT()[celli];
                }
            }
            shares(cells, c);
        },
        shares,
        [](carrier& c, const carrier& other)
        {
            c.alphac += other.alphac;
            c.gradp += other.gradp;
        }
    );

    for (label i = 0; symmetry.wedge() && i < carriers.size(); i++)
    {
        toSpace(carriers[i], i);
    }
}


void Foam::dew::particleExchange::toSpace(carrier& c, const label i) const
{
    c.U = map_.toSpace(c.U, i);
    c.gradp = map_.toSpace(c.gradp, i);
    c.surface.X = map_.symmetry().unfold(c.surface.X, state_.x[i]);
    c.surface.n = map_.toSpace(c.surface.n, i);
}


void Foam::dew::particleExchange::evaluateLaws()
{
    const label n = state_.size();
    const scalar dt = mesh_.time().deltaTValue();

    forces_.Su.setSize(n);
    forces_.Sn.setSize(n);
    forces_.Sp.setSize(n);
    forces_.U.setSize(n);
    if (heatTransfer_)
    {
        forces_.Qp.setSize(n);
        forces_.Tf.setSize(n);
    }
    forces_.kT.setSize(laws_.brownian() ? n : 0);
    if (laws_.needsSurface())
    {
        forces_.surfaceX.setSize(n);
        forces_.surfaceN.setSize(n);
        forces_.surfaceSpeed.setSize(n);
        forces_.surfaceCurvature.setSize(n);
        forces_.surfaceK.setSize(n);
    }
    relaxation_ = 0;

    for (label i = 0; i < n; i++)
    {
        const carrier& c = carriers_[i];
        const particle p
        {
            state_.v[i],
            state_.d[i],
            state_.rho[i],
            state_.thermal ? state_.T[i] : 0,
            state_.type[i]
        };

        // Outside the mesh there is no fluid
        particleForceList::sum f;
        scalar Qp = 0;
        if (c.rho > 0)
        {
            f = laws_.total(p, c);
            if (heatTransfer_)
            {
                Qp = heatTransfer_->Qp(p, c);
            }
        }

        forces_.Su[i] = f.Su;
        forces_.Sn[i] = f.Sn;
        forces_.Sp[i] = f.Sp;
        forces_.U[i] = c.U;
        if (laws_.brownian())
        {
            forces_.kT[i] = f.kT;
        }
        if (laws_.needsSurface())
        {
            const liquidSurface& s = c.surface;
            forces_.surfaceX[i] = s.X;
            forces_.surfaceN[i] = s.n;
            forces_.surfaceSpeed[i] = s.speed;
            forces_.surfaceCurvature[i] = s.curvature;
            forces_.surfaceK[i] = s.n == vector::zero ? 0 : f.surfaceK;
        }
        if (heatTransfer_)
        {
            forces_.Qp[i] = Qp;
            forces_.Tf[i] = c.T;
        }
        relaxation_ = max(relaxation_, f.Sp*dt/state_.mass(i));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::particleExchange::checkFinite() const
{
    findNotFinite(fluid_.U);
    findNotFinite(fluid_.p);
    if (fluid_.T)
    {
        findNotFinite(*fluid_.T);
    }
}
