/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "Gaussian.H"
#include "addToRunTimeSelectionTable.H"
#include "kernelSupport.H"
#include "polyMesh.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeNameAndDebug(Gaussian, 0);
    addToRunTimeSelectionTable(voidFractionModel, Gaussian, dictionary);
}
}


// * * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{

class GaussianKernel
:
    public cellKernel
{
    const dictionary dict_;

    const scalar width_, diameters_;

    scalar s(const scalar d) const { return width_ + diameters_*d; }

public:

    GaussianKernel
    (
        const polyMesh& mesh, const dictionary& dict,
        const scalar width, const scalar diameters
    )
    :
        cellKernel(mesh),
        dict_(dict),
        width_(width),
        diameters_(diameters)
    {}

    scalar reach(const scalar d) const override { return 4*s(d); }

    scalar weight
    (
        const point& centre, const scalar d, const label celli
    ) const override
    {
        const scalar square =
            magSqr(across(centre, mesh_.cellCentres()[celli]))/sqr(s(d));
        return
            square < 16
          ? mesh_.cellVolumes()[celli]*(exp(-0.5*square) - exp(scalar(-8)))
          : 0;
    }

    void tooWide(const scalar reach, const scalar most) const override
    {
        const word entry(width_ > 0 ? "width" : "diameters");
        FatalIOErrorInFunction(dict_)
            << "Entry '" << entry << "' " << width_ + diameters_
            << ": the Gaussian reaches " << reach << " m, but the mesh leaves"
            << " room for " << most << " m (its size, or half of a cyclic"
            << " period)" << nl << "Choose '" << entry << "' below "
            << (width_ + diameters_)*most/reach << ", or a larger mesh"
            << exit(FatalIOError);
    }
};

} // End namespace dew
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::Gaussian::Gaussian(const dictionary& dict)
:
    voidFractionModel(dict),
    width_(0),
    diameters_(0)
{
    userEntry::onlyThese(dict, {"type", "width", "diameters"});

    if (dict.found("width") == dict.found("diameters"))
    {
        FatalIOErrorInFunction(dict)
            << "The void fraction model 'Gaussian' needs one of the entries"
            << " 'width' and 'diameters'" << nl << "Give the standard"
            << " deviation in metres, e.g. 'width 3e-3;', or in particle"
            << " diameters, e.g. 'diameters 1.5;'" << exit(FatalIOError);
    }
    if (dict.found("width"))
    {
        width_ = userEntry::positive(dict, "width", dimLength);
    }
    else
    {
        diameters_ = userEntry::positive(dict, "diameters", dimless);
    }
}



// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::particleSupport> Foam::dew::Gaussian::support
(
    const polyMesh& mesh
) const
{
    return autoPtr<particleSupport>
    (
        new kernelSupport
        (
            autoPtr<cellKernel>
            (
                new GaussianKernel(mesh, dict_, width_, diameters_)
            )
        )
    );
}
