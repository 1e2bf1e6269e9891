/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Overlaps in the hashed grid against the plain double loop, at three scales,
// with and without periodic sides

#include <gtest/gtest.h>
#include "counterRandom.H"
#include "sphereGrid.H"

using namespace Foam;
using namespace Foam::dew;

TEST(sphereGrid, sameAsBruteForce)
{
    for (const scalar L : {1e-6, 1.0, 1e3})
    {
        for (const bool periodic : {false, true})
        {
            const particleBox box
            (
                boundBox(point::zero, L*point(1, 1, 0.12)),
                FixedList<bool, 3>({periodic, false, periodic})
            );
            const scalar rMax = 0.05*L;
            sphereGrid grid(box, rMax);
            counterRandom random(3);
            DynamicList<point> x;
            DynamicList<scalar> r;
            label overlaps = 0;

            for (label i = 0; i < 400; i++)
            {
                const point p
                (
                    L*random.uniform(),
                    L*random.uniform(),
                    0.12*L*random.uniform()
                );
                const scalar ri = rMax*(0.3 + 0.7*random.uniform());

                bool expected = false;
                forAll(x, j)
                {
                    const scalar gap =
                        mag(box.separation(p, x[j])) - ri - r[j];
                    expected = expected || gap < 0;
                }
                ASSERT_EQ(grid.overlapping(p, ri) >= 0, expected);

                overlaps += expected;
                grid.append(p, ri);
                x.append(p);
                r.append(ri);
            }

            EXPECT_GT(overlaps, 50);
        }
    }
}
