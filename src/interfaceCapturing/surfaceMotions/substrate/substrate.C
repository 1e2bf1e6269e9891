/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "substrate.H"
#include "polyMesh.H"
#include "SubField.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

Foam::label namedPatch
(
    const Foam::polyMesh& mesh,
    const Foam::dictionary& dict
)
{
    using namespace Foam;

    const word name(dict.get<word>("substrate"));
    const label patchi = mesh.boundaryMesh().findPatchID(name);
    if (patchi < 0)
    {
        FatalIOErrorInFunction(dict)
            << "Entry 'substrate' in " << dict.dictName() << " is " << name
            << nl << "The mesh has no such patch; it has "
            << flatOutput(mesh.boundaryMesh().names())
            << exit(FatalIOError);
    }
    return patchi;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::substrate::substrate(const polyMesh& mesh, const dictionary& dict)
:
    mesh_(mesh),
    dict_(dict),
    patch_(namedPatch(mesh, dict)),
    centre_(Zero),
    normal_(Zero),
    area_(0)
{
    const polyPatch& patch = mesh.boundaryMesh()[patch_];
    const SubField<vector> areas(patch.faceAreas());
    const SubField<vector> centres(patch.faceCentres());
    const label n = returnReduce(patch.size(), sumOp<label>());
    const vector S(returnReduce(sum(areas), sumOp<vector>()));
    area_ = mag(S);

    if (!(area_ > 0))
    {
        FatalIOErrorInFunction(dict)
            << "The patch " << name() << " has " << n
            << " faces, which add up to no area: it is not flat" << nl
            << "Entry 'substrate' in " << dict.dictName()
            << " must name a flat patch of the mesh" << exit(FatalIOError);
    }
    normal_ = -S/area_;
    centre_ = returnReduce(sum(centres), sumOp<vector>())/n;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

const Foam::word& Foam::dew::substrate::name() const
{
    return mesh_.boundaryMesh()[patch_].name();
}


Foam::scalar Foam::dew::substrate::off(const point& x) const
{
    scalar off = 0;
    for (const label pointi : mesh_.boundaryMesh()[patch_].meshPoints())
    {
        off = max(off, mag((mesh_.points()[pointi] - x) & normal_));
    }
    return returnReduce(off, maxOp<scalar>());
}


void Foam::dew::substrate::checkFlat(const scalar tolerance) const
{
    const scalar distance = off(centre_);
    if (distance > tolerance)
    {
        FatalIOErrorInFunction(dict_)
            << "The patch " << name() << ", entry 'substrate' in "
            << dict_.dictName() << ", is not flat: its points are up to "
            << distance << " m away from the plane through its centre" << nl
            << "Choose a flat patch" << exit(FatalIOError);
    }
}


// ************************************************************************* //
