/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Application
    testEngine

Description
    A particle engine under given bulk forces, without a fluid: for tests. The
    forces come from constant/testProperties,

    \verbatim
    Sp      1e-9;           // [N s/m]
    U       (1 0 0);        // [m/s], at the origin
    gradU   (0 0 0  0 0 0  0 0 0);  // U(x) = U + (x & gradU)
    Su      (0 0 0);        // [N]
    Tp      0;              // [N m s]
    Omega   (0 0 0);
    Tu      (0 0 0);
    Qp      0;              // [W/K]
    Tf      300;
    Qu      0;
    nSteps  1;              // time steps
    poison  -1;             // step at which Su becomes NaN
    \endverbatim

    and every time step is written to <time>/engine.csv: the state, and what
    each particle received.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "particleEngine.H"
#include "polyMesh.H"
#include "tensor.H"
#include "Time.H"

#include <fstream>
#include <limits>

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

void write(const Time& time, const dew::particleState& s)
{
    const fileName path(time.globalPath()/time.timeName()/"engine.csv");

    for (label rank = 0; rank < Pstream::nProcs(); rank++)
    {
        if (rank == Pstream::myProcNo())
        {
            mkDir(path.path());
            std::ofstream os(path, rank ? std::ios::app : std::ios::trunc);
            os.precision(17);
            if (rank == 0)
            {
                os << "id,x,y,z,vx,vy,vz,wx,wy,wz,d,rho,T,"
                    << "jx,jy,jz,lx,ly,lz,q\n";
            }

            const auto put = [&os](const vector& v)
            {
                os << ',' << v.x() << ',' << v.y() << ',' << v.z();
            };

            for (label i = 0; i < s.size(); i++)
            {
                os << s.id[i];
                put(s.x[i]);
                put(s.v[i]);
                put(s.omega[i]);
                os << ',' << s.d[i] << ',' << s.rho[i] << ','
                    << (s.thermal ? s.T[i] : 0);
                put(s.impulse[i]);
                put(s.angularImpulse[i]);
                os << ',' << (s.thermal ? s.heat[i] : 0) << '\n';
            }
        }
        label turn = rank;
        reduce(turn, maxOp<label>());
    }
}


int main(int argc, char *argv[])
{
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createPolyMesh.H"

    IFstream is(runTime.globalPath()/"constant"/"testProperties");
    const dictionary dict(is);
    const label poison = dict.getOrDefault<label>("poison", -1);

    autoPtr<dew::particleEngine> engine(dew::particleEngine::New(mesh));
    dew::particleEngine& particles = engine();

    while (runTime.run())
    {
        const dew::particleState& s = particles.state();
        const label n = s.size();
        dew::bulkForces b;

        const auto fill = [&](const word& key, auto& array, const auto& zero)
        {
            typedef typename std::decay<decltype(zero)>::type Type;
            if (dict.found(key))
            {
                array.setSize(n);
                array = dict.get<Type>(key);
            }
        };

        fill("Sp", b.Sp, scalar(0));
        fill("U", b.U, vector(Zero));
        fill("Su", b.Su, vector(Zero));
        fill("Tp", b.Tp, scalar(0));
        fill("Omega", b.Omega, vector(Zero));
        fill("Tu", b.Tu, vector(Zero));
        fill("Qp", b.Qp, scalar(0));
        fill("Tf", b.Tf, scalar(0));
        fill("Qu", b.Qu, scalar(0));

        if (dict.found("gradU"))
        {
            const tensor gradU(dict.get<tensor>("gradU"));
            for (label i = 0; i < n; i++)
            {
                b.U[i] += s.x[i] & gradU;
            }
        }

        ++runTime;

        if (runTime.timeIndex() == poison && n)
        {
            b.Su.setSize(n);
            b.Su[0].x() = std::numeric_limits<scalar>::quiet_NaN();
        }

        particles.evolve(b);
        write(runTime, particles.state());
        runTime.write();

        const dew::particleEngine::ledger& l = particles.balance();
        Info<< "Time = " << runTime.timeName() << " particles "
            << l.particles << " sub-steps " << l.subSteps
            << " impulse " << l.impulse << " heat " << l.heat << endl;
    }

    Info<< "End\n" << endl;

    return 0;
}


// ************************************************************************* //
