/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Gases by name, diffusivities and mixtures with several vapours

#include <gtest/gtest.h>
#include <cmath>
#include "binaryDiffusivity.H"
#include "entries.H"
#include "gasMixture.H"
#include "mixedGas.H"
#include "saturation.H"
#include "table.H"

using namespace Foam;
using namespace Foam::dew;

namespace
{

constexpr scalar atm = 101325;

struct mixed
{
    liquidMixture liquids;

    autoPtr<gasMixture> gas;

    mixed(const std::string& species, const std::string& text)
    :
        liquids(entries(species)),
        gas(gasMixture::New(entries("type " + text), liquids))
    {}
};

const std::string water("type library; liquid H2O;");

const std::string both
(
    "liquids { ethanol { type library; } water { type library; } }"
);

const std::string given
(
    "diffusivity { D0 2.5e-5; Tref 298.15; pRef 101325; }"
);

const std::string humidAir("idealGas; p0 101325; carrier { type air; }" + given);

autoPtr<pureGas> gas(const std::string& name)
{
    return pureGases::mixedGas::species(name);
}

scalar D
(
    const std::string& type,
    const word& a,
    const scalar Wa,
    const word& b,
    const scalar Wb,
    const scalar T
)
{
    return
        binaryDiffusivity::New
        (
            entries("type " + type + ";"),
            pureGas::part{a, 1e-3*Wa, 1}, pureGas::part{b, 1e-3*Wb, 1}
        )->D(atm, T);
}

scalarField two(const scalar a, const scalar b)
{
    return values({a, b});
}

} // End anonymous namespace


TEST(pureGas, againstTables)
{
    const char* names[] = {"N2", "O2", "CO2"};
    for (const auto& row : readTable("gases.csv"))
    {
        const autoPtr<pureGas> g(gas(names[int(row[0])]));
        const scalar T = row[1];
        EXPECT_NEAR(g->Cp(T)/row[2], 1, 0.01) << g->name() << T;
        EXPECT_NEAR(g->mu(T)/row[3], 1, 0.02) << g->name() << T;
        EXPECT_NEAR(g->kappa(T)/row[4], 1, 0.03) << g->name() << T;
    }
    EXPECT_EQ(gas("nitrogen")->name(), "N2");
}


// Check values of IAPWS R15-11, table 4, at zero density: 18.4341883 mW/m/K at
// 298.15 K, 79.1034659 at 873.15 K; of R12-08, table 4: 32.619679 uPa s at
// 873.15 K and 1 kg/m3, which is 0.1 % more or less than at none
TEST(pureGas, steam)
{
    const autoPtr<pureGas> g(gas("water"));
    EXPECT_NEAR(g->kappa(298.15)/18.4341883e-3, 1, 1e-8);
    EXPECT_NEAR(g->kappa(873.15)/79.1034659e-3, 1, 1e-8);
    EXPECT_NEAR(g->mu(873.15)/32.619679e-6, 1, 1e-3);

    // Ideal gas at 298.15 K: 33.59 J/mol/K (JANAF)
    EXPECT_NEAR(g->Cp(298.15)*g->W(), 33.59, 0.01);
}


// Mass 23.3 % of oxygen is 21 % of moles; dry air of its own table
TEST(pureGas, mixture)
{
    const liquidMixture l(entries(water));
    const autoPtr<pureGas> air
    (
        pureGas::New
        (
            entries("type mixture; x { N2 0.79; O2 0.21; }"), l.liquid(0)
        )
    );
    const autoPtr<pureGas> known(gas("air"));
    EXPECT_NEAR(air->W(), 0.79*28.0134e-3 + 0.21*31.9988e-3, 1e-9);
    for (const scalar T : {300.0, 600.0})
    {
        EXPECT_NEAR(air->Cp(T)/known->Cp(T), 1, 0.01);
        EXPECT_NEAR(air->mu(T)/known->mu(T), 1, 0.02);
        EXPECT_NEAR(air->kappa(T)/known->kappa(T), 1, 0.02);
    }
    const autoPtr<pureGas> byMass
    (
        pureGas::New
        (
            entries("type mixture; Y { N2 0.76707; O2 0.23293; }"), l.liquid(0)
        )
    );
    EXPECT_NEAR(byMass->W()/air->W(), 1, 1e-5);

    const auto with = [&](const std::string& text)
    {
        pureGas::New(entries("type mixture; " + text), l.liquid(0));
    };
    EXPECT_ANY_THROW(with("x { N2 79; O2 21; }"));
    EXPECT_ANY_THROW(with("x { N2 0.8; O2 0.1; }"));
    EXPECT_ANY_THROW(with("x { N2 1; } Y { N2 1; }"));
    EXPECT_TRUE
    (
        contains
        (
            message([&] { with("x { xenon 1; }"); }), "Known gases"
        )
    );
}


// Water in air 2.5e-5 and ethanol in air 1.19e-5 m2/s at 298.15 K, acetone in
// air 1.05e-5 at 273 K (T.R. Marrero, E.A. Mason, J. Phys. Chem. Ref. Data 1
// (1972) 3-118; E.L. Cussler, Diffusion (1997)): the method promises 5 to 8 %
TEST(diffusivity, Fuller)
{
    EXPECT_NEAR
    (
        D("Fuller", "H2O", 18.015, "air", 28.9647, 298.15)/2.5e-5, 1, 0.05
    );
    EXPECT_NEAR
    (
        D("Fuller", "C2H5OH", 46.069, "air", 28.9647, 298.15)/1.19e-5, 1, 0.05
    );
    // Reid et al. (1987), example 11-3: allyl chloride in air at 298 K,
    // 0.096 cm2/s by this method at 1 bar
    EXPECT_NEAR
    (
        D
        (
            "Fuller; volumes { C3H5Cl 80.25; }", "C3H5Cl", 76.5, "air", 28.9647,
            298
        )*atm/1e5/0.096e-4, 1, 0.006
    );
    EXPECT_ANY_THROW(D("Fuller", "C3H5Cl", 76.5, "air", 29, 298));
}


// Reid et al. (1987), example 11-1: N2 and CO2 at 590 K, 1 bar, 0.52 cm2/s. R.B. Bird,
// W.E. Stewart, E.N. Lightfoot (1960), example 16.4-1: CO and CO2 at 296.1 K,
// 0.149 cm2/s with their potentials; their two digits of the collision integral
// allow 1 %
TEST(diffusivity, ChapmanEnskog)
{
    EXPECT_NEAR
    (
        D("ChapmanEnskog", "N2", 28.0134, "CO2", 44.0095, 590)*atm/1e5/0.52e-4,
        1, 0.01
    );
    EXPECT_NEAR
    (
        D
        (
            "ChapmanEnskog; potentials { CO (3.590 110); CO2 (3.996 190); }",
            "CO", 28.01, "CO2", 44.01, 296.1
        )/0.149e-4, 1, 0.01
    );
    EXPECT_ANY_THROW
    (
        D
        (
            "ChapmanEnskog; potentials { CO (3.590 -110); }", "CO", 28, "CO2",
            44, 296
        )
    );
}


// Of one vapour both forms of the flux are the same
TEST(gasMixture, oneVapour)
{
    const mixed s(water, humidAir);
    for (const scalar Y1 : {0.0, 0.02, 0.5, 1.0})
    {
        const scalar T = 330;
        const scalarField Y(1, Y1);
        EXPECT_NEAR
        (
            s.gas->Dx(0, atm, T, Y)*s.gas->W(0)/s.gas->W(Y)*s.gas->dxdY(Y1)
           /s.gas->DY(0, atm, T, Y), 1, 1e-12
        );
    }

    // D goes as 1/p
    const scalarField none(1, Zero);
    EXPECT_NEAR
    (
        s.gas->DY(0, 2*atm, 330, none)/s.gas->DY(0, atm, 330, none), 0.5, 1e-14
    );

    const mixed c
    (
        water,
        "constant; p0 1e5; Wc 29; rho 1.2; D 2e-5; Cp 1000; CpVapour 1900;"
        "kappa 0.026; mu 1.8e-5;"
    );
    const scalarField Y(1, 0.3);
    EXPECT_TRUE(c.gas->uniformDensity());
    EXPECT_EQ(c.gas->rho(1e5, 700, Y), 1.2);
    EXPECT_EQ(c.gas->DY(0, 1e5, 700, Y), 2e-5);
    EXPECT_EQ(c.gas->CpVapour(0, 700), 1900);
    EXPECT_NEAR
    (
        c.gas->Dx(0, 1e5, 700, Y)*c.gas->W(0)/c.gas->W(Y)*c.gas->dxdY(0.3),
        2e-5, 1e-18
    );
}


TEST(gasMixture, fractions)
{
    const mixed s
    (
        both, "idealGas; p0 1e5; carrier { type air; }"
        "diffusivity { type Fuller; }"
    );
    const scalarField x(two(0.3, 0.2));
    scalarField Y(2), back(2);
    s.gas->massFractions(x, Y);

    // W = 0.3*46.069 + 0.2*18.015 + 0.5*28.9647 = 31.90605
    EXPECT_NEAR(s.gas->W(Y), 31.90605e-3, 1e-9);
    EXPECT_NEAR(Y[0], 0.3*46.069/31.90605, 1e-9);
    s.gas->moleFractions(Y, back);
    EXPECT_NEAR(back[0], 0.3, 1e-15);
    EXPECT_NEAR(back[1], 0.2, 1e-15);
    EXPECT_NEAR
    (
        s.gas->rho(2e5, 400, Y), 2e5*31.90605e-3/(8.314462618*400), 1e-6
    );
}


// (1 - w_i)/sum_j (y_j/D_ij) with the sum over all species of the gas, those of
// the carrier too; by hand from the binary diffusivities
TEST(gasMixture, diffusivityInTheMixture)
{
    const mixed s
    (
        both, "idealGas; p0 1e5; carrier { type mixture; x { N2 0.7; CO2 0.3; }}"
        "diffusivity { type Fuller; pairs { water-carrier"
        " { D0 2e-5; Tref 300; pRef 1e5; } } }"
    );
    const scalar T = 300, p = atm;
    const scalarField x(two(0.3, 0.2));
    scalarField Y(2);
    s.gas->massFractions(x, Y);

    const scalar sum =
        0.2/D("Fuller", "C2H5OH", 46.069, "H2O", 18.015, T)
      + 0.5*0.7/D("Fuller", "C2H5OH", 46.069, "N2", 28.0134, T)
      + 0.5*0.3/D("Fuller", "C2H5OH", 46.069, "CO2", 44.0095, T);
    EXPECT_NEAR(s.gas->Dx(0, p, T, Y)*sum/(1 - Y[0]), 1, 1e-9);
    EXPECT_NEAR(s.gas->DY(0, p, T, Y)*sum/(1 - x[0]), 1, 1e-9);

    const scalar ofWater =
        0.3/D("Fuller", "C2H5OH", 46.069, "H2O", 18.015, T)
      + 0.5/(2e-5*1e5/atm);
    EXPECT_NEAR(s.gas->DY(1, p, T, Y)*ofWater/0.8, 1, 1e-9);
    EXPECT_NEAR(s.gas->Dc(1, 1e5, 300), 2e-5, 1e-18);

    // All at once, and by a law that is no power of temperature
    scalarField all(2);
    s.gas->DY(p, T, Y, all);
    EXPECT_NEAR(all[0]/s.gas->DY(0, p, T, Y), 1, 1e-14);
    EXPECT_NEAR(all[1]/s.gas->DY(1, p, T, Y), 1, 1e-14);
    const mixed c
    (
        both, "idealGas; p0 1e5; carrier { type gas; species N2; }"
        "diffusivity { type ChapmanEnskog; }"
    );
    c.gas->massFractions(x, Y);
    const scalar ofEthanol =
        0.2/D("ChapmanEnskog", "C2H5OH", 46.069, "H2O", 18.015, T)
      + 0.5/D("ChapmanEnskog", "C2H5OH", 46.069, "N2", 28.0134, T);
    c.gas->DY(p, T, Y, all);
    EXPECT_NEAR(all[0]*ofEthanol/0.7, 1, 1e-9);
    s.gas->massFractions(x, Y);

    // A trace of ethanol in the carrier, and pure ethanol
    EXPECT_NEAR
    (
        s.gas->DY(0, p, T, two(1e-10, 0))/s.gas->Dc(0, p, T), 1, 1e-9
    );
    EXPECT_TRUE(std::isfinite(s.gas->Dx(0, p, T, two(1, 0))));
    EXPECT_GT(s.gas->DY(0, p, T, two(1, 0)), 1e-6);
}


// One vapour twice is one vapour
TEST(gasMixture, equalVapours)
{
    const mixed s
    (
        "liquids { a { type library; liquid H2O; } b { type library; liquid H2O;"
        "} }",
        "idealGas; p0 1e5; carrier { type air; } diffusivity { type Fuller; }"
    );
    const mixed one
    (
        water,
        "idealGas; p0 1e5; carrier { type air; } diffusivity { type Fuller; }"
    );
    const scalarField Y(two(0.1, 0.2)), Y1(1, 0.3);
    EXPECT_NEAR(s.gas->mu(350, Y)/one.gas->mu(350, Y1), 1, 1e-13);
    EXPECT_NEAR(s.gas->kappa(350, Y)/one.gas->kappa(350, Y1), 1, 1e-13);
    EXPECT_NEAR(s.gas->Cp(350, Y)/one.gas->Cp(350, Y1), 1, 1e-13);
    EXPECT_NEAR(s.gas->rho(1e5, 350, Y)/one.gas->rho(1e5, 350, Y1), 1, 1e-13);
}


TEST(gasMixture, refused)
{
    const auto with = [](const std::string& text) { mixed(both, text); };
    const std::string air("idealGas; p0 1e5; carrier { type air; }");
    EXPECT_ANY_THROW(with(air + given));
    EXPECT_ANY_THROW(with(air + "vapour { type steam; } diffusivity { type"
        " Fuller; }"));
    EXPECT_ANY_THROW(with(air + "vapours { steam { type steam; } }"
        "diffusivity { type Fuller; }"));
    EXPECT_ANY_THROW(with(air + "diffusivity { type Knudsen; }"));
    EXPECT_TRUE
    (
        contains
        (
            message([&] { with(air + given); }), "water-ethanol"
        )
    );
    EXPECT_ANY_THROW
    (
        with
        (
            air + "diffusivity { type Fuller; pairs { iron-water { D0 1; } } }"
        )
    );
    EXPECT_ANY_THROW
    (
        with
        (
            "constant; p0 1e5; Wc 29; rho 1; D (1e-5); Cp 1; kappa 1; mu 1;"
        )
    );
}
