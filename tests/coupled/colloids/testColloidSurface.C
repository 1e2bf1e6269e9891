/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    testColloidSurface

Description
    Particles under the laws of coupling in a drop whose surface is given, in
    a fluid that is not solved for: for tests. constant/testProperties has

    \verbatim
    U       (1e-3 0 0);     // [m/s]
    T       300;            // [K]
    rho     1000;
    mu      1e-3;
    centre  (0 0 0);        // of the drop at time 0 [m]
    radius  1e-5;           // [m]
    speed   (0 0 0);        // of the drop [m/s]
    \endverbatim

    Lines "particle <id> <x y z> <v>" at the end.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "fvMesh.H"
#include "IFstream.H"
#include "particleEngine.H"
#include "particleExchange.H"
#include "Time.H"
#include "volFields.H"

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    #include "setRootCase.H"
    #include "createTime.H"

    const fvMesh mesh
    (
        IOobject
        (
            fvMesh::defaultRegion,
            runTime.timeName(),
            runTime,
            IOobject::MUST_READ
        )
    );

    IFstream is(runTime.globalPath()/"constant"/"testProperties");
    const dictionary dict(is);

    const auto vectors = [&](const word& name, const dimensionSet& dims)
    {
        return tmp<volVectorField>::New
        (
            IOobject(name, runTime.timeName(), mesh),
            mesh,
            dimensionedVector(name, dims, dict.getOrDefault(name, vector(Zero)))
        );
    };
    const auto scalars = [&](const word& name, const dimensionSet& dims)
    {
        return tmp<volScalarField>::New
        (
            IOobject(name, runTime.timeName(), mesh),
            mesh,
            dimensionedScalar(name, dims, dict.getOrDefault(name, scalar(0)))
        );
    };

    const volVectorField U(vectors("U", dimVelocity));
    const volVectorField gradp(vectors("gradp", dimPressure/dimLength));
    const volScalarField p(scalars("p", dimPressure));
    const volScalarField rho(scalars("rho", dimDensity));
    const volScalarField mu(scalars("mu", dimDynamicViscosity));
    const volScalarField T(scalars("T", dimTemperature));

    const point start(dict.get<point>("centre"));
    const vector speed(dict.getOrDefault("speed", vector(Zero)));
    const scalar radius(dict.get<scalar>("radius"));

    volScalarField psi(scalars("psi", dimLength));
    volVectorField n(vectors("n", dimless));
    volScalarField normalSpeed(scalars("normalSpeed", dimVelocity));
    volScalarField curvature(scalars("curvature", dimless/dimLength));

    dew::carrierFields carrier{U, U, p, gradp, rho, mu};
    carrier.T = &T;
    carrier.psi = &psi;
    carrier.n = &n;
    carrier.surfaceSpeed = &normalSpeed;
    carrier.curvature = &curvature;

    autoPtr<dew::particleEngine> engine(dew::particleEngine::New(mesh));
    dew::particleEngine& particles = engine();
    dew::particleExchange exchange
    (
        mesh, particles.properties(), carrier, particles.state(), vector(Zero)
    );

    while (runTime.run())
    {
        const point centre(start + runTime.value()*speed);
        forAll(psi, celli)
        {
            const vector r(mesh.C()[celli] - centre);
            psi[celli] = radius - mag(r);
            n[celli] = r/mag(r);
            normalSpeed[celli] = speed & n[celli];
            curvature[celli] = 1/radius;
        }

        const dew::bulkForces& forces = exchange.forces();
        ++runTime;
        particles.evolve(forces);
        exchange.correct();
        exchange.report();
    }

    const dew::particleState& s = particles.state();
    Pout.precision(15);
    forAll(s.x, i)
    {
        Pout<< "particle " << s.id[i] << ' ' << s.x[i] << ' ' << s.v[i]
            << endl;
    }

    Info<< "End\n" << endl;

    return 0;
}


// ************************************************************************* //
