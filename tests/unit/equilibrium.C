/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Vapour over liquids: activities, fugacities, boiling and dew points

#include <gtest/gtest.h>
#include <cmath>
#include "entries.H"
#include "table.H"
#include "vapourLiquidEquilibrium.H"

using namespace Foam;
using namespace Foam::dew;

namespace
{

//- Liquids with what is above them
struct mixed
{
    liquidMixture liquids;

    vapourLiquidEquilibrium equilibrium;

    mixed(const std::string& species, const std::string& text)
    :
        liquids(entries("liquids { " + species + " }")),
        equilibrium(liquids, entries(text))
    {}
};

const std::string ethanolWater
(
    "ethanol { type library; } water { type library; }"
);

const std::string three
(
    "acetone { type library; } methanol { type library; }"
    "water { type library; }"
);

const std::string vanLaar
(
    "activity { type vanLaar; ethanol-water { A12 1.6798; A21 0.9227; } }"
);

const std::string NRTL
(
    "activity { type NRTL; ethanol-water { a12 -0.8009; a21 3.4578;"
    "b12 246.18; b21 -586.0809; alpha 0.3; } }"
);

const std::string Wilson
(
    "activity { type Wilson; ethanol-water { a12 1158.0; a21 4081.4;"
    "V1 58.68e-6; V2 18.07e-6; } }"
);

const std::string UNIFAC("activity { type UNIFAC; }");

//- Of acetone, methanol and water: as in reference/activity.py
const std::string ofThree[]
{
    "activity { type Wilson;"
    "acetone-methanol { a12 -112; a21 900; V1 74e-6; V2 40.7e-6; }"
    "water-acetone { a12 5100; a21 1200; V1 18.07e-6; V2 74e-6; }"
    "methanol-water { a12 400; a21 1900; V1 40.7e-6; V2 18.07e-6; } }",
    "activity { type NRTL;"
    "acetone-methanol { a12 0.3; a21 -0.2; b12 60; b21 110; alpha 0.3; }"
    "water-acetone { a12 0.6; a21 0.1; b12 400; b21 320; alpha 0.53; }"
    "methanol-water { a12 -0.7; a21 2.7; b12 170; b21 -600; alpha 0.3; } }",
    UNIFAC
};

scalarField pair(const scalar x)
{
    scalarField both(2);
    both[0] = x;
    both[1] = 1 - x;
    return both;
}

constexpr scalar atm = 101325;

//- As solution: the T where y is x
scalar azeotrope(const vapourLiquidEquilibrium& e, scalar& T)
{
    scalar low = 0.7, high = 0.99;
    scalarField y(2);
    for (label i = 0; i < 60; i++)
    {
        const scalar x = 0.5*(low + high);
        T = e.bubbleT(atm, pair(x), y);
        (y[0] > x ? low : high) = x;
    }
    return low;
}

} // End anonymous namespace


TEST(equilibrium, vanLaarTable)
{
    const mixed s(ethanolWater, vanLaar);
    scalarField y(2);
    for (const auto& row : readTable("vanLaar.csv"))
    {
        EXPECT_NEAR(s.equilibrium.bubbleT(atm, pair(row[0]), y), row[1], 0.006);
        EXPECT_NEAR(y[0], row[2], 0.0006) << row[0];
        EXPECT_NEAR(y[0] + y[1], 1, 1e-12);
    }
    scalar T = 0;
    EXPECT_NEAR(azeotrope(s.equilibrium, T), 0.9085, 0.0005);
    EXPECT_NEAR(T, 351.47, 0.01);

    // The pair named the other way round
    const mixed other
    (
        ethanolWater,
        "activity { type vanLaar; water-ethanol { A12 0.9227; A21 1.6798; } }"
    );
    scalarField y2(2);
    s.equilibrium.bubbleT(atm, pair(0.2), y);
    other.equilibrium.bubbleT(atm, pair(0.2), y2);
    EXPECT_NEAR(y[0], y2[0], 1e-14);
}


// y within 0.02 of the measurements, boiling points within 1 K: as far as other
// measurements are from these. UNIFAC knows nothing of the pair, and is as good
// from x = 0.05 up, with boiling points within 1.6 K
TEST(equilibrium, measuredEthanolWater)
{
    for (const std::string& model : {vanLaar, NRTL, Wilson, UNIFAC})
    {
        const mixed s(ethanolWater, model);
        scalarField y(2);
        for (const auto& row : readTable("ethanolWater.csv"))
        {
            if (model == UNIFAC && row[0] < 0.05)
            {
                continue;
            }
            const scalar T = s.equilibrium.bubbleT(atm, pair(row[0]), y);
            EXPECT_NEAR(y[0], row[1], 0.02) << model << ' ' << row[0];
            EXPECT_NEAR(T, row[2] + 273.15, model == UNIFAC ? 1.6 : 1) << model << ' ' << row[0];
        }

        // Measured: 0.894 (95.6 % of mass) and 351.3 K
        scalar T = 0;
        EXPECT_NEAR(azeotrope(s.equilibrium, T), 0.894, 0.02) << model;
        EXPECT_NEAR(T, 351.3, 0.2) << model;
    }
}


TEST(activity, againstGibbsEnergy)
{
    for (label model = 0; model < 3; model++)
    {
        const mixed s(three, ofThree[model]);
        for (const auto& row : readTable("activity.csv"))
        {
            if (row[0] != model)
            {
                continue;
            }
            scalarField x(3), g(3);
            forAll(x, i)
            {
                x[i] = row[2 + i];
            }
            s.equilibrium.activity().lnGamma(row[1], x, g);
            forAll(x, i)
            {
                EXPECT_NEAR(g[i], row[5 + i], 1e-9)
                    << model << ' ' << row[1] << ' ' << i;
            }

            // What counts are the ratios of the amounts
            scalarField twice(2*x), g2(3);
            s.equilibrium.activity().lnGamma(row[1], twice, g2);
            EXPECT_NEAR(mag(g2[2] - g[2]), 0, 1e-13);
        }
    }
}


// R.C. Reid, J.M. Prausnitz, B.E. Poling (1987), example 8-11: acetone and
// n-pentane at 307 K, x = 0.047: gamma 4.99 and 1.005
TEST(activity, UNIFACOfTextbook)
{
    const mixed s
    (
        "acetone { type library; } pentane { type constant; W 72.15; rho 621;"
        "mu 2.2e-4; Cp 2300; kappa 0.11; hv 3.7e5; sigma 0.0155; pSat 6.8e4; }",
        "activity { type UNIFAC; groups { pentane { CH3 2; CH2 3; } } }"
    );
    scalarField g(2);
    s.equilibrium.activity().lnGamma(307, pair(0.047), g);
    EXPECT_NEAR(std::exp(g[0]), 4.99, 0.005);
    EXPECT_NEAR(std::exp(g[1]), 1.005, 0.0005);
}


TEST(activity, GibbsDuhem)
{
    const scalarField x(values({0.2, 0.3, 0.5}));
    for (const std::string& model : ofThree)
    {
        const mixed s(three, model);
        scalarField d(3);
        for (label j = 0; j < 3; j++)
        {
            s.equilibrium.activity().dx(j, 320, x, d);
            EXPECT_NEAR(sum(x*d), 0, 1e-6) << model << ' ' << j;
            EXPECT_GT(sum(mag(d)), 0.1);
        }
    }
    const mixed s(ethanolWater, vanLaar);
    scalarField d(2);
    for (label j = 0; j < 2; j++)
    {
        s.equilibrium.activity().dx(j, 320, pair(0.3), d);
        EXPECT_NEAR(sum(pair(0.3)*d), 0, 1e-6);
        EXPECT_GT(mag(d[0]), 0.1);
    }
}


// 1 + x1 d lnGamma_1/dx1 of van Laar: 1 - 2 A12^2 A21^2 x1 x2/(A12 x1 +
// A21 x2)^3, by hand
TEST(activity, factorOfDiffusion)
{
    const mixed s(ethanolWater, vanLaar);
    const scalar a = 1.6798, b = 0.9227, x = 0.3;
    EXPECT_NEAR
    (
        s.equilibrium.activity().factor(320, pair(x)),
        1 - 2*a*a*b*b*x*(1 - x)/std::pow(a*x + b*(1 - x), 3), 1e-8
    );
    EXPECT_ANY_THROW
    (
        mixed(three, UNIFAC).equilibrium.activity().factor
        (
            300, scalarField(3, 1.0/3)
        )
    );
}


TEST(equilibrium, derivatives)
{
    for
    (
        const std::string more
      : {"", "fugacity PengRobinson;", "Poynting on;"}
    )
    {
        const mixed s(three, UNIFAC + more);
        const scalarField x(values({0.2, 0.3, 0.5}));
        const scalar T = 320;
        scalarField d(3), low(3), high(3);

        s.equilibrium.dpdT(atm, T, x, d);
        s.equilibrium.partialPressures(atm, T - 0.01, x, low);
        s.equilibrium.partialPressures(atm, T + 0.01, x, high);
        forAll(x, i)
        {
            EXPECT_NEAR((high[i] - low[i])/0.02/d[i], 1, 1e-5) << more;
        }

        // From x_j to x_k: with the sum kept at one
        for (label j = 0; j < 3; j++)
        {
            const label k = (j + 1) % 3;
            scalarField dj(3), dk(3), moved(x);
            s.equilibrium.dpdx(j, atm, T, x, dj);
            s.equilibrium.dpdx(k, atm, T, x, dk);
            moved[j] += 1e-4;
            moved[k] -= 1e-4;
            s.equilibrium.partialPressures(atm, T, moved, high);
            moved[j] -= 2e-4;
            moved[k] += 2e-4;
            s.equilibrium.partialPressures(atm, T, moved, low);
            forAll(x, i)
            {
                EXPECT_NEAR
                (
                    (high[i] - low[i])/2e-4, dj[i] - dk[i],
                    1e-5*mag(dj[i] - dk[i]) + 0.01
                )   << more << ' ' << j << ' ' << i;
            }
        }
    }
}


TEST(fugacity, againstIntegral)
{
    const PengRobinson gas
    (
        values({516.25, 126.1}), values({6.3835e6, 3.3944e6}),
        values({0.6371, 0.0403})
    );
    for (const auto& row : readTable("fugacity.csv"))
    {
        scalarField y(values({row[2], row[3]})), f(2);
        gas.lnPhi(row[1], row[0], y, f);
        EXPECT_NEAR(f[0], row[4], 1e-7) << row[0] << ' ' << row[1];
        EXPECT_NEAR(f[1], row[5], 1e-7) << row[0] << ' ' << row[1];
        if (row[3] == 0)
        {
            EXPECT_NEAR(gas.lnPhi(0, row[1], row[0]), f[0], 1e-14);
        }
    }
}


// Saturated steam at 1 atm: B = -452e-6 m3/mol (A.H. Harvey, E.W. Lemmon, J.
// Phys. Chem. Ref. Data 33 (2004) 369-376), exp(B p/(Ru T)) = 0.9854. That the
// equation does not know association costs 1 %
TEST(fugacity, steam)
{
    const PengRobinson steam
    (
        scalarField(1, 647.13), scalarField(1, 2.2055e7), scalarField(1, 0.3449)
    );
    EXPECT_NEAR(std::exp(steam.lnPhi(0, atm, 373.15)), 0.9854, 0.01);
}


TEST(fugacity, PoyntingByHand)
{
    const mixed with(ethanolWater, "Poynting on;");
    const mixed without(ethanolWater, "");
    scalarField p(2), p0(2);
    with.equilibrium.partialPressures(1e7, 298.15, pair(0), p);
    without.equilibrium.partialPressures(1e7, 298.15, pair(0), p0);

    // 18.015e-3/996.9994*(1e7 - 3170.4)/(8.314462618*298.15) = 0.0728673
    EXPECT_NEAR(std::log(p[1]/p0[1]), 0.0728673, 1e-7);
}


// At 1 atm the corrections are small, and cancel for a pure boiling liquid
TEST(fugacity, smallAtOneAtmosphere)
{
    const mixed real(ethanolWater, UNIFAC + "fugacity PengRobinson;");
    const mixed ideal(ethanolWater, UNIFAC);
    scalarField y(2), yIdeal(2);
    EXPECT_NEAR
    (
        real.equilibrium.bubbleT(atm, pair(1), y),
        ideal.equilibrium.bubbleT(atm, pair(1), yIdeal), 1e-6
    );
    real.equilibrium.bubbleT(atm, pair(0.3), y);
    ideal.equilibrium.bubbleT(atm, pair(0.3), yIdeal);
    EXPECT_NEAR(y[0], yIdeal[0], 0.01);
    EXPECT_GT(mag(y[0] - yIdeal[0]), 1e-4);

    // Ethanol into nitrogen at 50 bar: its fugacity is smaller there
    const mixed dense
    (
        ethanolWater, "fugacity PengRobinson; carrier N2;"
    );
    scalarField p(2), p0(2);
    dense.equilibrium.partialPressures(5e6, 320, pair(1), p);
    mixed(ethanolWater, "").equilibrium.partialPressures
    (
        5e6, 320, pair(1), p0
    );
    EXPECT_GT(p[0]/p0[0], 1.02);
}


TEST(equilibrium, dewIsTheInverseOfBoiling)
{
    for
    (
        const std::string& model
      : {std::string(), vanLaar, NRTL, UNIFAC,
         UNIFAC + "fugacity PengRobinson; Poynting on;"}
    )
    {
        const mixed s(ethanolWater, model);
        for (const scalar x1 : {0.001, 0.1, 0.5, 0.95})
        {
            scalarField x(2), y(2);
            const scalar T = s.equilibrium.bubbleT(atm, pair(x1), y);
            EXPECT_NEAR(s.equilibrium.dewT(atm, y, x), T, 1e-7) << model;
            EXPECT_NEAR(x[0], x1, 1e-7) << model;

            const scalar p = s.equilibrium.bubbleP(T, pair(x1), y);
            EXPECT_NEAR(p/atm, 1, 1e-9) << model;
            EXPECT_NEAR(s.equilibrium.dewP(T, y, x)/p, 1, 1e-8) << model;
            EXPECT_NEAR(x[0], x1, 1e-7) << model;
        }
    }
}


// alpha of the ideal, well mixed droplet, n1/n10 = (n2/n20)^alpha, and the
// ratios of mass fluxes of ethanol to water into dry air, with diffusivities
// of 1.19e-5 and 2.5e-5: an independent calculation with the same constants
TEST(equilibrium, ratiosOfFluxes)
{
    const mixed ideal(ethanolWater, ""), real(ethanolWater, vanLaar);
    const auto ratio = [](const mixed& s, const scalar Y, const scalar T)
    {
        scalarField x(2), p(2);
        s.liquids.moleFractions(pair(Y), x);
        s.equilibrium.partialPressures(atm, T, x, p);
        return
            1.19e-5*p[0]*s.liquids.W()[0]/(2.5e-5*p[1]*s.liquids.W()[1]);
    };
    scalarField p1(2), p2(2);
    ideal.equilibrium.partialPressures(atm, 298.15, pair(1), p1);
    ideal.equilibrium.partialPressures(atm, 298.15, pair(0), p2);
    EXPECT_NEAR(1.19*p1[0]/(2.5*p2[1]), 1.18562, 1e-5);

    const double Y[] = {0.05, 0.1, 0.2, 0.3, 0.5};
    const double withActivity[] = {0.297, 0.555, 0.974, 1.295, 1.793};
    const double without[] = {0.062, 0.132, 0.296, 0.508, 1.186};
    for (label i = 0; i < 5; i++)
    {
        EXPECT_NEAR(ratio(real, Y[i], 298.15)/withActivity[i], 1, 0.005);
        EXPECT_NEAR(ratio(ideal, Y[i], 298.15)/without[i], 1, 0.01);
    }
}


TEST(equilibrium, refused)
{
    const mixed s(ethanolWater, UNIFAC);
    scalarField y(2);

    // Above the critical pressure and temperature of ethanol
    EXPECT_TRUE
    (
        contains
        (
            message([&] { s.equilibrium.bubbleT(3e7, pair(0.5), y); }),
            "No boiling point"
        )
    );
    EXPECT_ANY_THROW(s.equilibrium.partialPressures(atm, 520, pair(0.5), y));

    const auto with = [](const std::string& text)
    {
        const mixed s(ethanolWater, text);
    };
    EXPECT_ANY_THROW(with("activity { type Margules; }"));
    EXPECT_ANY_THROW(with("activity { type NRTL; }"));
    EXPECT_ANY_THROW
    (
        with("activity { type vanLaar; ethanol-water { A12 1; A21 -1; } }")
    );
    EXPECT_ANY_THROW(with("fugacity SRK;"));
    EXPECT_ANY_THROW(with("fugacity PengRobinson; carrier xenon;"));
    EXPECT_ANY_THROW(with("Pointing on;"));
    EXPECT_TRUE
    (
        contains
        (
            message
            (
                [&]
                {
                    with
                    (
                        "activity { type UNIFAC; groups { water { H3O 1; } } }"
                    );
                }
            ),
            "Known groups"
        )
    );
    EXPECT_ANY_THROW
    (
        mixed
        (
            "urea { type library; liquid CH4N2O; } water { type library; }",
            UNIFAC
        )
    );
    EXPECT_ANY_THROW(mixed(three, vanLaar));
}
