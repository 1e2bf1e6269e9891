/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    demFoam

Group
    grpLagrangianSolvers

Description
    Particles alone: contact, walls, gravity, heat conduction, and a given
    fluid around them (surroundingFluid). The case is set up in
    constant/particleProperties; the mesh gives the domain, its cyclic
    sides and, where wanted, the walls.

Usage
    \verbatim
    demFoam                       # in the case directory
    mpirun -np 2 demFoam -parallel
    \endverbatim
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "particleEngine.H"
#include "particleOutput.H"
#include "particleReport.H"
#include "polyMesh.H"
#include "surroundingFluid.H"
#include "Time.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote("Solver for particles alone (DEM)");

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createPolyMesh.H"

    autoPtr<dew::particleEngine> engine(dew::particleEngine::New(mesh));
    dew::particleEngine& particles = engine();

    // What the entry fluid tells of, if anything
    dew::surroundingFluid fluid(mesh, particles);

    // Cloud, VTK and table of every write time
    dew::particleOutput output(mesh, particles);
    dew::particleReport report(runTime, particles, output);

    output.writeStart();

    while (runTime.run())
    {
        ++runTime;

        particles.evolve(fluid.forces());

        runTime.write();

        report.print();
    }

    Info<< "End\n" << endl;

    return 0;
}


// ************************************************************************* //
