/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    interEvapDemFoam

Group
    grpLagrangianSolvers

Description
    A liquid that evaporates into a gas, with colloids in it.

    Vapour around the surface (Y, mass fraction), with the flow it makes, and
    heat in gas and liquid:

        d(rhoG Y)/dt + div(phiG Y) = div(rhoG D grad Y) + N delta
        rho Cp dT/dt + rhoCpPhi.grad T = div(kappa grad T) - hv N delta

    with N, the mass flux through the surface, in the equation of the vapour.
    The liquid loses what that equation has: the surface moves (surfaceMotion),
    and the flow of the liquid follows from its volume:

        div(phiL) = - d(alpha)/dt - mDot/rhoL
        dU/dt + U.grad U = - grad p + div(nu (grad U + grad U^T)) + F/rhoL

    without stress on the surface. Particles see U, T and the surface.

Usage
    \verbatim
    setSphericalCap                 # the drop into 0/alpha.<liquid>
    interEvapDemFoam                # in the case directory
    interEvapDemFoam -dry-run       # set up and check, then end
    mpirun -np 2 interEvapDemFoam -parallel
    \endverbatim
\*---------------------------------------------------------------------------*/

#include "fvCFD.H"
#include "gaussConvectionScheme.H"
#include "pimpleControl.H"
#include "sigFpe.H"
#include "wallFvPatch.H"

#include "caseDictionary.H"
#include "checkInLiquid.H"
#include "couplingCheck.H"
#include "evaporationLedger.H"
#include "exponentialFitted.H"
#include "gasModel.H"
#include "gasPhase.H"
#include "interfaceTransfer.H"
#include "liquidModel.H"
#include "particleEngine.H"
#include "particleExchange.H"
#include "particleOutput.H"
#include "particleReport.H"
#include "saturation.H"
#include "stefanFlux.H"
#include "surfaceShape.H"
#include "userEntry.H"
#include "wetRegion.H"
#include "wholeSubSteps.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Solver for an evaporating liquid with particles in it"
    );
    argList::addBoolOption
    (
        "dry-run",
        "set up the case, print the checks and end"
    );

    #include "setRootCaseLists.H"
    #include "createTime.H"
    sigFpe::unset();
    #include "createMesh.H"
    #include "createControl.H"
    #include "createTimeControls.H"
    #include "createFields.H"

    dew::particleOutput output(mesh, particles);
    dew::particleReport report(runTime, particles, output, exchange);
    dew::couplingCheck check(mesh, particles, exchange);

    check.print();
    if (args.found("dry-run"))
    {
        Info<< "End of the dry run\n" << endl;
        return 0;
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

        // Vapour and heat around the present surface: what evaporates. The
        // first step has no other to go on from
        const label nIter = (ledger.rate() == 0 ? 20 : 1)*nGasCorrectors;
        label iter = 0;
        for (; iter < nIter && interface.change() > gasTolerance; iter++)
        {
            #include "gasRows.H"
            interface.linearise(T, Y.get(), energy);
            gas.correct();
            #include "YEqn.H"
            interface.assemble(Y.get());
            #include "TEqn.H"
        }
        #include "checkGas.H"
        gas.store();

        // The surface gives way to it
        const scalar lost = ledger.liquidLost(runTime.deltaTValue());
        surface.evolve(lost);
        interface.distribute();
        ledger.add(lost, runTime.deltaTValue(), phiG);

        // The liquid follows
        #include "liquidRegion.H"
        while (pimple.loop())
        {
            #include "UEqn.H"
            while (pimple.correct())
            {
                #include "pEqn.H"
            }
        }

        ledger.report(gMax(scalarField(mag(U.primitiveField())*(1 - dry))));
        exchange.report();

        // On to the new place of the surface
        interface.move();
        gas.move();
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

    Info<< "End\n" << endl;

    return 0;
}


// ************************************************************************* //
