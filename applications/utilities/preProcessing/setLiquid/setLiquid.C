/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    setLiquid

Group
    grpPreProcessingUtilities

Description
    Fills shapes with liquid: writes alpha.<liquid>, the exact share of each
    cell, into the start time. An alpha.<liquid> that is there keeps its
    boundary conditions; a new one has zeroGradient. Volumes set are printed
    beside those by formula.

Usage
    \verbatim
    setLiquid                       # in the case directory
    setLiquid -dict system/second   # another dictionary
    mpirun -np 2 setLiquid -parallel
    \endverbatim

    with, in system/setLiquidDict,

    \verbatim
    liquid  water;

    shapes
    {
        drop { type sphere; centre (0 0 0); radius 1e-3; }
    }
    \endverbatim

    All entries are described in filling.H, the shapes in their headers.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "filling.H"
#include "fvMesh.H"
#include "Time.H"
#include "volFields.H"
#include "zeroGradientFvPatchFields.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote("Write alpha.<liquid> of the shapes in setLiquidDict");
    argList::addOption("dict", "file", "Use instead of system/setLiquidDict");

    #include "setRootCase.H"
    #include "createTime.H"
    const fvMesh mesh
    (
        IOobject
        (
            polyMesh::defaultRegion,
            runTime.timeName(),
            runTime,
            IOobject::MUST_READ
        )
    );

    const IOdictionary dict
    (
        IOobject::selectIO
        (
            IOobject
            (
                "setLiquidDict",
                runTime.system(),
                mesh,
                IOobject::MUST_READ,
                IOobject::NO_WRITE
            ),
            args.getOrDefault<fileName>("dict", "")
        )
    );
    volScalarField alpha
    (
        IOobject
        (
            IOobject::groupName("alpha", dict.get<word>("liquid")),
            runTime.timeName(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE
        ),
        mesh,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    );

    const dew::meshSymmetry symmetry(mesh);
    const dew::filling liquid(mesh, symmetry, dict);
    alpha.primitiveFieldRef() = liquid.share();

    // Not evaluated: conditions may ask for fields that are not here
    for (fvPatchScalarField& patch : alpha.boundaryFieldRef())
    {
        patch = patch.patchInternalField();
    }

    liquid.report(Info);
    Info<< "Writing " << alpha.objectPath() << nl << endl;

    // All digits: the start of a run compares the volumes
    IOstream::defaultPrecision(max(IOstream::defaultPrecision(), 15u));
    alpha.write();

    Info<< "End\n" << endl;

    return 0;
}


// ************************************************************************* //
