/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "rankIndependentRefineFvMesh.H"
#include "addToRunTimeSelectionTable.H"
#include "syncTools.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeNameAndDebug(rankIndependentRefineFvMesh, 0);
    addToRunTimeSelectionTable
    (
        dynamicFvMesh,
        rankIndependentRefineFvMesh,
        IOobject
    );
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::rankIndependentRefineFvMesh::rankIndependentRefineFvMesh
(
    const IOobject& io
)
:
    dynamicRefineFvMesh(io)
{}


// * * * * * * * * * * * * Protected Member Functions  * * * * * * * * * * * //

void Foam::dew::rankIndependentRefineFvMesh::selectRefineCandidates
(
    const scalar lowerRefineLevel,
    const scalar upperRefineLevel,
    const scalarField& vFld,
    bitSet& candidateCell
) const
{
    scalarField sum(nPoints(), Zero);
    scalarField n(nPoints(), Zero);

    const labelListList& about = pointCells();
    forAll(about, pointi)
    {
        for (const label celli : about[pointi])
        {
            sum[pointi] += vFld[celli];
        }
        n[pointi] = about[pointi].size();
    }
    syncTools::syncPointList(*this, sum, plusEqOp<scalar>(), scalar(0));
    syncTools::syncPointList(*this, n, plusEqOp<scalar>(), scalar(0));

    const scalarField wanted
    (
        maxPointField(error(sum/n, lowerRefineLevel, upperRefineLevel))
    );
    forAll(wanted, celli)
    {
        if (wanted[celli] > 0)
        {
            candidateCell.set(celli);
        }
    }
}

