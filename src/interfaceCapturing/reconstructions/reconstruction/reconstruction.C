/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "reconstruction.H"
#include "Map.H"
#include "surfaceFields.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(reconstruction);
    defineRunTimeSelectionTable(reconstruction, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::reconstruction::reconstruction
(
    const fvMesh& mesh,
    const dictionary& dict
)
:
    mesh_(mesh),
    tolerance_(userEntry::positiveOr(dict, "tolerance", dimless, 1e-8))
{
    planes_.clear(mesh.nCells());
}


// * * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * //

void Foam::dew::reconstruction::findCrossed(const scalarField& alpha)
{
    planes_.clear(mesh_.nCells());
    crossed_.clear();
    forAll(alpha, celli)
    {
        if (crossed(alpha[celli]))
        {
            crossed_.append(celli);
        }
    }
}


Foam::vector Foam::dew::reconstruction::direction(const vector& n) const
{
    vector d(n);
    for (Foam::direction i = 0; i < vector::nComponents; i++)
    {
        if (mesh_.geometricD()[i] < 0)
        {
            d[i] = 0;
        }
    }
    const scalar size = mag(d);
    return size > 0 ? d/size : vector(Zero);
}


void Foam::dew::reconstruction::appendPlane
(
    cellCut& cut,
    const label celli,
    const vector& n,
    const scalar share,
    const point& near
)
{
    const vector d(direction(n));
    if (d == vector(Zero))
    {
        return;
    }
    cut.cutPlane(d, share, near);
    planes_.append(celli, cut.centre(), d, mag(cut.S()));
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::reconstruction::addFaces(const volScalarField& alpha)
{
    const auto full = [&](const scalar a) { return a >= 1 - tolerance_; };
    const auto empty = [&](const scalar a) { return a <= tolerance_; };

    // Few: sums by cell, in the order they are met
    DynamicList<label> cells;
    DynamicList<vector> Sf, moment;
    Map<label> place;
    const auto add = [&](const label celli, const vector& S, const point& x)
    {
        if (place.insert(celli, cells.size()))
        {
            cells.append(celli);
            Sf.append(Zero);
            moment.append(Zero);
        }
        const label at = place[celli];
        Sf[at] += S;
        moment[at] += mag(S)*(x - mesh_.C()[celli]);
    };

    const labelUList& own = mesh_.owner();
    const labelUList& nei = mesh_.neighbour();
    forAll(own, facei)
    {
        const scalar a = alpha[own[facei]];
        const scalar b = alpha[nei[facei]];
        if (full(a) && empty(b))
        {
            add(own[facei], mesh_.Sf()[facei], mesh_.Cf()[facei]);
        }
        else if (full(b) && empty(a))
        {
            add(nei[facei], -mesh_.Sf()[facei], mesh_.Cf()[facei]);
        }
    }
    for (const fvPatchScalarField& patch : alpha.boundaryField())
    {
        if (patch.coupled())
        {
            const scalarField other(patch.patchNeighbourField());
            const label patchi = patch.patch().index();
            forAll(other, i)
            {
                const label celli = patch.patch().faceCells()[i];
                if (full(alpha[celli]) && empty(other[i]))
                {
                    add
                    (
                        celli,
                        mesh_.Sf().boundaryField()[patchi][i],
                        mesh_.Cf().boundaryField()[patchi][i]
                    );
                }
            }
        }
    }

    forAll(cells, i)
    {
        const scalar area = mag(Sf[i]);
        const vector n(direction(Sf[i]));
        if (area > 0 && n != vector(Zero))
        {
            planes_.append
            (
                cells[i], mesh_.C()[cells[i]] + moment[i]/area, n, area
            );
        }
    }
}
