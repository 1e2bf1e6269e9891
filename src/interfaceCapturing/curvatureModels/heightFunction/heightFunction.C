/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "heightFunction.H"
#include "addToRunTimeSelectionTable.H"
#include "DynamicList.H"
#include "transportedSurface.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace curvatureModels
{
    defineTypeName(heightFunction);
    addToRunTimeSelectionTable(curvatureModel, heightFunction, dictionary);
}
}
}

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Less of a cell, or so much that less is missing, says nothing of K
constexpr Foam::scalar sliver = 1e-3;

//- Neighbours whose K lie further apart, of the largest, say nothing of others
constexpr Foam::scalar agreement = 0.1;

//- K of a cell that has none
constexpr Foam::scalar noK = Foam::GREAT;

} // End anonymous namespace

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::curvatureModels::heightFunction::heightFunction
(
    const transportedSurface& surface,
    const dictionary& dict
)
:
    curvatureModel(surface),
    around_(surface.mesh())
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::vector Foam::dew::curvatureModels::heightFunction::normal
(
    const cellColumns& columns,
    const label celli
) const
{
    // Differences along each axis, summed over the lines beside the cell
    vector n(Zero);
    for (label k = 0; k < 3; k++)
    {
        if (!columns.solved(k))
        {
            continue;
        }
        FixedList<label, 9> beside(-1);
        beside[0] = celli;
        label nBeside = 1;
        for (label j = 0; j < 3; j++)
        {
            if (j != k && columns.solved(j))
            {
                const label nBefore = nBeside;
                for (label i = 0; i < nBefore; i++)
                {
                    for (label side = 0; side < 2; side++)
                    {
                        const label next =
                            columns.next(beside[i], 2*j + side);
                        if (next >= 0)
                        {
                            beside[nBeside++] = next;
                        }
                    }
                }
            }
        }
        for (label i = 0; i < nBeside; i++)
        {
            const label own = beside[i];
            const label up = columns.next(own, 2*k + 1);
            const label down = columns.next(own, 2*k);
            n[k] +=
                (down >= 0 ? alpha_[down] : alpha_[own])
              - (up >= 0 ? alpha_[up] : alpha_[own]);
        }
    }
    return n;
}


bool Foam::dew::curvatureModels::heightFunction::crossed
(
    const scalar alpha
) const
{
    return surface_.crossed(alpha);
}


Foam::labelList Foam::dew::curvatureModels::heightFunction::cells
(
    const cellColumns& columns
) const
{
    const fvMesh& mesh = surface_.mesh();
    DynamicList<label> list;

    for (label celli = 0; celli < mesh.nCells(); celli++)
    {
        if (crossed(alpha_[celli]))
        {
            list.append(celli);
        }
        else
        {
            // Between full and empty the surface is the face
            for (const label next : columns.around(celli))
            {
                if (next >= 0 && mag(alpha_[next] - alpha_[celli]) > 0.5
                 && !crossed(alpha_[next]))
                {
                    list.append(celli);
                    break;
                }
            }
        }
    }
    return labelList(std::move(list));
}


Foam::dew::curvatureModels::heightFunction::found
Foam::dew::curvatureModels::heightFunction::heights
(
    const cellColumns& columns,
    const label celli,
    scalar& K
) const
{
    const vector n(normal(columns, celli));
    vector size(cmptMag(n));
    found best = found::none;

    // The axis closest to the normal first
    for (label tries = 0; tries < 3; tries++)
    {
        const label k =
            size.x() >= size.y() && size.x() >= size.z() ? 0
          : size.y() >= size.z() ? 1
          : 2;
        if (size[k] <= 0)
        {
            break;
        }
        size[k] = -1;
        scalar here;
        const found by = byHeights(columns, celli, n, 2*k + (n[k] > 0), here);
        if (by > best)
        {
            best = by;
            K = here;
        }
        if (best == found::exact)
        {
            break;
        }
    }
    return best;
}


Foam::scalar Foam::dew::curvatureModels::heightFunction::spread
(
    const cellColumns& columns,
    const label celli,
    const scalarField& exact
) const
{
    scalar least = noK, most = -noK;
    const auto see = [&](const label other)
    {
        if (other >= 0 && exact[other] < noK)
        {
            least = min(least, exact[other]);
            most = max(most, exact[other]);
        }
    };

    // Two cells around
    for (const label next : columns.around(celli))
    {
        if (next == cellColumns::boundary)
        {
            return noK;
        }
        see(next);
        if (next >= 0)
        {
            for (const label other : columns.around(next))
            {
                if (other == cellColumns::boundary)
                {
                    return noK;
                }
                see(other);
            }
        }
    }

    return
        least > most
      ? noK
      : (most - least)/max(max(mag(most), mag(least)), VSMALL);
}


void Foam::dew::curvatureModels::heightFunction::tellUnfit
(
    const cellColumns& columns
)
{
    if (!told_ && columns.nUnfit() > 0)
    {
        const fvMesh& mesh = surface_.mesh();
        boundBox where;
        for (label celli = 0; celli < mesh.nCells(); celli++)
        {
            if (!columns.fits(celli))
            {
                where.add(mesh.C()[celli]);
            }
        }
        where.reduce();
        Info<< "Curvature: " << columns.nUnfit() << " cells between "
            << where.min() << " and " << where.max()
            << " line up in no columns; there it is from paraboloids" << endl;
    }
    told_ = true;
}


// * * * * * * * * * * * * * Protected Member Functions * * * * * * * * * * //

void Foam::dew::curvatureModels::heightFunction::calculate
(
    scalarField& K,
    boolList& known
)
{
    const cellColumns& columns = cellColumns::New(surface_.mesh());
    tellUnfit(columns);
    columns.fetch(surface_.alpha().primitiveField(), alpha_);
    fetchAngles(columns);

    nHeights_ = nFits_ = nLeft_ = 0;
    DynamicList<label> left;
    DynamicList<bool> rough;
    scalarField exact(alpha_.size(), noK);

    for (const label celli : cells(columns))
    {
        const found by =
            columns.fits(celli) ? heights(columns, celli, K[celli])
          : found::none;
        if (by == found::exact)
        {
            known[celli] = true;
            exact[celli] = K[celli];
            nHeights_++;
        }
        else
        {
            left.append(celli);
            rough.append(by == found::rough);
        }
    }
    if (returnReduce(left.empty(), andOp<bool>()))
    {
        return;
    }
    columns.refresh(exact);

    bool any = false;
    forAll(left, i)
    {
        // Neighbours know better if they agree, and in any case of a cell that
        // the surface has hardly come to; but for the contact angle
        const label celli = left[i];
        const bool small = min(alpha_[celli], 1 - alpha_[celli]) < sliver;
        if
        (
            columns.fits(celli)
         && spread(columns, celli, exact) < (small ? noK : agreement)
        )
        {
            nLeft_++;
            left[i] = -1;
        }
        else if (rough[i])
        {
            known[celli] = true;
            nHeights_++;
            left[i] = -1;
        }
        any = any || left[i] >= 0;
    }
    if (!returnReduce(any, orOp<bool>()))
    {
        return;
    }

    around_.correct(surface_.planes(), surface_.angles());
    const paraboloidFit fit(surface_.mesh());
    planesAround::plane surface;
    for (const label celli : left)
    {
        if (celli >= 0)
        {
            known[celli] =
                surface_.planes().of(celli) >= 0
             && fit.find(around_, celli, K[celli], surface);
            known[celli] ? nFits_++ : nLeft_++;
        }
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::curvatureModels::heightFunction::report(Ostream& os) const
{
    const label nHeights = returnReduce(nHeights_, sumOp<label>());
    const label nFits = returnReduce(nFits_, sumOp<label>());
    const label nLeft = returnReduce(nLeft_, sumOp<label>());

    os  << "Curvature: " << nHeights << " cells by heights, " << nFits
        << " by paraboloids, " << nLeft << " by neighbours" << endl;
}
