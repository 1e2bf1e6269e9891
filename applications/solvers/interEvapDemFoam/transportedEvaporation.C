/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
InNamespace
    Foam::dew

Description
    The equations of interEvapDemFoam for a surface that the flow carries: those
    of interDemFoam for two fluids, with the density of the gas rhoG, and

        d(alphac)/dt + div(alphac U) = e

        d(alphac alpha)/dt + div(alphac alpha U) = - mDot/rhoL

        e = mDot (1/rhoG - 1/rhoL) - (1 - alpha)/rhoG D(rhoG)/Dt

    The flux that carries the surface has not e in it (carryingFlux.H). What
    evaporates is found at the new place of the surface, and leaves the liquid
    after the next transport; it is on its way in between (leaving). A cap that
    is too thin for the mesh is handed over (handOver).
\*---------------------------------------------------------------------------*/

#include "evaporations.H"

#include "fvCFD.H"
#include "fvOptions.H"
#include "gaussConvectionScheme.H"
#include "pimpleControl.H"
#include "reverseLinear.H"
#include "turbulentTransportModel.H"
#include "wallFvPatch.H"
#include "weighted.H"

#include "boundaryForces.H"
#include "caseDictionary.H"
#include "checkField.H"
#include "checkOptionFields.H"
#include "couplingCheck.H"
#include "evaluateCoupled.H"
#include "evaporatingFluids.H"
#include "evaporationLedger.H"
#include "exponentialFitted.H"
#include "fromFaces.H"
#include "gasMixture.H"
#include "gasPhase.H"
#include "gasPressure.H"
#include "handOver.H"
#include "heatLedger.H"
#include "heatStorage.H"
#include "interfaceTransfer.H"
#include "linearGradient.H"
#include "liquidPhase.H"
#include "liquidSpecies.H"
#include "meshSymmetry.H"
#include "neighbourSum.H"
#include "particleEngine.H"
#include "particleExchange.H"
#include "particleOutput.H"
#include "particleReport.H"
#include "phaseRegion.H"
#include "saturation.H"
#include "surfaceTension.H"
#include "transportedSurface.H"
#include "userEntry.H"
#include "wholeSubSteps.H"

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

Foam::dictionary Foam::dew::evaporate
(
    argList& args,
    Time& runTime,
    fvMesh& mesh,
    transportedSurface& surface
)
{
    #include "createControl.H"
    #include "createTimeControls.H"
    #include "createTransported.H"

    dew::particleOutput output(mesh, particles);
    dew::particleReport report(runTime, particles, output, exchange);
    dew::couplingCheck check(mesh, particles, exchange);

    check.print();
    #include "checkCapillary.H"
    #include "checkViscous.H"
    if (args.found("dry-run"))
    {
        Info<< "End of the dry run\n" << endl;
        return dictionary();
    }

    const dew::handOver thin(surface, surfaceProperties);

    #include "startPressure.H"
    output.writeStart();

    bool courantTold = false;
    while (runTime.run())
    {
        #include "readTimeControls.H"
        #include "CourantNo.H"
        #include "checkCourant.H"
        #include "limitRecession.H"
        #include "setTwoFluidDeltaT.H"
        #include "checkViscous.H"

        ++runTime;

        Info<< "Time = " << runTime.timeName() << nl << endl;

        const dew::bulkForces& forces = exchange.forces();

        // The surface goes with the flow, and gives way
        #include "evaporatingAlphaEqn.H"

        // Particles to the new time, and what the fluids see of them
        particles.evolve(forces);
        exchange.correct();
        alphacf = fvc::interpolate(alphac);

        // Vapour and heat around the surface: what evaporates
        if (gas.isTransient())
        {
            gasCarried.reset
            (
                new surfaceScalarField
                (
                    sameGas*fvc::interpolate(gas.rho())*phiL
                )
            );
        }
        #include "solveGas.H"

        interface.distribute();
        leaving.primitiveFieldRef() =
            interface.mDot().field()*runTime.deltaTValue();
        #include "lastRemnant.H"
        ledger.add
        (
            interface.rate()*runTime.deltaTValue()/rhoL + remnant,
            runTime.deltaTValue(),
            phiG,
            liquidSpecies
        );
        expansion.primitiveFieldRef() =
            gas.expansion(phiG)().field() - interface.sourceOf(1/rhoL)();

        // Both fluids, with the volume that phase change makes
        alphacFluid.primitiveFieldRef() +=
            runTime.deltaTValue()*expansion.primitiveField();
        while (pimple.loop())
        {
            #include "UEqn.H"

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
        alphacFluid.primitiveFieldRef() -=
            runTime.deltaTValue()*expansion.primitiveField();

        // What the particles will see of it
        #include "carryingFlux.H"

        #include "surfaceReport.H"
        ledger.report(gMax(mag(U.primitiveField())));
        if (heatLedger.valid())
        {
            heatLedger->report();
        }
        pressure.report();
        exchange.report();

        if (thin.due())
        {
            // What is on its way leaves now; the quasi-static p is another one
            ledger.giveBack
            (
                surface.recede
                (
                    leaving.primitiveField()*mesh.V()/rhoL, alphacFluid
                ),
                liquidSpecies
            );
            surface.correct(flow, true);
            leaving == dimensionedScalar(dimDensity, Zero);
            p.writeOpt() = IOobject::NO_WRITE;
            runTime.writeNow();
            report.print();
            return thin.shape();
        }

        runTime.write();
        report.print();
    }

    return dictionary();
}


// ************************************************************************* //
