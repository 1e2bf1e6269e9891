/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    mapBenchmark

Description
    Cost of the map between particles and cells: particles at random places of
    the mesh, dealt to ranks by their position along y, moved by a tenth of a
    cell a step, in one line of numbers:

        particles on this rank, ns a particle and step for correct(), gather,
        scatter; bytes of the map a particle; bytes sent a particle and step

    Arguments: number of particles of all ranks, diameter over cell width,
    void fraction model, steps. A Gaussian has a standard deviation of one
    diameter, a bigParticle 1.5 times its size.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "carrier.H"
#include "clockTime.H"
#include "dictionary.H"
#include "particleMesh.H"
#include "polyMesh.H"
#include "Random.H"
#include "Time.H"
#include "voidFractionModel.H"

#include <cmath>

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::noBanner();
    argList::addArgument("particles");
    argList::addArgument("diameter over cell width");
    argList::addArgument("model");
    argList::addArgument("steps");

    #include "setRootCase.H"
    #include "createTime.H"
    #include "createPolyMesh.H"

    const label n = args.get<label>(1);
    const scalar ratio = args.get<scalar>(2);
    dictionary dict;
    const word model(args.get<word>(3));
    dict.add("type", model);
    if (model == "Gaussian")
    {
        dict.add("diameters", 1);
    }
    if (model == "bigParticle")
    {
        dict.add("scale", 1.5);
    }
    const label nSteps = args.get<label>(4);

    const boundBox box(mesh.points(), true);
    const label nCells = returnReduce(mesh.nCells(), sumOp<label>());
    const scalar width = std::cbrt(box.span().x()*box.span().y()*box.span().z()/nCells);

    // Every rank draws all and keeps its own
    Random random(1);
    DynamicList<point> x;
    for (label i = 0; i < n; i++)
    {
        vector s;
        random.randomise01(s);
        if (label(s.y()*Pstream::nProcs()) == Pstream::myProcNo())
        {
            x.append(box.min() + cmptMultiply(s, box.span()));
        }
    }
    // As the engine has them: neighbours in space are neighbours in the list
    std::sort
    (
        x.begin(),
        x.end(),
        [&](const point& a, const point& b)
        {
            const auto key = [&](const point& p)
            {
                const vector c((p - box.min())/(4*width));
                return
                    label(c.z())*1000000L + label(c.y())*1000 + label(c.x());
            };
            return key(a) < key(b);
        }
    );
    const label nOwn = x.size();
    const List<scalar> d(nOwn, ratio*width);
    List<scalar> volume(nOwn, scalar(1));
    List<vector> force(nOwn, vector::one);
    List<dew::carrier> carriers(nOwn);
    scalarField alpha(mesh.nCells(), 0.5), sum(mesh.nCells());
    vectorField U(mesh.nCells(), vector::one), total(mesh.nCells());

    dew::particleMesh map
    (
        mesh, dew::voidFractionModel::New(dict)->support(mesh)
    );
    map.correct(x, d);
    const std::size_t before = map.sent();

    scalar times[3] = {0, 0, 0};
    for (label step = 0; step < nSteps; step++)
    {
        for (point& p : x)
        {
            vector s;
            random.randomise01(s);
            p += 0.1*width*(s - 0.5*vector::one);
            p = max(min(p, box.max()), box.min());
        }

        const clockTime clock;
        map.correct(x, d);
        times[0] += clock.elapsedTime();

        map.gather
        (
            carriers,
            [&](const label celli, const point&, const auto& cells, dew::carrier& c)
            {
                c.U = U[celli];
                c.alphac = 0;
                cells([&](const label k, const scalar w){ c.alphac += w*alpha[k]; });
            },
            [&](const auto& cells, dew::carrier& c)
            {
                c.alphac = 0;
                cells([&](const label k, const scalar w){ c.alphac += w*alpha[k]; });
            },
            [](dew::carrier& a, const dew::carrier& b){ a.alphac += b.alphac; }
        );
        const scalar gathered = clock.elapsedTime();

        sum = 0;
        total = Zero;
        map.scatter(volume, sum);
        map.scatter(force, total);
        times[2] += clock.elapsedTime() - gathered;
        times[1] += gathered;
    }
    times[1] -= times[0];

    const scalar perStep = 1e9/max(nOwn, label(1))/nSteps;
    for (label rank = 0; rank < Pstream::nProcs(); rank++)
    {
        if (rank == Pstream::myProcNo())
        {
            printf
            (
                "rank %d: %d particles; ns a particle and step: correct %.0f, gather %.0f, scatter %.0f, all %.0f;"
                " map %.0f bytes a particle, sent %.1f bytes a particle and step\n",
                rank, nOwn, times[0]*perStep, times[1]*perStep,
                times[2]*perStep, (times[0] + times[1] + times[2])*perStep,
                scalar(map.bytes())/max(nOwn, label(1)),
                scalar(map.sent() - before)/max(nOwn, label(1))/nSteps
            );
            fflush(stdout);
        }
        label sync = 0;
        reduce(sync, sumOp<label>());
    }

    return 0;
}
