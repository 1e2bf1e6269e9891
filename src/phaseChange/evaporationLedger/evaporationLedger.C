/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "evaporationLedger.H"
#include "gasPhase.H"
#include "interfaceTransfer.H"
#include "liquidModel.H"
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
    const liquidModel& liquid,
    const scalar p0,
    const volScalarField& T,
    const volScalarField* Y
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
    evaporated_(0),
    out_(0),
    storedAtStart_(gas.held()),
    record_(new record(*this))
{
    if (record_->found("rhoL"))
    {
        rhoL_ = record_->get<scalar>("rhoL");
        V0_ = record_->get<scalar>("V0");
        rate_ = record_->get<scalar>("rate");
        evaporated_ = record_->get<scalar>("evaporated");
        out_ = record_->get<scalar>("out");
        storedAtStart_ = record_->get<scalar>("storedAtStart");
    }
    else
    {
        const scalarField V(surface.alpha().primitiveField()*mesh.V());
        rhoL_ =
            liquid.rho(p0, gSum(scalarField(V*T.primitiveField()))/gSum(V));
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


void Foam::dew::evaporationLedger::add
(
    const scalar lost,
    const scalar dt,
    const surfaceScalarField& phiG
)
{
    const scalar mass = lost*rhoL_;
    evaporated_ += mass;
    rate_ = interface_.rate();

    if (!Y_)
    {
        return;
    }

    const surfaceScalarField& Gamma = gas_.GammaY();
    scalar out = 0;
    for (const fvPatchScalarField& Yb : Y_->boundaryField())
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
    reduce(out, sumOp<scalar>());

    // Of a step that the liquid did not last, and of a remnant
    const scalar more = mass - interface_.rate()*dt;
    out_ += out*dt;
    if (gas_.isTransient())
    {
        gas_.add(more);
    }
    else
    {
        out_ += more;
    }
}


void Foam::dew::evaporationLedger::giveBack(const scalar unmet)
{
    const scalar mass = unmet*rhoL_;
    evaporated_ -= mass;
    if (!Y_)
    {
        return;
    }
    if (gas_.isTransient())
    {
        gas_.add(-mass);
    }
    else
    {
        out_ -= mass;
    }
}


void Foam::dew::evaporationLedger::report(const scalar maxU)
{
    const scalar factor = surface_.wholeFactor();
    const scalar stored = gas_.held() - storedAtStart_;
    scalar T, least, most;
    interface_.surfaceTemperature(T, least, most);

    Info<< "evaporated " << factor*evaporated_ << " kg";
    if (Y_)
    {
        const scalar error = evaporated_ - stored - out_;
        Info<< " = stored " << factor*stored << " + out " << factor*out_
            << ", error "
            << (evaporated_ != 0 ? mag(error/evaporated_) : mag(error));
    }
    Info<< "; rate " << factor*interface_.rate() << " kg/s; surface at "
        << T << " K (" << least << " to " << most << "); max|U| " << maxU
        << " m/s" << endl;

    if (table_.valid())
    {
        OFstream& os = table_();
        os  << mesh_.time().value() << ' ' << factor*evaporated_ << ' '
            << factor*stored << ' ' << factor*out_ << ' '
            << factor*interface_.rate() << ' ' << T << ' ' << maxU;
        for (const auto& measure : surface_.measures())
        {
            os  << ' ' << measure.second();
        }
        os  << endl;
    }
}


// ************************************************************************* //
