/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "bigParticle.H"
#include "addToRunTimeSelectionTable.H"
#include "kernelSupport.H"
#include "polyMesh.H"
#include "PstreamReduceOps.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeNameAndDebug(bigParticle, 0);
    addToRunTimeSelectionTable(voidFractionModel, bigParticle, dictionary);
}
}


// * * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{

class rampKernel
:
    public cellKernel
{
    const dictionary dict_;

    const scalar scale_;

    scalarField width_;
    scalar widest_;

public:

    rampKernel
    (
        const polyMesh& mesh, const dictionary& dict, const scalar scale
    )
    :
        cellKernel(mesh),
        dict_(dict),
        scale_(scale)
    {
        update();
    }

    void update() override
    {
        width_ = widths();
        widest_ = max(width_);
    }

    //- The ball, at least as wide as the way to a corner
    scalar ball(const scalar d, const scalar width) const
    {
        return max(0.5*scale_*d, std::sqrt(scalar(0.75))*width);
    }

    // Cells are in from centres that are half a width outside the ball
    scalar reach(const scalar d) const override
    {
        return ball(d, widest_) + 0.5*widest_;
    }

    scalar weight
    (
        const point& centre, const scalar d, const label celli
    ) const override
    {
        const scalar r = mag(across(centre, mesh_.cellCentres()[celli]));
        const scalar h = width_[celli];
        const scalar part = (ball(d, h) - r)/h + 0.5;
        return mesh_.cellVolumes()[celli]*min(max(part, scalar(0)), scalar(1));
    }

    void tooWide(const scalar reach, const scalar most) const override
    {
        FatalIOErrorInFunction(dict_)
            << "Entry 'scale' " << scale_ << ": particles spread over "
            << reach << " m, but the mesh leaves room for " << most
            << " m (its size, or half of a cyclic period)" << nl
            << "Choose a smaller 'scale', smaller particles or a larger mesh"
            << exit(FatalIOError);
    }
};

} // End namespace dew
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::bigParticle::bigParticle(const dictionary& dict)
:
    voidFractionModel(dict),
    scale_(userEntry::within(dict, "scale", 1, 1000))
{
    userEntry::onlyThese(dict, {"type", "scale"});
}



// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::particleSupport> Foam::dew::bigParticle::support
(
    const polyMesh& mesh
) const
{
    return autoPtr<particleSupport>
    (
        new kernelSupport
        (
            autoPtr<cellKernel>(new rampKernel(mesh, dict_, scale_))
        )
    );
}
