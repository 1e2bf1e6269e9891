/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "reconstructed.H"
#include "addToRunTimeSelectionTable.H"
#include "syncTools.H"
#include "transportedSurface.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace distanceModels
{
    defineTypeName(reconstructed);
    addToRunTimeSelectionTable(distanceModel, reconstructed, dictionary);
}
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- On each side of the crossed cells
constexpr Foam::label nLayers = 4;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::distanceModels::reconstructed::reconstructed
(
    const transportedSurface& surface,
    const dictionary& dict
)
:
    distanceModel(surface),
    around_(surface.mesh()),
    cells_(nLayers + 1)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::distanceModels::reconstructed::bend(const paraboloidFit& fit)
{
    around_.bend
    (
        [&](const label celli, planesAround::plane& surface)
        {
            scalar K = 0;
            fit.find(around_, celli, K, surface);
        }
    );
}


Foam::scalar Foam::dew::distanceModels::reconstructed::onItsSide
(
    const label celli,
    const scalar psi
) const
{
    if (surface_.planes().of(celli) >= 0)
    {
        return psi;
    }

    const scalar side = surface_.alpha()[celli] > 0.5 ? 1 : -1;
    const vector d(surface_.mesh().C()[celli] - closest_[celli].x);
    const scalar down = -(closest_[celli].n & d);

    return
        side*psi > 0 ? side*min(mag(psi), mag(d))
      : side*down > 0 ? down
      : side*mag(d);
}


void Foam::dew::distanceModels::reconstructed::mean
(
    const label celli,
    const UList<planesAround::plane>& planes,
    scalar& psi,
    vector& n
)
{
    const point& x = surface_.mesh().C()[celli];
    scalar sum = 0;
    scalar least = GREAT;
    psi = 0;
    n = Zero;
    for (const planesAround::plane& p : planes)
    {
        const vector d(x - p.x);
        const scalar far = magSqr(d);

        const scalar up = p.n & d;
        const vector t(d - up*p.n);
        const scalar bend = t & p.bend & t;

        // Levels of psi bend less on the outside of a drop
        const scalar level =
            max(1 - up*bend/max(magSqr(t), VSMALL), scalar(0.25));

        // Not zero where all planes go through x
        const scalar w = sqr(sqr(up)/max(far, VSMALL)) + SMALL;
        psi += w*(0.5*bend/level - up);
        n += w*normalised(p.n - (p.bend & t)/level);
        sum += w;
        if (far < least)
        {
            least = far;
            closest_[celli] = p;
        }
    }
    psi /= sum;
    psi = onItsSide(celli, psi);

    // Planes on both sides of a thin pocket have none in the mean
    n = mag(n) > 1e-6*sum ? n/mag(n) : closest_[celli].n;
}


void Foam::dew::distanceModels::reconstructed::nextLayer
(
    const label layer,
    scalarField& psi,
    vectorField& n
)
{
    const fvMesh& mesh = surface_.mesh();
    const label nInternal = mesh.nInternalFaces();
    const labelUList& owner = mesh.owner();
    const labelUList& neighbour = mesh.neighbour();

    // What is behind coupled boundaries
    const label nBoundary = mesh.nBoundaryFaces();
    pointField x(nBoundary, Zero);
    vectorField nx(nBoundary, Zero);
    scalarField area(nBoundary, Zero);
    List<tensor> bends(nBoundary, tensor::zero);
    bool coupled = false;
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (patch.coupled())
        {
            coupled = true;
            forAll(patch, i)
            {
                const label celli = patch.faceCells()[i];
                const label facei = patch.start() + i - nInternal;
                if (layer_[celli] > 0)
                {
                    x[facei] = closest_[celli].x;
                    nx[facei] = closest_[celli].n;
                    area[facei] = closest_[celli].area;
                    bends[facei] = closest_[celli].bend;
                }
                else
                {
                    x[facei] = mesh.C()[celli];
                }
            }
        }
    }
    if (returnReduce(coupled, orOp<bool>()))
    {
        syncTools::swapBoundaryFacePositions(mesh, x);
        syncTools::swapBoundaryFaceList(mesh, nx);
        syncTools::swapBoundaryFaceList(mesh, area);
        syncTools::swapBoundaryFaceList(mesh, bends);
    }

    DynamicList<label>& fresh = cells_[layer];
    fresh.clear();
    for (const label celli : cells_[layer - 1])
    {
        for (const label next : mesh.cellCells()[celli])
        {
            if (layer_[next] == 0)
            {
                layer_[next] = layer;
                fresh.append(next);
            }
        }
    }
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (patch.coupled())
        {
            forAll(patch, i)
            {
                const label celli = patch.faceCells()[i];
                if
                (
                    layer_[celli] == 0
                 && area[patch.start() + i - nInternal] > 0
                )
                {
                    layer_[celli] = layer;
                    fresh.append(celli);
                }
            }
        }
    }

    DynamicList<planesAround::plane> planes;
    const auto add = [&](const planesAround::plane& p)
    {
        for (const planesAround::plane& q : planes)
        {
            if (magSqr(p.x - q.x) < 1e-12*p.area)
            {
                return;
            }
        }
        planes.append(p);
    };
    for (const label celli : fresh)
    {
        planes.clear();
        for (const label facei : mesh.cells()[celli])
        {
            if (mesh.isInternalFace(facei))
            {
                const label next =
                    owner[facei] == celli ? neighbour[facei] : owner[facei];
                if (layer_[next] > 0 && layer_[next] < layer)
                {
                    add(closest_[next]);
                }
            }
            else if (area[facei - nInternal] > 0)
            {
                const label i = facei - nInternal;
                add({x[i], nx[i], area[i], Zero, Zero, symm(bends[i])});
            }
        }
        mean(celli, planes, psi[celli], n[celli]);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::distanceModels::reconstructed::correct
(
    volScalarField& psi,
    volVectorField& n
)
{
    const fvMesh& mesh = surface_.mesh();
    scalarField& psic = psi.primitiveFieldRef();
    vectorField& nc = n.primitiveFieldRef();

    const paraboloidFit fit(mesh);
    around_.correct(surface_.planes(), surface_.angles());
    bend(fit);
    layer_.setSize(mesh.nCells());
    layer_ = 0;
    closest_.setSize(mesh.nCells());
    nc = Zero;

    around_.findNextTo(layer_, cells_[1]);
    DynamicList<planesAround::plane> planes;
    for (const label celli : cells_[1])
    {
        around_.find(celli, planes);
        mean(celli, planes, psic[celli], nc[celli]);
    }
    for (label layer = 2; layer <= nLayers; layer++)
    {
        nextLayer(layer, psic, nc);
    }

    // Beyond the band
    scalar width = 0;
    for (const DynamicList<label>& cells : cells_)
    {
        for (const label celli : cells)
        {
            width = max(width, mag(psic[celli]));
        }
    }
    reduce(width, maxOp<scalar>());
    forAll(psic, celli)
    {
        if (layer_[celli] == 0)
        {
            psic[celli] = surface_.alpha()[celli] > 0.5 ? width : -width;
        }
    }

    // At boundaries, by the plane
    psi.correctBoundaryConditions();
    forAll(mesh.boundary(), patchi)
    {
        const fvPatch& patch = mesh.boundary()[patchi];
        if (!patch.coupled())
        {
            const vectorField d(patch.Cf() - patch.Cn());
            const labelUList& cells = patch.faceCells();
            scalarField& psib = psi.boundaryFieldRef()[patchi];
            forAll(psib, facei)
            {
                const label celli = cells[facei];
                psib[facei] = psic[celli] - (d[facei] & nc[celli]);

                // Where no plane is, the cell is all of one side
                if
                (
                    surface_.planes().of(celli) < 0
                 && psib[facei]*psic[celli] < 0
                )
                {
                    psib[facei] = psic[celli];
                }
            }
        }
    }
    n.correctBoundaryConditions();
    forAll(mesh.boundary(), patchi)
    {
        if (!mesh.boundary()[patchi].coupled())
        {
            n.boundaryFieldRef()[patchi] ==
                n.boundaryField()[patchi].patchInternalField();
        }
    }
}
