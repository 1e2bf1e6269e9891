/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Numbers of the user: read with and without dimensions, refused when they
// cannot be meant

#include <gtest/gtest.h>
#include "IStringStream.H"
#include "userEntry.H"

using namespace Foam;
using namespace Foam::dew;

namespace
{

dictionary entries(const char* text)
{
    IStringStream is(text);
    return dictionary(is);
}

} // End anonymous namespace


TEST(userEntry, withAndWithoutDimensions)
{
    const dictionary dict
    (
        entries
        (
            "a 2500; b [1 -3 0 0 0 0 0] 2500; c c [1 -3 0 0 0 0 0] 2500;"
            "p [0 1 0 0 0 0 0] (1 2 3); q (1 2 3);"
        )
    );

    for (const char* key : {"a", "b", "c"})
    {
        EXPECT_EQ(userEntry::positive(dict, key, dimDensity), 2500);
    }
    EXPECT_EQ(userEntry::point(dict, "p", dimLength), vector(1, 2, 3));
    EXPECT_EQ(userEntry::point(dict, "q", dimLength), vector(1, 2, 3));

    // Reading an entry twice gives the same
    EXPECT_EQ(userEntry::positive(dict, "b", dimDensity), 2500);
}


TEST(userEntry, refused)
{
    const dictionary dict
    (
        entries
        (
            "wrong [0 1 0 0 0 0 0] 1; zero 0; minus -1; text abc;"
            "flat (0 0 0);"
        )
    );

    EXPECT_ANY_THROW(userEntry::positive(dict, "wrong", dimDensity));
    EXPECT_ANY_THROW(userEntry::positive(dict, "zero", dimless));
    EXPECT_ANY_THROW(userEntry::notNegative(dict, "minus", dimless));
    EXPECT_ANY_THROW(userEntry::number(dict, "text", dimless));
    EXPECT_ANY_THROW(userEntry::number(dict, "absent", dimless));
    EXPECT_ANY_THROW(userEntry::within(dict, "minus", 0, 1));
    EXPECT_ANY_THROW(userEntry::direction(dict, "flat"));
    EXPECT_ANY_THROW(userEntry::onlyThese(dict, {"zero", "minus"}));
    EXPECT_NO_THROW(userEntry::notNegative(dict, "zero", dimless));
}
