/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "divided.H"
#include "addToRunTimeSelectionTable.H"
#include "ballPoints.H"
#include "mathematicalConstants.H"
#include "userEntry.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeNameAndDebug(divided, 0);
    addToRunTimeSelectionTable(voidFractionModel, divided, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Mean distance of a shell that ends at shares a and b of the volume [radii]
scalar distance(const scalar a, const scalar b)
{
    return 0.75*(std::pow(b, 4.0/3) - std::pow(a, 4.0/3))/(b - a);
}


//- A core, and two shells in the directions of axes and space diagonals
List<vector> axesAndDiagonals()
{
    const label nParts = 29, nDirections = 14;

    DynamicList<vector> points;
    points.append(vector::zero);

    label inner = 1;
    for (label shell = 0; shell < 2; shell++)
    {
        const label outer = inner + nDirections;
        const scalar r =
            distance(scalar(inner)/nParts, scalar(outer)/nParts);
        inner = outer;

        for (label i = -1; i <= 1; i++)
        {
            for (label j = -1; j <= 1; j++)
            {
                for (label k = -1; k <= 1; k++)
                {
                    // Axes have one component, space diagonals three
                    const vector n(i, j, k);
                    if (mag(i) + mag(j) + mag(k) == 1 || i*j*k != 0)
                    {
                        points.append(r*normalised(n));
                    }
                }
            }
        }
    }

    return List<vector>(std::move(points));
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::divided::divided(const dictionary& dict)
:
    voidFractionModel(dict)
{
    userEntry::onlyThese(dict, {"type", "points"});
    points_ =
        dict.found("points")
      ? spirals(userEntry::count(dict, "points"))
      : axesAndDiagonals();
}



// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::List<Foam::vector> Foam::dew::divided::spirals(const label nParts)
{
    const scalar golden =
        constant::mathematical::pi*(3 - std::sqrt(scalar(5)));

    List<vector> points(nParts, vector::zero);

    // Shares of the volume up to the end of the core and of each shell
    const label core = nParts % 2;
    const scalar inner = std::cbrt(scalar(core)/nParts);
    const scalar apart =
        std::cbrt(4*constant::mathematical::pi/(3*scalar(nParts)));
    const label nShells = max(label((1 - inner)/apart + 0.5), label(1));

    label from = core;
    for (label shell = 1; shell <= nShells; shell++)
    {
        const scalar end = pow3(inner + (1 - inner)*shell/nShells);
        const label to =
            shell == nShells
          ? nParts : core + 2*label(0.5*(end*nParts - core) + 0.5);
        if (to == from)
        {
            continue;
        }

        const scalar r = distance(scalar(from)/nParts, scalar(to)/nParts);
        const label nPairs = (to - from)/2;
        for (label i = 0; i < nPairs; i++)
        {
            const scalar z = (i + 0.5)/nPairs;
            const scalar s = r*std::sqrt(1 - sqr(z));
            const scalar phi = golden*i + shell;
            points[from + 2*i] =
                vector(s*std::cos(phi), s*std::sin(phi), r*z);
            points[from + 2*i + 1] = -points[from + 2*i];
        }
        from = to;
    }

    return points;
}


Foam::autoPtr<Foam::dew::particleSupport> Foam::dew::divided::support
(
    const polyMesh&
) const
{
    return autoPtr<particleSupport>(new ballPoints(points_));
}
