/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Eddy interaction in homogeneous turbulence, k 1.5 and epsilon such that an
// eddy has length and life 1 and each component of its velocity variance 1

#include <cmath>
#include <gtest/gtest.h>
#include "IStringStream.H"
#include "seenVelocityModel.H"

using namespace Foam;
using namespace Foam::dew;

namespace
{

const double k = 1.5, epsilon = 0.164*std::pow(k, 1.5);


autoPtr<seenVelocityModel> model(const std::string& more = "")
{
    IStringStream is("type eddyInteraction; " + more);
    return seenVelocityModel::New(dictionary(is));
}


// One particle, its eddies and its path
struct tracked
{
    std::vector<double> memory = std::vector<double>(7, 0);
    vector x = Zero;
    vector v = Zero;
    label id = 0;

    // Velocity seen over the step dt in a mean flow U
    vector see
    (
        const seenVelocityModel& eddies,
        const double dt,
        const vector& U = Zero
    )
    {
        particle p;
        p.U = v;
        p.id = id;
        p.memory = memory.data();
        carrier c;
        c.U = U;
        c.deltaT = dt;
        c.motion.k = k;
        c.motion.epsilon = epsilon;
        eddies.correct(p, c);
        return c.U;
    }

    // A step as a tracer
    void follow(const seenVelocityModel& eddies, const double dt)
    {
        v = see(eddies, dt);
        x += dt*v;
    }
};

} // End anonymous namespace


// Variance of a component, 60 000 samples: 1 +- 4 (2/60 000)^1/2; mean and
// products of two 0 +- 4 (1/60 000)^1/2
TEST(eddies, velocities)
{
    const autoPtr<seenVelocityModel> eddies(model("seed 1;"));
    double square = 0, mean = 0, cross = 0, fourth = 0;
    const int n = 20000;

    for (int i = 0; i < n; i++)
    {
        tracked one;
        one.id = i + 1;
        const vector u(one.see(*eddies, 0.1));
        for (direction d = 0; d < 3; d++)
        {
            mean += u[d]/(3*n);
            square += sqr(u[d])/(3*n);
            fourth += pow4(u[d])/(3*n);
            cross += u[d]*u[(d + 1)%3]/(3*n);
        }
    }
    EXPECT_NEAR(square, 1, 0.023);
    EXPECT_NEAR(mean, 0, 0.016);
    EXPECT_NEAR(cross, 0, 0.016);
    // Normal: 3 +- 4 (96/60 000)^1/2
    EXPECT_NEAR(fourth, 3, 0.16);
}


// Tracers, all in a new eddy at t = 0: the variance of their place is t^2 up to
// the life T = 1 of an eddy, D = t; after n eddies n T^2, D = (2k/3) T/2 = 1/2.
// 30 000 samples: +- 4 (2/30 000)^1/2
TEST(eddies, dispersion)
{
    const autoPtr<seenVelocityModel> eddies(model("seed 7;"));
    const int n = 10000, steps = 200;
    const double dt = 0.1;
    std::vector<double> variance(steps + 1, 0);

    for (int i = 0; i < n; i++)
    {
        tracked one;
        one.id = i + 1;
        for (int step = 1; step <= steps; step++)
        {
            one.follow(*eddies, dt);
            variance[step] += magSqr(one.x)/(3*n);
        }
    }
    for (const int step : {1, 5, 10})
    {
        EXPECT_NEAR(variance[step]/sqr(step*dt), 1, 0.033) << step;
    }
    // Half the growth over a step: t for t < T
    for (const int step : {2, 5, 9})
    {
        const double D =
            (variance[step + 1] - variance[step - 1])/(4*dt);
        EXPECT_NEAR(D/(step*dt), 1, 0.033) << step;
    }
    for (const int step : {100, 200})
    {
        EXPECT_NEAR(variance[step]/(2*step*dt)/0.5, 1, 0.033) << step;
    }
}


// An eddy stays for ten steps of a tenth of its life; one whose particle is
// swept through at 20 times its speed for a twentieth of it
TEST(eddies, howLongTheyStay)
{
    const autoPtr<seenVelocityModel> eddies(model("seed 3;"));

    tracked still;
    still.id = 5;
    vector last(still.see(*eddies, 0.1));
    for (int step = 1; step < 100; step++)
    {
        // It follows the fluid
        still.v = last;
        const vector u(still.see(*eddies, 0.1));
        EXPECT_EQ(u == last, step % 10 != 0) << step;
        last = u;
    }

    tracked swept;
    swept.id = 5;
    swept.v = vector(1000, 0, 0);
    int met = 1;
    last = swept.see(*eddies, 1e-5);
    for (int step = 1; step < 1000; step++)
    {
        const vector u(swept.see(*eddies, 1e-5));
        met += u != last;
        last = u;
    }
    // 1e-3 each, less what the eddy's own speed of up to 4 in 1000 changes
    EXPECT_NEAR(met, 10, 1);
}


// By particle, seed and number of the eddy: not by order, and with the memory
// alone it goes on elsewhere
TEST(eddies, byParticle)
{
    const autoPtr<seenVelocityModel> eddies(model("seed 3;"));
    const autoPtr<seenVelocityModel> again(model("seed 3;"));
    const autoPtr<seenVelocityModel> other(model("seed 4;"));

    std::vector<tracked> forth(20), back(20);
    for (int i = 0; i < 20; i++)
    {
        forth[i].id = back[i].id = i + 1;
    }
    for (int step = 0; step < 35; step++)
    {
        for (int i = 0; i < 20; i++)
        {
            forth[i].follow(*eddies, 0.1);
        }
        for (int i = 19; i >= 0; i--)
        {
            back[i].follow(step < 15 ? *eddies : *again, 0.1);
        }
    }
    for (int i = 0; i < 20; i++)
    {
        EXPECT_EQ(forth[i].x, back[i].x);
        EXPECT_NE(forth[i].x, forth[(i + 1)%20].x);
    }

    tracked one, same;
    one.id = same.id = 1;
    EXPECT_NE(one.see(*eddies, 0.1), same.see(*other, 0.1));
}


// Nothing where there is no turbulence, and the mean flow stays what it is
TEST(eddies, laminar)
{
    const autoPtr<seenVelocityModel> eddies(model("seed 3; C 0.2;"));
    std::vector<double> memory(7, 0);
    particle p;
    p.memory = memory.data();
    carrier c;
    c.U = vector(1, 2, 3);
    c.deltaT = 0.1;
    eddies->correct(p, c);
    EXPECT_EQ(c.U, vector(1, 2, 3));
}


TEST(eddies, refused)
{
    EXPECT_ANY_THROW(model());
    EXPECT_ANY_THROW(model("seed 1; C 0;"));
    EXPECT_ANY_THROW(model("seed 1; colour red;"));
    EXPECT_ANY_THROW(model("seed 1.5;"));
}
