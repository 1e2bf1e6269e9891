/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Liquids of the library and mixtures of liquids against handbooks and hand
// calculation

#include <gtest/gtest.h>
#include <cmath>
#include "entries.H"
#include "liquidMixture.H"
#include "table.H"

using namespace Foam;
using namespace Foam::dew;

namespace
{

autoPtr<liquidMixture> mixture(const std::string& text)
{
    return autoPtr<liquidMixture>(new liquidMixture(entries(text)));
}

const std::string ethanolWater
(
    "liquids { ethanol { type library; } water { type library; } }"
);

constexpr scalar p = 101325, T0 = 298.15;

//- Mole fractions of ethanol and water of a mass fraction of ethanol
scalarField x(const liquidMixture& m, const scalar Y)
{
    scalarField fractions(2), x(2);
    fractions[0] = Y;
    fractions[1] = 1 - Y;
    m.moleFractions(fractions, x);
    return x;
}

const word constant
(
    "type constant; rho 1000; Cp 2000; hv 1e6; sigma 0.03; pSat 1000; "
);

} // End anonymous namespace


// 5 %, but what the header of libraryLiquid admits: kappa is not in it, hv is
// within 3 %
TEST(libraryLiquids, againstHandbook)
{
    const wordList names
    ({
        "decane", "dodecane", "acetone", "diethylEther", "hexane", "benzene",
        "heptane", "toluene", "ethylbenzene", "octane", "nonane", "methanol",
        "isooctane", "isopropanol", "propanol"
    });
    const auto rows = readTable("liquids.csv");
    ASSERT_EQ(label(rows.size()), names.size());
    forAll(names, i)
    {
        const autoPtr<liquidModel> l
        (
            liquidModel::New(entries("type library; liquid " + names[i] + ";"))
        );
        const std::vector<double> values
        {
            l->rho(p, T0), l->mu(p, T0), l->Cp(p, T0), l->kappa(p, T0), l->hv(p, T0),
            l->sigma(p, T0), l->pSat(T0)
        };
        for (size_t k = 0; k < values.size(); k++)
        {
            if (rows[i][k] > 0)
            {
                EXPECT_NEAR(values[k]/rows[i][k], 1, 0.05)
                    << names[i] << " column " << k;
            }
        }
        EXPECT_TRUE(l->inRange(T0));
        EXPECT_FALSE(l->inRange(0.95*l->Tc()));
    }
}


// Water at 25 degrees, 23.76 mmHg; ethanol at its boiling point
TEST(libraryLiquids, Antoine)
{
    const autoPtr<liquidModel> water
    (
        liquidModel::New
        (
            entries
            (
                "type library; liquid water; overrides { Antoine { A 8.07131;"
                "B 1730.63; C 233.426; unitOfP 133.322; zeroOfT 273.15; } }"
            )
        )
    );
    // log10 p = 8.07131 - 1730.63/258.426 = 1.374502 by hand
    EXPECT_NEAR(water->pSat(298.15)/133.322/23.6866, 1, 1e-4);
    EXPECT_NEAR(water->Tboil(101325), 373.15, 0.02);
    EXPECT_NEAR
    (
        water->dpSatdT(350)/water->pSat(350),
        std::log(10.0)*1730.63/std::pow(350 - 273.15 + 233.426, 2), 1e-9
    );
    EXPECT_ANY_THROW
    (
        liquidModel::New
        (
            entries("type library; liquid water; overrides { Antoine { A 8; }}")
        )
    );
}


TEST(liquidMixture, fractions)
{
    const autoPtr<liquidMixture> m(mixture(ethanolWater));
    EXPECT_EQ(m->size(), 2);
    EXPECT_EQ(m->names()[1], "water");
    EXPECT_EQ(m->liquid(1).name(), "H2O");
    EXPECT_EQ(m->index("water"), 1);
    EXPECT_ANY_THROW(m->index("H2O"));

    // 0.1/46.069/(0.1/46.069 + 0.9/18.015)
    const scalarField some(x(m(), 0.1));
    EXPECT_NEAR(some[0], 0.04164009, 1e-8);
    scalarField Y(2);
    m->massFractions(some, Y);
    EXPECT_NEAR(Y[0], 0.1, 1e-15);
    EXPECT_NEAR(m->W(some), 0.04164009*0.046069 + 0.95835991*0.018015, 1e-9);
}


TEST(liquidMixture, oneLiquid)
{
    const autoPtr<liquidMixture> m(mixture("type library; liquid water;"));
    const autoPtr<liquidModel> l
    (
        liquidModel::New(entries("type library; liquid H2O;"))
    );
    const scalarField one(1, 1);
    EXPECT_EQ(m->names()[0], "H2O");
    EXPECT_NEAR(m->rho(p, T0, one)/l->rho(p, T0), 1, 1e-14);
    EXPECT_NEAR(m->mu(p, T0, one)/l->mu(p, T0), 1, 1e-14);
    EXPECT_NEAR(m->Cp(p, T0, one)/l->Cp(p, T0), 1, 1e-14);
    EXPECT_NEAR(m->kappa(p, T0, one)/l->kappa(p, T0), 1, 1e-14);
    EXPECT_NEAR(m->sigma(p, T0, one)/l->sigma(p, T0), 1, 1e-14);
    EXPECT_ANY_THROW(m->D(0, p, T0, one));

    // Thermal expansion of water: CRC Handbook, 95th ed., 2.57e-4 1/K at 25
    // degrees and 6.96e-4 at 90
    EXPECT_NEAR(m->beta(p, 298.15, one), 2.57e-4, 1e-6);
    EXPECT_NEAR(m->beta(p, 363.15, one), 6.96e-4, 1e-6);
    EXPECT_EQ(m->Tmin(), l->Tmin());
    EXPECT_EQ(m->Tmax(), l->Tmax());
}


// Mass 50 %: CRC Handbook, 0.9099 g/cm3 at 25 degrees. The excess volumes of
// -1.0e-6 m3/mol near x = 0.3 to 0.5 make the difference to ideal volumes
TEST(liquidMixture, density)
{
    const autoPtr<liquidMixture> ideal(mixture(ethanolWater));
    const scalarField half(x(ideal(), 0.5));
    const scalar volume =
        0.5/ideal->liquid(0).rho(p, T0) + 0.5/ideal->liquid(1).rho(p, T0);
    EXPECT_NEAR(ideal->rho(p, T0, half)*volume, 1, 1e-14);

    // a0 + a1 (x_e - x_w), -4e-6 + 1.2e-6 (x_e - x_w)
    const autoPtr<liquidMixture> m
    (
        mixture(ethanolWater + "excessVolume { ethanol-water (-4e-6 1.2e-6); }")
    );
    EXPECT_NEAR
    (
        m->V(p, T0, half) - ideal->V(p, T0, half),
        half[0]*half[1]*(-4e-6 + 1.2e-6*(half[0] - half[1])), 1e-18
    );
    EXPECT_NEAR(m->rho(p, T0, half)/909.9, 1, 0.006);

    const autoPtr<liquidMixture> swapped
    (
        mixture
        (
            ethanolWater + "excessVolume { water-ethanol (-4e-6 -1.2e-6); }"
        )
    );
    EXPECT_NEAR(swapped->V(p, T0, half)/m->V(p, T0, half), 1, 1e-14);
}


TEST(liquidMixture, viscosityAndConductivity)
{
    const std::string three
    (
        "liquids { a { " + constant + "W 20; mu 1e-3; kappa 0.6; }"
        " b { " + constant + "W 40; mu 4e-3; kappa 0.2; }"
        " c { " + constant + "W 80; mu 1e-3; kappa 0.2; } }"
        "viscosity { b-a (2); }"
    );
    const autoPtr<liquidMixture> m(mixture(three));
    scalarField x(3, 0);
    x[0] = x[1] = 0.5;

    // 2e-3 exp(0.25*2)
    EXPECT_NEAR(m->mu(p, T0, x), 2e-3*std::exp(0.5), 1e-15);

    // Y 1/3, 2/3: (0.6 + 0.4)/3 - 0.72*2/9*0.4 by hand
    EXPECT_NEAR(m->kappa(p, T0, x), 1.0/3 - 0.064, 1e-12);

    x[1] = 0;
    x[2] = 0.5;
    EXPECT_NEAR(m->mu(p, T0, x), 1e-3, 1e-15);
    // Y 0.2, 0.8
    EXPECT_NEAR(m->kappa(p, T0, x), 0.28 - 0.72*0.16*0.4, 1e-12);
    EXPECT_NEAR(m->Cp(p, T0, x), 2000, 1e-9);
}


// The example of the header is fitted within 1.5 %, and the library's pure
// liquids are within 5 %
TEST(liquidMixture, measuredViscosity)
{
    const autoPtr<liquidMixture> m
    (
        mixture
        (
            ethanolWater
          + "viscosity { ethanol-water (2.935 -2.572 3.331 -3.564); }"
        )
    );
    for (const auto& row : readTable("ethanolWaterViscosity.csv"))
    {
        EXPECT_NEAR(m->mu(p, 293.15, x(m(), row[0]))/row[1], 1, 0.06) << row[0];
    }
}


TEST(surfaceTension, measuredEthanolWater)
{
    std::string values;
    const auto rows = readTable("ethanolWaterSigma.csv");
    for (const auto& row : rows)
    {
        values +=
            "(" + std::to_string(row[0]) + " " + std::to_string(row[1]) + ") ";
    }
    const autoPtr<liquidMixture> table
    (
        mixture
        (
            ethanolWater + "surfaceTension { type table; of ethanol;"
            "fraction mass; Tref 298.15; values (" + values + "); }"
        )
    );
    const autoPtr<liquidMixture> Eberhart
    (
        mixture
        (
            ethanolWater
          + "surfaceTension { type Eberhart; S { ethanol 22; water 1; } }"
        )
    );
    const autoPtr<liquidMixture> Tamura
    (
        mixture(ethanolWater + "surfaceTension { type Tamura; q 2; }")
    );
    for (const auto& row : rows)
    {
        const scalarField z(x(table(), row[0]));
        EXPECT_NEAR(table->sigma(p, T0, z)/row[1], 1, 1e-5) << row[0];

        // 1 mN/m of the fit, and the library's water is 1.2 % off
        EXPECT_NEAR(Eberhart->sigma(p, T0, z), row[1], 2e-3) << row[0];
        EXPECT_NEAR(Tamura->sigma(p, T0, z)/row[1], 1, 0.12) << row[0];
    }

    // Between the points, and proportional to ideal mixing at another temperature
    const scalarField z(x(table(), 0.125));
    EXPECT_NEAR(table->sigma(p, T0, z), 0.5*(0.04753 + 0.04208), 1e-9);
    const autoPtr<liquidMixture> ideal(mixture(ethanolWater));
    EXPECT_NEAR
    (
        table->sigma(p, 330, z)/table->sigma(p, T0, z),
        ideal->sigma(p, 330, z)/ideal->sigma(p, T0, z), 1e-14
    );
}


// Methanol in water at 303 K, x = 0.122: 46.1 mN/m measured, 47.2 by Tamura's
// method with its own pure data: R.C. Reid, J.M. Prausnitz, B.E. Poling (1987),
// example 12-5
TEST(surfaceTension, TamuraOfTextbook)
{
    const autoPtr<liquidMixture> own
    (
        mixture
        (
            "liquids { methanol { type library; overrides { sigma 0.02175; } }"
            "water { type library; overrides { sigma 0.07118; } } }"
            "surfaceTension { type Tamura; q 1; }"
        )
    );
    scalarField x(2);
    x[0] = 0.122;
    x[1] = 0.878;
    EXPECT_NEAR(own->sigma(p, 303.15, x)/0.0461, 1, 0.05);

    x = 0;
    x[0] = 1;
    EXPECT_EQ(own->sigma(p, 303.15, x), 0.02175);
}


TEST(surfaceTension, others)
{
    const auto of = [](const std::string& type)
    {
        return mixture
        (
            "liquids { a { " + constant + "W 20; mu 1e-3; kappa 0.6; }"
            " b { type constant; rho 500; Cp 2000; hv 1e6; sigma 0.12;"
            "pSat 1000; W 20; mu 4e-3; kappa 0.2; } }"
            "surfaceTension { type " + type + "; }"
        );
    };
    scalarField x(2, 0.5);
    EXPECT_NEAR(of("ideal")->sigma(p, T0, x), 0.075, 1e-15);

    // Volumes 1 to 2: ((sqrt 0.03 + 2 sqrt 0.12)/3)^2 = 0.03 (5/3)^2
    EXPECT_NEAR
    (
        of("WinterfeldScrivenDavis")->sigma(p, T0, x), 0.03*25/9, 1e-12
    );
    EXPECT_ANY_THROW(of("Tamura; q 2"));
    EXPECT_ANY_THROW(of("Eberhart; S { a 2; }"));
    EXPECT_ANY_THROW(of("Kelvin"));
    EXPECT_ANY_THROW
    (
        of("table; of a; fraction mass; Tref 300; values ((0 1) (.5 1))")
    );
    EXPECT_ANY_THROW
    (
        of("table; of a; fraction volume; Tref 300; values ((0 1) (1 1))")
    );
}


// Ethanol in water at 25 degrees: 1.24e-9 m2/s, CRC Handbook, 95th ed.; the
// method promises some 10 %, and the library's water is 4 % too viscous
TEST(liquidDiffusivity, ethanolInWater)
{
    const autoPtr<liquidMixture> m(mixture(ethanolWater));
    const scalar dilute = m->D(0, p, T0, x(m(), 1e-9));
    EXPECT_NEAR(dilute/1.24e-9, 1, 0.12);
    EXPECT_NEAR(m->D(1, p, T0, x(m(), 1e-9))/dilute, 1, 1e-6);

    // Vignes: the geometric mean in the middle
    scalarField middle(2, 0.5);
    EXPECT_NEAR
    (
        m->D(0, p, T0, middle),
        std::sqrt(dilute*m->D(0, p, T0, x(m(), 1 - 1e-9))), 1e-15
    );

    const autoPtr<liquidMixture> given
    (
        mixture(ethanolWater + "diffusivity { type constant; D 2e-9; }")
    );
    EXPECT_NEAR(given->D(0, p, T0, x(m(), 0.3)), 2e-9, 1e-20);
}


TEST(liquidMixture, refused)
{
    EXPECT_ANY_THROW(mixture("liquids { }"));
    EXPECT_ANY_THROW(mixture("liquids { mercury { type library; } }"));
    EXPECT_ANY_THROW(mixture(ethanolWater + "viscosity { ethanol-iron (1); }"));
    EXPECT_TRUE
    (
        contains
        (
            message
            (
                []
                {
                    mixture
                    (
                        ethanolWater
                      + "viscosity { ethanol-water (1); water-ethanol (1); }"
                    );
                }
            ),
            "Both"
        )
    );
    EXPECT_ANY_THROW(mixture(ethanolWater + "sigma { }"));
    EXPECT_ANY_THROW(mixture(ethanolWater + "diffusivity { type Fick; }"));
}
