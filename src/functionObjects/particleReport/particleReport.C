/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "particleReport.H"
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
    particles_(particles),
    output_(output)
{}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::particleReport::print()
{
    const particleEngine::ledger& l = particles_.balance();
    const scalar wall = max(clock_.elapsedTime(), SMALL);

    const scalar writing = output_.time() + particles_.writeTime();

    // Four digits are enough to read
    std::ostringstream energy, clock;
    energy.precision(4);
    energy << l.kineticEnergy;
    clock.precision(2);
    clock << std::fixed << wall;

    Info<< "Time = " << time_.timeName()
        << "  particles " << l.particles
        << "  sub-steps " << l.subSteps
        << "  kinetic energy " << energy.str().c_str() << " J"
        << "  wall " << clock.str().c_str() << " s (engine "
        << std::round(100*particles_.engineTime()/wall) << " %, output "
        << std::round(100*writing/wall) << " %)" << endl;

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
    if (l.departed)
    {
        Info<< "    left the domain: " << l.departed << " particles, "
            << l.departedMass << " kg; in all " << l.departedTotal << endl;
    }
}
