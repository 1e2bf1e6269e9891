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
    Sn      (0 0 0);
    kick    (0 0 0);        // [N s], in every time step
    heatKick 0;             // [J], likewise
    kT      4e-21;          // [J]
    addedMass 0;            // [kg]
    surfaceX (0 0 0);       // at time 0, moves with surfaceSpeed surfaceN
    surfaceN (1 0 0);
    surfaceSpeed 0;         // [m/s]
    surfaceCurvature 0;     // [1/m]
    surfaceK 1e-3;          // [N/m]
    poison  -1;             // step at which an array becomes NaN:
    poisoned Su;            // Su, Sn, kick or heatKick
    recordWrite file;       // at the start: a particleRecord of x and d
    recordRead  file;       // at the start: is it the present x and d?
    \endverbatim

    and every time step is written to <time>/engine.csv: the state, and what
    each particle received.
\*---------------------------------------------------------------------------*/

#include "argList.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "particleEngine.H"
#include "particleRecord.H"
#include "polyMesh.H"
#include "tensor.H"
#include "Time.H"

#include <fstream>
#include <limits>
#include <sstream>

using namespace Foam;

// * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * * //

std::string digits(const scalar x)
{
    std::ostringstream os;
    os.precision(17);
    os << x;
    return os.str();
}


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
                    << "jx,jy,jz,lx,ly,lz,q,jsp,qsp\n";
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
                os << ',' << (s.thermal ? s.heat[i] : 0)
                    << ',' << s.impulseSp[i]
                    << ',' << (s.thermal ? s.heatSp[i] : 0) << '\n';
            }
        }
        label turn = rank;
        reduce(turn, maxOp<label>());
    }
}


//- Particle records, for as many values as make use of all components
void records(const dictionary& dict, const dew::particleState& s)
{
    const label nComponents = 4;
    List<scalar> now(nComponents*s.size());
    forAll(s.x, i)
    {
        for (direction k = 0; k < 3; k++)
        {
            now[nComponents*i + k] = s.x[i][k];
        }
        now[nComponents*i + 3] = s.d[i];
    }

    fileName file;
    if (dict.readIfPresent("recordWrite", file))
    {
        dew::particleRecord::write(file, s.id, now, nComponents);
    }
    if (dict.readIfPresent("recordRead", file))
    {
        boolList found;
        const List<scalar> then
        (
            dew::particleRecord::read(file, s.id, nComponents, found)
        );
        label nFound = 0, nSame = 0;
        forAll(found, i)
        {
            bool same = true;
            for (label k = 0; k < nComponents; k++)
            {
                same = same
                 && now[nComponents*i + k] == then[nComponents*i + k];
            }
            nFound += found[i];
            nSame += same;
        }
        reduce(nFound, sumOp<label>());
        reduce(nSame, sumOp<label>());
        Info<< "Record: found " << nFound << " same " << nSame << endl;
    }
}


int main(int argc, char *argv[])
{
    #include "setRootCase.H"
    #include "createTime.H"
    #include "createPolyMesh.H"

    IFstream is(runTime.globalPath()/"constant"/"testProperties");
    const dictionary dict(is);
    Sout.precision(15);
    const label poison = dict.getOrDefault<label>("poison", -1);

    autoPtr<dew::particleEngine> engine(dew::particleEngine::New(mesh));
    dew::particleEngine& particles = engine();

    Info<< "Stable sub-step " << particles.stableDeltaT() << endl;
    records(dict, particles.state());

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
        fill("Sn", b.Sn, vector(Zero));
        fill("kick", b.kick, vector(Zero));
        fill("heatKick", b.heatKick, scalar(0));
        fill("Tp", b.Tp, scalar(0));
        fill("Omega", b.Omega, vector(Zero));
        fill("Tu", b.Tu, vector(Zero));
        fill("Qp", b.Qp, scalar(0));
        fill("Tf", b.Tf, scalar(0));
        fill("Qu", b.Qu, scalar(0));
        fill("kT", b.kT, scalar(0));
        fill("addedMass", b.addedMass, scalar(0));
        fill("surfaceX", b.surfaceX, vector(Zero));
        fill("surfaceN", b.surfaceN, vector(Zero));
        fill("surfaceSpeed", b.surfaceSpeed, scalar(0));
        fill("surfaceCurvature", b.surfaceCurvature, scalar(0));
        fill("surfaceK", b.surfaceK, scalar(0));
        fill("surfaceTension", b.surfaceTension, scalar(0));
        fill("contactAngle", b.contactAngle, scalar(0));
        fill("planePull", b.planePull, scalar(0));

        for (label i = 0; i < b.surfaceX.size(); i++)
        {
            b.surfaceX[i] +=
                runTime.value()*b.surfaceSpeed[i]*b.surfaceN[i];
        }

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
            const word what(dict.getOrDefault<word>("poisoned", "Su"));
            const scalar bad = std::numeric_limits<scalar>::quiet_NaN();

            if (what == "heatKick")
            {
                b.heatKick.setSize(n);
                b.heatKick = Zero;
                b.heatKick[0] = bad;
            }
            else
            {
                DynamicList<vector>& array =
                    what == "Sn" ? b.Sn : what == "kick" ? b.kick : b.Su;
                array.setSize(n);
                array = Zero;
                array[0].x() = bad;
            }
        }

        particles.evolve(b);
        write(runTime, particles.state());
        runTime.write();

        const dew::particleEngine::ledger& l = particles.balance();
        Info<< "Time = " << runTime.timeName() << " particles "
            << l.particles << " sub-steps " << l.subSteps
            << " impulse " << l.impulse << " heat " << l.heat
            << " walls " << l.wallHeat
            << " energies " << digits(l.kineticEnergy).c_str() << ' '
            << digits(l.colloidEnergy).c_str()
            << " departed " << l.departed << ' ' << l.departedMass << ' '
            << l.departedVolume << ' ' << l.departedImpulse << ' '
            << l.departedHeat << endl;
    }

    Info<< "End\n" << endl;

    return 0;
}


// ************************************************************************* //
