/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    cfdDemFoam

Group
    grpLagrangianSolvers

Description
    One incompressible Newtonian fluid and particles, coupled both ways through
    void fraction, forces and heat (unresolved CFD-DEM), PIMPLE:

        d(alphac)/dt + div(alphac U) = 0

        d(alphac U)/dt + div(alphac U U)
          = - beta grad p + div(alphac tau) + (F + Sp (U^n - U))/rho

        d(alphac T)/dt + div(alphac U T)
          = div(alphac D grad T) + (Q + Qp (T^n - T))/(rho Cp)

        d(alphac c)/dt + div(alphac U c)
          = div(alphac (Dc + nut/Sct) grad c) + F + Sp (c^n - c)

    with beta = alphac (model A) or 1 (model B), and D = nu/Pr + nut/Prt. The
    pressure p is the dynamic one over the density, without rho g.x: gravity
    acts on the fluid through it, and on the particles as their weight and
    their buoyancy (pressureGradientForce). Energy is solved where there is a
    field T, and a scalar c for each entry of 'scalars' (scalarExchange).

Usage
    \verbatim
    cfdDemFoam                      # in the case directory
    cfdDemFoam -dry-run             # set up and check, then end
    mpirun -np 2 cfdDemFoam -parallel
    \endverbatim
\*---------------------------------------------------------------------------*/

#include "cyclicAMIFvPatch.H"
#include "fvCFD.H"
#include "dynamicFvMesh.H"
#include "fixedFluxPressureFvPatchScalarField.H"
#include "fvOptions.H"
#include "IOobjectList.H"
#include "PhaseIncompressibleTurbulenceModel.H"
#include "pimpleControl.H"
#include "reverseLinear.H"
#include "sigFpe.H"
#include "singlePhaseTransportModel.H"
#include "wallFvPatch.H"

#include "boundaryForces.H"
#include "checkOptionFields.H"
#include "couplingCheck.H"
#include "evaluateCoupled.H"
#include "linearGradient.H"
#include "meshSymmetry.H"
#include "particleEngine.H"
#include "particleExchange.H"
#include "particleOutput.H"
#include "particleReport.H"
#include "userEntry.H"
#include "wholeSubSteps.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Solver for one incompressible fluid with particles (CFD-DEM)"
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
    #include "initContinuityErrs.H"

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

    while (runTime.run())
    {
        #include "readTimeControls.H"
        #include "CourantNo.H"
        #include "setSubStepDeltaT.H"

        ++runTime;

        Info<< "Time = " << runTime.timeName() << nl << endl;

        // Of the present fluid, where its cells still are
        const dew::bulkForces& forces = exchange.forces();
        #include "moveMesh.H"

        // Particles to the new time
        particles.evolve(forces);

        // What the fluid sees of them: void fraction, momentum, heat
        exchange.correct();
        #include "alphacEqn.H"

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

            // With the flux that continuity has made: heat is conserved
            if (energy)
            {
                #include "TEqn.H"
            }
            #include "scalarEqns.H"

            if (pimple.turbCorr())
            {
                transport.correct();
                turbulence->correct();
                #include "carrierTurbulence.H"
            }
        }

        exchange.report();
        runTime.write();
        report.print();
    }

    Info<< "End\n" << endl;

    return 0;
}


// ************************************************************************* //
