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
    A liquid that evaporates into a gas, with particles in it.

    Vapour around the surface (Y, mass fraction), with the flow it makes, and
    heat in gas and liquid:

        d(rhoG Y)/dt + div(phiG Y) = div(rhoG D grad Y) + N delta
        rho Cp dT/dt + rhoCpPhi.grad T = div(kappa grad T) - hv N delta

    with N, the mass flux through the surface, in the equation of the vapour:
    what the gas gains there the liquid loses. How the surface moves
    (surfaceMotion) decides on the rest:

    - a shape (quasiStatic, film) gives way as a whole, and the flow of the
      liquid follows from it: quasiStaticEvaporation.C;
    - a surface that the flow carries (isoAdvector, MULES) has the equations of
      two fluids, with what evaporates in their volume:
      transportedEvaporation.C.

    Particles see U, T and the surface, and exchange heat with the cells they are in.

Usage
    \verbatim
    setLiquid                       # the drop into 0/alpha.<liquid>
    interEvapDemFoam                # in the case directory
    interEvapDemFoam -dry-run       # set up and check, then end
    mpirun -np 2 interEvapDemFoam -parallel
    \endverbatim
\*---------------------------------------------------------------------------*/

#include "evaporations.H"

#include "dynamicFvMesh.H"
#include "fvCFD.H"
#include "sigFpe.H"

#include "caseDictionary.H"
#include "handOver.H"
#include "surfaceShape.H"
#include "transportedSurface.H"

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
    #include "createCaseMesh.H"

    if (mesh.dynamic())
    {
        FatalErrorInFunction
            << "constant/dynamicMeshDict: " << mesh.type() << " moves or changes"
            << " the mesh, and what evaporates is held by cells of a mesh at"
            << " rest" << nl
            << "Remove the file, or use 'dynamicFvMesh staticFvMesh;'"
            << exit(FatalError);
    }

    dictionary surfaceProperties
    (
        dew::caseDictionary(runTime, "surfaceProperties")
    );
    autoPtr<dew::surfaceMotion> surface
    (
        dew::surfaceMotion::New<dew::surfaceMotion>(mesh, surfaceProperties)
    );

    if (!isA<dew::surfaceShape>(surface()))
    {
        dew::transportedSurface& carried =
            refCast<dew::transportedSurface>(surface());

        // The start may be one that was handed over before
        const bool wasShape =
            IOobject
            (
                "surface", runTime.timeName(), "uniform", mesh
            ).typeHeaderOk<IOdictionary>(true);

        surfaceProperties =
            wasShape
          ? dew::handOver(carried, surfaceProperties).shape()
          : dew::evaporate(args, runTime, mesh, carried);
        surface.clear();
        if (!surfaceProperties.empty())
        {
            Info<< "The liquid is a cap from here on: "
                << surfaceProperties.subDict("surfaceMotion") << endl;
            surface =
                dew::surfaceMotion::New<dew::surfaceMotion>
                (
                    mesh, surfaceProperties
                );
        }
    }
    if (surface.valid())
    {
        dew::evaporate
        (
            args, runTime, mesh, refCast<dew::surfaceShape>(surface())
        );
    }

    Info<< "End\n" << endl;

    return 0;
}


// ************************************************************************* //
