/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Philox 4x32-10 against the known answers published with the generator
// (Random123 1.09, kat_vectors: lines "philox4x32 10")

#include <gtest/gtest.h>
#include <cmath>
#include "counterRandom.H"

using Foam::dew::counterRandom;

TEST(counterRandom, knownAnswers)
{
    struct vector { uint32_t counter[4], key[2], expected[4]; };

    const vector table[] =
    {
        {
            {0, 0, 0, 0}, {0, 0},
            {0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}
        },
        {
            {0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff},
            {0xffffffff, 0xffffffff},
            {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}
        },
        {
            {0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344},
            {0xa4093822, 0x299f31d0},
            {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}
        }
    };

    for (const vector& v : table)
    {
        uint32_t c[4] = {v.counter[0], v.counter[1], v.counter[2], v.counter[3]};
        counterRandom::philox(v.key, c);

        for (int k = 0; k < 4; k++)
        {
            EXPECT_EQ(c[k], v.expected[k]);
        }
    }
}

TEST(counterRandom, knownAnswersOf64Bits)
{
    // The same file, lines "philox4x64 10"; the first also of numpy's Philox
    struct vector { uint64_t counter[4], key[2], expected[4]; };
    const uint64_t all = ~0ull;

    const vector table[] =
    {
        {
            {0, 0, 0, 0}, {0, 0},
            {
                0x16554d9eca36314c, 0xdb20fe9d672d0fdc,
                0xd7e772cee186176b, 0x7e68b68aec7ba23b
            }
        },
        {
            {all, all, all, all}, {all, all},
            {
                0x87b092c3013fe90b, 0x438c3c67be8d0224,
                0x9cc7d7c69cd777b6, 0xa09caebf594f0ba0
            }
        }
    };

    for (const vector& v : table)
    {
        uint64_t c[4] = {v.counter[0], v.counter[1], v.counter[2], v.counter[3]};
        counterRandom::philox(v.key, c);

        for (int k = 0; k < 4; k++)
        {
            EXPECT_EQ(c[k], v.expected[k]);
        }
    }
}

TEST(counterRandom, continuesFromItsCounter)
{
    counterRandom all(7, 3);
    for (int i = 0; i < 5; i++)
    {
        all.uniform();
    }
    counterRandom later(7, 3, all.counter());
    EXPECT_EQ(all.uniform(), later.uniform());
}

TEST(counterRandom, momentsOfTheUniformDistribution)
{
    counterRandom r(1);
    const int n = 100000;
    double sum = 0, square = 0;
    for (int i = 0; i < n; i++)
    {
        const double u = r.uniform();
        ASSERT_GT(u, 0);
        ASSERT_LT(u, 1);
        sum += u;
        square += u*u;
    }

    // Four standard errors of mean and second moment
    EXPECT_NEAR(sum/n, 0.5, 4*std::sqrt(1.0/12/n));
    EXPECT_NEAR(square/n, 1.0/3, 4*std::sqrt(4.0/45/n));
}
