/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "couplingCheck.H"
#include "fvc.H"
#include "unitConversion.H"
#include "wedgeFvPatch.H"

#include <cmath>
#include <cstdio>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

//- One line of the table
void printLine
(
    const char* what,
    const double value,
    const double limit,
    const char* remedy
)
{
    char text[120];
    std::snprintf(text, sizeof(text), "    %-44s %10.3g   %s", what, value, value > limit ? "WARNING" : "ok");
    Foam::Info<< text;
    if (value > limit)
    {
        std::snprintf(text, sizeof(text), "%.3g", limit);
        Foam::Info<< ": above " << text << ". " << remedy;
    }
    Foam::Info<< Foam::nl;
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::couplingCheck::couplingCheck
(
    const fvMesh& mesh,
    const particleEngine& particles,
    particleExchange& exchange
)
:
    mesh_(mesh),
    particles_(particles),
    exchange_(exchange)
{}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::tmp<Foam::scalarField> Foam::dew::couplingCheck::cellWidths() const
{
    tmp<scalarField> twidth(new scalarField(cbrt(mesh_.V().field())));

    // Of a wedge in the plane: its sides have the area of that
    for (const fvPatch& patch : mesh_.boundary())
    {
        if (isA<wedgeFvPatch>(patch))
        {
            const labelUList& cells = patch.faceCells();
            forAll(cells, facei)
            {
                twidth.ref()[cells[facei]] =
                    std::sqrt(patch.magSf()[facei]);
            }
        }
    }
    return twidth;
}


void Foam::dew::couplingCheck::printWedge(const scalar dMax) const
{
    const meshSymmetry& symmetry = exchange_.map().symmetry();

    // Outer radius of the innermost cells
    scalar inner = GREAT;
    forAll(mesh_.C(), celli)
    {
        scalar outer = 0;
        for (const label pointi : mesh_.cellPoints()[celli])
        {
            outer = max(outer, symmetry.radius(mesh_.points()[pointi]));
        }
        inner = min(inner, outer);
    }
    reduce(inner, minOp<scalar>());

    // The ring factor is 2 pi/sin(theta)
    const scalar angle = radToDeg
    (
        std::asin(constant::mathematical::twoPi/symmetry.ringFactor())
    );
    const auto digits = [](const scalar value)
    {
        char text[20];
        std::snprintf(text, sizeof(text), "%.6g", value);
        return string(text);
    };
    Info<< "    Wedge mesh of " << digits(angle).c_str() << " degrees about the axis "
        << symmetry.axis() << " through " << symmetry.origin()
        << ": it stands for " << digits(symmetry.ringFactor()).c_str() << " times its volume"
        << nl;
    printLine
    (
        "particle diameter over that of innermost ring", dMax/(2*inner),
        exchange_.widthLimit(),
        "Particles fill the cells at the axis: use wider ones there"
    );

    const vector& g = exchange_.g();
    if (mag(g - symmetry.axis()*(symmetry.axis() & g)) > 1e-9*mag(g))
    {
        Info<< "    WARNING: gravity " << g << " is not along the axis: the"
            << " fluid of a wedge cannot follow particles across it" << nl;
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::couplingCheck::print() const
{
    const particleState& s = particles_.state();
    const scalar dt = mesh_.time().deltaTValue();

    // Laws in the fluid as it is at the start
    exchange_.forces();

    // Largest particle over the width of the cell it is in
    scalar width = 0, dMax = 0;
    {
        const hostCells& hosts = exchange_.map().hosts();
        const List<scalar> d(hosts.map().forward(s.d));
        const scalarField widths(cellWidths());
        const scalar smoothed = exchange_.smoothingLength();
        forAll(d, k)
        {
            width =
                max(width, d[k]/max(widths[hosts.cells()[k]], smoothed));
            dMax = max(dMax, d[k]);
        }
        reduce(width, maxOp<scalar>());
        reduce(dMax, maxOp<scalar>());
    }
    label celli = -1;
    const scalar share =
        returnReduce(exchange_.largestOccupation(celli), maxOp<scalar>());

    const surfaceScalarField& phi =
        mesh_.lookupObject<surfaceScalarField>("phi");
    const scalar Co =
        0.5*dt*gMax
        (
            scalarField
            (
                fvc::surfaceSum(mag(phi))().primitiveField()/mesh_.V().field()
            )
        );

    Info<< "Check of the set-up" << nl;
    if (particles_.stableDeltaT() > 0)
    {
        printLine
        (
            "sub-step over stability limit of contacts",
            particles_.deltaT()/particles_.stableDeltaT(), 0.5,
            "Lower timeStep.fraction or timeStep.deltaT"
        );
        printLine
        (
            "sub-steps a time step", dt/particles_.deltaT(), 1e5,
            "Lower deltaT, or choose softer contacts"
        );
    }
    printLine
    (
        "time step over relaxation time",
        exchange_.largestRelaxation(),
        exchange_.explicitMomentum() ? 1 : GREAT,
        "Lower deltaT, or use momentum semiImplicit"
    );
    printLine
    (
        exchange_.smoothingLength() > 0
      ? "particle diameter over width of smoothing"
      : "particle diameter over cell width",
        width,
        exchange_.widthLimit(),
        "The fluid a particle sees is disturbed by itself: use a coarser mesh"
        " or a wider smoothing"
    );
    if (exchange_.displaces() && !(exchange_.smoothingLength() > 0))
    {
        printLine
        (
            "share of a cell one particle fills", share, 0.5,
            "Use a coarser mesh, or voidFraction divided"
        );
    }
    if (exchange_.map().symmetry().wedge())
    {
        printWedge(dMax);
    }
    printLine("Courant number", Co, 1, "Lower deltaT, or set adjustTimeStep");
    if (mesh_.dynamic())
    {
        Info<< "    The mesh may move: walls of the particles, also those of"
            << " its patches, do not move with it" << nl;
    }
    Info<< endl;
}
