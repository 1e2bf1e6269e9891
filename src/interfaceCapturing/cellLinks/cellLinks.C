/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "cellLinks.H"
#include "emptyFvPatch.H"
#include "fvMesh.H"
#include "volFields.H"
#include "wedgeFvPatch.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::cellLinks::append
(
    const label celli,
    const labelUList& usable,
    const bitSet& faces
)
{
    const label first = link_.size();
    const point& C = mesh_.C()[celli];
    symmTensor D(Zero);

    for (const label facei : mesh_.cells()[celli])
    {
        link l;
        l.face = facei;
        l.patch = unknown;
        l.toFace = mesh_.faceCentres()[facei] - C;
        l.S = mesh_.faceAreas()[facei];

        if (mesh_.isInternalFace(facei))
        {
            const bool own = mesh_.faceOwner()[facei] == celli;
            l.cell =
                own ? mesh_.faceNeighbour()[facei] : mesh_.faceOwner()[facei];
            l.d = mesh_.C()[l.cell] - C;
            l.S = own ? l.S : -l.S;
            l.patch = usable[l.cell] < 0 ? unknown : inside;
        }
        else
        {
            const label k = facei - mesh_.nInternalFaces();
            const label patchi = mesh_.boundaryMesh().patchID()[k];
            const fvPatch& patch = mesh_.boundary()[patchi];
            l.cell = -1 - k;
            if (isA<emptyFvPatch>(patch) || isA<wedgeFvPatch>(patch))
            {
                continue;
            }
            l.d = patch.coupled() ? toBehind_[k] : l.toFace;
            l.patch =
                !faces[k] ? label(unknown)
              : patch.coupled() ? label(inside)
              : patchi;
        }

        for (direction i = 0; i < vector::nComponents; i++)
        {
            if (mesh_.geometricD()[i] < 0)
            {
                l.d[i] = l.toFace[i] = l.S[i] = 0;
            }
        }
        l.length = mag(l.d);
        if (l.patch != unknown)
        {
            D += sqr(l.d)/magSqr(l.d);
        }
        link_.append(l);
    }

    // What no link reaches stays zero
    const symmTensor inverse(inv(D + 1e-9*symmTensor::I));
    for (label i = first; i < link_.size(); i++)
    {
        link& l = link_[i];
        l.w =
            l.patch == unknown
          ? vector(Zero)
          : inverse & (l.d/magSqr(l.d));
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::cellLinks::grow
(
    const fvMesh& mesh,
    const label nLayers,
    labelList& layer
)
{
    DynamicList<label> front;
    forAll(layer, celli)
    {
        if (layer[celli] == 0)
        {
            front.append(celli);
        }
    }

    boolList reached(mesh.nBoundaryFaces());
    for (label step = 1; step <= nLayers; step++)
    {
        DynamicList<label> next;
        const auto reach = [&](const label celli)
        {
            if (layer[celli] < 0)
            {
                layer[celli] = step;
                next.append(celli);
            }
        };

        reached = false;
        for (const label celli : front)
        {
            for (const label facei : mesh.cells()[celli])
            {
                if (mesh.isInternalFace(facei))
                {
                    reach
                    (
                        mesh.faceOwner()[facei] == celli
                      ? mesh.faceNeighbour()[facei]
                      : mesh.faceOwner()[facei]
                    );
                }
                else
                {
                    reached[facei - mesh.nInternalFaces()] = true;
                }
            }
        }
        syncTools::swapBoundaryFaceList(mesh, reached);
        for (const polyPatch& patch : mesh.boundaryMesh())
        {
            if (patch.coupled())
            {
                forAll(patch, i)
                {
                    if (reached[patch.start() + i - mesh.nInternalFaces()])
                    {
                        reach(patch.faceCells()[i]);
                    }
                }
            }
        }
        front.transfer(next);
    }
}


void Foam::dew::cellLinks::set
(
    const labelUList& cells,
    const labelList& layer,
    const bitSet& faces
)
{
    labelList behind(mesh_.nBoundaryFaces(), -1);
    fetch(mesh_, layer, behind);

    bitSet chosen(mesh_.nBoundaryFaces());
    toBehind_.setSize(mesh_.nBoundaryFaces());
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        const label first = patch.start() - mesh_.nInternalFaces();
        if (patch.coupled())
        {
            SubList<vector>(toBehind_, patch.size(), first) =
                mesh_.boundary()[patch.index()].delta()();
        }
        forAll(patch, i)
        {
            chosen.set
            (
                first + i,
                patch.coupled() ? behind[first + i] >= 0
              : faces[first + i]
            );
        }
    }

    cell_ = cells;
    start_.clear();
    link_.clear();
    for (const label celli : cell_)
    {
        start_.append(link_.size());
        append(celli, layer, chosen);
    }
    start_.append(link_.size());
}
