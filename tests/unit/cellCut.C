/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// A cube cut by planes, against closed forms, at any size; areas of polygons
// below a level, of one that is not convex too; the mean share of a face that
// a plane sweeps

#include <gtest/gtest.h>
#include "cellCut.H"
#include "faceCut.H"
#include "polygonCut.H"
#include "polyMesh.H"
#include "StringStream.H"
#include "Time.H"

#include <vector>

using namespace Foam;
using namespace Foam::dew;

namespace
{

//- A cube from the origin, of this size; face 1 is at the highest x
autoPtr<polyMesh> cube(const Time& runTime, const scalar h)
{
    pointField x(8);
    for (label i = 0; i < 8; i++)
    {
        x[i] = h*point(i & 1, (i >> 1) & 1, i >> 2);
    }
    faceList faces
    ({
        face({0, 4, 6, 2}), face({1, 3, 7, 5}), face({0, 1, 5, 4}),
        face({2, 6, 7, 3}), face({0, 2, 3, 1}), face({4, 5, 7, 6})
    });
    return autoPtr<polyMesh>::New
    (
        IOobject("cube", runTime.timeName(), runTime),
        std::move(x), std::move(faces), labelList(6, Zero), labelList(), false
    );
}

//- A control dictionary that does for a mesh
dictionary control()
{
    return dictionary
    (
        IStringStream
        (
            "startFrom startTime; startTime 0; stopAt endTime; endTime 1;"
            "deltaT 1; writeControl timeStep; writeInterval 1;"
        )()
    );
}

class cuts : public testing::TestWithParam<scalar>
{
protected:

    const scalar h = GetParam();
    Time runTime{control(), "/", "tmp", "system", "constant", false};
    autoPtr<polyMesh> mesh = cube(runTime, h);
    const vector n = vector(1, 1, 1)/std::sqrt(3.0);
};

//- Twice the area of the part of a polygon in the plane z = 0 with x <= level
scalar twiceBelow(const std::vector<point>& x, const scalar level)
{
    return polygonCut
    (
        x.size(),
        [&](const label i) -> const point& { return x[i]; },
        [&](const label i) { return x[i].x(); },
        level,
        [](const point&, const bool) {}
    ).z();
}

} // End anonymous namespace


TEST_P(cuts, cornerOfCube)
{
    cellCut cut(*mesh);
    cut.set(0);
    for (const scalar share : {1e-9, 1e-3, 0.1, 1.0/6})
    {
        // A tetrahedron with three edges of length s
        const scalar s = h*std::cbrt(6*share);
        cut.function(n);
        EXPECT_NEAR(cut.cut(share), share, 1e-14);
        EXPECT_NEAR(mag(cut.S())/(0.5*std::sqrt(3.0)*s*s), 1, 1e-9);
        EXPECT_NEAR(mag(cut.centre() - point::uniform(s/3))/h, 0, 1e-9);
    }
}


TEST_P(cuts, middleOfCube)
{
    cellCut cut(*mesh);
    cut.set(0);
    cut.function(n);
    cut.cut(0.5);

    // A regular hexagon through the middles of edges
    EXPECT_NEAR(mag(cut.S())/(h*h), 0.75*std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(mag(cut.centre() - point::uniform(h/2))/h, 0, 1e-12);

    // Along an axis, from a far guess
    EXPECT_NEAR(cut.cutPlane(vector(0, -1, 0), 0.3, Zero), 0.3, 1e-14);
    EXPECT_NEAR(mag(cut.centre() - h*point(0.5, 0.7, 0.5))/h, 0, 1e-12);
    EXPECT_NEAR
    (
        cut.share(h*point(0.5, 0.2, 0.5), vector(0, 1, 0)), 0.2, 1e-14
    );
}


TEST_P(cuts, sweptFace)
{
    faceCut cut(*mesh);
    const vector d = vector(0, 1, 1)/std::sqrt(2.0);

    // y + z = s on the face: the share is s^2/2, then 1 - (2 - s)^2/2
    const scalar unit = h/std::sqrt(2.0);
    EXPECT_NEAR(cut.meanShare(1, 0.5*unit*d, d, 0), 0.125, 1e-14);
    EXPECT_NEAR(cut.meanShare(1, Zero, d, unit), 1.0/6, 1e-14);
    EXPECT_NEAR(cut.meanShare(1, Zero, d, 2*unit), 0.5, 1e-14);
    EXPECT_NEAR(cut.meanShare(1, unit*d, d, -2*unit), 1.0/12, 1e-14);
    EXPECT_NEAR(cut.meanShare(1, -unit*d, d, 3*unit), 1.0/3, 1e-14);

    // A plane along the face passes it all at once
    EXPECT_NEAR
    (
        cut.meanShare(1, h*point(0.8, 0, 0), vector(1, 0, 0), 0.8*h), 0.75, 1e-14
    );
}


INSTANTIATE_TEST_SUITE_P(sizes, cuts, testing::Values(1.0, 1e-6, 1e3));


TEST(polygonCut, notConvex)
{
    // A comb with two teeth to the right
    const std::vector<point> comb
    {
        {0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {3, 2, 0},
        {3, 3, 0}, {0, 3, 0}
    };
    EXPECT_NEAR(twiceBelow(comb, 0.5), 3, 1e-14);
    EXPECT_NEAR(twiceBelow(comb, 1.5), 2*(3 + 0.5 + 0.5), 1e-14);
    EXPECT_NEAR(twiceBelow(comb, 2.5), 2*(3 + 1 + 1.5), 1e-14);
}
