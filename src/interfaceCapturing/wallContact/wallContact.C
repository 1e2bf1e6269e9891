/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "wallContact.H"
#include "mathematicalConstants.H"
#include "symmetryPlanePolyPatch.H"
#include "symmetryPolyPatch.H"
#include "transportedSurface.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Does the plane through x cut the face?
bool cuts
(
    const polyMesh& mesh, const label facei, const point& x, const vector& n
)
{
    scalar low = GREAT, high = -GREAT;
    for (const label pointi : mesh.faces()[facei])
    {
        const scalar s = (mesh.points()[pointi] - x) & n;
        low = min(low, s);
        high = max(high, s);
    }
    return low < 0 && high > 0;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::List<Foam::labelPair> Foam::dew::wallContact::betweenFaces
(
    const transportedSurface& surface
)
{
    const fvMesh& mesh = surface.mesh();
    const scalarField& alpha = surface.alpha().primitiveField();

    scalarList behind;
    cellLinks::fetch(mesh, alpha, behind);

    DynamicList<labelPair> pairs;
    const auto jumps = [&](const scalar a, const scalar b)
    {
        return mag(a - b) > 0.5 && !surface.crossed(a) && !surface.crossed(b);
    };
    const labelUList& own = mesh.owner();
    const labelUList& nei = mesh.neighbour();
    forAll(own, facei)
    {
        if (jumps(alpha[own[facei]], alpha[nei[facei]]))
        {
            pairs.append(labelPair(own[facei], facei));
            pairs.append(labelPair(nei[facei], facei));
        }
    }
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (patch.coupled())
        {
            forAll(patch, i)
            {
                const label facei = patch.start() + i;
                const label celli = patch.faceCells()[i];
                if
                (
                    jumps(alpha[celli], behind[facei - mesh.nInternalFaces()])
                )
                {
                    pairs.append(labelPair(celli, facei));
                }
            }
        }
    }
    return List<labelPair>(std::move(pairs));
}


Foam::bitSet Foam::dew::wallContact::faces
(
    const transportedSurface& surface,
    const UList<labelPair>& betweenFaces,
    const label nCells
)
{
    const fvMesh& mesh = surface.mesh();
    const interfacePlanes& planes = surface.planes();

    labelList layer(mesh.nCells(), -1);
    for (const labelPair& pair : betweenFaces)
    {
        layer[pair.first()] = 0;
    }
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (!patch.coupled())
        {
            const labelUList& cells = patch.faceCells();
            forAll(cells, i)
            {
                const label plane = planes.of(cells[i]);
                if
                (
                    plane >= 0
                 && cuts
                    (
                        mesh, patch.start() + i,
                        planes.x()[plane], planes.n()[plane]
                    )
                )
                {
                    layer[cells[i]] = 0;
                }
            }
        }
    }
    cellLinks::grow(mesh, nCells, layer);

    bitSet near(mesh.nBoundaryFaces());
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        const bool mirror =
            isA<symmetryPolyPatch>(patch) || isA<symmetryPlanePolyPatch>(patch);
        const labelUList& cells = patch.faceCells();
        forAll(cells, i)
        {
            near.set
            (
                patch.start() + i - mesh.nInternalFaces(),
                mirror || layer[cells[i]] >= 0
            );
        }
    }
    return near;
}


Foam::vector Foam::dew::wallContact::normal
(
    const transportedSurface& surface,
    const cellLinks::link& l,
    const scalar psi,
    const vector& n,
    const tensor& gradn
)
{
    const polyPatch& patch = surface.mesh().boundaryMesh()[l.patch];
    const vector m(normalised(l.S));
    const vector across(n - (n & m)*m);
    const scalar size = mag(across);
    if (size < SMALL)
    {
        return n;
    }
    const vector t(across/size);
    if (isA<symmetryPolyPatch>(patch) || isA<symmetryPlanePolyPatch>(patch))
    {
        return t;
    }

    scalar theta = 0.5*constant::mathematical::pi;
    if (surface.angles().has(l.patch))
    {
        theta = surface.angles().theta(l.patch)[l.face - patch.start()];
    }
    const vector there(t*Foam::sin(theta) - m*Foam::cos(theta));

    // From the contact line to the centre of the face
    scalar s = ((l.toFace & n) - psi)/size;
    s = max(min(s, 8*mag(l.d)), -8*mag(l.d));
    return normalised(there + s*(t & gradn));
}
