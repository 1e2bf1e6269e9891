/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Forces on one particle against numbers of the papers: reference/forces.csv
// and slip.csv (their scripts take the laws of beds per volume of bed),
// pressure drop of a bed, terminal velocities and Archimedes

#include <cfenv>
#include <gtest/gtest.h>
#include "IStringStream.H"
#include "particleForce.H"
#include "table.H"

using namespace Foam;
using namespace Foam::dew;

namespace
{

// In the order of the columns of forces.csv
const char* const dragLaws[] =
{
    "Stokes", "SchillerNaumann", "DiFelice", "WenYu", "Ergun", "Gidaspow",
    "KochHill", "Beetstra", "Tenneti", "Darcy", "Dallavalle", "HaiderLevenspiel"
};
const int nLaws = 12;

// A few units in the last place of each of some ten operations
const double roundOff = 1e-14;


autoPtr<particleForce> law(const std::string& entries)
{
    IStringStream is("type " + entries + ";");
    return particleForce::New(dictionary(is));
}


particle sphere(const double d)
{
    particle p;
    p.U = vector(0, -0.2, 0.3);
    p.d = d;
    p.rho = 3000;
    return p;
}


// Flow past a particle. The slip is exact, so that Re can be on a branch point
carrier flow
(
    const particle& p,
    const double slip,
    const double rho,
    const double mu,
    const double eps
)
{
    carrier c;
    c.U = p.U + vector(slip, 0, 0);
    c.alphac = eps;
    c.rho = rho;
    c.mu = mu;
    return c;
}


double Sp
(
    const particleForce& force,
    const double d,
    const double slip,
    const double rho,
    const double mu,
    const double eps
)
{
    const particle p(sphere(d));
    const forceSuSp f(force.force(p, flow(p, slip, rho, mu, eps)));

    EXPECT_EQ(f.Su, vector::zero);
    return f.Sp;
}


// Velocity at which drag balances weight less buoyancy
double terminalVelocity
(
    const particleForce& force,
    const double d,
    const double rhop,
    const double rho,
    const double mu
)
{
    const double weight = (rhop - rho)*9.81*sphere(d).volume();

    double u = 1e-6;
    for (int i = 0; i < 200; ++i)
    {
        u = 0.5*(u + weight/Sp(force, d, u, rho, mu, 1));
    }
    return u;
}

} // End anonymous namespace


TEST(forces, dragAgainstPapers)
{
    for (int i = 0; i < nLaws; ++i)
    {
        const autoPtr<particleForce> force(law(dragLaws[i]));

        EXPECT_EQ(force->reaction(), particleForce::reactions::fluid);
        EXPECT_EQ(force->convention(), particleForce::conventions::A);

        for (const auto& row : readTable("forces.csv"))
        {
            const double eps = row[0], d = row[1], rho = row[2], mu = row[3];
            const double slip = row[4];

            // Equal to zero where that is the limit
            EXPECT_NEAR
            (
                Sp(*force, d, slip, rho, mu, eps)*slip, row[5 + i],
                roundOff*row[5 + i]
            )   << dragLaws[i] << " eps " << eps << " slip " << slip;
        }
    }
}


TEST(forces, slipOfRarefiedGas)
{
    const autoPtr<particleForce> slip(law("Stokes; meanFreePath 6.6e-8"));
    const autoPtr<particleForce> same
    (
        law("StokesCunningham; meanFreePath 6.6e-8")
    );
    const autoPtr<particleForce> none(law("Stokes; meanFreePath 0"));

    for (const auto& row : readTable("slip.csv"))
    {
        const double without = Sp(*none, row[0], 1e-3, 1.2, 1.8e-5, 1);

        EXPECT_NEAR
        (
            without/Sp(*slip, row[0], 1e-3, 1.2, 1.8e-5, 1)/row[2], 1, roundOff
        )   << "d " << row[0];
        EXPECT_EQ
        (
            Sp(*slip, row[0], 1e-3, 1.2, 1.8e-5, 1),
            Sp(*same, row[0], 1e-3, 1.2, 1.8e-5, 1)
        );
    }
}


// Creeping flow past a single sphere: Stokes' drag, of Dallavalle's curve
// 4.8^2/24 of it
TEST(forces, creepingFlow)
{
    const double stokes = 3*3.14159265358979324*1e-3*1e-4;
    const std::pair<const char*, double> limits[] =
    {
        {"Stokes", 1}, {"SchillerNaumann", 1}, {"WenYu", 1}, {"Gidaspow", 1},
        {"DiFelice", 0.96}, {"KochHill", 1}, {"Beetstra", 1}, {"Tenneti", 1},
        {"Dallavalle", 0.96}, {"HaiderLevenspiel", 1}
    };

    for (const auto& [name, limit] : limits)
    {
        // Re 1e-10: 0.15 Re^0.687 is 2e-8, 2*0.63/4.8 Re^0.5 is 2.6e-6
        const double value = Sp(*law(name), 1e-4, 1e-12, 1000, 1e-3, 1);

        EXPECT_NEAR(value/stokes/limit, 1, 3e-6) << name;
    }
}


// At rest, also without particles around: the limit, and no operation that
// OpenFOAM would stop at
TEST(forces, atRest)
{
    const double stokes = 3*3.14159265358979324*1e-3*1e-4;

    for (const double eps : {1.0, 0.8, 0.799, 0.4})
    {
        const double WenYu = std::pow(eps, -2.65);
        const double Ergun = 150.0/18*(1 - eps)/eps;
        const double phi = 1 - eps;
        const double KochHill =
            phi >= 0.4 ? 10*phi/(eps*eps*eps)
          : phi > 0
          ? (
                1 + 3*std::sqrt(phi/2) + 135.0/64*phi*std::log(phi)
              + 16.14*phi
            )
           /(1 + 0.681*phi - 8.48*phi*phi + 8.16*phi*phi*phi)
          : 1;

        // Over Stokes' drag, in the order of dragLaws
        const double limits[] =
        {
            1, 1, 4.8*4.8/24*std::pow(eps, -2.7), WenYu, Ergun,
            eps < 0.8 ? Ergun : WenYu, eps*eps*KochHill,
            10*phi/eps + eps*eps*eps*(1 + 1.5*std::sqrt(phi)),
            (1 + 5.81*phi)/eps + 0.48*std::cbrt(phi)/(eps*eps),
            10*phi/eps, 4.8*4.8/24, 1
        };

        for (int i = 0; i < nLaws; ++i)
        {
            const autoPtr<particleForce> force(law(dragLaws[i]));

            std::feclearexcept(FE_ALL_EXCEPT);
            const double value = Sp(*force, 1e-4, 0, 1000, 1e-3, eps)/stokes;

            EXPECT_FALSE
            (
                std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW)
            )   << dragLaws[i] << " eps " << eps;
            EXPECT_NEAR(value, limits[i], roundOff*(1 + limits[i]))
                << dragLaws[i] << " eps " << eps;
        }
    }
}


// Sphere of 0.1 mm and 3000 kg/m3 in a fluid of 10 kg/m3 and 1e-4 Pa s: root of
// Cd pi/8 d^2 rho u^2 = weight less buoyancy, computed apart; five digits given
TEST(forces, terminalVelocity)
{
    const double d = 1e-4, rhop = 3000, rho = 10, mu = 1e-4;

    EXPECT_NEAR
    (
        terminalVelocity(*law("SchillerNaumann"), d, rhop, rho, mu),
        0.13734, 5e-6
    );
    EXPECT_NEAR
    (
        terminalVelocity(*law("DiFelice"), d, rhop, rho, mu), 0.12861, 5e-6
    );

    // (rho_p - rho) g d^2/(18 mu)
    EXPECT_NEAR
    (
        terminalVelocity(*law("Stokes"), d, rhop, rho, mu)/0.1629550, 1, 1e-9
    );
}


// Fluid through a packed bed of length 0.0156 m: the drag of the particles in
// a volume is eps times Ergun's pressure gradient; two decimals given
TEST(forces, pressureDropOfBed)
{
    const double d = 1e-3, mu = 1.5e-3, rho = 10, e = 0.451335, L = 0.0156;
    const double n = (1 - e)/sphere(d).volume();

    // Superficial velocity, pressure drop
    const std::pair<double, double> cases[] = {{0.002, 22.99}, {0.01, 115.09}};

    for (const auto& [U, dp] : cases)
    {
        for (const char* name : {"Ergun", "Gidaspow"})
        {
            const double u = U/e;
            const double drop = n*Sp(*law(name), d, u, rho, mu, e)*u/e*L;

            EXPECT_NEAR(drop, dp, 0.005) << name;

            const double ergun =
                L*(1 - e)/(e*e*e)
               *(150*(1 - e)*mu*U/(d*d) + 1.75*rho*U*U/d);
            EXPECT_NEAR(drop/ergun, 1, roundOff) << name;
        }
    }
}


// Cd of a single sphere, five digits, computed apart
TEST(forces, HaiderLevenspielCurve)
{
    const std::pair<double, double> curve[] =
    {
        {0.01, 2422.1}, {0.1, 249.80}, {1, 28.334}, {10, 4.3185},
        {100, 1.0947}, {1e3, 0.45346}, {1e4, 0.42038}, {1e5, 0.47150}
    };
    const autoPtr<particleForce> force(law("HaiderLevenspiel"));

    // Of unit density and viscosity and d 1: slip is Re, F = Cd pi/8 Re^2
    for (const auto& [Re, Cd] : curve)
    {
        const double F = Sp(*force, 1, Re, 1, 1, 0.7)*Re;
        EXPECT_NEAR(F*8/3.14159265358979324/(Re*Re)/Cd, 1, 5e-5) << Re;
    }
}


// Before and after solid fraction 0.4 at rest, by hand: F0 18.33 and 18.52
TEST(forces, KochHillJump)
{
    const double stokes = 3*3.14159265358979324*1e-3*1e-4;
    const autoPtr<particleForce> force(law("KochHill"));

    for (const auto& [eps, F0] : {std::pair(0.600001, 18.33), {0.6, 18.52}})
    {
        EXPECT_NEAR
        (
            Sp(*force, 1e-4, 0, 1000, 1e-3, eps)/stokes/(eps*eps), F0, 0.005
        );
    }
}


// Carman's pressure gradient, 180 mu (1 - eps)^2 U/(d^2 eps^3), of Darcy, and of
// KochHill where dense; Tenneti's and Beetstra's fits are within 10 % of it
TEST(forces, denseCreepingFlow)
{
    const double d = 1e-4, mu = 1e-3, u = 1e-9;
    const std::pair<const char*, double> laws[] =
    {
        {"Darcy", 1e-12}, {"KochHill", 1e-6}, {"Beetstra", 0.1}, {"Tenneti", 0.1}
    };

    for (const auto& [name, tolerance] : laws)
    {
        for (const double eps : {0.5, 0.6})
        {
            const double n = (1 - eps)/sphere(d).volume();
            const double gradient =
                180*mu*(1 - eps)*(1 - eps)*eps*u/(d*d*eps*eps*eps);

            // The drag of model A is eps times the gradient
            EXPECT_NEAR
            (
                n*Sp(*law(name), d, u, 1000, mu, eps)*u/(eps*gradient), 1,
                tolerance
            )   << name << " eps " << eps;
        }
    }
}


// A body loses the weight of the fluid it displaces
TEST(forces, Archimedes)
{
    const particle p(sphere(0.01));
    carrier c(flow(p, 0.4, 850, 0.1, 0.6));
    c.g = vector(0, 0, -9.81);

    // 0.5235987755982989 cm3 of 850 kg/m3
    const double mass = 4.450589592585541e-4;
    const double buoyancy = 9.81*mass;

    const autoPtr<particleForce> force(law("pressureGradientForce"));
    EXPECT_EQ(force->reaction(), particleForce::reactions::sharedPressure);
    EXPECT_EQ(force->convention(), particleForce::conventions::both);

    const forceSuSp atRest(force->force(p, c));
    EXPECT_NEAR(atRest.Su.z()/buoyancy, 1, roundOff);
    EXPECT_EQ(atRest.Su.x(), 0);
    EXPECT_EQ(atRest.Su.y(), 0);
    EXPECT_EQ(atRest.Sp, 0);

    // A fluid that falls freely carries no weight: gradp = -rho g
    c.gradp = -c.rho*c.g;
    EXPECT_EQ(force->force(p, c).Su, vector::zero);

    // A particle of the fluid's density goes with a fluid accelerated by a:
    // gradp = -rho a, F = m a
    const vector a(1, 2, -3);
    c.g = Zero;
    c.gradp = -c.rho*a;
    EXPECT_NEAR(mag(force->force(p, c).Su/mass - a), 0, 10*roundOff);

    // Without buoyancy only gradp is left
    const autoPtr<particleForce> noWeight
    (
        law("pressureGradientForce; buoyancy off")
    );
    const vector gradpOnly(force->force(p, c).Su);
    c.g = vector(0, 0, -9.81);
    EXPECT_EQ(noWeight->force(p, c).Su, gradpOnly);
}


TEST(forces, refused)
{
    for (const char* name : dragLaws)
    {
        EXPECT_ANY_THROW(law(std::string(name) + "; colour red")) << name;
    }
    EXPECT_ANY_THROW(law("Stokes; meanFreePath -1e-8"));
    EXPECT_ANY_THROW(law("Stokes; meanFreePath [0 0 1 0 0 0 0] 1e-8"));
    EXPECT_ANY_THROW(law("StokesCunningham"));
    EXPECT_ANY_THROW(law("StokesCunningham; meanFreePath 0"));
    EXPECT_ANY_THROW(law("pressureGradientForce; colour red"));
    EXPECT_ANY_THROW(law("pressureGradientForce; buoyancy heavy"));
    EXPECT_ANY_THROW(law("StokesDrag"));
}
