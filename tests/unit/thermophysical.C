/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Liquids and gases against tables (reference/water.csv, ethanol.csv, air.csv)
// and hand calculation

#include <cmath>
#include <gtest/gtest.h>
#include "entries.H"
#include "gasMixture.H"
#include "liquidProperties.H"
#include "saturation.H"
#include "table.H"

using namespace Foam;
using namespace Foam::dew;

namespace
{

autoPtr<liquidModel> liquid(const std::string& text)
{
    return liquidModel::New(entries("type " + text));
}

// A gas of one vapour, at its own pressure
struct oneVapour
{
    liquidMixture liquids;

    autoPtr<gasMixture> gas;

    oneVapour(const std::string& text, const std::string& liquid)
    :
        liquids(entries("type " + liquid)),
        gas(gasMixture::New(entries("type " + text), liquids))
    {}

    const liquidModel& liquid() const { return liquids.liquid(0); }
    scalar p() const { return gas->p0(); }
    bool uniformDensity() const { return gas->uniformDensity(); }

    scalar Y(const scalar x) const { return gas->Y(x); }
    scalar x(const scalar Y) const { return gas->x(Y); }
    scalar dYdx(const scalar x) const { return gas->dYdx(x); }
    scalar dxdY(const scalar Y) const { return gas->dxdY(Y); }
    scalar W(const scalar Y) const { return gas->W(scalarField(1, Y)); }

    scalar rho(const scalar Y, const scalar T) const
    {
        return gas->rho(p(), T, scalarField(1, Y));
    }
    scalar D(const scalar T) const
    {
        return gas->DY(0, p(), T, scalarField(1, Zero));
    }
    scalar Cp(const scalar Y, const scalar T) const
    {
        return gas->Cp(T, scalarField(1, Y));
    }
    scalar CpVapour(const scalar T) const { return gas->CpVapour(0, T); }
    scalar kappa(const scalar Y, const scalar T) const
    {
        return gas->kappa(T, scalarField(1, Y));
    }
    scalar mu(const scalar Y, const scalar T) const
    {
        return gas->mu(T, scalarField(1, Y));
    }

    scalar xs(const scalar T) const
    {
        return saturation::xs(liquid(), p(), T);
    }
    scalar Ys(const scalar T) const
    {
        return saturation::Ys(liquid(), gas(), p(), T);
    }
    scalar dYsdT(const scalar T) const
    {
        return saturation::dYsdT(liquid(), gas(), p(), T);
    }
    scalar Yinf(const scalar RH, const scalar T) const
    {
        return saturation::Yinf(liquid(), gas(), RH, p(), T);
    }
};

autoPtr<oneVapour> gas(const std::string& text, const std::string& liquid)
{
    return autoPtr<oneVapour>(new oneVapour(text, liquid));
}

const std::string H2O("library; liquid H2O;");

const std::string constantWater
(
    "constant; W 18; rho 997; mu 8.9e-4; Cp 4181; kappa 0.606; hv 2.4e6;"
    "sigma 0.072; "
);

const std::string humidAir
(
    "idealGas; p0 101325; carrier { type air; }"
    "diffusivity { D0 2.5e-5; Tref 298.15; pRef 101325; }"
);

void compare
(
    const liquidModel& l,
    const std::string& table,
    const std::vector<double>& tolerance
)
{
    for (const auto& row : readTable(table))
    {
        const scalar p = 101325, T = row[0];
        const std::vector<double> values
        {
            l.rho(p, T), l.mu(p, T), l.Cp(p, T), l.kappa(p, T), l.hv(p, T),
            l.pSat(T), l.sigma(p, T)
        };
        for (size_t i = 0; i < values.size(); i++)
        {
            EXPECT_NEAR(values[i]/row[i + 1], 1, tolerance[i])
                << l.name() << ' ' << T << " K, column " << i + 1;
        }
    }
}

} // End anonymous namespace


// Tolerances: what the fits of the data base promise (rho, Cp, hv 1 %, pSat
// 1 %, kappa 2 %, sigma 2 %, mu 5 %); rho of water is 1.2 % high at 363 K
TEST(liquid, waterAgainstIAPWS)
{
    compare
    (
        liquid(H2O)(), "water.csv", {0.015, 0.05, 0.01, 0.02, 0.01, 0.01, 0.02}
    );
}


// hv of the fit is 2.3 % high. Cp as shipped with v1912 is 52 % off
TEST(liquid, ethanolAgainstHandbooks)
{
    compare
    (
        liquid("library; liquid C2H5OH;")(), "ethanol.csv",
        {0.01, 0.05, 0.01, 0.02, 0.03, 0.01, 0.02}
    );
    // 2052.57 - 1.21991 T - 0.00714146 T^2 + 5.20524e-5 T^3 by hand
    EXPECT_NEAR
    (
        liquid("library; liquid C2H5OH;")->Cp(1e5, 350), 2982.5, 0.1
    );
}


// What else was wrong in v1912. CRC Handbook of Chemistry and Physics, 95th ed.:
// sigma of methanol 22.07 mN/m at 25 degrees; vapour pressure of nonane 0.57 kPa
// at 25 degrees, whose two digits allow 0.9 %, and the fit 1 %. NIST Chemistry WebBook, SRD 69: N2 at its boiling
// point 160.7e-6 Pa s; the fit is 2 % off
TEST(liquid, mendedAgainstHandbooks)
{
    EXPECT_NEAR
    (
        liquid("library; liquid CH3OH;")->sigma(1e5, 298.15)/0.02207, 1, 0.015
    );
    EXPECT_NEAR(liquid("library; liquid C9H20;")->pSat(298.15)/570, 1, 0.02);
    EXPECT_NEAR
    (
        liquid("library; liquid N2;")->mu(1e5, 77.35)/160.7e-6, 1, 0.03
    );
}


// The fit of pv at the boiling point that the library knows besides; that of
// IDEA is decane's
TEST(liquid, allBoilWhereTheyShould)
{
    label n = 0;
    for
    (
        const word& name
      : liquidProperties::dictionaryConstructorTablePtr_->sortedToc()
    )
    {
        if (name != "IDEA" && name != "CH4N2O")
        {
            EXPECT_NEAR
            (
                liquid("library; liquid " + name + ";")->Tboil(101325),
                liquidProperties::New(name)->Tb(), 0.6
            )   << name;
            n++;
        }
    }
    EXPECT_EQ(n, 28);
}


TEST(liquid, boilingPoint)
{
    const autoPtr<liquidModel> water(liquid(H2O));
    EXPECT_NEAR(water->Tboil(101325), 373.15, 0.1);

    // Ethanol 351.4 K, NIST Chemistry WebBook
    EXPECT_NEAR
    (
        liquid("library; liquid C2H5OH;")->Tboil(101325), 351.4, 0.2
    );

    for (const scalar p : {1e-3, 700.0, 3e4, 1e6, 2e7})
    {
        // The step of the iteration is 1e-10 T, and T/p dp/dT some 20
        EXPECT_NEAR(water->pSat(water->Tboil(p))/p, 1, 1e-8) << p;
    }
    EXPECT_EQ(water->Tboil(2.3e7), GREAT);
    EXPECT_NEAR(water->Tc(), 647.1, 0.1);
    EXPECT_NEAR(water->W(), 18.015e-3, 1e-6);
}


// d ln p/dT of exp(a + b/T + c ln T + d T^e) with the coefficients of
// DIPPR/NSRDS for water
TEST(liquid, slopeOfSaturationPressure)
{
    const autoPtr<liquidModel> water(liquid(H2O));
    for (const scalar T : {280.0, 298.15, 373.15, 600.0})
    {
        const scalar exact = 7258.2/(T*T) - 7.3037/T + 2*4.1653e-6*T;
        EXPECT_NEAR(water->dpSatdT(T)/water->pSat(T)/exact, 1, 1e-6) << T;
    }
}


TEST(liquid, constantWithBoilingPoint)
{
    const autoPtr<liquidModel> l
    (
        liquid(constantWater + "Tboil 373.15; pBoil 101325;")
    );

    EXPECT_NEAR(l->Tboil(101325), 373.15, 1e-9);
    EXPECT_NEAR(l->pSat(373.15), 101325, 1e-6);

    // W hv/Ru = 0.018*2.4e6/8.314462618 = 5195.765 K; 1/373.15 - 1/350 =
    // -1.772554e-4: exp(-0.9209776) = 0.398130
    EXPECT_NEAR(l->pSat(350)/101325, 0.398130, 2e-6);
    EXPECT_NEAR(l->Tboil(l->pSat(310)), 310, 1e-9);

    // Clausius-Clapeyron: dp/dT = p W hv/(Ru T^2)
    EXPECT_NEAR(l->dpSatdT(350)/l->pSat(350), 5195.765/(350.0*350), 1e-7);
    EXPECT_EQ(l->Tboil(1e20), GREAT);
    EXPECT_EQ(l->name(), "liquid");
}


TEST(liquid, constantPressure)
{
    const autoPtr<liquidModel> l
    (
        liquid(constantWater + "name water; pSat 3169;")
    );
    EXPECT_EQ(l->pSat(290), 3169);
    EXPECT_EQ(l->dpSatdT(290), 0);
    EXPECT_EQ(l->Tboil(101325), GREAT);
    EXPECT_EQ(l->rho(1e5, 400), 997);
    EXPECT_EQ(l->hv(1e5, 400), 2.4e6);
    EXPECT_EQ(l->name(), "water");
}


TEST(liquid, overrides)
{
    const autoPtr<liquidModel> l
    (
        liquid
        (
            H2O + "overrides { sigma 0.05; hl 2e6; mug 7e-6;"
            "kappa { a 0.5; b 1e-3; c 0; d 0; e 0; f 0; } }"
        )
    );
    EXPECT_EQ(l->sigma(1e5, 300), 0.05);
    EXPECT_EQ(l->hv(1e5, 300), 2e6);
    EXPECT_NEAR(l->kappa(1e5, 300), 0.8, 1e-15);
    EXPECT_EQ(l->vapourMu(1e5, 300), 7e-6);

    // The others are as before
    EXPECT_EQ(l->rho(1e5, 300), liquid(H2O)->rho(1e5, 300));

    // Also over the mended coefficients
    EXPECT_EQ
    (
        liquid("library; liquid C2H5OH; overrides { Cp 2500; }")->Cp(1e5, 300),
        2500
    );
}


TEST(liquid, refused)
{
    EXPECT_ANY_THROW(liquid("library; liquid H2SO4;"));
    EXPECT_ANY_THROW(liquid("library; liquid H2O; override { Cp 4000; }"));
    EXPECT_ANY_THROW(liquid(H2O + "overrides { cp 4000; }"));
    EXPECT_ANY_THROW(liquid(H2O + "overrides { Cp -4000; }"));
    EXPECT_ANY_THROW(liquid(H2O + "overrides { pv 3000; }"));
    EXPECT_NE
    (
        message([] { liquid(H2O + "overrides { D 2.5e-5; }"); })
            .find("gasProperties"),
        std::string::npos
    );

    EXPECT_ANY_THROW(liquid(constantWater));
    EXPECT_ANY_THROW(liquid(constantWater + "pSat 1; Tboil 3; pBoil 1;"));
    EXPECT_ANY_THROW(liquid(constantWater + "pSat 1; pBoil 1;"));

    // A temperature beyond the fits, or none
    const autoPtr<liquidModel> water(liquid(H2O));
    EXPECT_NE
    (
        message([&] { water->rho(1e5, 700); }).find("700 K"),
        std::string::npos
    );
    EXPECT_ANY_THROW(water->pSat(std::nan("")));
    EXPECT_ANY_THROW(water->sigma(1e5, -1));
}


TEST(gas, airAgainstTable)
{
    const autoPtr<oneVapour> g(gas(humidAir, H2O));

    for (const auto& row : readTable("air.csv"))
    {
        const scalar T = row[0];
        EXPECT_NEAR(g->Cp(0, T)/row[1], 1, 0.01) << T;
        EXPECT_NEAR(g->mu(0, T)/row[2], 1, 0.025) << T;
        EXPECT_NEAR(g->kappa(0, T)/row[3], 1, 0.015) << T;
    }
    // 353.09 J/K/m3 at 1 atm: 1.184 at 25 degrees
    EXPECT_NEAR(g->rho(0, 298.15), 1.184, 0.001);
}


// Steam at 373.15 K and 1 atm: Incropera & DeWitt, table A.6 (saturated:
// 2.029 kJ/kg/K, 12.02e-6 Pa s, 24.8e-3 W/m/K); an ideal gas has 1.89 kJ/kg/K
TEST(gas, vapourOfWater)
{
    const autoPtr<oneVapour> g(gas(humidAir, H2O));

    EXPECT_NEAR(g->CpVapour(373.15)/1890, 1, 0.01);
    EXPECT_EQ(g->Cp(1, 373.15), g->CpVapour(373.15));
    EXPECT_NEAR(g->mu(1, 373.15)/12.02e-6, 1, 0.05);
    EXPECT_NEAR(g->kappa(1, 373.15)/24.8e-3, 1, 0.05);
}


TEST(gas, fractions)
{
    const autoPtr<oneVapour> g(gas(humidAir, H2O));

    // 0.5*18.015/(0.5*18.015 + 0.5*28.9647) by hand
    EXPECT_NEAR(g->Y(0.5), 0.3834635, 1e-7);
    EXPECT_EQ(g->Y(0), 0);
    EXPECT_EQ(g->Y(1), 1);
    for (const scalar x : {0.0, 1e-9, 0.03, 0.5, 0.999, 1.0})
    {
        EXPECT_NEAR(g->x(g->Y(x)), x, 1e-15);
        const scalar h = 1e-5;
        EXPECT_NEAR((g->Y(x + h) - g->Y(x - h))/(2*h)/g->dYdx(x), 1, 1e-8);
        EXPECT_NEAR(g->dYdx(x)*g->dxdY(g->Y(x)), 1, 1e-14);
    }
    EXPECT_NEAR(g->W(g->Y(0.5)), 0.5*(18.015e-3 + 28.9647e-3), 1e-10);

    // Dalton: partial densities are those of the partial pressures
    const scalar Y = g->Y(0.1), rho = g->rho(Y, 300);
    EXPECT_NEAR(Y*rho/(0.1*101325*18.015e-3/(8.314462618*300)), 1, 1e-8);
}


TEST(gas, diffusivity)
{
    EXPECT_NEAR(gas(humidAir, H2O)->D(298.15), 2.5e-5, 1e-19);

    // Half the pressure, and 2^1.75
    std::string half(humidAir);
    half.replace(half.find("p0 101325"), 9, "p0 50662.5");
    EXPECT_NEAR(gas(half, H2O)->D(596.3)/(5e-5*3.363586), 1, 1e-6);

    std::string linear(humidAir);
    linear.replace(linear.find("Tref"), 4, "n 1; Tref");
    EXPECT_NEAR(gas(linear, H2O)->D(596.3), 5e-5, 1e-18);
}


// Two gases of equal mass and viscosity mix linearly in mole fractions
TEST(gas, mixtureOfLikeGases)
{
    const std::string l(constantWater + "pSat 1000;");
    const autoPtr<oneVapour> g
    (
        gas
        (
            "idealGas; p0 1e5;"
            "carrier { type constant; W 18; Cp 1000; kappa 0.02; mu 1e-5; }"
            "vapour { type constant; Cp 2000; kappa 0.04; mu 1e-5; }"
            "diffusivity { D0 1e-5; Tref 300; pRef 1e5; }",
            l
        )
    );
    EXPECT_NEAR(g->kappa(0.25, 300), 0.025, 1e-16);
    EXPECT_NEAR(g->mu(0.25, 300), 1e-5, 1e-19);
    EXPECT_NEAR(g->Cp(0.25, 300), 1250, 1e-10);
    EXPECT_FALSE(g->uniformDensity());
}


// Bird, Stewart & Lightfoot, Transport Phenomena, example 1.4-2: CO2 and N2 at
// 293 K, mu 1.462e-5 and 1.754e-5 Pa s, have phi 0.727 and 1.370. Their three
// digits allow 4e-9
TEST(gas, WilkeOfTextbook)
{
    std::string CO2(constantWater);
    CO2.replace(CO2.find("W 18"), 4, "W 44.01");
    const std::string l(CO2 + "pSat 1000;");
    const autoPtr<oneVapour> g
    (
        gas
        (
            "idealGas; p0 1e5;"
            "carrier { type constant; W 28.02; Cp 1; kappa 1; mu 1.754e-5; }"
            "vapour { type constant; Cp 1; kappa 1; mu 1.462e-5; }"
            "diffusivity { D0 1e-5; Tref 300; pRef 1e5; }",
            l
        )
    );
    const scalar x = 0.5;
    EXPECT_NEAR
    (
        g->mu(g->Y(x), 293),
        x*1.462e-5/(x + x*0.727) + x*1.754e-5/(x + x*1.370), 4e-9
    );
}


TEST(gas, constant)
{
    const std::string l(constantWater + "pSat 1000;");
    const std::string text
    (
        "constant; p0 1e5; Wc 29; rho 1.2; D 2e-5; Cp 1000; kappa 0.026;"
        "mu 1.8e-5;"
    );
    const autoPtr<oneVapour> g(gas(text, l));
    EXPECT_TRUE(g->uniformDensity());
    EXPECT_EQ(g->rho(0.5, 700), 1.2);
    EXPECT_EQ(g->D(700), 2e-5);
    EXPECT_EQ(g->CpVapour(700), 1000);
    EXPECT_EQ(gas(text + "CpVapour 1900;", l)->CpVapour(700), 1900);
    EXPECT_EQ(g->kappa(0.5, 700), 0.026);
    EXPECT_NEAR(g->xs(300), 0.01, 1e-17);
    EXPECT_NEAR(g->Ys(300), 0.18/(0.18 + 28.71), 1e-15);
    EXPECT_EQ(g->dYsdT(300), 0);
}


TEST(gas, saturation)
{
    const autoPtr<oneVapour> g(gas(humidAir, H2O));

    // Saturated air at 25 degrees: 20.1 g of water per kg of dry air (ASHRAE
    // Fundamentals (2009), chapter 1, table 2: 0.020173, with 0.4 % for the
    // gases not being ideal)
    const scalar Y = g->Ys(298.15);
    EXPECT_NEAR(Y/(1 - Y)/0.02017, 1, 0.006);

    const scalar h = 1e-3;
    EXPECT_NEAR
    (
        (
            g->Ys(298.15 + h)
          - g->Ys(298.15 - h)
        )/(2*h)/g->dYsdT(298.15), 1, 1e-6
    );

    EXPECT_EQ(g->Yinf(0, 298.15), 0);
    EXPECT_EQ(g->Yinf(1, 298.15), Y);
    EXPECT_NEAR
    (
        g->x(g->Yinf(0.4, 298.15)),
        0.4*g->xs(298.15), 1e-16
    );
    EXPECT_ANY_THROW(g->Yinf(40, 298.15));
    EXPECT_ANY_THROW(g->Yinf(std::nan(""), 298.15));
}


TEST(gas, refused)
{
    const std::string l(constantWater + "pSat 1000;");

    const auto with = [](const std::string& from, const std::string& to)
    {
        std::string text(humidAir);
        return text.replace(text.find(from), from.size(), to);
    };
    EXPECT_NO_THROW(gas(with("air", "air"), H2O));
    EXPECT_ANY_THROW(gas(with("air", "neon"), H2O));
    EXPECT_ANY_THROW(gas(with("p0 101325", "p0 0"), H2O));
    EXPECT_ANY_THROW(gas(with("D0 2.5e-5;", ""), H2O));
    EXPECT_ANY_THROW(gas(with("Tref", "n 17; Tref"), H2O));
    EXPECT_ANY_THROW(gas(with("p0", "vapor { } p0"), H2O));
    EXPECT_ANY_THROW
    (
        gas
        (
            with
            (
                "p0",
                "vapour { type constant; W 18; Cp 1; kappa 1; mu 1; } p0"
            ),
            H2O
        )
    );

    // A liquid without a vapour
    EXPECT_NE
    (
        message([&] { gas(humidAir, l); }).find("vapour { type constant"),
        std::string::npos
    );
    EXPECT_ANY_THROW
    (
        gas
        (
            "constant; p0 1e5; Wc 0.029; rho 1.2; D 2e-5; Cp 1000;"
            "kappa 0.026; mu 1.8e-5;", l
        )
    );
}
