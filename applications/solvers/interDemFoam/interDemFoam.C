/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    interDemFoam

Group
    grpLagrangianSolvers

Description
    Two incompressible, immiscible fluids with the surface between them, and
    particles, coupled both ways through void fraction and forces, PIMPLE:

        d(alphac)/dt + div(alphac U) = 0

        d(alphac alpha)/dt + div(alphac alpha U) = 0

        d(alphac rho U)/dt + div(alphac rho U U)
          = beta (- grad p_rgh + sigma K grad I - (rho1 - rho2) g.x grad alpha)
            + div(alphac tau) + beta grad_s(sigma) delta + F + Sp (U^n - U)

    with the share alpha of the liquid in the fluids, and beta = alphac (model
    A) or 1 (model B). The pressure is p = p_rgh + rho g.x; x is that of the
    surface in the force of gravity, which makes a tilted level at rest one of
    the solutions.

    The surface moves first, by the flux of the last pressure equation, and so
    do its void fraction and its mass: each cell keeps

        alphacFluid^n+1 = alphacFluid^n - dt div(alphac U)^n

    exactly, and liquid and momentum with it, whatever the particles did and
    the tolerance of the pressure was. The pressure equation leads alphacFluid
    back to the particles' void fraction.

Usage
    \verbatim
    interDemFoam                    # in the case directory
    interDemFoam -dry-run           # set up and check, then end
    mpirun -np 2 interDemFoam -parallel
    \endverbatim
\*---------------------------------------------------------------------------*/

#include "cyclicAMIFvPatch.H"
#include "fvCFD.H"
#include "dynamicFvMesh.H"
#include "fvOptions.H"
#include "pimpleControl.H"
#include "reverseLinear.H"
#include "sigFpe.H"
#include "turbulentTransportModel.H"

#include "boundaryForces.H"
#include "caseDictionary.H"
#include "checkField.H"
#include "checkOptionFields.H"
#include "couplingCheck.H"
#include "evaluateCoupled.H"
#include "fromFaces.H"
#include "linearGradient.H"
#include "meshSymmetry.H"
#include "particleEngine.H"
#include "particleExchange.H"
#include "particleOutput.H"
#include "particleReport.H"
#include "surfaceTension.H"
#include "transportedSurface.H"
#include "twoFluids.H"
#include "userEntry.H"
#include "wholeSubSteps.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Solver for two immiscible fluids with particles (VOF and CFD-DEM)"
    );
    argList::addBoolOption
    (
        "dry-run",
        "set up the case, print the checks and end"
    );

    #include "setRootCaseLists.H"
    #include "createTime.H"
    #include "createCaseMesh.H"
    #include "createControl.H"
    #include "createTimeControls.H"
    #include "createFields.H"

    dew::particleOutput output(mesh, particles);
    dew::particleReport report(runTime, particles, output, exchange);
    dew::couplingCheck check(mesh, particles, exchange);

    check.print();
    #include "checkCapillary.H"
    #include "checkViscous.H"
    if (args.found("dry-run"))
    {
        Info<< "End of the dry run\n" << endl;
        return 0;
    }

    #include "startPressure.H"
    output.writeStart();

    while (runTime.run())
    {
        #include "readTimeControls.H"
        #include "CourantNo.H"
        #include "setTwoFluidDeltaT.H"
        #include "checkViscous.H"

        ++runTime;

        Info<< "Time = " << runTime.timeName() << nl << endl;

        // Of the present fluids, where their cells still are
        const dew::bulkForces& forces = exchange.forces();
        #include "moveMesh.H"

        // The surface goes with the flow
        #include "alphaEqn.H"

        // Particles to the new time, and what the fluids see of them
        particles.evolve(forces);
        exchange.correct();
        alphacf = fvc::interpolate(alphac);

        while (pimple.loop())
        {
            #include "UEqn.H"

            // Each time: a solver cannot go on from a residual that is NaN
            exchange.checkFinite();
            while (pimple.correct())
            {
                #include "pEqn.H"
                exchange.checkFinite();
            }
            #include "carrierPressure.H"
            #include "carrierVelocity.H"

            if (pimple.turbCorr())
            {
                turbulence->correct();
                #include "carrierTurbulence.H"
            }
        }

        // What the particles will see of it
        surface.correctSpeed(U);

        #include "surfaceReport.H"
        exchange.report();
        runTime.write();
        report.print();
    }

    Info<< "End\n" << endl;

    return 0;
}


// ************************************************************************* //
