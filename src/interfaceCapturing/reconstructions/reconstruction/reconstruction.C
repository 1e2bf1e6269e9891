/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "reconstruction.H"
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
