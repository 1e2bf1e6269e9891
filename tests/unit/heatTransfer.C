/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Nusselt numbers against those of the papers (reference/heatTransfer.csv)
// and against two numbers published for cases

#include <cfenv>
#include <gtest/gtest.h>
#include "IStringStream.H"
#include "heatTransferModel.H"
#include "table.H"

using namespace Foam;
using namespace Foam::dew;

namespace
{

autoPtr<heatTransferModel> law(const std::string& entries)
{
    IStringStream is("type " + entries + ";");
    return heatTransferModel::New(dictionary(is));
}

} // End anonymous namespace


TEST(heatTransfer, NusseltAgainstPapers)
{
    const autoPtr<heatTransferModel> RanzMarshall(law("RanzMarshall"));
    const autoPtr<heatTransferModel> LiMason(law("LiMason"));
    const autoPtr<heatTransferModel> Gunn(law("Gunn"));
    const autoPtr<heatTransferModel> AcrivosTaylor(law("AcrivosTaylor"));

    for (const auto& row : readTable("heatTransfer.csv"))
    {
        const double Re = row[0], Pr = row[1], eps = row[2];

        // A few units in the last place of each operation
        EXPECT_NEAR(RanzMarshall->Nu(Re, Pr, eps)/row[3], 1, 5e-15)
            << "Re " << Re << " Pr " << Pr;
        EXPECT_NEAR(LiMason->Nu(Re, Pr, eps)/row[4], 1, 5e-15)
            << "Re " << Re << " Pr " << Pr << " eps " << eps;
        EXPECT_NEAR(Gunn->Nu(Re, Pr, eps)/row[5], 1, 5e-15)
            << "Re " << Re << " Pr " << Pr << " eps " << eps;
        EXPECT_NEAR(AcrivosTaylor->Nu(Re, Pr, eps)/row[6], 1, 5e-15)
            << "Re " << Re << " Pr " << Pr;
    }
}


TEST(heatTransfer, publishedNumbers)
{
    // Computed with Pr^0.33: 5.334 of it
    EXPECT_NEAR
    (
        2 + (law("RanzMarshall")->Nu(100, 0.7, 1) - 2)
       *std::pow(0.7, 0.33 - 1.0/3), 7.334, 0.0005
    );
    EXPECT_NEAR(law("AcrivosTaylor")->Nu(0.01, 1, 0.5), 2.00489, 5e-6);
    EXPECT_NEAR(law("AcrivosTaylor")->Nu(0.2, 0.5, 1), 2.04444, 5e-6);
    EXPECT_NEAR(law("AcrivosTaylor")->Nu(0.05, 10, 1), 2.20977, 5e-6);

    EXPECT_NEAR(law("RanzMarshall")->Nu(1384, 0.7165, 1), 21.97, 0.005);

    // 2.815 was computed with Pr^0.33; its digits, and those of Re, Pr and
    // eps, allow 0.0005 + 0.0006 + 0.0002 + 0.0003
    const double third = law("LiMason")->Nu(33.1, 70.1, 0.4436);
    EXPECT_NEAR
    (
        2 + (third - 2)*std::pow(70.1, 0.33 - 1.0/3), 2.815, 0.0016
    );
}


// Before and after the branch points, at Pr 1.72 and eps 1: by hand
TEST(heatTransfer, LiMasonJumps)
{
    const autoPtr<heatTransferModel> LiMason(law("LiMason"));

    EXPECT_NEAR(LiMason->Nu(200, 1.72, 1), 12.17, 0.005);
    EXPECT_NEAR(LiMason->Nu(200.001, 1.72, 1), 12.13, 0.005);
    EXPECT_NEAR(LiMason->Nu(1500, 1.72, 1), 33.5, 0.05);
    EXPECT_NEAR(LiMason->Nu(1500.001, 1.72, 1), 25.5, 0.05);
}


TEST(heatTransfer, exponentOfVoidFraction)
{
    // 0.5^3.5 by default, 0.5^2 if so said, none at 0
    EXPECT_NEAR(law("LiMason")->Nu(100, 1, 0.5), 2 + 6/std::sqrt(128), 1e-14);
    EXPECT_NEAR(law("LiMason; n 2")->Nu(100, 1, 0.5), 2 + 6.0/4, 1e-14);
    EXPECT_NEAR(law("LiMason; n 0")->Nu(100, 1, 0.5), 8, 1e-14);
}


TEST(heatTransfer, Qp)
{
    particle p;
    p.d = 2e-3;
    p.U = vector(1, 0, 0);

    carrier c;
    c.U = p.U;
    c.alphac = 0.5;
    c.rho = 1.2;
    c.mu = 1.8e-5;
    c.kappa = 0.025;
    c.Cp = 1000;

    // Around a sphere at rest the temperature falls as 1/r: 2 pi kappa d
    for (const char* name : {"RanzMarshall", "LiMason"})
    {
        std::feclearexcept(FE_ALL_EXCEPT);
        EXPECT_NEAR(law(name)->Qp(p, c)/3.14159265358979e-4, 1, 1e-14) << name;
        EXPECT_FALSE
        (
            std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW)
        )   << name;
    }

    std::feclearexcept(FE_ALL_EXCEPT);
    EXPECT_NEAR(law("AcrivosTaylor")->Qp(p, c)/3.14159265358979e-4, 1, 1e-14);
    // 7 - 5 + 1.25 in the place of 2
    EXPECT_NEAR(law("Gunn")->Qp(p, c)/3.14159265358979e-4, 1.625, 1e-14);
    EXPECT_FALSE(std::fetestexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW));

    // Slip 0.75 m/s: Re 100, Pr 0.72, the void fraction not in Re
    c.U = vector(1, 0.75, 0);
    EXPECT_NEAR
    (
        law("RanzMarshall")->Qp(p, c)/3.14159265358979e-4,
        1 + 3*std::cbrt(0.72), 1e-14
    );
}


TEST(heatTransfer, refused)
{
    EXPECT_ANY_THROW(law("RanzMarshall; n 3.5"));
    EXPECT_ANY_THROW(law("LiMason; m 3.5"));
    EXPECT_ANY_THROW(law("LiMason; n -1"));
    EXPECT_ANY_THROW(law("Gunn; n 3.5"));
    EXPECT_ANY_THROW(law("AcrivosTaylor; n 3.5"));
    EXPECT_ANY_THROW(law("Gunnn"));
}
