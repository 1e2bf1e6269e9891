/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    frozenFlow

Description
    Moves the liquid alpha.<liquid> of a case through a given flow, with the
    reconstruction of constant/surfaceProperties and planeAdvection, by
    constant/frozenFlow

    \verbatim
    flow    { type vortex; length 1; speed 1; period 8; }
    maxAlphaCo  0.5;      // optional: steps by the Courant number of the surface
    maxDeltaT   0.05;     // and no longer than this
    solids  { depth 0.4; width 0.1; centre 0.5; speed 1; length 1; }  // optional
    \endverbatim

    The velocity is that of the middle of each step. The last line of the log
    has: steps, volume at start and end, lowest share and highest less one of
    all steps, volume moved into bounds, largest error of the shares that a cut
    leaves, seconds of the advection and of the reconstruction.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "cellCut.H"
#include "cpuTime.H"
#include "contactAngles.H"
#include "flows.H"
#include "fvMesh.H"
#include "IOdictionary.H"
#include "planeAdvection.H"
#include "reconstruction.H"
#include "Time.H"

using namespace Foam;
using namespace Foam::dew;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

IOdictionary constantDict(const fvMesh& mesh, const word& name)
{
    return IOdictionary
    (
        IOobject
        (
            name, mesh.time().constant(), mesh, IOobject::MUST_READ,
            IOobject::NO_WRITE, false
        )
    );
}


//- Flux of the potential around a face
scalar flux(const closedFlow& flow, const face& f, const pointField& points)
{
    scalar sum = 0;
    forAll(f, i)
    {
        const point& a = points[f[i]];
        const point& b = points[f.nextLabel(i)];
        sum += flow.potential(0.5*(a + b)) & (b - a);
    }
    return sum;
}


void setFlow
(
    const closedFlow& flow,
    surfaceScalarField& phi,
    volVectorField& U
)
{
    const fvMesh& mesh = U.mesh();
    forAll(phi, facei)
    {
        phi[facei] = flux(flow, mesh.faces()[facei], mesh.points());
    }
    forAll(U, celli)
    {
        U[celli] = flow.velocity(mesh.C()[celli]);
    }
    forAll(mesh.boundary(), patchi)
    {
        const polyPatch& patch = mesh.boundaryMesh()[patchi];
        scalarField& phib = phi.boundaryFieldRef()[patchi];
        vectorField& Ub = U.boundaryFieldRef()[patchi];
        forAll(phib, i)
        {
            phib[i] =
                patch.type() == "wedge"
              ? 0 : flux(flow, patch[i], mesh.points());
            Ub[i] = flow.velocity(patch.faceCentres()[i]);
        }
    }
    U.correctBoundaryConditions();
}


//- Share of the fluids of each cell of a mesh of boxes
void setShare
(
    const movingLayer& layer, const scalar t, volScalarField& alphac
)
{
    const fvMesh& mesh = alphac.mesh();
    scalarField& share = alphac.primitiveFieldRef();
    forAll(share, celli)
    {
        const boundBox box(mesh.points(), mesh.cellPoints(celli), false);
        const scalar a = box.min().x(), b = box.max().x();
        share[celli] = 1 - (layer.below(b, t) - layer.below(a, t))/(b - a);
    }
    alphac.correctBoundaryConditions();
}


//- The flux of all less that of the solids, mean of a step
void takeSolids
(
    const movingLayer& layer, const scalar t, const scalar dt,
    const volScalarField& alphac,
    surfaceScalarField& phi, volVectorField& U
)
{
    const fvMesh& mesh = U.mesh();
    const auto mean = [&](const point& x)
    {
        return (layer.below(x.x(), t) - layer.below(x.x(), t + dt))/dt;
    };
    forAll(phi, facei)
    {
        phi[facei] -= mesh.Sf()[facei].x()*mean(mesh.Cf()[facei]);
    }
    forAll(mesh.boundary(), patchi)
    {
        scalarField& phib = phi.boundaryFieldRef()[patchi];
        forAll(phib, i)
        {
            phib[i] -=
                mesh.boundary()[patchi].Sf()[i].x()
               *mean(mesh.boundary()[patchi].Cf()[i]);
        }
    }
    forAll(U, celli)
    {
        const scalar solids = 1 - alphac[celli];
        U[celli].x() =
            (U[celli].x() - solids*layer.speed())/alphac[celli];
    }
    U.correctBoundaryConditions();
}

//- Half the sum of the fluxes of the crossed cells over their volume [1/s]
scalar surfaceRate(const interfacePlanes& planes, const surfaceScalarField& phi)
{
    const fvMesh& mesh = phi.mesh();
    scalar highest = 0;
    for (const label celli : planes.cell())
    {
        scalar sum = 0;
        for (const label facei : mesh.cells()[celli])
        {
            if (mesh.isInternalFace(facei))
            {
                sum += mag(phi[facei]);
            }
        }
        highest = max(highest, 0.5*sum/mesh.V()[celli]);
    }
    return returnReduce(highest, maxOp<scalar>());
}

} // End anonymous namespace


// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

int main(int argc, char *argv[])
{
    argList::noBanner();

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

    const IOdictionary properties(constantDict(mesh, "surfaceProperties"));
    const IOdictionary flowDict(constantDict(mesh, "frozenFlow"));
    const closedFlow flow(flowDict.subDict("flow"));
    autoPtr<movingLayer> layer;
    if (flowDict.found("solids"))
    {
        layer.reset(new movingLayer(flowDict.subDict("solids")));
    }

    volScalarField alpha
    (
        IOobject
        (
            "alpha." + properties.get<word>("liquid"), runTime.timeName(), mesh,
            IOobject::MUST_READ, IOobject::AUTO_WRITE
        ),
        mesh
    );
    volScalarField alphac
    (
        IOobject("alphac", runTime.timeName(), mesh),
        mesh,
        dimensionedScalar("one", dimless, 1),
        alpha.boundaryField().types()
    );
    volVectorField U
    (
        IOobject("U", runTime.timeName(), mesh, IOobject::MUST_READ), mesh
    );
    surfaceScalarField phi
    (
        IOobject("phi", runTime.timeName(), mesh), mesh,
        dimensionedScalar(dimVolume/dimTime, Zero)
    );
    surfaceScalarField alphaPhi("alphaPhi", phi);
    phi.setOriented();

    const contactAngles angles(mesh, properties);
    autoPtr<reconstruction> planes
    (
        reconstruction::New(mesh, angles, properties)
    );
    planeAdvection advection(mesh);

    if (layer)
    {
        setShare(*layer, 0, alphac);
    }
    setFlow(flow, phi, U);
    const surfaceScalarField phi0("phi0", phi);
    const volVectorField U0("U0", U);

    const auto volume = [&]()
    {
        return gSum(alpha.primitiveField()*alphac.primitiveField()*mesh.V());
    };
    const scalar start = volume();
    scalar low = GREAT, high = -GREAT, error = 0;
    double tAdvect = 0, tPlanes = 0;
    label steps = 0;

    cellCut cut(mesh);
    alpha.oldTime();
    alphac.oldTime();
    planes->correct(alpha);
    const scalar maxAlphaCo = flowDict.getOrDefault<scalar>("maxAlphaCo", 0);
    while (runTime.run())
    {
        if (maxAlphaCo > 0)
        {
            const scalar rate =
                surfaceRate(planes->planes(), phi0)
               *mag(flow.factor(runTime.value()));
            runTime.setDeltaT
            (
                min
                (
                    min(maxAlphaCo/max(rate, VSMALL), 1.2*runTime.deltaTValue()),
                    min
                    (
                        flowDict.get<scalar>("maxDeltaT"),
                        runTime.endTime().value() - runTime.value()
                    )
                )
            );
        }
        ++runTime;
        const scalar dt = runTime.deltaTValue();
        const scalar t = runTime.value() - dt;

        phi = phi0*flow.factor(t + 0.5*dt);
        U = U0*flow.factor(t + 0.5*dt);
        if (layer)
        {
            setShare(*layer, t + dt, alphac);
            takeSolids(*layer, t, dt, alphac, phi, U);
        }

        cpuTime clock;
        advection.advect(alpha, alphaPhi, planes->planes(), phi, U, alphac);
        tAdvect += clock.cpuTimeIncrement();
        planes->correct(alpha);
        tPlanes += clock.cpuTimeIncrement();

        low = min(low, gMin(alpha.primitiveField()));
        high = max(high, gMax(alpha.primitiveField()) - 1);
        steps++;
        runTime.write();
    }
    alpha.write();

    forAll(planes->planes().cell(), i)
    {
        const label celli = planes->planes().cell()[i];
        cut.set(celli);
        error = max
        (
            error,
            mag
            (
                cut.share(planes->planes().x()[i], planes->planes().n()[i])
              - alpha[celli]
            )
        );
    }

    Info<< "result " << steps << ' ' << start << ' ' << volume() << ' ' << low
        << ' ' << high << ' '
        << returnReduce(advection.moved(), sumOp<scalar>()) << ' '
        << returnReduce(error, maxOp<scalar>()) << ' ' << tAdvect << ' '
        << tPlanes << endl;
    return 0;
}
