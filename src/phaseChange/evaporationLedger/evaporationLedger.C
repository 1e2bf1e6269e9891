/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "evaporationLedger.H"
#include "gasPhase.H"
#include "interfaceTransfer.H"
#include "liquidPhase.H"
#include "liquidSpecies.H"
#include "OSspecific.H"
#include "surfaceMotion.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Of the volume at the start, that may evaporate in the last step
constexpr Foam::scalar largestRemnant = 0.1;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::evaporationLedger::record::record(const evaporationLedger& ledger)
:
    IOdictionary
    (
        IOobject
        (
            "evaporation",
            ledger.mesh_.time().timeName(),
            "uniform",
            ledger.mesh_.time(),
            IOobject::READ_IF_PRESENT,
            IOobject::AUTO_WRITE
        )
    ),
    ledger_(ledger)
{}


Foam::dew::evaporationLedger::evaporationLedger
(
    const fvMesh& mesh,
    const surfaceMotion& surface,
    const interfaceTransfer& interface,
    gasPhase& gas,
    const liquidPhase& liquid,
    const scalar p0,
    const volScalarField& T,
    const speciesFields& Y
)
:
    mesh_(mesh),
    surface_(surface),
    interface_(interface),
    gas_(gas),
    Y_(Y),
    rhoL_(0),
    rate_(0),
    V0_(surface.volume()),
    names_(liquid.liquids().names()),
    evaporated_(names_.size(), Zero),
    out_(names_.size(), Zero),
    storedAtStart_(names_.size(), Zero),
    rates_(names_.size(), Zero),
    record_(new record(*this))
{
    if (record_->found("rhoL"))
    {
        rhoL_ = record_->get<scalar>("rhoL");
        V0_ = record_->get<scalar>("V0");
        rate_ = record_->get<scalar>("rate");
        record_->readEntry("evaporated", evaporated_);
        record_->readEntry("out", out_);
        record_->readEntry("storedAtStart", storedAtStart_);
    }
    else
    {
        const scalarField V(surface.alpha().primitiveField()*mesh.V());
        scalarField X(names_.size());
        forAll(X, i)
        {
            X[i] =
                liquid.X().solved()
              ? gSum(scalarField(V*liquid.X()[i].primitiveField()))/gSum(V)
              : liquid.X().standard()[i];
        }
        rhoL_ =
            liquid.liquids().rho
            (
                p0, gSum(scalarField(V*T.primitiveField()))/gSum(V),
                liquid.x(X)
            );
    }

    if (Pstream::master())
    {
        const fileName dir
        (
            mesh.time().globalPath()/"postProcessing"/"evaporation"
           /mesh.time().timeName()
        );
        mkDir(dir);
        table_.reset(new OFstream(dir/"ledger.dat"));
        OFstream& os = table_();
        os.precision(10);
        os  << "# time evaporated[kg] stored[kg] out[kg] rate[kg/s]"
            << " Tsurface[K] maxU[m/s]";
        for (const auto& measure : surface_.measures())
        {
            os  << ' ' << measure.first();
        }
        for (const word& name : columns())
        {
            os  << " evaporated_" << name << "[kg] stored_" << name
                << "[kg] out_" << name << "[kg]";
        }
        os  << endl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dew::evaporationLedger::record::writeData(Ostream& os) const
{
    const int precision = os.precision(17);
    os.writeEntry("rhoL", ledger_.rhoL_);
    os.writeEntry("V0", ledger_.V0_);
    os.writeEntry("rate", ledger_.rate_);
    os.writeEntry("evaporated", ledger_.evaporated_);
    os.writeEntry("out", ledger_.out_);
    os.writeEntry("storedAtStart", ledger_.storedAtStart_);
    os.precision(precision);
    return os.good();
}


void Foam::dew::evaporationLedger::start()
{
    if (!record_->found("rhoL"))
    {
        forAll(names_, i)
        {
            storedAtStart_[i] = gas_.held(i);
        }
    }
}


Foam::scalar Foam::dew::evaporationLedger::liquidLost(const scalar dt) const
{
    const scalar V = surface_.volume();
    const scalar lost = interface_.rate()*dt/rhoL_;
    const bool seen =
        returnReduce(interface_.faces().faces().size(), sumOp<label>());

    const bool all = !seen || V - lost < 1e-6*V0_;

    if (all && V > largestRemnant*V0_)
    {
        FatalErrorInFunction
            << "At time " << mesh_.time().timeName() << " the last "
            << 100*V/V0_ << " % of the liquid would vanish in one step" << nl
            << (
                   seen
                 ? "Lower deltaT, or maxVolumeChange, in system/controlDict"
                 : "No cell centre and no face of a wall is in it: refine the"
                   " mesh there"
               )
            << exit(FatalError);
    }

    return all ? V : lost;
}


Foam::scalar Foam::dew::evaporationLedger::outflow
(
    const label i,
    const surfaceScalarField& phiG
) const
{
    const surfaceScalarField& Gamma = gas_.GammaY(i);
    scalar out = 0;
    for (const fvPatchScalarField& Yb : Y_[i].boundaryField())
    {
        const label patchi = Yb.patch().index();
        if
        (
            !Yb.coupled()
         && !polyPatch::constraintType(Yb.patch().patch().type())
        )
        {
            out += sum
            (
                phiG.boundaryField()[patchi]*Yb
              - Gamma.boundaryField()[patchi]*Yb.snGrad()*Yb.patch().magSf()
            );
        }
    }
    return returnReduce(out, sumOp<scalar>());
}


const Foam::wordList& Foam::dew::evaporationLedger::columns() const
{
    return names_.size() > 1 ? names_ : wordList::null();
}


void Foam::dew::evaporationLedger::add
(
    const scalar lost,
    const scalar dt,
    const surfaceScalarField& phiG,
    const liquidSpecies& liquid
)
{
    rate_ = interface_.rate();

    // Of a step that the liquid did not last, and of a remnant
    const scalar more = lost*rhoL_ - rate_*dt;
    forAll(names_, i)
    {
        rates_[i] = interface_.rate(i);
        const scalar part = more*liquid.share(i);
        evaporated_[i] += rates_[i]*dt + part;
        if (Y_.solved())
        {
            out_[i] += outflow(i, phiG)*dt;
            moveVapour(i, part);
        }
    }
}


void Foam::dew::evaporationLedger::moveVapour(const label i, const scalar mass)
{
    if (gas_.isTransient())
    {
        gas_.add(i, mass);
    }
    else
    {
        out_[i] += mass;
    }
}


void Foam::dew::evaporationLedger::giveBack
(
    const scalar unmet,
    liquidSpecies& liquid
)
{
    forAll(names_, i)
    {
        const scalar mass =
            unmet*rhoL_*(rate_ != 0 ? rates_[i]/rate_ : liquid.share(i));
        evaporated_[i] -= mass;
        liquid.add(i, mass);
        if (Y_.solved())
        {
            moveVapour(i, -mass);
        }
    }
}


void Foam::dew::evaporationLedger::report(const scalar maxU)
{
    const scalar factor = surface_.wholeFactor();
    scalarField stored(names_.size());
    forAll(names_, i)
    {
        stored[i] = gas_.held(i) - storedAtStart_[i];
    }
    scalar T, least, most;
    interface_.surfaceTemperature(T, least, most);

    const auto balance = [&]
    (
        const scalar evaporated, const scalar held, const scalar out
    )
    {
        Info<< "evaporated " << factor*evaporated << " kg";
        if (Y_.solved())
        {
            const scalar error = evaporated - held - out;
            Info<< " = stored " << factor*held << " + out " << factor*out
                << ", error "
                << (evaporated != 0 ? mag(error/evaporated) : mag(error));
        }
    };
    balance(sum(evaporated_), sum(stored), sum(out_));
    Info<< "; rate " << factor*interface_.rate() << " kg/s; surface at "
        << T << " K (" << least << " to " << most << "); max|U| " << maxU
        << " m/s" << endl;
    forAll(columns(), i)
    {
        Info<< "    " << names_[i] << ": ";
        balance(evaporated_[i], stored[i], out_[i]);
        Info<< "; rate " << factor*interface_.rate(i) << " kg/s" << endl;
    }

    if (table_.valid())
    {
        OFstream& os = table_();
        os  << mesh_.time().value() << ' ' << factor*sum(evaporated_) << ' '
            << factor*sum(stored) << ' ' << factor*sum(out_) << ' '
            << factor*interface_.rate() << ' ' << T << ' ' << maxU;
        for (const auto& measure : surface_.measures())
        {
            os  << ' ' << measure.second();
        }
        forAll(columns(), i)
        {
            os  << ' ' << factor*evaporated_[i] << ' ' << factor*stored[i]
                << ' ' << factor*out_[i];
        }
        os  << endl;
    }
}


// ************************************************************************* //
