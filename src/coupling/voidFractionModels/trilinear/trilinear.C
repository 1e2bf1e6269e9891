/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "trilinear.H"
#include "addToRunTimeSelectionTable.H"
#include "boundBox.H"
#include "pointSupport.H"
#include "polyMesh.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeNameAndDebug(trilinear, 0);
    addToRunTimeSelectionTable(voidFractionModel, trilinear, dictionary);
}
}


// * * * * * * * * * * * * * * * * Local Classes * * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{

//- Eight points: where the particle is, or just behind a face of its cell
class boxPoints
:
    public pointSupport
{
    const polyMesh& mesh_;

    List<boundBox> box_;

    void update() override
    {
        box_.setSize(mesh_.nCells());
        box_ = boundBox();
        forAll(box_, celli)
        {
            for (const label facei : mesh_.cells()[celli])
            {
                for (const label pointi : mesh_.faces()[facei])
                {
                    box_[celli].add(mesh_.points()[pointi]);
                }
            }
        }
    }

protected:

    scalar reach(const scalar) const override { return GREAT; }

    void place
    (
        const meshSymmetry&, const point& centre, const scalar,
        const label host
    ) override
    {
        vector share(Zero), step(Zero);
        for (direction k = 0; k < 3; k++)
        {
            const scalar low = box_[host].min()[k], high = box_[host].max()[k];
            const scalar s = (centre[k] - 0.5*(low + high))/(high - low);

            // Not along empty directions and around an axis
            if (mesh_.geometricD()[k] > 0)
            {
                share[k] = min(mag(s), scalar(0.5));
                step[k] =
                    s < 0 ? low - centre[k] - 0.025*(high - low)
                  : high - centre[k] + 0.025*(high - low);
            }
        }

        for (label corner = 0; corner < 8; corner++)
        {
            scalar w = 1;
            vector away(Zero);
            for (direction k = 0; k < 3; k++)
            {
                const bool other = corner & (1 << k);
                w *= other ? share[k] : 1 - share[k];
                away[k] = other ? step[k] : 0;
            }
            weight_[corner] = w;
            away_[corner] = away;
        }
    }

public:

    explicit boxPoints(const polyMesh& mesh)
    :
        pointSupport(8),
        mesh_(mesh)
    {
        update();
    }
};

} // End namespace dew
} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::trilinear::trilinear(const dictionary& dict)
:
    voidFractionModel(dict)
{
    userEntry::onlyThese(dict, {"type"});
}



// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::autoPtr<Foam::dew::particleSupport> Foam::dew::trilinear::support
(
    const polyMesh& mesh
) const
{
    return autoPtr<particleSupport>(new boxPoints(mesh));
}
