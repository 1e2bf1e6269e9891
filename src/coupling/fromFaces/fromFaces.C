/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fromFaces.H"
#include "extrapolatedCalculatedFvPatchFields.H"
#include "surfaceFields.H"
#include "volFields.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeNameAndDebug(fromFaces, 0);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Sum of what each face gives to the cells beside it
template<class Type, class OfFace>
void sumOverFaces
(
    const Foam::fvMesh& mesh,
    Foam::Field<Type>& sum,
    const OfFace& ofFace
)
{
    const Foam::labelUList& own = mesh.owner();
    const Foam::labelUList& nei = mesh.neighbour();
    const Foam::vectorField& Sf = mesh.Sf().primitiveField();
    const Foam::scalarField& magSf = mesh.magSf().primitiveField();
    forAll(own, facei)
    {
        const Type value(ofFace(-1, facei, Sf[facei], magSf[facei]));
        sum[own[facei]] += value;
        sum[nei[facei]] += value;
    }
    forAll(mesh.boundary(), patchi)
    {
        const Foam::fvPatch& patch = mesh.boundary()[patchi];
        const Foam::labelUList& cells = patch.faceCells();
        const Foam::vectorField& S = patch.Sf();
        const Foam::scalarField& magS = patch.magSf();
        forAll(S, i)
        {
            sum[cells[i]] += ofFace(patchi, i, S[i], magS[i]);
        }
    }
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::fromFaces::fromFaces(const fvMesh& mesh)
:
    MeshObject<fvMesh, GeometricMeshObject, fromFaces>(mesh)
{
    symmTensorField sum(mesh.nCells(), Zero);
    sumOverFaces
    (
        mesh, sum,
        [](const label, const label, const vector& S, const scalar magS)
        {
            return symmTensor(sqr(S)/magS);
        }
    );
    inverse_ = inv(sum);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::volVectorField> Foam::dew::fromFaces::reconstruct
(
    const surfaceScalarField& phi
)
{
    const fvMesh& mesh = phi.mesh();
    const symmTensorField& inverse = New(mesh).inverse_;

    tmp<volVectorField> tv
    (
        new volVectorField
        (
            IOobject("fromFaces", phi.instance(), mesh),
            mesh,
            dimensionedVector(phi.dimensions()/dimArea, Zero),
            extrapolatedCalculatedFvPatchVectorField::typeName
        )
    );
    vectorField& v = tv.ref().primitiveFieldRef();
    sumOverFaces
    (
        mesh, v,
        [&]
        (
            const label patchi, const label i,
            const vector& S, const scalar magS
        )
        {
            const scalar flux =
                patchi < 0 ? phi[i] : phi.boundaryField()[patchi][i];
            return vector(S*(flux/magS));
        }
    );
    forAll(v, celli)
    {
        v[celli] = inverse[celli] & v[celli];
    }
    tv.ref().correctBoundaryConditions();

    return tv;
}
