/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Laws of the contact angle: tables of the published formulas, and branches

#include <gtest/gtest.h>
#include "contactAngle.H"
#include "IStringStream.H"
#include "table.H"
#include "unitConversion.H"

using namespace Foam;
using namespace Foam::dew;

namespace
{

autoPtr<contactAngle> law(const std::string& entries)
{
    return contactAngle::New(dictionary(IStringStream(entries)()));
}


//- Of a line at the angle held [degrees] and the capillary number
scalar theta(const contactAngle& law, const scalar held, const scalar Ca)
{
    const scalar mu = 1.8e-3, sigma = 0.072;
    return radToDeg
    (
        law.theta({degToRad(45), degToRad(held), Ca*sigma/mu, mu, sigma})
    );
}

} // End anonymous namespace


// 1e-6 degrees: acos of the formula near 0 loses half of its digits
TEST(contactAngles, KistlerAndCoxVoinov)
{
    for (const auto& row : readTable("contactAngles.csv"))
    {
        std::ostringstream os;
        os.precision(17);
        if (row[0] == 0)
        {
            os  << "type Kistler; thetaA " << row[1] << "; thetaR " << row[2]
                << ";";
        }
        else
        {
            os  << "type CoxVoinov; theta " << row[1] << "; L " << row[2]
                << "; lambda " << row[3] << ";";
        }
        EXPECT_NEAR(theta(law(os.str())(), 50, row[4]), row[5], 1e-6)
            << os.str() << " Ca " << row[4];
    }
}


// Held between both angles, else that of the side; the speed is nothing to it
TEST(contactAngles, hysteresis)
{
    const auto both = law("type hysteresis; thetaA 90; thetaR 30;");
    EXPECT_TRUE(both->holds());
    for (const scalar Ca : {-0.1, 0.0, 0.1})
    {
        EXPECT_NEAR(theta(*both, 10, Ca), 30, 1e-12);
        EXPECT_NEAR(theta(*both, 50, Ca), 50, 1e-12);
        EXPECT_NEAR(theta(*both, 120, Ca), 90, 1e-12);
    }
}


TEST(contactAngles, pinned)
{
    const auto all = law("type pinned;");
    const auto some = law("type pinnedThenReceding; thetaR 30;");
    EXPECT_TRUE(all->holds() && some->holds());
    for (const scalar held : {5.0, 29.0, 31.0, 100.0, 170.0})
    {
        EXPECT_NEAR(theta(*all, held, 0.1), held, 1e-12);
        EXPECT_NEAR(theta(*some, held, -0.1), max(held, scalar(30)), 1e-12);
    }
}


TEST(contactAngles, constant)
{
    const auto one = law("type constant; theta 60;");
    EXPECT_FALSE(one->holds());
    EXPECT_NEAR(theta(*one, 10, 0.5), 60, 1e-12);
}
