/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "exactOverlap.H"
#include "addToRunTimeSelectionTable.H"
#include "cellOverlap.H"
#include "kernelSupport.H"
#include "polyMesh.H"
#include "userEntry.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeNameAndDebug(exactOverlap, 0);
    addToRunTimeSelectionTable(voidFractionModel, exactOverlap, dictionary);
}
}


// * * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{

class overlapKernel
:
    public cellKernel
{
    const dictionary dict_;

    cellOverlap overlap_;

public:

    overlapKernel(const polyMesh& mesh, const dictionary& dict)
    :
        cellKernel(mesh),
        dict_(dict),
        overlap_(mesh)
    {}

    void update() override { overlap_.correct(); }

    scalar reach(const scalar d) const override { return 0.5*d; }

    scalar weight
    (
        const point& centre, const scalar d, const label celli
    ) const override
    {
        return overlap_.volume(centre, 0.5*d, celli);
    }

    void tooWide(const scalar reach, const scalar most) const override
    {
        FatalIOErrorInFunction(dict_)
            << "Entry 'type' exactOverlap: a particle of radius " << reach
            << " m, but the mesh leaves room for " << most
            << " m (its size, or half of a cyclic period)" << nl
            << "Use smaller particles or a larger mesh" << exit(FatalIOError);
    }
};

} // End namespace dew
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::exactOverlap::exactOverlap(const dictionary& dict)
:
    voidFractionModel(dict)
{
    userEntry::onlyThese(dict, {"type"});
}



// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::particleSupport> Foam::dew::exactOverlap::support
(
    const polyMesh& mesh
) const
{
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if (isA<wedgePolyPatch>(patch))
        {
            FatalIOErrorInFunction(dict_)
                << "Entry 'type' exactOverlap on a wedge mesh, whose cells"
                << " stand for rings, not for what a ball overlaps" << nl
                << "Use 'type divided;'" << exit(FatalIOError);
        }
    }

    return autoPtr<particleSupport>
    (
        new kernelSupport
        (
            autoPtr<cellKernel>(new overlapKernel(mesh, dict_))
        )
    );
}
