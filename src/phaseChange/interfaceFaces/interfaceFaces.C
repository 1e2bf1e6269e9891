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
    sameSide_("sameSide", sameGas_),
    sameLiquid_("sameLiquid", sameGas_)
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
    const scalar d
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
    face.wall = false;
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


Foam::scalar Foam::dew::interfaceFaces::addWall
(
    const label patch,
    const label facei,
    const label gas
)
{
    // Shares of liquid below are rounding
    const scalar least = 1e-6;
    const fvPatch& wall = mesh_.boundary()[patch];
    const point& C = mesh_.cellCentres()[gas];
    const vector& n = surface_.n()[gas];
    const vector e(-wall.Sf()[facei]/wall.magSf()[facei]);
    const scalar d =
        1/mesh_.nonOrthDeltaCoeffs().boundaryField()[patch][facei];
    const scalar rise = n & e;
    if (rise <= 0 || surface_.alpha()[gas] < least)
    {
        return 0;
    }

    // psi at the wall, above which the surface has the height psi/rise
    corners_.clear();
    for (const label pointi : mesh_.faces()[wall.start() + facei])
    {
        const point& x = mesh_.points()[pointi];
        corners_.append({x, surface_.psi()[gas] - (n & (x - C))});
    }
    clip(0, 1);
    clip(rise*d, -1);

    vector S(Zero);
    scalar sum = 0, weights = 0;
    for (label i = 2; i < corners_.size(); i++)
    {
        const wallPoint& a = corners_[0];
        const wallPoint& b = corners_[i - 1];
        const wallPoint& c = corners_[i];
        const vector part(0.5*((b.x - a.x) ^ (c.x - a.x)));
        S += part;
        weights += mag(part);
        sum += mag(part)*(a.psi + b.psi + c.psi)/3;
    }
    const scalar share = mag(S)/wall.magSf()[facei];
    if (share < least)
    {
        return 0;
    }
    const scalar f =
        min(max(sum/(weights*rise*d), scalar(least)), scalar(1 - least));

    faces_.append
    (
        interfaceFace
        {
            wall.start() + facei, patch, facei, gas, -1, true, mag(S),
            (1 - f)*d, f*d, e, n
        }
    );
    return min(share, scalar(1));
}


void Foam::dew::interfaceFaces::clip(const scalar level, const label side)
{
    clipped_.clear();
    forAll(corners_, i)
    {
        const wallPoint& a = corners_[i];
        const wallPoint& b = corners_[corners_.fcIndex(i)];
        const scalar fa = side*(a.psi - level);
        const scalar fb = side*(b.psi - level);
        if (fa >= 0)
        {
            clipped_.append(a);
        }
        if ((fa >= 0) != (fb >= 0))
        {
            clipped_.append({a.x + fa/(fa - fb)*(b.x - a.x), level});
        }
    }
    corners_.swap(clipped_);
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
                -1, facei, g, l, C[l], psi[l], C[g], 1/delta[facei]
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
                        1/delta.boundaryField()[patchi][facei]
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
                if (!gas_[celli])
                {
                    sameGas[facei] = 0;
                }
                else if (isA<wallFvPatch>(patch))
                {
                    sameGas[facei] -= addWall(patchi, facei, celli);
                    sameSide[facei] = sameGas[facei];
                }
            }
        }
    }

    sameLiquid_ = sameSide_ - sameGas_;
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
