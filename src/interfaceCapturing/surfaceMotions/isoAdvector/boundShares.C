/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "planeAdvection.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Shares out of bounds by less are rounding
constexpr Foam::scalar rounding = 1e-12;

//- Most passes of each kind
constexpr Foam::label nPasses = 20;

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dew::planeAdvection::excess(const label celli) const
{
    return
        content_[celli] > capacity_[celli] ? content_[celli] - capacity_[celli]
      : min(content_[celli], scalar(0));
}


bool Foam::dew::planeAdvection::isOut
(
    const label celli,
    const scalar share
) const
{
    return
        content_[celli] > (1 + share)*capacity_[celli]
     || content_[celli] < -share*capacity_[celli];
}


void Foam::dew::planeAdvection::findOut(const scalar share)
{
    listed_.setSize(mesh_.nCells());
    listed_ = false;
    out_.clear();
    forAll(content_, celli)
    {
        if (isOut(celli, share))
        {
            out_.append(celli);
            listed_[celli] = true;
        }
    }
}


void Foam::dew::planeAdvection::limitExits
(
    const label celli,
    const scalar excess
)
{
    const bool more = excess > 0;
    exits_.clear();
    limit_.clear();
    weight_.clear();
    for (const label facei : mesh_.cells()[celli])
    {
        const scalar fluid = outOf(celli, facei, fluid_[facei]);
        const scalar liquid = outOf(celli, facei, liquid_[facei]);
        const scalar limit = more ? fluid - liquid : liquid;
        if (fluid > 0 && limit > 0)
        {
            exits_.append(facei);
            limit_.append(limit);
            weight_.append(fluid);
        }
    }

    // Through all faces alike, up to their limits
    scalar rest = mag(excess);
    for (label n = exits_.size(); n > 0 && rest > 0; n--)
    {
        scalar sum = 0;
        forAll(exits_, i)
        {
            sum += limit_[i] > 0 ? weight_[i] : 0;
        }
        if (sum == 0)
        {
            break;
        }

        const scalar given = rest;
        forAll(exits_, i)
        {
            if (limit_[i] > 0)
            {
                const scalar part = min(given*weight_[i]/sum, limit_[i]);
                limit_[i] -= part;
                rest -= part;
                faces_.append(exits_[i]);
                changes_.append
                (
                    outOf(celli, exits_[i], more ? part : -part)
                );
            }
        }
    }
}


void Foam::dew::planeAdvection::giveAway
(
    const label celli,
    const scalar excess,
    const scalarField& content,
    const scalarField& capacity
)
{
    const label nInternal = mesh_.nInternalFaces();
    exits_.clear();
    weight_.clear();
    scalar sum = 0;
    for (const label facei : mesh_.cells()[celli])
    {
        scalar in, all;
        if (mesh_.isInternalFace(facei))
        {
            const label own = mesh_.faceOwner()[facei];
            const label other =
                own == celli ? mesh_.faceNeighbour()[facei] : own;
            in = content_[other];
            all = capacity_[other];
        }
        else
        {
            in = content[facei - nInternal];
            all = capacity[facei - nInternal];
        }
        if (all > 0)
        {
            // To cells that have both, so as to wet no others
            exits_.append(facei);
            weight_.append(max(in, scalar(0))*max(all - in, scalar(0))/all);
            sum += weight_.last();
        }
    }

    forAll(exits_, i)
    {
        const scalar part =
            excess*(sum > 0 ? weight_[i]/sum : 1.0/exits_.size());
        faces_.append(exits_[i]);
        changes_.append(outOf(celli, exits_[i], part));
        moved_ += mag(part);
    }
}


void Foam::dew::planeAdvection::applyChanges(const scalar share)
{
    const label nInternal = mesh_.nInternalFaces();
    scalarField across(mesh_.nFaces() - nInternal, Zero);

    DynamicList<label> touched(2*faces_.size() + out_.size());
    touched = out_;
    forAll(faces_, i)
    {
        const label facei = faces_[i];
        const label own = mesh_.faceOwner()[facei];
        liquid_[facei] += changes_[i];
        content_[own] -= changes_[i];
        touched.append(own);
        if (facei < nInternal)
        {
            const label nei = mesh_.faceNeighbour()[facei];
            content_[nei] += changes_[i];
            touched.append(nei);
        }
        else
        {
            across[facei - nInternal] += changes_[i];
        }
    }

    syncTools::swapBoundaryFaceList(mesh_, across);
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (patch.coupled())
        {
            forAll(patch, i)
            {
                const label facei = patch.start() + i;
                const scalar change = across[facei - nInternal];
                if (change != 0)
                {
                    liquid_[facei] -= change;
                    content_[mesh_.faceOwner()[facei]] += change;
                    touched.append(mesh_.faceOwner()[facei]);
                }
            }
        }
    }

    for (const label celli : out_)
    {
        listed_[celli] = false;
    }
    out_.clear();
    for (const label celli : touched)
    {
        if (!listed_[celli] && isOut(celli, share))
        {
            listed_[celli] = true;
            out_.append(celli);
        }
    }
}


void Foam::dew::planeAdvection::bound()
{
    // Each face has one cell that the fluid leaves through it: the order of
    // the cells of a pass does not matter
    findOut(rounding);
    for (label pass = 0; pass < nPasses; pass++)
    {
        faces_.clear();
        changes_.clear();
        for (const label celli : out_)
        {
            limitExits(celli, excess(celli));
        }
        if (!returnReduce(faces_.size(), sumOp<label>()))
        {
            break;
        }
        applyChanges(rounding);
    }

    findOut(tolerance);
    for (label pass = 0; pass < nPasses; pass++)
    {
        if (!returnReduce(out_.size(), sumOp<label>()))
        {
            break;
        }

        const label nInternal = mesh_.nInternalFaces();
        scalarField content(mesh_.nFaces() - nInternal, Zero);
        scalarField capacity(content.size(), Zero);
        for (const polyPatch& patch : mesh_.boundaryMesh())
        {
            if (patch.coupled())
            {
                forAll(patch, i)
                {
                    const label celli = patch.faceCells()[i];
                    const label at = patch.start() + i - nInternal;
                    content[at] = content_[celli];
                    capacity[at] = capacity_[celli];
                }
            }
        }
        syncTools::swapBoundaryFaceList(mesh_, content);
        syncTools::swapBoundaryFaceList(mesh_, capacity);

        faces_.clear();
        changes_.clear();
        for (const label celli : out_)
        {
            giveAway(celli, excess(celli), content, capacity);
        }
        applyChanges(tolerance);
    }
}
