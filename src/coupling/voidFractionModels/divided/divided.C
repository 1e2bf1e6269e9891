/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "divided.H"
#include "addToRunTimeSelectionTable.H"
#include "userEntry.H"
#include "DynamicList.H"

#include <cmath>

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace dew
{
    defineTypeNameAndDebug(divided, 0);
    addToRunTimeSelectionTable(voidFractionModel, divided, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::divided::divided(const dictionary& dict)
{
    userEntry::onlyThese(dict, {"type"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::dew::supportStencil Foam::dew::divided::stencil() const
{
    const label nParts = 29, nDirections = 14;

    // Mean distance of a shell that ends at parts a and b of the volume
    const auto distance = [](const scalar a, const scalar b)
    {
        return 0.75*(std::pow(b, 4.0/3) - std::pow(a, 4.0/3))/(b - a);
    };

    supportStencil result;

    DynamicList<vector> offset;
    offset.append(vector::zero);

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
                        offset.append(r*normalised(n));
                    }
                }
            }
        }
    }

    result.offset.transfer(offset);
    result.weight = List<scalar>(nParts, scalar(1)/nParts);

    return result;
}
