/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "noEngine.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeName(noEngine);
    addToRunTimeSelectionTable(particleEngine, noEngine, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::noEngine::noEngine(const polyMesh& mesh, const dictionary& dict)
:
    particleEngine(mesh, dict)
{
    // What is for particles in a case may stay there
    userEntry::onlyThese
    (
        dict, {"FoamFile", "engine", "coupling", "output", "periodic"}
    );
    account();
}


// ************************************************************************* //
