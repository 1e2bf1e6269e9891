/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "liquidSpecies.H"
#include "fvcDiv.H"
#include "interfaceTransfer.H"
#include "liquidPhase.H"
#include "phaseRegion.H"
#include "Time.H"
#include "zeroGradientFvPatchFields.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::liquidSpecies::liquidSpecies
(
    liquidPhase& liquid,
    const interfaceTransfer& interface,
    const phaseRegion& region,
    const volScalarField& alpha,
    const scalar rhoL
)
:
    mesh_(alpha.mesh()),
    liquid_(liquid),
    interface_(interface),
    region_(region),
    alpha_(alpha),
    rhoL_(rhoL),
    held_(liquid.X().solved() ? liquid.size() : 0),
    mass_(liquid.size(), Zero),
    massAfter_(mass_),
    content_(liquid.size()),
    after_(mesh_.nCells(), Zero),
    before_(after_),
    all_
    (
        IOobject
        (
            "liquidHeld", mesh_.time().timeName(), mesh_,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE
        ),
        mesh_,
        dimensionedScalar("none", dimDensity, -1)
    ),
    potential_
    (
        IOobject("chiLiquid", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimMass/dimLength/dimTime, Zero),
        zeroGradientFvPatchScalarField::typeName
    ),
    uniform_(true)
{
    liquid_.setRho(rhoL);
    mesh_.setFluxRequired(potential_.name());
    forAll(held_, i)
    {
        held_.set
        (
            i,
            new volScalarField
            (
                IOobject
                (
                    "liquidHeld." + liquid.liquids().names()[i],
                    mesh_.time().timeName(), mesh_, IOobject::READ_IF_PRESENT,
                    IOobject::AUTO_WRITE
                ),
                mesh_,
                dimensionedScalar("none", dimDensity, -1)
            )
        );
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::liquidSpecies::fill()
{
    scalar worst = 0;
    forAll(alpha_, celli)
    {
        if (alpha_[celli] > SMALL)
        {
            worst = max(worst, mag(sum(liquid_.X().cell(celli)) - 1));
        }
    }
    reduce(worst, maxOp<scalar>());
    if (worst > 1e-4)
    {
        FatalErrorInFunction
            << "The mass fractions X of " << liquid_.liquids().names() << " in "
            << mesh_.time().timePath() << " do not add up to 1 in the liquid:"
            << " the sum is wrong by " << worst << nl
            << "Mend the fields; mole fractions x are mass fractions"
            << " X_i = x_i W_i/sum_j x_j W_j" << exit(FatalError);
    }
    forAll(alpha_, celli)
    {
        const scalarField& X = liquid_.X().cell(celli);
        const scalar all = sum(X);
        forAll(held_, i)
        {
            held_[i][celli] =
                alpha_[celli] > SMALL ? rhoL_*alpha_[celli]*X[i]/all : 0;
        }
    }
}


Foam::tmp<Foam::scalarField> Foam::dew::liquidSpecies::loss
(
    const label i,
    const scalar dt,
    scalarField& slope
) const
{
    const auto& faces = interface_.faces().faces();
    scalarField through(faces.size()), slopes(faces.size());
    scalar walls = 0;
    forAll(faces, k)
    {
        through[k] = interface_.through(k, i)*dt;
        slopes[k] = interface_.slope(k, i)*dt;
        walls += faces[k].wall ? through[k] : 0;
    }
    reduce(walls, sumOp<scalar>());
    tmp<scalarField> tloss(new scalarField(mesh_.nCells(), Zero));
    interface_.faces().toLiquid(through, tloss.ref());
    slope.setSize(mesh_.nCells());
    slope = 0;
    interface_.faces().toLiquid(slopes, slope);
    const scalar all = gSum(before_);
    if (all > 0)
    {
        tloss.ref() += walls*before_/all;
    }
    return tloss;
}


void Foam::dew::liquidSpecies::solveUniform
(
    const scalar dt,
    const bool last
)
{
    scalarField X(mass_.size());
    forAll(X, i)
    {
        massAfter_[i] = mass_[i] - interface_.rate(i)*dt;
        scalar slope = 0;
        for (label k = 0; k < interface_.faces().faces().size() && !last; k++)
        {
            slope += interface_.slope(k, i)*dt;
        }
        reduce(slope, sumOp<scalar>());

        // In the liquid all cells have the same, in the gas, too
        const scalar before = gMax(liquid_.X()[i].primitiveField());
        const scalar all = sum(mass_) - interface_.rate()*dt;

        // A last step takes more than there is
        X[i] =
            all + slope > 0
          ? max(massAfter_[i] + slope*before, scalar(0))/(all + slope)
          : before;
    }
    X /= max(sum(X), SMALL);
    forAll(X, i)
    {
        liquid_.X()[i].primitiveFieldRef() = X[i];
        liquid_.X()[i].correctBoundaryConditions();
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::liquidSpecies::start()
{
    if (gMin(all_.primitiveField()) < 0)
    {
        all_.primitiveFieldRef() = rhoL_*alpha_.primitiveField();
    }
    if (!several())
    {
        move();
        return;
    }
    bool read = true;
    forAll(held_, i)
    {
        read = read && gMin(held_[i].primitiveField()) >= 0;
    }
    if (!read)
    {
        fill();
    }
    move();
    if (uniform_)
    {
        solveUniform(0, true);
    }
}


void Foam::dew::liquidSpecies::solve
(
    const surfaceScalarField& phiL,
    const volScalarField& T,
    const scalar p,
    const bool last
)
{
    if (!several())
    {
        return;
    }
    if (uniform_)
    {
        solveUniform(mesh_.time().deltaTValue(), last);
        return;
    }
    solveCells(flux(phiL), T, p, last);
}


void Foam::dew::liquidSpecies::store()
{
    if (uniform_ && F_.valid())
    {
        const scalar dt = mesh_.time().deltaTValue();
        after_ =
            before_
          - dt*fvc::div(F_())().primitiveField()*mesh_.V();
        scalarField unused;
        forAll(mass_, i)
        {
            after_ -= loss(i, dt, unused);
        }
        all_.primitiveFieldRef() = region_.giveBack(after_);
        all_.writeOpt() = IOobject::AUTO_WRITE;
    }

    const scalarField own(alpha_.primitiveField()*mesh_.V());
    const scalar all = gSum(own);
    forAll(held_, i)
    {
        if (uniform_)
        {
            held_[i].primitiveFieldRef() =
                all > 0 ? massAfter_[i]/all*alpha_.primitiveField() : 0*own;
            continue;
        }
        held_[i].primitiveFieldRef() =
            region_.giveBack(after_*liquid_.X()[i].primitiveField());
    }
}


void Foam::dew::liquidSpecies::move()
{
    F_.clear();
    uniform_ =
        !several() || liquid_.wellMixed() || gSum(region_.V()) <= 0;
    if (uniform_)
    {
        before_ = region_.collect(all_.primitiveField());
    }
    else
    {
        before_ = 0;
    }
    forAll(held_, i)
    {
        mass_[i] = gSum(scalarField(held_[i].primitiveField()*mesh_.V()));
        if (!uniform_)
        {
            content_[i] = region_.collect(held_[i].primitiveField());
            before_ += content_[i];
        }
    }
    massAfter_ = mass_;
}


Foam::scalar Foam::dew::liquidSpecies::share(const label i) const
{
    const scalar all = sum(massAfter_);
    return several() && all > 0 ? massAfter_[i]/all : 1.0/mass_.size();
}


void Foam::dew::liquidSpecies::add(const label i, const scalar mass)
{
    if (several())
    {
        const scalarField own(alpha_.primitiveField()*mesh_.V());
        held_[i].primitiveFieldRef() +=
            mass/max(gSum(own), VSMALL)*alpha_.primitiveField();
    }
}


// ************************************************************************* //
