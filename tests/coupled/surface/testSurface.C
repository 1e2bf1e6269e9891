/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    testSurface

Description
    The surface of a liquid moves by given losses, without a solver: for tests.
    From constant/testProperties,

    \verbatim
    lost (1e-16 2e-16);         // liquid lost in each step [m3]
    validity (0.07 1000 1e-3 9.81 1e-3);    // sigma rho mu g U, if given
    \endverbatim

    Of each rank, cells<rank>.csv (centre, volume, alpha, its old value, area,
    psi, n, curvature, speed, inLiquid of the centre), faces<rank>.csv (centre,
    area, alphaf), patch faces psi<rank>.csv (centre, psi); of the master,
    steps.csv (time, volume in the mesh, volume, contact radius and angle of the
    drop). crossing.csv has the crossing between centres of neighbours, one in
    the liquid and one outside: both centres, and the fraction.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "fvMesh.H"
#include "quasiStatic.H"
#include "Time.H"

#include <fstream>

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

std::ofstream table(const fileName& path, const char* names)
{
    std::ofstream os(path);
    os.precision(17);
    os << names << '\n';
    return os;
}


std::ostream& operator<<(std::ostream& os, const vector& v)
{
    return os << v.x() << ',' << v.y() << ',' << v.z();
}


int main(int argc, char *argv[])
{
    #include "setRootCase.H"
    #include "createTime.H"
    const fvMesh mesh
    (
        IOobject
        (
            polyMesh::defaultRegion,
            runTime.timeName(),
            runTime,
            IOobject::MUST_READ
        )
    );

    const auto read = [&](const word& name)
    {
        return IOdictionary
        (
            IOobject(name, runTime.constant(), mesh, IOobject::MUST_READ)
        );
    };
    const IOdictionary properties(read("surfaceProperties"));
    const IOdictionary test(read("testProperties"));
    const scalarList lost(test.get<scalarList>("lost"));

    autoPtr<dew::surfaceShape> motionPtr
    (
        dew::surfaceMotion::New<dew::surfaceShape>(mesh, properties)
    );
    dew::surfaceShape& motion = motionPtr();
    const auto shape = [&]() -> dew::surfaceMotions::quasiStatic::shape
    {
        if (isA<dew::surfaceMotions::quasiStatic>(motion))
        {
            return refCast<dew::surfaceMotions::quasiStatic>(motion).drop();
        }
        // Of a film: volume and thickness
        const auto measures = motion.measures();
        return {measures[0].second(), measures[1].second(), 0};
    };

    const fileName root(args.rootPath()/args.globalCaseName());
    const word rank(name(Pstream::myProcNo()));

    std::ofstream steps;
    if (Pstream::master())
    {
        steps = table(root/"steps.csv", "time,held,V,a,theta");
    }
    const auto step = [&]()
    {
        motion.report(Info);
        const scalar held = gSum(motion.alpha().primitiveField()*mesh.V());
        if (Pstream::master())
        {
            const auto drop = shape();
            steps
                << runTime.value() << ',' << held << ',' << drop.V << ','
                << drop.a << ',' << drop.theta << '\n';
        }
    };

    if (test.found("validity"))
    {
        const scalarList v(test.get<scalarList>("validity"));
        motion.checkValidity(v[0], v[1], v[2], v[3], v[4]);
        motion.checkValidity(v[0], v[1], v[2], v[3], v[4]);
    }

    step();
    while (runTime.run())
    {
        ++runTime;
        motion.evolve(lost[runTime.timeIndex() - 1]);
        runTime.write();
        step();
    }

    std::ofstream cells
    (
        table
        (
            root/("cells" + rank + ".csv"),
            "x,y,z,V,alpha,old,area,psi,nx,ny,nz,curvature,speed,inside"
        )
    );
    forAll(mesh.C(), i)
    {
        cells
            << mesh.C()[i] << ',' << mesh.V()[i] << ',' << motion.alpha()[i]
            << ',' << motion.alpha().oldTime()[i] << ',' << motion.area()[i]
            << ',' << motion.psi()[i] << ',' << motion.n()[i] << ','
            << motion.curvature()[i] << ',' << motion.speed()[i] << ','
            << motion.inLiquid(mesh.C()[i]) << '\n';
    }

    std::ofstream faces
    (
        table(root/("faces" + rank + ".csv"), "x,y,z,area,alphaf")
    );
    std::ofstream crossings
    (
        table(root/("crossing" + rank + ".csv"), "x,y,z,u,v,w,t")
    );
    forAll(motion.alphaf(), i)
    {
        faces
            << mesh.Cf()[i] << ',' << mesh.magSf()[i] << ','
            << motion.alphaf()[i] << '\n';

        label own = mesh.owner()[i], nei = mesh.neighbour()[i];
        if (motion.inLiquid(mesh.C()[nei]))
        {
            Swap(own, nei);
        }
        const point& a = mesh.C()[own];
        const point& b = mesh.C()[nei];
        if (motion.inLiquid(a) && !motion.inLiquid(b))
        {
            crossings
                << a << ',' << b << ','
                << motion.crossing(a, motion.psi()[own], b, motion.psi()[nei])
                << '\n';
        }
    }
    std::ofstream patches
    (
        table(root/("psi" + rank + ".csv"), "x,y,z,psi")
    );
    forAll(mesh.boundary(), patchi)
    {
        forAll(mesh.boundary()[patchi], i)
        {
            const point& x = mesh.Cf().boundaryField()[patchi][i];
            faces
                << x << ',' << mesh.magSf().boundaryField()[patchi][i] << ','
                << motion.alphaf().boundaryField()[patchi][i] << '\n';
            if (!mesh.boundary()[patchi].coupled())
            {
                patches
                    << x << ',' << motion.psi().boundaryField()[patchi][i]
                    << '\n';
            }
        }
    }

    Info<< "End\n" << endl;

    return 0;
}


// ************************************************************************* //
