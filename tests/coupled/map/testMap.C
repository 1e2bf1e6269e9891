/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    testMap

Description
    Particles of a table on a mesh, without an engine and without a solver: for
    tests. Rows of constant/map.csv (x, y, z, d after one line of names) are
    dealt to the ranks in blocks, irrespective of the mesh. From
    constant/testProperties,

    \verbatim
    voidFraction { type divided; }
    before  false;              // find the rows in reverse order first
    gather  false;              // also U at the particles, by the exchange:
    centre  (0 0 0);            // U(x) = U + (r & gradU) + (r.r) square,
    U       (0 0 0);            // r = x - centre
    gradU   (0 0 0  0 0 0  0 0 0);
    square  (0 0 0);
    overlap false;              // also the exact overlap with all cells
    \endverbatim

    cells.csv has centre, volume and the volume of particles of each cell;
    particles.csv, in the order of the table, the label and centre of the cell
    that holds the particle (-1 if none), the sum of its weights, the fluid's
    velocity, what was asked of the field there, the rank, and the overlap with
    all cells of that rank over the particle's volume.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "cellOverlap.H"
#include "fvMesh.H"
#include "IFstream.H"
#include "particleExchange.H"
#include "Time.H"
#include "volFields.H"
#include "voidFractionModel.H"

#include <algorithm>
#include <fstream>
#include <sstream>

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

//- This rank's block of the table
void readTable(const fileName& path, dew::particleState& s)
{
    std::ifstream is(path);
    std::string line;
    std::getline(is, line);

    DynamicList<List<scalar>> rows;
    while (std::getline(is, line))
    {
        std::replace(line.begin(), line.end(), ',', ' ');
        std::istringstream columns(line);
        List<scalar> row(4);
        columns >> row[0] >> row[1] >> row[2] >> row[3];
        rows.append(row);
    }

    const label me = Pstream::myProcNo(), nRanks = Pstream::nProcs();
    const label begin = rows.size()*me/nRanks;
    const label end = rows.size()*(me + 1)/nRanks;

    s.setSize(end - begin);
    for (label i = begin; i < end; i++)
    {
        const label k = i - begin;
        s.id[k] = i + 1;
        s.type[k] = 0;
        s.x[k] = point(rows[i][0], rows[i][1], rows[i][2]);
        s.d[k] = rows[i][3];
        s.rho[k] = 1000;
        s.v[k] = Zero;
        s.omega[k] = Zero;
    }
}


//- Lines of all ranks in their order
void write(const fileName& path, const char* names, const std::string& lines)
{
    for (label rank = 0; rank < Pstream::nProcs(); rank++)
    {
        if (rank == Pstream::myProcNo())
        {
            std::ofstream os(path, rank ? std::ios::app : std::ios::trunc);
            if (rank == 0)
            {
                os << names << '\n';
            }
            os << lines;
        }
        label turn = rank;
        reduce(turn, maxOp<label>());
    }
}


int main(int argc, char *argv[])
{
    #include "setRootCase.H"
    #include "createTime.H"

    fvMesh mesh
    (
        IOobject
        (
            fvMesh::defaultRegion, runTime.timeName(), runTime,
            IOobject::MUST_READ
        )
    );

    IFstream is(runTime.globalPath()/"constant"/"testProperties");
    const dictionary dict(is);

    dew::particleState s;
    readTable(runTime.globalPath()/"constant"/"map.csv", s);

    // The map alone
    dew::particleMesh map
    (
        mesh,
        dew::voidFractionModel::New(dict.subDict("voidFraction"))->support(mesh)
    );

    if (dict.getOrDefault("before", false))
    {
        List<point> x(s.x);
        std::reverse(x.begin(), x.end());
        map.correct(x, s.d);
    }
    map.correct(s.x, s.d);

    List<scalar> volume(s.size());
    forAll(volume, i)
    {
        volume[i] = s.volume(i);
    }
    scalarField solid(mesh.nCells(), Zero);
    map.scatter(volume, solid);

    List<scalar> weights(s.size(), scalar(-1));
    map.average(scalarField(mesh.nCells(), scalar(1)), weights);

    struct place
    {
        label rank;
        label cell;
        point centre;
    };
    List<place> places(s.size(), place{-1, -1, Zero});
    map.gather
    (
        places,
        [&](const label celli, const point&, const auto&, place& to)
        {
            to = place{Pstream::myProcNo(), celli, mesh.C()[celli]};
        },
        [](const auto&, place& to) { to = place{-1, -1, Zero}; },
        [](place&, const place&) {}
    );

    // The fluid's velocity, as the exchange hands it to the particles
    List<vector> U(s.size(), vector::zero), exact(s.size(), vector::zero);
    if (dict.getOrDefault("gather", false))
    {
        const point centre(dict.get<point>("centre"));
        const vector U0(dict.get<vector>("U"));
        const tensor gradU(dict.get<tensor>("gradU"));
        const vector square(dict.get<vector>("square"));
        const auto formula = [&](const point& x)
        {
            const vector r(x - centre);
            return U0 + (r & gradU) + magSqr(r)*square;
        };

        const auto io = [&](const word& name)
        {
            return IOobject(name, runTime.timeName(), mesh);
        };
        volVectorField field
        (
            io("U"), mesh, dimensionedVector(dimVelocity, Zero), "calculated"
        );
        forAll(field, celli)
        {
            field[celli] = formula(mesh.C()[celli]);
        }
        forAll(field.boundaryField(), patchi)
        {
            fvPatchVectorField& patch = field.boundaryFieldRef()[patchi];
            if (!patch.coupled())
            {
                vectorField values(patch.size());
                forAll(values, facei)
                {
                    values[facei] = formula(patch.patch().Cf()[facei]);
                }
                patch == values;
            }
        }
        field.correctBoundaryConditions();

        const volScalarField p
        (
            io("p"), mesh, dimensionedScalar(sqr(dimVelocity), Zero)
        );
        const volVectorField gradp
        (
            io("gradp"), mesh, dimensionedVector(dimPressure/dimLength, Zero)
        );
        const volScalarField rho
        (
            io("rho"), mesh, dimensionedScalar("rho", dimDensity, 1000)
        );
        const volScalarField mu
        (
            io("mu"), mesh, dimensionedScalar("mu", dimDynamicViscosity, 1e-3)
        );

        dew::particleExchange exchange
        (
            mesh, dict, dew::carrierFields{field, field, p, gradp, rho, mu}, s, Zero
        );
        U = exchange.forces().U;
        forAll(exact, i)
        {
            exact[i] = formula(s.x[i]);
        }
    }

    List<scalar> overlap(s.size(), Zero);
    if (dict.getOrDefault("overlap", false))
    {
        const dew::cellOverlap balls(mesh);
        forAll(overlap, i)
        {
            for (label celli = 0; celli < mesh.nCells(); celli++)
            {
                overlap[i] +=
                    balls.volume(s.x[i], 0.5*s.d[i], celli)/volume[i];
            }
        }
    }

    std::ostringstream cells, particles;
    cells.precision(17);
    particles.precision(17);
    const auto put = [](std::ostream& os, const vector& v)
    {
        os << v.x() << ',' << v.y() << ',' << v.z();
    };
    forAll(solid, celli)
    {
        put(cells, mesh.C()[celli]);
        cells << ',' << mesh.V()[celli] << ',' << solid[celli] << '\n';
    }
    forAll(places, i)
    {
        particles << places[i].cell << ',';
        put(particles, places[i].centre);
        particles << ',' << weights[i] << ',';
        put(particles, U[i]);
        particles << ',';
        put(particles, exact[i]);
        particles << ',' << places[i].rank << ',' << overlap[i] << '\n';
    }
    write(runTime.globalPath()/"cells.csv", "x,y,z,V,solid", cells.str());
    write
    (
        runTime.globalPath()/"particles.csv",
        "cell,x,y,z,weights,ux,uy,uz,ex,ey,ez,rank,overlap", particles.str()
    );

    Info<< "Outside " << map.nOutside() << nl << "End\n" << endl;

    return 0;
}


// ************************************************************************* //
