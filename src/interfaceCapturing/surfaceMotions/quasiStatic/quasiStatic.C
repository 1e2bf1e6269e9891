/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "quasiStatic.H"
#include "fvMesh.H"
#include "Time.H"
#include "unitConversion.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- What remains of the volume when all of it has been lost, by round-off
constexpr Foam::scalar roundOff = 1e-9;

//- Above it a growing drop is a ball that touches the substrate [degrees]
constexpr Foam::scalar largestAngle = 179;

//- Volume of the mesh that may be missing where its points have six digits
constexpr Foam::scalar missing = 1e-5;

//- Limits of a warning and of an error
constexpr Foam::scalar CaWarning = 1e-3, CaError = 0.1;
constexpr Foam::scalar BoWarning = 0.3, BoError = 3;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::point Foam::dew::surfaceMotions::quasiStatic::inSpace
(
    const point& x
) const
{
    return
        symmetry_.wedge()
      ? symmetry_.origin() + symmetry_.radius(x)*symmetry_.radial()
      + symmetry_.height(x)*symmetry_.axis()
      : x;
}


Foam::autoPtr<Foam::dew::sphericalCap>
Foam::dew::surfaceMotions::quasiStatic::makeCap(const shape& s) const
{
    autoPtr<sphericalCap> cap;
    if (s.V > 0)
    {
        cap.reset(new sphericalCap(base_, normal_, s.a, s.theta));
    }
    return cap;
}


void Foam::dew::surfaceMotions::quasiStatic::overlap()
{
    if (!cap_.valid())
    {
        alpha_ = dimensionedScalar(dimless, Zero);
        wetFaces_ = dimensionedScalar(dimless, Zero);
        area_ = 0;
        return;
    }

    overlap_.calculate
    (
        cap_(), alpha_.primitiveFieldRef(), area_, wetFaces_
    );
    alpha_.correctBoundaryConditions();

    const scalar whole = share_*cap_->volume();
    const scalar held = heldVolume();
    if (mag(held - whole) > missing*whole)
    {
        FatalErrorInFunction
            << "The drop leaves the mesh: of its " << whole << " m3 there, "
            << held << " m3 are in the cells (contact radius "
            << cap_->contactRadius() << " m, contact angle "
            << radToDeg(cap_->angle()) << " degrees, height "
            << cap_->height() << " m)" << nl
            << "Make the mesh larger, or end the run earlier"
            << exit(FatalError);
    }
}


void Foam::dew::surfaceMotions::quasiStatic::correctGeometry()
{
    const autoPtr<sphericalCap> before
    (
        dt_ > 0 ? makeCap(before_) : autoPtr<sphericalCap>()
    );

    const auto set = [&]
    (
        const point& inMesh,
        scalar& psi, vector& n, scalar& curvature, scalar& speed
    )
    {
        const point x(inSpace(inMesh));
        point foot(base_);
        if (cap_.valid())
        {
            psi = cap_->psi(x);
            n = cap_->outward(x);
            curvature = cap_->curvature();
            foot = x + psi*n;
        }
        else
        {
            // The last drop was here
            const vector away(x - base_);
            psi = -mag(away);
            n = psi < 0 ? away/mag(away) : normal_;
            curvature = 0;
        }
        speed = before.valid() ? -before->psi(foot)/dt_ : 0;
    };

    forAll(psi_, celli)
    {
        set
        (
            mesh_.C()[celli],
            psi_[celli], n_[celli], curvature_[celli], speed_[celli]
        );
    }

    forAll(psi_.boundaryField(), patchi)
    {
        fvPatchScalarField& psi = psi_.boundaryFieldRef()[patchi];
        fvPatchVectorField& n = n_.boundaryFieldRef()[patchi];
        fvPatchScalarField& curvature = curvature_.boundaryFieldRef()[patchi];
        fvPatchScalarField& speed = speed_.boundaryFieldRef()[patchi];
        const vectorField& x = mesh_.Cf().boundaryField()[patchi];
        forAll(psi, i)
        {
            set(x[i], psi[i], n[i], curvature[i], speed[i]);
        }
    }
    psi_.correctBoundaryConditions();
    n_.correctBoundaryConditions();
    curvature_.correctBoundaryConditions();
    speed_.correctBoundaryConditions();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dew::surfaceMotions::quasiStatic::inLiquid(const point& x) const
{
    return cap_.valid() && cap_->power(inSpace(x)) > 0;
}


Foam::scalar Foam::dew::surfaceMotions::quasiStatic::crossing
(
    const point& inside,
    const scalar,
    const point& outside,
    const scalar
) const
{
    if (!cap_.valid())
    {
        return 0;
    }
    const point a(inSpace(inside)), b(inSpace(outside));
    return sphericalCap::leaves(cap_->power(a), cap_->power(b), magSqr(b - a));
}


void Foam::dew::surfaceMotions::quasiStatic::evolve(const scalar liquidLost)
{
    before_ = now_;
    dt_ = mesh_.time().deltaTValue();

    scalar V = now_.V - liquidLost/share_;
    if (V < -roundOff*now_.V || (dry() && liquidLost != 0))
    {
        FatalErrorInFunction
            << "At time " << mesh_.time().timeName() << " the drop has "
            << volume() << " m3 of liquid in the mesh and was to lose "
            << liquidLost << " m3 in one step" << nl
            << (
                   dry()
                 ? "A dry substrate neither loses nor gains liquid"
                 : "Take a smaller time step, or lose what there is"
               )
            << exit(FatalError);
    }

    if (V <= roundOff*now_.V)
    {
        now_ = shape();
    }
    else
    {
        now_.V = V;
        line_->move(V, now_.a, now_.theta);
        if (now_.theta > degToRad(largestAngle))
        {
            FatalErrorInFunction
                << "At time " << mesh_.time().timeName() << " the drop has"
                << " grown to a contact angle of " << radToDeg(now_.theta)
                << " degrees on the contact radius " << now_.a << " m" << nl
                << "Up to " << largestAngle << " are possible: end the run"
                << " earlier, or choose contactLine constantAngle"
                << exit(FatalError);
        }
    }

    alphaf_ = wetFaces_;
    cap_ = makeCap(now_);
    overlap();
    alphaf_ = 0.5*(alphaf_ + wetFaces_);
    correctGeometry();
}


Foam::List<Foam::Tuple2<Foam::word, Foam::scalar>>
Foam::dew::surfaceMotions::quasiStatic::measures() const
{
    return
    {
        {"volume", now_.V},
        {"contactRadius", now_.a},
        {"contactAngle", radToDeg(now_.theta)},
        {"height", cap_.valid() ? cap_->height() : 0}
    };
}


void Foam::dew::surfaceMotions::quasiStatic::report(Ostream& os) const
{
    os  << "drop: ";
    if (dry())
    {
        os  << "dry" << endl;
        return;
    }
    os  << "volume " << now_.V << " m3, contact radius " << now_.a
        << " m, contact angle " << radToDeg(now_.theta)
        << " degrees, height " << cap_->height() << " m" << endl;
}


void Foam::dew::surfaceMotions::quasiStatic::checkValidity
(
    const scalar sigma,
    const scalar rho,
    const scalar mu,
    const scalar g,
    const scalar U
) const
{
    if (dry())
    {
        return;
    }
    const scalar Ca = mu*U/sigma;
    const scalar Bo = rho*g*now_.a*cap_->height()/sigma;
    Info<< "drop: Ca " << Ca << ", Bo " << Bo << endl;

    if (Ca > CaError || Bo > BoError)
    {
        FatalErrorInFunction
            << "The drop is no spherical cap: Ca = mu U/sigma is " << Ca
            << ", Bo = rho g a h/sigma is " << Bo << nl
            << "surfaceMotion quasiStatic holds below " << CaError << " and "
            << BoError
            << exit(FatalError);
    }
    if (!warned_ && (Ca > CaWarning || Bo > BoWarning))
    {
        warned_ = true;
        WarningInFunction
            << "The drop is not quite a spherical cap: Ca = mu U/sigma is "
            << Ca << ", Bo = rho g a h/sigma is " << Bo << nl
            << "They should be below " << CaWarning << " and " << BoWarning
            << endl;
    }
}
