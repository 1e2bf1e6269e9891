/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "film.H"
#include "fvMesh.H"
#include "SubField.H"
#include "Time.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- What remains of the volume when all of it has been lost, by round-off
constexpr Foam::scalar roundOff = 1e-9;

//- Volume and area of the film that may be missing where points have six
//  digits
constexpr Foam::scalar missing = 1e-5;

//- Area of the part of a triangle where s > 0, s linear between its points
Foam::scalar positivePart
(
    const Foam::FixedList<Foam::scalar, 3>& s,
    const Foam::scalar area
)
{
    Foam::label nIn = 0;
    for (const Foam::scalar v : s)
    {
        nIn += v > 0;
    }
    if (nIn == 0 || nIn == 3)
    {
        return nIn ? area : 0;
    }

    // The corner that is alone on its side
    Foam::label k = 0;
    while ((s[k] > 0) != (nIn == 1))
    {
        k++;
    }
    const Foam::scalar corner =
        area
       *s[k]/(s[k] - s[(k + 1) % 3])
       *s[k]/(s[k] - s[(k + 2) % 3]);
    return nIn == 1 ? corner : area - corner;
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::scalar Foam::dew::surfaceMotions::film::wetArea(const label facei) const
{
    const face& f = mesh_.faces()[facei];
    const pointField& points = mesh_.points();

    bool someIn = false, someOut = false;
    for (const label pointi : f)
    {
        (depth(points[pointi]) > 0 ? someIn : someOut) = true;
    }
    const scalar whole = mag(mesh_.faceAreas()[facei]);
    if (!someIn || !someOut)
    {
        return someIn ? whole : 0;
    }

    // Of triangles around the centre, which add up to the whole
    const point& c = mesh_.faceCentres()[facei];
    const vector n(mesh_.faceAreas()[facei]/whole);
    const scalar sc = depth(c);
    scalar wet = 0;
    forAll(f, i)
    {
        const point& p = points[f[i]];
        const point& q = points[f.nextLabel(i)];
        wet += positivePart
        (
            {sc, depth(p), depth(q)},
            0.5*(((p - c) ^ (q - c)) & n)
        );
    }
    return wet;
}


void Foam::dew::surfaceMotions::film::overlap()
{
    const vector& up = substrate_.normal();
    const vectorField& Sf = mesh_.faceAreas();
    const vectorField& Cf = mesh_.faceCentres();

    scalarField share(mesh_.nFaces());
    forAll(share, facei)
    {
        share[facei] = wetArea(facei)/mag(Sf[facei]);
    }

    wetFaces_.primitiveFieldRef() =
        SubField<scalar>(share, mesh_.nInternalFaces());
    for (fvsPatchScalarField& patch : wetFaces_.boundaryFieldRef())
    {
        forAll(patch, i)
        {
            patch[i] = share[patch.patch().start() + i];
        }
    }

    // Keeps the values before
    scalarField& alpha = alpha_.primitiveFieldRef();

    forAll(alpha, celli)
    {
        const cell& faces = mesh_.cells()[celli];

        bool someIn = false, someOut = false;
        for (const label facei : faces)
        {
            for (const label pointi : mesh_.faces()[facei])
            {
                const scalar d = depth(mesh_.points()[pointi]);
                (d > 0 ? someIn : someOut) = true;
            }
        }

        area_[celli] = 0;
        alpha[celli] = someIn;
        if (someIn && someOut)
        {
            // Nearest point of the surface
            const point& C = mesh_.cellCentres()[celli];
            const point origin(C + (h_ - height(C))*up);

            scalar V = 0;
            for (const label facei : faces)
            {
                const scalar sign =
                    mesh_.faceOwner()[facei] == celli ? 1 : -1;
                const scalar out = sign*share[facei];
                V += out*(Sf[facei] & (Cf[facei] - origin))/3;
                area_[celli] -= out*(Sf[facei] & up);
            }
            alpha[celli] = V/mesh_.V()[celli];
        }
    }
    alpha_.correctBoundaryConditions();

    if (dry())
    {
        return;
    }
    const scalar held = heldVolume();
    const scalar top = gSum(area_);
    if
    (
        mag(held - volume()) > missing*volume()
     || mag(top - substrate_.area()) > missing*substrate_.area()
    )
    {
        FatalErrorInFunction
            << "A film of thickness " << h_ << " m on the patch "
            << substrate_.name() << " of area " << substrate_.area()
            << " m2 does not fit the mesh: " << held << " m3 of its "
            << volume() << " m3 are in cells, and its surface is " << top
            << " m2" << nl
            << "The walls beside it must be upright, and the film thinner"
            << " than they are high" << exit(FatalError);
    }
}


void Foam::dew::surfaceMotions::film::correctGeometry()
{
    const scalar speed = dt_ > 0 ? (h_ - before_)/dt_ : 0;

    psi_.primitiveFieldRef() =
        h_
      - (
            (mesh_.C().primitiveField() - substrate_.centre())
          & substrate_.normal()
        );
    n_ = dimensionedVector("n", dimless, substrate_.normal());
    curvature_ = dimensionedScalar(dimless/dimLength, Zero);
    speed_ = dimensionedScalar("speed", dimVelocity, speed);

    for (fvPatchScalarField& psi : psi_.boundaryFieldRef())
    {
        const vectorField& x = psi.patch().Cf();
        forAll(psi, i)
        {
            psi[i] = h_ - height(x[i]);
        }
    }
    psi_.correctBoundaryConditions();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::dew::surfaceMotions::film::inLiquid(const point& x) const
{
    return height(x) < h_;
}


void Foam::dew::surfaceMotions::film::evolve(const scalar liquidLost)
{
    before_ = h_;
    dt_ = mesh_.time().deltaTValue();

    const scalar V = volume() - liquidLost;
    if (V < -roundOff*volume() || (dry() && liquidLost != 0))
    {
        FatalErrorInFunction
            << "At time " << mesh_.time().timeName() << " the film has "
            << volume() << " m3 of liquid in the mesh and was to lose "
            << liquidLost << " m3 in one step" << nl
            << (
                   dry()
                 ? "A dry substrate neither loses nor gains liquid"
                 : "Take a smaller time step, or lose what there is"
               )
            << exit(FatalError);
    }
    h_ = V <= roundOff*volume() ? 0 : V/substrate_.area();

    alphaf_ = wetFaces_;
    overlap();
    alphaf_ = 0.5*(alphaf_ + wetFaces_);
    correctGeometry();
}


Foam::List<Foam::Tuple2<Foam::word, Foam::scalar>>
Foam::dew::surfaceMotions::film::measures() const
{
    return {{"volume", wholeFactor()*volume()}, {"thickness", h_}};
}


void Foam::dew::surfaceMotions::film::report(Ostream& os) const
{
    os  << "film: ";
    if (dry())
    {
        os  << "dry" << endl;
        return;
    }
    os  << "volume " << wholeFactor()*volume() << " m3, thickness " << h_
        << " m" << endl;
}


void Foam::dew::surfaceMotions::film::checkValidity
(
    const scalar,
    const scalar,
    const scalar,
    const scalar,
    const scalar
) const
{
    report(Info);
}


// ************************************************************************* //
