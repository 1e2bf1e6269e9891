/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "transportedSurface.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Shares out of bounds by less are rounding
constexpr Foam::scalar rounding = 1e-13;

//- How far what a cell has not got may be brought from
constexpr Foam::label nPasses = 50;

} // End anonymous namespace


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::dew::transportedSurface::recede
(
    const scalarField& lost,
    const volScalarField& alphac
)
{
    const label nInternal = mesh_.nInternalFaces();
    const label nBoundary = mesh_.nFaces() - nInternal;
    const scalarField room(alphac.primitiveField()*mesh_.V());
    scalarField liquid(alpha_.primitiveField()*room - lost);

    scalar rest = 0;
    for (label pass = 0; pass < nPasses; pass++)
    {
        // What is beyond the bounds, and what there is to make it good
        scalarField over(liquid.size(), Zero);
        scalar all = 0;
        forAll(liquid, celli)
        {
            if
            (
                liquid[celli] < -rounding*room[celli]
             || liquid[celli] > (1 + rounding)*room[celli]
            )
            {
                over[celli] =
                    liquid[celli] < 0 ? liquid[celli]
                  : liquid[celli] - room[celli];
                all += mag(over[celli]);
            }
        }
        reduce(all, sumOp<scalar>());
        rest = all;
        if (all == 0)
        {
            break;
        }

        scalarField liquidAcross(nBoundary, Zero), roomAcross(nBoundary, Zero);
        for (const fvPatch& patch : mesh_.boundary())
        {
            if (patch.coupled())
            {
                forAll(patch, i)
                {
                    const label at = patch.start() + i - nInternal;
                    liquidAcross[at] = liquid[patch.faceCells()[i]];
                    roomAcross[at] = room[patch.faceCells()[i]];
                }
            }
        }
        syncTools::swapBoundaryFaceList(mesh_, liquidAcross);
        syncTools::swapBoundaryFaceList(mesh_, roomAcross);

        scalarField given(nBoundary, Zero);
        scalarField change(liquid.size(), Zero);
        forAll(over, celli)
        {
            if (over[celli] == 0)
            {
                continue;
            }

            // Liquid comes from where most is, and goes to where there is room
            // and liquid already
            const cell& faces = mesh_.cells()[celli];
            scalarList weight(faces.size(), Zero);
            scalar sum = 0;
            forAll(faces, i)
            {
                const label facei = faces[i];
                scalar in, size;
                if (facei < nInternal)
                {
                    const label own = mesh_.faceOwner()[facei];
                    const label other =
                        own == celli ? mesh_.faceNeighbour()[facei] : own;
                    in = liquid[other];
                    size = room[other];
                }
                else
                {
                    in = liquidAcross[facei - nInternal];
                    size = roomAcross[facei - nInternal];
                }
                in = min(max(in, scalar(0)), size);
                weight[i] =
                    over[celli] < 0
                  ? in
                  : (size - in)*(in > 0 ? 1 : 1e-3);
                sum += weight[i];
            }
            if (sum <= 0)
            {
                continue;
            }
            forAll(faces, i)
            {
                const label facei = faces[i];
                const scalar part = over[celli]*weight[i]/sum;
                change[celli] -= part;
                if (facei >= nInternal)
                {
                    given[facei - nInternal] = part;
                }
                else
                {
                    const label own = mesh_.faceOwner()[facei];
                    change
                    [
                        own == celli ? mesh_.faceNeighbour()[facei] : own
                    ] += part;
                }
            }
        }
        syncTools::swapBoundaryFaceList(mesh_, given);
        for (const fvPatch& patch : mesh_.boundary())
        {
            if (patch.coupled())
            {
                forAll(patch, i)
                {
                    change[patch.faceCells()[i]] +=
                        given[patch.start() + i - nInternal];
                }
            }
        }
        liquid += change;
    }

    // None is left, or no room: the shares stay within their bounds
    scalar unmet = 0;
    forAll(liquid, celli)
    {
        const scalar bounded =
            min(max(liquid[celli], scalar(0)), room[celli]);
        if (rest > 0)
        {
            unmet += bounded - liquid[celli];
            liquid[celli] = bounded;
        }
    }
    reduce(unmet, sumOp<scalar>());

    alpha_.primitiveFieldRef() = liquid/room;
    alpha_.correctBoundaryConditions();

    return unmet;
}


// ************************************************************************* //
