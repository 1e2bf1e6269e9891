/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "surfaceMotion.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(surfaceMotion);
    defineRunTimeSelectionTable(surfaceMotion, dictionary);
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::IOobject derived
(
    const Foam::fvMesh& mesh,
    const Foam::word& name,
    const Foam::word& liquidName
)
{
    return Foam::IOobject
    (
        Foam::IOobject::groupName(name, liquidName),
        mesh.time().timeName(),
        mesh
    );
}

//- The share of the liquid, in a field that must be there
Foam::IOobject shares(const Foam::fvMesh& mesh, const Foam::word& liquidName)
{
    using namespace Foam;

    IOobject io(derived(mesh, "alpha", liquidName));
    io.readOpt() = IOobject::MUST_READ;
    io.writeOpt() = IOobject::AUTO_WRITE;
    if (!io.typeHeaderOk<volScalarField>(true))
    {
        FatalErrorInFunction
            << "There is no volScalarField " << io.objectPath()
            << ", the share of the liquid " << liquidName
            << " of constant/surfaceProperties" << nl
            << "Make it with setLiquid, or change 'liquid'"
            << exit(FatalError);
    }
    return io;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::surfaceMotion::surfaceMotion
(
    const fvMesh& mesh,
    const dictionary& surfaceProperties
)
:
    mesh_(mesh),
    symmetry_(mesh),
    dict_(userEntry::subDict(surfaceProperties, "surfaceMotion")),
    liquidName_(surfaceProperties.get<word>("liquid")),
    alpha_(shares(mesh, liquidName_), mesh),
    psi_(derived(mesh, "surfaceDistance", liquidName_), mesh, dimLength),
    n_(derived(mesh, "surfaceNormal", liquidName_), mesh, dimless),
    curvature_
    (
        derived(mesh, "surfaceCurvature", liquidName_), mesh, dimless/dimLength
    ),
    speed_(derived(mesh, "surfaceSpeed", liquidName_), mesh, dimVelocity),
    area_(mesh.nCells(), scalar(0))
{
    if (alpha_.dimensions() != dimless)
    {
        FatalErrorInFunction
            << "The file " << alpha_.objectPath() << " has dimensions "
            << alpha_.dimensions() << nl
            << "A share of the volume has none: [0 0 0 0 0 0 0]"
            << exit(FatalError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::surfaceMotion::heldVolume() const
{
    return gSum(alpha_.primitiveField()*mesh_.V());
}
