/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Forces of the fluid's motion on one particle: lift, torque, added mass and
// viscous stress, against reference/lift.csv and by hand

#include <cfenv>
#include <gtest/gtest.h>
#include "IStringStream.H"
#include "particleForce.H"
#include "table.H"

using namespace Foam;
using namespace Foam::dew;

namespace
{

const double pi = 3.14159265358979324;

const vector x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);

// Units in the last place of some ten operations, of an exponent up to ten
const double roundOff = 2e-14;


autoPtr<particleForce> law(const std::string& entries)
{
    IStringStream is("type " + entries + ";");
    return particleForce::New(dictionary(is));
}


particle sphere()
{
    particle p;
    p.U = vector(0.25, -0.5, 1);
    p.d = 0.0009765625;
    p.rho = 3000;
    return p;
}


carrier liquid(const particle& p, const vector& slip)
{
    carrier c;
    c.U = p.U + slip;
    c.rho = 1024;
    c.mu = 0.0009765625;
    return c;
}


// d_i U_j of U = W x r
tensor rotation(const vector& W)
{
    return tensor(W ^ x, W ^ y, W ^ z);
}

} // End anonymous namespace


TEST(lift, vorticity)
{
    fluidMotion m;
    const vector W(0.3, -2, 5);

    m.gradU = rotation(W);
    EXPECT_EQ(m.vorticity(), 2*W);

    // U = 3 y along x
    m.gradU = tensor(0, 0, 0, 3, 0, 0, 0, 0, 0);
    EXPECT_EQ(m.vorticity(), -3*z);
}


TEST(lift, againstPapers)
{
    const autoPtr<particleForce> shear(law("SaffmanMei"));
    const autoPtr<particleForce> spin(law("Magnus"));
    const autoPtr<particleForce> torque(law("rotationalTorque"));

    for (const auto& row : readTable("lift.csv"))
    {
        particle p(sphere());
        p.U = Zero;
        carrier c(liquid(p, row[0]*x));

        c.motion.gradU = tensor(0, 0, 0, row[1], 0, 0, 0, 0, 0);
        const vector F(shear->force(p, c).Su);
        EXPECT_NEAR(F.y()/row[3], 1, roundOff) << row[0] << ' ' << row[1];
        EXPECT_EQ(F.x(), 0);
        EXPECT_EQ(F.z(), 0);

        // In a fluid at rest, and as much faster than one that turns
        for (const double Omega : {0.0, 2*row[2]})
        {
            c.motion.gradU = rotation(Omega*z);
            p.omega = (Omega + row[2])*z;

            // W x (v - U) = z x (-x)
            EXPECT_NEAR(spin->force(p, c).Su.y()/-row[4], 1, roundOff)
                << row[0] << ' ' << row[2];

            const forceSuSp M(torque->force(p, c));
            EXPECT_NEAR(M.Tp*row[2]/row[5], 1, roundOff) << row[2];
            EXPECT_EQ(M.Tu, vector::zero);
            EXPECT_EQ(M.Su, vector::zero);
            EXPECT_EQ(M.Sp, 0);
        }
    }
}


// Rubinow and Keller's lift pi/8 rho d^3 W x v and Stokes' torque pi mu d^3
TEST(lift, creepingFlow)
{
    particle p(sphere());
    p.omega = vector(0.3, 0.2, -0.5)*1e-9;
    const vector slip(-2e-12, 1e-12, 3e-12);
    const carrier c(liquid(p, slip));

    const vector v(p.U - c.U);
    const vector theory(pi/8*c.rho*pow3(p.d)*(p.omega ^ v));
    const vector F(law("Magnus")->force(p, c).Su);
    // 0.06 Rer^0.4 Re^0.3: Rer 6e-10, Re 4e-9
    EXPECT_NEAR(mag(F - theory)/mag(theory), 0, 1e-7);

    EXPECT_NEAR
    (
        law("rotationalTorque")->force(p, c).Tp/(pi*c.mu*pow3(p.d)), 1, roundOff
    );
}


// Where a thrown ball and a particle in a pipe go
TEST(lift, directions)
{
    particle p(sphere());
    const autoPtr<particleForce> shear(law("SaffmanMei"));
    const autoPtr<particleForce> spin(law("Magnus"));

    // Topspin: y is up, it flies along x, and its top moves forward
    carrier c(liquid(p, -0.01*x));
    p.omega = -10*z;
    EXPECT_GT((p.omega ^ y) & x, 0);
    EXPECT_LT(spin->force(p, c).Su.y(), 0);
    p.omega = 10*z;
    EXPECT_GT(spin->force(p, c).Su.y(), 0);

    // Faster towards y: one that lags goes there, one that leads to the other
    c = liquid(p, 0.01*x);
    c.motion.gradU = tensor(0, 0, 0, 3, 0, 0, 0, 0, 0);
    EXPECT_GT(shear->force(p, c).Su.y(), 0);
    c.U = p.U - 0.01*x;
    EXPECT_LT(shear->force(p, c).Su.y(), 0);
}


// Without slip, shear or spin: nothing, and nothing OpenFOAM would stop at
TEST(lift, atRest)
{
    for (const char* name : {"SaffmanMei", "Magnus", "rotationalTorque"})
    {
        const autoPtr<particleForce> force(law(name));
        for (int i = 0; i < 3; i++)
        {
            particle p(sphere());
            carrier c(liquid(p, i == 1 ? 0.1*x : vector::zero));
            if (i == 2)
            {
                c.motion.gradU = rotation(3*z);
            }
            std::feclearexcept(FE_ALL_EXCEPT);
            EXPECT_EQ(force->force(p, c).Su, vector::zero) << name;
            EXPECT_FALSE
            (
                std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW)
            )   << name;
        }
    }
}


TEST(virtualMass, halfOfWhatIsDisplaced)
{
    particle p(sphere());
    carrier c(liquid(p, 0.1*x));
    c.motion.DUDt = vector(1, 2, -3);

    const double displaced = 1024*pi/6*std::pow(2.0, -30);
    const std::pair<const char*, double> cases[] =
    {
        {"virtualMass", 0.5}, {"virtualMass; coefficient 0.7", 0.7}
    };
    for (const auto& [entries, Ca] : cases)
    {
        const autoPtr<particleForce> force(law(entries));
        const forceSuSp f(force->force(p, c));
        EXPECT_NEAR(f.addedMass/(Ca*displaced), 1, roundOff);
        EXPECT_EQ(f.Su, f.addedMass*c.motion.DUDt);
        EXPECT_EQ(f.Sp, 0);
        EXPECT_TRUE(force->needs().addedMass && force->needs().DUDt);
    }
}


TEST(viscousStressForce, shareOfTheStress)
{
    particle p(sphere());
    carrier c(liquid(p, 0.1*x));
    c.motion.divTau = vector(1, 2, -3);
    const autoPtr<particleForce> force(law("viscousStressForce"));

    const vector share(pi/6*std::pow(2.0, -30)*c.motion.divTau);
    EXPECT_NEAR(mag(force->force(p, c).Su - share)/mag(share), 0, roundOff);
    EXPECT_EQ(force->reaction(), particleForce::reactions::sharedStress);
    EXPECT_FALSE(force->inModelB());
}


TEST(lift, refused)
{
    for
    (
        const char* name :
        {
            "SaffmanMei", "Magnus", "rotationalTorque", "viscousStressForce",
            "virtualMass"
        }
    )
    {
        EXPECT_ANY_THROW(law(std::string(name) + "; colour red")) << name;
    }
    EXPECT_ANY_THROW(law("virtualMass; coefficient -0.5"));
}
