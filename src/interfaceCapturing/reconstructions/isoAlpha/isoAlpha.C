/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "isoAlpha.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace reconstructions
{
    defineTypeName(isoAlpha);
    addToRunTimeSelectionTable(reconstruction, isoAlpha, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::reconstructions::isoAlpha::isoAlpha
(
    const fvMesh& mesh,
    const contactAngles&,
    const dictionary& dict
)
:
    reconstruction(mesh, dict),
    pointMean_(mesh),
    cut_(mesh)
{
    userEntry::onlyThese(dict, {"type", "tolerance"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::reconstructions::isoAlpha::correct(const volScalarField& alpha)
{
    const scalarField& share = alpha.primitiveField();
    findCrossed(share);

    // Highest where there is no liquid
    const scalarField gas(pointMean_(1 - share, crossed_));

    for (const label celli : crossed_)
    {
        cut_.set(celli);
        cut_.function(gas);
        cut_.cut(share[celli]);
        appendPlane(cut_, celli, cut_.S(), share[celli], cut_.centre());
    }
}
