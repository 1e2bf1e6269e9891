/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "filling.H"
#include "bitSet.H"
#include "emptyPolyPatch.H"
#include "polyMesh.H"
#include "Time.H"
#include "userEntry.H"
#include "wedgePolyPatch.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- Volumes below this, of a piece, are round-off
constexpr Foam::scalar nothing = 1e-13;

//- Halvings of a cell that several curved shapes cut
constexpr Foam::label maxDepth = 18;

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::filling::filling
(
    const polyMesh& mesh,
    const meshSymmetry& symmetry,
    const dictionary& dict
)
:
    mesh_(mesh),
    symmetry_(symmetry),
    dict_(dict),
    share_(mesh.nCells(), Zero)
{
    // Other entries may be there, for macros
    const dictionary& shapes = userEntry::subDict(dict, "shapes");
    for (const entry& e : shapes)
    {
        const dictionary& d = userEntry::dictOf(shapes, e);
        shapes_.append
        (
            liquidShape::New(mesh.time(), symmetry, d).ptr()
        );
        names_.append(e.keyword());
        outside_.append(d.getOrDefault<Switch>("outside", false));
        const word action(d.getOrDefault<word>("action", "add"));
        remove_.append(action == "remove");
        if (action != "add" && action != "remove")
        {
            FatalIOErrorInFunction(d)
                << "Unknown action '" << action << "' of the shape "
                << e.keyword() << nl << "Known: add remove"
                << exit(FatalIOError);
        }
    }
    if (shapes_.empty())
    {
        FatalIOErrorInFunction(shapes)
            << "No shape in " << shapes.dictName() << nl
            << "Add: drop { type sphere; centre (0 0 0); radius 1e-3; }"
            << exit(FatalIOError);
    }

    bitSet atBoundary(mesh.nCells());
    for (const polyPatch& patch : mesh.boundaryMesh())
    {
        if
        (
            !patch.coupled()
         && !isA<emptyPolyPatch>(patch) && !isA<wedgePolyPatch>(patch)
        )
        {
            atBoundary.set(patch.faceCells());
        }
    }

    held_.setSize(shapes_.size(), Zero);
    atBoundary_.setSize(shapes_.size(), Zero);
    forAll(share_, celli)
    {
        const bool boundary = atBoundary.test(celli);
        if (!fillWhole(celli, boundary))
        {
            fill(celli, boundary);
        }
    }
    for (scalarField* sums : {&held_, &atBoundary_})
    {
        Pstream::listCombineGather(*sums, plusEqOp<scalar>());
        Pstream::listCombineScatter(*sums);
    }

    if (!(gSum(share_) > 0))
    {
        FatalIOErrorInFunction(dict)
            << "The shapes leave no liquid in the mesh, which is in "
            << mesh.bounds() << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dew::filling::place Foam::dew::filling::whereIs
(
    const label shapei,
    const point& c,
    const scalar r
) const
{
    const scalar depth = shapes_[shapei].level(c);

    return
        mag(depth) < r ? CUT
      : (depth > 0) != outside_[shapei] ? IN
      : OUT;
}


bool Foam::dew::filling::liquid(const UList<place>& places) const
{
    bool is = false;
    forAll(places, i)
    {
        if (places[i] == IN)
        {
            is = !remove_[i];
        }
    }
    return is;
}


void Foam::dew::filling::simplify(List<place>& places) const
{
    // The last that is in decides: what is before it does not matter, nor
    // what does the same as the last before it
    forAllReverse(places, i)
    {
        if (places[i] == IN)
        {
            for (label j = 0; j < i; j++)
            {
                places[j] = OUT;
            }
            break;
        }
    }
    bool before = false;
    forAll(places, i)
    {
        if (places[i] == CUT && before == !remove_[i])
        {
            bool all = true;
            for (label j = 0; j < i; j++)
            {
                all = all && places[j] != CUT;
            }
            if (all)
            {
                places[i] = OUT;
            }
        }
        if (places[i] == IN)
        {
            before = !remove_[i];
        }
    }
}


Foam::scalar Foam::dew::filling::volume
(
    const UList<place>& places,
    const UList<scalar>& in,
    const scalar whole
) const
{
    const label i = places.find(CUT);
    List<place> state(places);
    if (i < 0)
    {
        return liquid(state) ? whole : 0;
    }
    state[i] = IN;
    const bool with = liquid(state);
    state[i] = OUT;
    const bool without = liquid(state);

    return (with ? in[i] : 0) + (without ? whole - in[i] : 0);
}


Foam::scalar Foam::dew::filling::byTangents
(
    const convexPiece& piece,
    List<place> places
) const
{
    const label i = places.find(CUT);
    if (i < 0 || piece.empty())
    {
        return i < 0 && liquid(places) ? piece.volume() : 0;
    }

    const point c(piece.centre());
    const scalar r = piece.radius(c), depth = shapes_[i].level(c);
    vector inward(Zero);
    for (direction k = 0; k < 3; k++)
    {
        vector d(Zero);
        d[k] = 1e-3*r;
        inward[k] = (shapes_[i].level(c + d) - shapes_[i].level(c - d))/(2e-3*r);
    }

    convexPiece out, in;
    if (mag(inward) > 0)
    {
        piece.split(c - depth/magSqr(inward)*inward, inward, out, in);
    }
    List<place> inside(places);
    inside[i] = outside_[i] ? OUT : IN;
    places[i] = outside_[i] ? IN : OUT;

    return byTangents(in, inside) + byTangents(out, places);
}


Foam::scalar Foam::dew::filling::divided
(
    const convexPiece& piece,
    const label depth
) const
{
    const scalar whole = piece.volume();
    if (piece.empty() || !(whole > 0))
    {
        return 0;
    }

    List<place> places(shapes_.size());
    scalarList in(shapes_.size(), Zero);
    forAll(shapes_, i)
    {
        places[i] = whereIs(i, piece);
        if (places[i] == CUT)
        {
            const scalar v = shapes_[i].volumeIn(piece);
            in[i] = outside_[i] ? whole - v : v;
            places[i] =
                in[i] <= nothing*whole ? OUT
              : in[i] >= (1 - nothing)*whole ? IN
              : CUT;
        }
    }
    simplify(places);

    label nCut = 0;
    for (const place p : places)
    {
        nCut += p == CUT;
    }
    if (nCut < 2)
    {
        return volume(places, in, whole);
    }

    convexPiece below, above;
    forAll(shapes_, i)
    {
        for (label k = 0; places[i] == CUT && k < shapes_[i].nPlanes(); k++)
        {
            point x;
            vector n;
            shapes_[i].bound(k, x, n);
            piece.split(x, n, below, above);
            if (min(below.volume(), above.volume()) > nothing*whole)
            {
                return divided(below, depth) + divided(above, depth);
            }
        }
    }

    if (depth == 0)
    {
        return byTangents(piece, places);
    }
    piece.halve(below, above);
    return divided(below, depth - 1) + divided(above, depth - 1);
}


bool Foam::dew::filling::fillWhole(const label celli, const bool boundary)
{
    // Where the points of a wedge truly are, it is wider
    const point& c = mesh_.cellCentres()[celli];
    const scalar away =
        symmetry_.wedge()
      ? symmetry_.radius(c) - (symmetry_.radial() & (c - symmetry_.origin()))
      : 0;
    scalar r = 0;
    for (const label pointi : mesh_.cellPoints()[celli])
    {
        r = max(r, mag(mesh_.points()[pointi] - c));
    }
    r /= symmetry_.wedge() ? symmetry_.cosHalfAngle() : 1;

    List<place> places(shapes_.size());
    forAll(shapes_, i)
    {
        places[i] = whereIs(i, c + away*symmetry_.radial(), r);
        if (places[i] == CUT)
        {
            return false;
        }
    }
    share_[celli] = liquid(places) ? 1 : 0;

    const scalar V = mesh_.cellVolumes()[celli];
    forAll(shapes_, i)
    {
        const scalar held = (places[i] == IN) != outside_[i] ? V : 0;
        held_[i] += held;
        atBoundary_[i] += boundary ? held : 0;
    }
    return true;
}


void Foam::dew::filling::fill(const label celli, const bool boundary)
{
    DynamicList<convexPiece> pieces;
    DynamicList<scalar> sign;
    cellPieces(mesh_, symmetry_, celli, pieces, sign);

    scalar liquidVolume = 0, wholeVolume = 0;
    List<place> places(shapes_.size());
    scalarList in(shapes_.size());
    forAll(pieces, piecei)
    {
        const convexPiece& piece = pieces[piecei];
        const scalar whole = piece.volume();

        label nCut = 0;
        forAll(shapes_, i)
        {
            places[i] = whereIs(i, piece);
            in[i] = places[i] == IN ? whole : 0;
            if (places[i] == CUT)
            {
                const scalar v = shapes_[i].volumeIn(piece);
                in[i] = outside_[i] ? whole - v : v;
                places[i] =
                    in[i] <= nothing*whole ? OUT
                  : in[i] >= (1 - nothing)*whole ? IN
                  : CUT;
            }

            // Of the mesh: a wedge is wider in its pieces
            const scalar held =
                sign[piecei]*(outside_[i] ? whole - in[i] : in[i])
               *(symmetry_.wedge() ? symmetry_.cosHalfAngle() : 1);
            held_[i] += held;
            atBoundary_[i] += boundary ? held : 0;
        }
        simplify(places);
        for (const place p : places)
        {
            nCut += p == CUT;
        }
        liquidVolume +=
            sign[piecei]
           *(nCut < 2 ? volume(places, in, whole) : divided(piece, maxDepth));
        wholeVolume += sign[piecei]*whole;
    }

    const scalar share = liquidVolume/wholeVolume;
    if (!(share >= -1e-9 && share <= 1 + 1e-9))
    {
        FatalErrorInFunction
            << "The share of the liquid in cell " << celli << " at "
            << mesh_.cellCentres()[celli] << " comes out as " << share << nl
            << "See checkMesh" << exit(FatalError);
    }
    share_[celli] =
        share < nothing ? 0 : share > 1 - nothing ? 1 : share;
}
