/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleReport.H"
#include "particleExchange.H"
#include "particleOutput.H"
#include "Time.H"

#include <cmath>
#include <sstream>

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::particleReport::particleReport
(
    const Time& time,
    const particleEngine& particles,
    const particleOutput& output
)
:
    time_(time),
    start_(time.value()),
    particles_(particles),
    output_(output),
    exchange_(nullptr)
{}


Foam::dew::particleReport::particleReport
(
    const Time& time,
    const particleEngine& particles,
    const particleOutput& output,
    const particleExchange& exchange
)
:
    time_(time),
    start_(time.value()),
    particles_(particles),
    output_(output),
    exchange_(&exchange)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::particleReport::print()
{
    const particleEngine::ledger& l = particles_.balance();
    const scalar wall = max(clock_.elapsedTime(), SMALL);

    const auto percent = [wall](const scalar time)
    {
        return std::round(100*time/wall);
    };
    const scalar writing = output_.time() + particles_.writeTime();

    // Four digits are enough to read
    std::ostringstream energy, clock, pace;
    energy.precision(4);
    energy << l.kineticEnergy << " J";
    const dictionary& given = particles_.properties();
    if
    (
        given.found("colloids") || given.found("dissipative")
     || given.found("immersion")
    )
    {
        energy << "  colloidal energy " << l.colloidEnergy << " J";
    }
    clock.precision(2);
    clock << std::fixed << wall;
    pace.precision(2);
    pace << (time_.value() - start_)/wall;

    Info<< "Time = " << time_.timeName()
        << "  particles " << l.particles
        << "  sub-steps " << l.subSteps
        << "  kinetic energy " << energy.str().c_str()
        << "  wall " << clock.str().c_str() << " s (engine "
        << percent(particles_.engineTime());
    if (exchange_)
    {
        const scalar known =
            particles_.engineTime() + exchange_->mapTime()
          + exchange_->exchangeTime() + writing;

        Info<< " %, map " << percent(exchange_->mapTime())
            << " %, exchange " << percent(exchange_->exchangeTime())
            << " %, fluid " << percent(max(wall - known, scalar(0)));
    }
    Info<< " %, output " << percent(writing) << " %), "
        << pace.str().c_str() << " s simulated per s" << endl;

    if (l.inserted || l.waiting)
    {
        Info<< "    inserted " << l.inserted << ", in all "
            << l.insertedTotal;
        if (l.waiting)
        {
            Info<< "; " << l.waiting << " wait for room in their region";
        }
        Info<< endl;
    }
    if (l.wallHeat != 0)
    {
        Info<< "    heat from walls " << l.wallHeat << " J" << endl;
    }
    if (l.departed)
    {
        Info<< "    left the domain: " << l.departed << " particles, "
            << l.departedMass << " kg; in all " << l.departedTotal << endl;
    }
}
