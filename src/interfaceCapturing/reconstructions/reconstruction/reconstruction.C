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
