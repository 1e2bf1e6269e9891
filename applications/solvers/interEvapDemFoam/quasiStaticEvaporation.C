/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
InNamespace
    Foam::dew

Description
    The equations of interEvapDemFoam for a surface whose shape a few numbers
    hold.

    The liquid loses what the equation of the vapour has: the shape changes, and
    the flow of the liquid follows from its volume,

        div(phiL) = - d(alpha)/dt - mDot/rhoL
        dU/dt + U.grad U = - grad p + div(nu (grad U + grad U^T)) + F/rhoL

    without stress on the surface. The flow of the gas is what evaporates.
\*---------------------------------------------------------------------------*/

#include "evaporations.H"

#include "fvCFD.H"
#include "gaussConvectionScheme.H"
#include "pimpleControl.H"
#include "wallFvPatch.H"
#include "weighted.H"

#include "caseDictionary.H"
#include "checkInLiquid.H"
#include "checkOptionFields.H"
#include "couplingCheck.H"
#include "evaporationLedger.H"
#include "exponentialFitted.H"
#include "gasMixture.H"
#include "gasPhase.H"
#include "gasPressure.H"
#include "heatLedger.H"
#include "heatStorage.H"
#include "interfaceTransfer.H"
#include "liquidPhase.H"
#include "liquidSpecies.H"
#include "particleEngine.H"
#include "particleExchange.H"
#include "particleOutput.H"
#include "particleReport.H"
#include "phaseRegion.H"
#include "saturation.H"
#include "stefanFlux.H"
#include "surfaceShape.H"
#include "transportedSurface.H"
#include "userEntry.H"
#include "wetRegion.H"
#include "wholeSubSteps.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

void Foam::dew::evaporate
(
    argList& args,
    Time& runTime,
    fvMesh& mesh,
    surfaceShape& surface
)
{
    #include "createControl.H"
    #include "createTimeControls.H"
    #include "createFields.H"
    dew::checkOptionFields(fv::options::New(mesh), mesh, wordList());

    dew::particleOutput output(mesh, particles);
    dew::particleReport report(runTime, particles, output, exchange);
    dew::couplingCheck check(mesh, particles, exchange);

    check.print();
    if (args.found("dry-run"))
    {
        Info<< "End of the dry run\n" << endl;
        return;
    }

    output.writeStart();

    while (runTime.run() && !surface.dry())
    {
        #include "readTimeControls.H"
        #include "setEvaporationDeltaT.H"

        ++runTime;

        Info<< "Time = " << runTime.timeName() << nl << endl;

        // Particles to the new time, under forces of the present liquid
        particles.evolve(exchange.forces());
        exchange.correct();

        #include "solveGas.H"

        // The surface gives way to it
        const scalar lost = ledger.liquidLost(runTime.deltaTValue());
        surface.evolve(lost);
        interface.distribute();
        ledger.add(lost, runTime.deltaTValue(), phiG, liquidSpecies);

        // The liquid follows
        #include "liquidRegion.H"
        while (pimple.loop())
        {
            #include "liquidUEqn.H"
            while (pimple.correct())
            {
                #include "liquidPEqn.H"
            }
        }

        surface.report(Info);
        ledger.report(gMax(scalarField(mag(U.primitiveField())*(1 - dry))));
        if (heatLedger.valid())
        {
            heatLedger->report();
        }
        pressure.report();
        exchange.report();

        // On to the new place of the surface
        #include "moveGas.H"
        #include "properties.H"

        if (surface.dry())
        {
            // Function objects see a write time, and the end
            runTime.writeAndEnd();
        }
        else
        {
            runTime.write();
        }
        report.print();
    }

    if (surface.dry())
    {
        Info<< "The liquid has dried at time " << runTime.timeName() << endl;
    }
}


// ************************************************************************* //
