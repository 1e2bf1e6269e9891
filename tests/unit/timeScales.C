/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Time scales of contact against numbers computed by hand

#include <gtest/gtest.h>
#include "liggghtsTimeStep.H"

using namespace Foam::dew;

TEST(timeScales, rayleigh)
{
    // R 75 um and 120 um, rho 7870, E 200 GPa, nu 0.29: G = 77.519 GPa.
    // pi R sqrt(rho/G)/(0.1631 nu + 0.8766) = 8.12646e-8 s, 1.30023e-7 s
    const double G = 200e9/(2*1.29);
    EXPECT_NEAR(rayleighTime(75e-6, 7870, G, 0.29)/8.12585e-8, 1, 1e-5);
    EXPECT_NEAR(rayleighTime(120e-6, 7870, G, 0.29)/1.300136e-7, 1, 1e-5);
}

TEST(timeScales, hooke)
{
    // Tayeb (2021), eq. 2.7, R 75 um, rho 7870, E* 1.0918e11, v_ch 1 m/s:
    // K_n = 2.83e5 N/m for two equal spheres (three digits given)
    const double m = 7870*4.0/3*3.14159265358979*75e-6*75e-6*75e-6;
    EXPECT_NEAR(hookeStiffness(37.5e-6, m/2, 1.0918e11, 1)/2.83e5, 1, 2e-3);

    // Half period of a spring of 1 N/m with 1 kg
    EXPECT_NEAR(hookeTime(1, 1), 3.14159265358979, 1e-14);
}
