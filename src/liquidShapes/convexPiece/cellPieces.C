/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "convexPiece.H"
#include "meshSymmetry.H"
#include "polyMesh.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

using namespace Foam;

//- Of the size of a cell
constexpr scalar flatness = 1e-10;

//- Where a point of a wedge truly is
point truePlace(const dew::meshSymmetry& symmetry, const point& x)
{
    return
        symmetry.wedge()
      ? x + (symmetry.radius(x) - (symmetry.radial() & (x - symmetry.origin())))
           *symmetry.radial()
      : x;
}


bool flatAndConvex(const polyMesh& mesh, const label celli)
{
    const cell& faces = mesh.cells()[celli];
    const point& c = mesh.cellCentres()[celli];
    const labelList& points = mesh.cellPoints()[celli];

    scalar size = 0;
    for (const label pointi : points)
    {
        size = max(size, mag(mesh.points()[pointi] - c));
    }
    for (const label facei : faces)
    {
        const vector n
        (
            (mesh.faceOwner()[facei] == celli ? 1 : -1)
           *vector(normalised(mesh.faceAreas()[facei]))
        );
        const point& middle = mesh.faceCentres()[facei];
        for (const label pointi : points)
        {
            if ((n & (mesh.points()[pointi] - middle)) > flatness*size)
            {
                return false;
            }
        }
        for (const label pointi : mesh.faces()[facei])
        {
            if (mag(n & (mesh.points()[pointi] - middle)) > flatness*size)
            {
                return false;
            }
        }
    }
    return true;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * * //

void Foam::dew::cellPieces
(
    const polyMesh& mesh,
    const meshSymmetry& symmetry,
    const label celli,
    DynamicList<convexPiece>& pieces,
    DynamicList<scalar>& sign
)
{
    const bool whole = flatAndConvex(mesh, celli);
    if (whole)
    {
        pieces.append(convexPiece());
        sign.append(1);
    }

    DynamicList<point> corners;
    for (const label facei : mesh.cells()[celli])
    {
        const face& f = mesh.faces()[facei];
        const bool outward = mesh.faceOwner()[facei] == celli;

        corners.clear();
        forAll(f, i)
        {
            corners.append
            (
                truePlace
                (
                    symmetry, mesh.points()[f[outward ? i : f.size() - 1 - i]]
                )
            );
        }
        if (whole)
        {
            pieces.last().addFace(corners);
            continue;
        }

        const point apex(truePlace(symmetry, mesh.cellCentres()[celli]));
        const point middle(truePlace(symmetry, mesh.faceCentres()[facei]));
        const label n = f.size() == 3 ? 1 : f.size();
        for (label i = 0; i < n; i++)
        {
            point x[4] =
            {
                apex,
                n == 1 ? corners[2] : middle,
                corners[i],
                corners[(i + 1) % f.size()]
            };
            const scalar six = (x[1] - x[0]) & ((x[2] - x[0])^(x[3] - x[0]));
            if (six == 0)
            {
                continue;
            }
            if (six < 0)
            {
                Swap(x[2], x[3]);
            }
            convexPiece tet;
            tet.addFace(List<point>({x[1], x[2], x[3]}));
            tet.addFace(List<point>({x[0], x[2], x[1]}));
            tet.addFace(List<point>({x[0], x[3], x[2]}));
            tet.addFace(List<point>({x[0], x[1], x[3]}));
            pieces.append(tet);
            sign.append(six > 0 ? 1 : -1);
        }
    }
}
