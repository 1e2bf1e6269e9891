/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    setSphericalCap

Group
    grpPreProcessingUtilities

Description
    Fills the cap of constant/surfaceProperties: writes alpha.<liquid>, the
    exact share of each cell, into the start time. An alpha.<liquid> that is
    there keeps its boundary conditions; a new one has zeroGradient.

Usage
    \verbatim
    setSphericalCap               # in the case directory
    mpirun -np 2 setSphericalCap -parallel
    \endverbatim

    with, in constant/surfaceProperties,

    \verbatim
    liquid          water;
    surfaceMotion
    {
        type            quasiStatic;
        substrate       substrate;
        contactRadius   25e-6;
        contactAngle    40;
        contactLine     { type pinned; }
    }
    \endverbatim
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "fvMesh.H"
#include "quasiStatic.H"
#include "Time.H"
#include "unitConversion.H"
#include "userEntry.H"
#include "zeroGradientFvPatchFields.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::addNote
    (
        "Write alpha.<liquid> of the drop in constant/surfaceProperties"
    );

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

    const IOdictionary properties
    (
        IOobject
        (
            "surfaceProperties",
            runTime.constant(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        )
    );
    const dictionary& dict =
        dew::userEntry::subDict(properties, "surfaceMotion");

    const dew::meshSymmetry symmetry(mesh);
    const dew::sphericalCap cap
    (
        dew::surfaceMotions::quasiStatic::capAtStart(mesh, symmetry, dict)
    );

    volScalarField alpha
    (
        IOobject
        (
            IOobject::groupName("alpha", properties.get<word>("liquid")),
            runTime.timeName(),
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE
        ),
        mesh,
        dimensionedScalar(dimless, Zero),
        zeroGradientFvPatchScalarField::typeName
    );
    surfaceScalarField faces
    (
        IOobject("faces", runTime.timeName(), mesh), mesh, dimless
    );
    scalarField area;
    dew::sphereOverlap(mesh, symmetry).calculate
    (
        cap, alpha.primitiveFieldRef(), area, faces
    );

    // Not evaluated: conditions may ask for fields that are not here
    for (fvPatchScalarField& patch : alpha.boundaryFieldRef())
    {
        patch = patch.patchInternalField();
    }

    const scalar held = gSum(alpha.primitiveField()*mesh.V());
    const scalar share = dew::surfaceMotions::quasiStatic::shareInMesh
    (
        symmetry, held, cap.volume()
    );
    if (share == 0)
    {
        FatalIOErrorInFunction(dict)
            << "The drop does not fit the mesh: it has " << cap.volume()
            << " m3, of which "
            << (symmetry.wedge() ? symmetry.ringFactor()*held : held)
            << " m3 are in the mesh" << nl
            << "It must be inside as a whole; without wedge patches also its"
            << " half or quarter, between symmetry planes through its axis"
            << exit(FatalIOError);
    }

    Info<< "Volume in the mesh " << held << " m3, of the whole drop "
        << cap.volume() << " m3" << nl
        << "Contact radius " << cap.contactRadius() << " m, contact angle "
        << radToDeg(cap.angle()) << " degrees, height " << cap.height()
        << " m, radius of the sphere " << cap.radius() << " m" << nl
        << "Writing " << alpha.objectPath() << nl << endl;

    // All digits: the start of a run compares the volumes
    IOstream::defaultPrecision(max(IOstream::defaultPrecision(), 12u));
    alpha.write();

    Info<< "End\n" << endl;

    return 0;
}


// ************************************************************************* //
