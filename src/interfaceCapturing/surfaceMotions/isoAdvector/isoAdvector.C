/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "isoAdvector.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
namespace surfaceMotions
{
    defineTypeName(isoAdvector);
    addToRunTimeSelectionTable(surfaceMotion, isoAdvector, dictionary);
}
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::surfaceMotions::isoAdvector::isoAdvector
(
    const fvMesh& mesh,
    const dictionary& surfaceProperties
)
:
    transportedSurface(mesh, surfaceProperties),
    advection_(mesh),
    timeIndex_(-1)
{
    userEntry::onlyThese(dict_, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::surfaceMotions::isoAdvector::advect
(
    const surfaceScalarField& alphacPhi,
    const volVectorField& U,
    const volScalarField& alphac
)
{
    // The planes at hand are those of the last step unless this is the first
    // one, the mesh has changed, or the step is done again
    const label timeIndex = mesh_.time().timeIndex();
    if (timeIndex_ < 0 || timeIndex_ == timeIndex || mesh_.changing())
    {
        reconstruct(alpha_.oldTime());
    }
    timeIndex_ = timeIndex;

    advection_.advect(alpha_, alphaPhi_, planes(), alphacPhi, U, alphac);
}


void Foam::dew::surfaceMotions::isoAdvector::report(Ostream& os) const
{
    transportedSurface::report(os);
    os  << alpha_.name() << ": moved into bounds so far "
        << returnReduce(advection_.moved(), sumOp<scalar>()) << " m3" << endl;
}
