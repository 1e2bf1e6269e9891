/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// The laws on each particle

#include "particleExchange.H"
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

void Foam::dew::particleExchange::sizeForces()
{
    const label n = state_.size();
    const lawNeeds& need = needs();

    forces_.Su.setSize(n);
    forces_.Sn.setSize(n);
    forces_.Sp.setSize(n);
    forces_.U.setSize(n);
    forces_.Qp.setSize(heatTransfer_ ? n : 0);
    forces_.Tf.setSize(heatTransfer_ ? n : 0);
    forces_.kT.setSize(laws_.brownian() ? n : 0);

    forces_.Tu.setSize(need.torque ? n : 0);
    forces_.Tp.setSize(need.torque ? n : 0);
    forces_.Omega.setSize(need.torque ? n : 0);
    forces_.addedMass.setSize(need.addedMass ? n : 0);

    const label nSurface = need.surface ? n : 0;
    forces_.surfaceX.setSize(nSurface);
    forces_.surfaceN.setSize(nSurface);
    forces_.surfaceSpeed.setSize(nSurface);
    forces_.surfaceCurvature.setSize(nSurface);
    forces_.surfaceK.setSize(nSurface);

    const label nTension = need.tension ? n : 0;
    forces_.surfaceTension.setSize(nTension);
    forces_.contactAngle.setSize(nTension);
    forces_.planePull.setSize(nTension);
    forces_.film = laws_.film();
    forces_.filmViscosity.setSize(laws_.film().share > 0 ? n : 0);

    forces_.nMemory = need.memory;
    forces_.memory = memory();
}


void Foam::dew::particleExchange::evaluateLaws()
{
    const scalar dt = mesh_.time().deltaTValue();
    const lawNeeds& need = needs();

    vector g(g_);
    if (frameAcceleration_)
    {
        g -= frameAcceleration_->value(mesh_.time().value());
    }

    sizeForces();
    relaxation_ = 0;
    ranges_.restart();

    for (label i = 0; i < state_.size(); i++)
    {
        carrier c(around(i, g));
        const particle p
        {
            state_.v[i],
            state_.d[i],
            state_.rho[i],
            state_.thermal ? state_.T[i] : 0,
            state_.type[i],
            state_.omega[i],
            state_.id[i],
            need.lastForce ? lastForce_[i] : vector::zero,
            need.memory ? forces_.memory.data() + i*need.memory : nullptr
        };

        // Outside the mesh there is no fluid
        particleForceList::sum f;
        scalar Qp = 0;
        if (c.rho > 0)
        {
            particle q(p);
            q.memory = p.memory + laws_.needs().memory;
            seenVelocity_.correct(q, c);
            f = laws_.total(p, c);
            ranges_.count(p, c);
            if (heatTransfer_)
            {
                Qp = heatTransfer_->Qp(p, c);
            }
        }
        for (scalarExchange& s : scalars_)
        {
            s.evolve(i, p, c, forces_.memory);
        }

        forces_.Su[i] = f.Su;
        forces_.Sn[i] = f.Sn;
        forces_.Sp[i] = f.Sp;
        forces_.U[i] = c.U;
        if (laws_.brownian())
        {
            forces_.kT[i] = f.kT;
        }
        if (need.torque)
        {
            forces_.Tu[i] = f.Tu;
            forces_.Tp[i] = f.Tp;
            forces_.Omega[i] = 0.5*c.motion.vorticity();
        }
        if (need.addedMass)
        {
            forces_.addedMass[i] = f.addedMass;
        }
        if (need.surface)
        {
            const liquidSurface& s = c.surface;
            forces_.surfaceX[i] = s.X;
            forces_.surfaceN[i] = s.n;
            forces_.surfaceSpeed[i] = s.speed;
            forces_.surfaceCurvature[i] = s.curvature;
            forces_.surfaceK[i] = s.n == vector::zero ? 0 : f.surfaceK;
            if (forces_.filmViscosity.size())
            {
                forces_.filmViscosity[i] = f.filmViscosity;
            }
            if (need.tension)
            {
                forces_.surfaceTension[i] =
                    s.n == vector::zero ? 0 : f.surfaceTension;
                forces_.contactAngle[i] = f.contactAngle;
                forces_.planePull[i] = f.planePull;
            }
        }
        if (heatTransfer_)
        {
            forces_.Qp[i] = Qp;
            forces_.Tf[i] = c.T;
        }
        relaxation_ =
            max(relaxation_, f.Sp*dt/(state_.mass(i) + f.addedMass));
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
    for (const scalarExchange& s : scalars_)
    {
        findNotFinite(s.field());
    }
}
