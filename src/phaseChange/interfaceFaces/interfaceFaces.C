/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "interfaceFaces.H"
#include "localMax.H"
#include "surfaceMotion.H"
#include "syncTools.H"
#include "wallFvPatch.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::interfaceFaces::interfaceFaces
(
    const fvMesh& mesh,
    const surfaceMotion& surface
)
:
    mesh_(mesh),
    surface_(surface),
    gas_(mesh.nCells()),
    sameGas_
    (
        IOobject("sameGas", mesh.time().timeName(), mesh),
        mesh,
        dimensionedScalar("one", dimless, 1)
    ),
    sameSide_("sameSide", sameGas_)
{
    correct();
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::interfaceFaces::add
(
    const label patch,
    const label facei,
    const label gas,
    const label liquid,
    const point& xLiquid,
    const scalar psiLiquid,
    const point& xGas,
    const scalar d,
    const bool wall
)
{
    // A centre on the surface itself would be no distance from it
    const scalar least = 1e-6;
    const scalar f =
        min
        (
            max
            (
                surface_.crossing
                (
                    xLiquid, psiLiquid, xGas, surface_.psi()[gas]
                ),
                least
            ),
            1 - least
        );

    interfaceFace face;
    face.patch = patch;
    face.patchFace = facei;
    face.face =
        patch < 0 ? facei : mesh_.boundary()[patch].start() + facei;
    face.gas = gas;
    face.liquid = liquid;
    face.wall = wall;
    face.S =
        patch < 0
      ? mesh_.magSf()[facei]
      : mesh_.magSf().boundaryField()[patch][facei];
    face.dL = f*d;
    face.dG = (1 - f)*d;
    face.e = (xGas - xLiquid)/mag(xGas - xLiquid);
    face.n = surface_.n()[gas];
    faces_.append(face);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::interfaceFaces::correct()
{
    const volScalarField& psi = surface_.psi();
    const vectorField& C = mesh_.cellCentres();
    const surfaceScalarField& delta = mesh_.nonOrthDeltaCoeffs();

    faces_.clear();
    forAll(gas_, celli)
    {
        gas_[celli] = psi[celli] <= 0;
    }

    forAll(mesh_.owner(), facei)
    {
        const label own = mesh_.owner()[facei];
        const label nei = mesh_.neighbour()[facei];

        sameGas_[facei] = gas_[own] && gas_[nei];
        sameSide_[facei] = gas_[own] == gas_[nei];

        if (gas_[own] != gas_[nei])
        {
            const label g = gas_[own] ? own : nei;
            const label l = gas_[own] ? nei : own;
            add
            (
                -1, facei, g, l, C[l], psi[l], C[g], 1/delta[facei], false
            );
        }
    }

    forAll(mesh_.boundary(), patchi)
    {
        const fvPatch& patch = mesh_.boundary()[patchi];
        const labelUList& cells = patch.faceCells();
        scalarField& sameGas = sameGas_.boundaryFieldRef()[patchi];
        scalarField& sameSide = sameSide_.boundaryFieldRef()[patchi];

        sameGas = 1;
        sameSide = 1;

        if (patch.coupled())
        {
            const scalarField other
            (
                psi.boundaryField()[patchi].patchNeighbourField()
            );
            const vectorField across(patch.delta());

            forAll(cells, facei)
            {
                const label celli = cells[facei];
                const bool otherGas = other[facei] <= 0;

                sameGas[facei] = gas_[celli] && otherGas;
                sameSide[facei] = gas_[celli] == otherGas;

                if (gas_[celli] && !otherGas)
                {
                    add
                    (
                        patchi, facei, celli, -1, C[celli] + across[facei],
                        other[facei], C[celli],
                        1/delta.boundaryField()[patchi][facei], false
                    );
                }
            }
        }
        else
        {
            // Also of wedges: gas has no values in liquid cells. Empty
            // patches have faces, but no values
            forAll(sameGas, facei)
            {
                const label celli = cells[facei];
                const point& Cf = patch.Cf()[facei];

                if (!gas_[celli])
                {
                    sameGas[facei] = 0;
                }
                else if (isA<wallFvPatch>(patch) && surface_.wets(patchi, facei))
                {
                    sameGas[facei] = 0;
                    sameSide[facei] = 0;
                    add
                    (
                        patchi, facei, celli, -1, Cf,
                        psi.boundaryField()[patchi][facei], C[celli],
                        1/delta.boundaryField()[patchi][facei], true
                    );
                }
            }
        }
    }
}


Foam::tmp<Foam::surfaceScalarField> Foam::dew::interfaceFaces::beside() const
{
    volScalarField cells
    (
        IOobject("besideSurface", mesh_.time().timeName(), mesh_),
        mesh_,
        dimensionedScalar(dimless, Zero)
    );
    for (const interfaceFace& face : faces_)
    {
        cells[face.gas] = 1;
    }
    toLiquid(scalarField(faces_.size(), 1), cells.primitiveFieldRef());
    cells.primitiveFieldRef() = pos(cells.primitiveField() - 0.5);
    cells.correctBoundaryConditions();
    return localMax<scalar>(mesh_).interpolate(cells);
}


void Foam::dew::interfaceFaces::toLiquid
(
    const UList<scalar>& values,
    scalarField& cells
) const
{
    const label nInternal = mesh_.nInternalFaces();
    scalarList across(mesh_.nFaces() - nInternal, Zero);

    forAll(faces_, k)
    {
        const interfaceFace& face = faces_[k];
        if (face.liquid >= 0)
        {
            cells[face.liquid] += values[k];
        }
        else if (!face.wall)
        {
            across[face.face - nInternal] += values[k];
        }
    }

    syncTools::swapBoundaryFaceList(mesh_, across);

    for (const fvPatch& patch : mesh_.boundary())
    {
        if (patch.coupled())
        {
            forAll(patch, facei)
            {
                const label celli = patch.faceCells()[facei];
                if (!gas_[celli])
                {
                    cells[celli] += across[patch.start() - nInternal + facei];
                }
            }
        }
    }
}


Foam::scalarField Foam::dew::interfaceFaces::ofLiquid
(
    const volScalarField& field
) const
{
    scalarField values(faces_.size());

    // Values across coupled patches, each patch once
    List<scalarField> other(mesh_.boundary().size());
    forAll(other, patchi)
    {
        if (mesh_.boundary()[patchi].coupled())
        {
            other[patchi] =
                field.boundaryField()[patchi].patchNeighbourField();
        }
        else
        {
            other[patchi] = field.boundaryField()[patchi];
        }
    }

    forAll(faces_, k)
    {
        const interfaceFace& face = faces_[k];
        values[k] =
            face.liquid >= 0
          ? field[face.liquid]
          : other[face.patch][face.patchFace];
    }

    return values;
}


// ************************************************************************* //
