/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "surroundingFluid.H"
#include "colloidConstants.H"
#include "gravity.H"
#include "polyMesh.H"
#include "slipCorrection.H"
#include "sphereInSurface.H"
#include "Time.H"
#include "userEntry.H"


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::surroundingFluid::surroundingFluid
(
    const polyMesh& mesh,
    const particleEngine& particles
)
:
    mesh_(mesh),
    particles_(particles),
    on_(particles.properties().found("fluid")),
    g_(Zero),
    mu_(0),
    rho_(0),
    lambda_(0),
    U_(Zero),
    Brownian_(false),
    T_(0),
    gradT_(Zero),
    origin_(Zero)
{
    if (on_)
    {
        read(userEntry::subDict(particles.properties(), "fluid"));
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::surroundingFluid::read(const dictionary& dict)
{
    userEntry::onlyThese
    (
        dict,
        {
            "viscosity", "density", "velocity", "Brownian", "temperature",
            "surface", "hindered", "meanFreePath"
        }
    );

    for (const word& key : wordList({"frameAcceleration", "input"}))
    {
        if (particles_.properties().found(key))
        {
            FatalIOErrorInFunction(particles_.properties())
                << "Entries 'fluid' and '" << key << "' exclude each other: the"
                << " fluid knows of no gravity but that of constant/g" << nl
                << "Remove one of them"
                << exit(FatalIOError);
        }
    }

    g_ = gravity(mesh_);

    mu_ = userEntry::positive(dict, "viscosity", dimDynamicViscosity);
    if (mag(g_) > 0 || dict.found("density"))
    {
        rho_ = userEntry::notNegative(dict, "density", dimDensity);
    }
    lambda_ = userEntry::notNegativeOr(dict, "meanFreePath", dimLength, 0);
    U_ = userEntry::pointOr(dict, "velocity", dimVelocity, Zero);

    Brownian_ = dict.getOrDefault<Switch>("Brownian", Switch(false));
    if (Brownian_ || dict.found("temperature"))
    {
        readTemperature(dict);
    }

    if (dict.found("surface"))
    {
        surface_.reset
        (
            new prescribedSurface(userEntry::subDict(dict, "surface"))
        );
        if (!particles_.restarted())
        {
            checkInside(dict, mesh_.time().value());
        }
    }
}


void Foam::dew::surroundingFluid::readTemperature(const dictionary& dict)
{
    if (!dict.isDict("temperature"))
    {
        T_ = userEntry::positive(dict, "temperature", dimTemperature);
        return;
    }

    const dictionary& linear = dict.subDict("temperature");
    userEntry::onlyThese(linear, {"value", "gradient", "origin"});
    T_ = userEntry::positive(linear, "value", dimTemperature);
    gradT_ = userEntry::point(linear, "gradient", dimTemperature/dimLength);
    origin_ = userEntry::point(linear, "origin", dimLength);
}


void Foam::dew::surroundingFluid::checkInside
(
    const dictionary& dict,
    const scalar t
) const
{
    const particleState& p = particles_.state();

    for (label i = 0; i < p.size(); i++)
    {
        const scalar out = surface_->nearest(p.x[i], t).distance;
        const scalar limit = surface_->tension() > 0 ? 0.5*p.d[i] : 0;

        if (out > limit)
        {
            // On this rank only: no collective call on the way out
            FatalIOErrorInFunction(dict)
                << "Particle " << p.id[i] << " at " << p.x[i]
                << " is outside the liquid: its centre is " << out
                << " m beyond the surface, at most " << limit
                << " m is possible at the start" << nl
                << "Move the surface, or place the particle in the liquid"
                << exit(FatalIOError);
        }
    }
}


Foam::scalar Foam::dew::surroundingFluid::thermalEnergy(const label i) const
{
    const particleState& p = particles_.state();
    const scalar T = T_ + (gradT_ & (p.x[i] - origin_));

    if (T <= 0)
    {
        FatalErrorInFunction
            << "Temperature of the fluid " << T << " K at particle "
            << p.id[i] << ", position " << p.x[i] << nl
            << "Lower fluid.temperature.gradient in"
            << " constant/particleProperties"
            << exit(FatalError);
    }
    return colloidConstants::boltzmann*T;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::dew::bulkForces& Foam::dew::surroundingFluid::forces()
{
    if (!on_)
    {
        return forces_;
    }

    const particleState& p = particles_.state();
    const label n = p.size();
    const scalar pi = constant::mathematical::pi;
    const scalar t0 = mesh_.time().value() - mesh_.time().deltaTValue();
    const bool heavy = rho_ > 0 && mag(g_) > 0;
    bulkForces& f = forces_;

    f.Sp.setSize(n);
    f.U.setSize(n);
    f.Tp.setSize(n);
    f.Omega.setSize(n);
    f.Sn.setSize(heavy ? n : 0);
    f.kT.setSize(Brownian_ ? n : 0);

    const label m = surface_ ? n : 0;
    f.surfaceX.setSize(m);
    f.surfaceN.setSize(m);
    f.surfaceSpeed.setSize(m);
    f.surfaceCurvature.setSize(m);
    f.surfaceK.setSize(m);
    f.surfaceTension.setSize(surface_ && surface_->tension() > 0 ? n : 0);
    f.contactAngle.setSize(f.surfaceTension.size());
    f.planePull.setSize(f.surfaceTension.size());
    f.film = surface_ ? surface_->film() : surfaceFilm();
    f.filmViscosity.setSize(f.film.share > 0 ? n : 0);
    f.filmViscosity = mu_;

    for (label i = 0; i < n; i++)
    {
        const scalar d = p.d[i];
        scalar share = 1;

        if (surface_)
        {
            const prescribedSurface::foot foot(surface_->nearest(p.x[i], t0));
            share = shareInLiquid(2*foot.distance/d);

            f.surfaceX[i] = foot.X;
            f.surfaceN[i] = foot.n;
            f.surfaceSpeed[i] = surface_->speed();
            f.surfaceCurvature[i] = foot.curvature;
            f.surfaceK[i] = surface_->stiffness();
            if (f.surfaceTension.size())
            {
                f.surfaceTension[i] = surface_->tension();
                f.contactAngle[i] = surface_->contactAngle();
                f.planePull[i] = surface_->planePull();
            }
        }

        f.Sp[i] = 3*pi*mu_*d/CunninghamFactor(lambda_, 0.5*d);
        f.U[i] = U_;
        f.Tp[i] = pi*mu_*pow3(d);
        f.Omega[i] = Zero;
        if (heavy)
        {
            f.Sn[i] = -share*rho_*p.volume(i)*g_;
        }
        if (Brownian_)
        {
            f.kT[i] = share > 0 ? thermalEnergy(i) : 0;
        }
    }

    return f;
}
