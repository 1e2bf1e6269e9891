/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// The history force: integrals of its kernels against reference/history.csv,
// and the law step by step under a given slip

#include <cmath>
#include <gtest/gtest.h>
#include "historyKernel.H"
#include "IStringStream.H"
#include "particleForce.H"
#include "table.H"

using namespace Foam;
using namespace Foam::dew;

namespace
{

const double pi = 3.14159265358979324;

// Radius, viscosities
const double R = 5e-4, nu = 1e-6, mu = 1e-3;

// Force over that of the kernel s^-1/2
const double unit = 6*pi*mu*R*R/std::sqrt(pi*nu);


autoPtr<historyKernel> kernel(const std::string& name)
{
    IStringStream is("kernel " + name + ";");
    return historyKernel::New(dictionary(is));
}


// The law on one particle at rest, in a fluid of given velocity
class pulled
{
    autoPtr<particleForce> law_;
    std::vector<double> memory_;

public:

    explicit pulled(const std::string& entries)
    {
        IStringStream is("type history; " + entries);
        law_ = particleForce::New(dictionary(is));
        memory_.assign(law_->needs().memory, 0);
    }

    // Mean force along x over the step h, in which U goes on with DUDt
    double operator()(const double U, const double DUDt, const double h)
    {
        particle p;
        p.d = 2*R;
        p.memory = memory_.data();
        carrier c;
        c.U = vector(U, 0, 0);
        c.rho = mu/nu;
        c.mu = mu;
        c.deltaT = h;
        c.motion.DUDt = vector(DUDt, 0, 0);
        const forceSuSp f(law_->force(p, c));
        EXPECT_EQ(f.Su.y(), 0);
        EXPECT_GT(f.addedMass, 0);
        return f.Su.x();
    }
};


// In-phase part and that 90 degrees ahead of what a sinusoidal slip, omega 1,
// has given in its last of some periods
std::pair<double, double> response
(
    const std::string& entries,
    const int perPeriod,
    const int periods
)
{
    pulled force(entries);
    const double h = 2*pi/perPeriod;

    std::pair<double, double> sum(0, 0);
    for (int i = 0; i < periods*perPeriod; i++)
    {
        const double t = i*h;
        const double F =
            force(std::sin(t), (std::sin(t + h) - std::sin(t))/h, h)/unit;
        if (i >= (periods - 1)*perPeriod)
        {
            // F is the mean over the step
            const double mean = 2/h*std::sin(0.5*h)*perPeriod/2;
            sum.first += F*std::sin(t + 0.5*h)/mean;
            sum.second += F*std::cos(t + 0.5*h)/mean;
        }
    }
    return sum;
}

} // End anonymous namespace


// Basset: differences of close numbers lose three digits. Mei and Adrian:
// Gauss' rule, worst for the oldest step at the highest slip
TEST(history, integralsOfKernels)
{
    const autoPtr<historyKernel> both[] =
    {
        kernel("Basset"), kernel("MeiAdrian")
    };
    const double tolerance[] = {1e-12, 2e-5};

    for (const auto& row : readTable("history.csv"))
    {
        const historyFlow f{row[0], row[1], row[2]};
        const double a = row[3], b = row[4], h = row[5];
        for (int k = 0; k < 2; k++)
        {
            const double* exact = &row[6 + 3*k];
            const historyKernel& K = *both[k];
            EXPECT_NEAR(K.integral(f, a, b)/exact[0], 1, tolerance[k]);
            EXPECT_NEAR(K.newest(f, h)/exact[1], 1, tolerance[k]);
            EXPECT_NEAR(K.interval(f, a, b, h)/exact[2], 1, tolerance[k])
                << k << ' ' << a/h << ' ' << row[2];
            EXPECT_NEAR(K.jump(f, a, h)*h/K.integral(f, a, a + h), 1, 1e-15);
        }
    }
}


// Basset's kernel for small ages, 2 R nu fH^3/(pi w^3) s^-2 for large ones
TEST(history, limitsOfMeiAdrian)
{
    const autoPtr<historyKernel> one(kernel("MeiAdrian")), two(kernel("Basset"));
    const double w = 0.02, fH = 0.75 + 0.105*20;
    const historyFlow f{R, nu, w};

    // Relative width 1e-4: 1e-9 of curvature. K/KBasset - 1 ~ s^(3/4)
    const auto mean = [&f](const historyKernel& K, const double s)
    {
        return K.integral(f, s, 1.0001*s)/(1e-4*s);
    };
    EXPECT_NEAR(mean(*one, 1e-12)/mean(*two, 1e-12), 1, 1e-6);
    for (const double s : {1e6, 1e7})
    {
        const double late = 2*R*nu*std::pow(fH/w, 3)/pi/(s*s*1.0001);
        EXPECT_NEAR(mean(*one, s)/late, 1, 1e-3) << s;
    }

    // Without slip it is Basset's at all ages
    const historyFlow still{R, nu, 0};
    EXPECT_NEAR
    (
        one->integral(still, 0.1, 5)/two->integral(still, 0.1, 5), 1, 1e-12
    );
}


// int_0^t (t - s)^-1/2 ds = 2 t^1/2, its mean over a step, for any steps
TEST(history, uniformAcceleration)
{
    for (const double growth : {1.0, 1.1, 0.9})
    {
        pulled force("kernel Basset; window 100; intervals 30;");
        double t = 0, h = 0.1;
        for (int i = 0; i < 30; i++)
        {
            const double mean =
                4.0/3*(std::pow(t + h, 1.5) - std::pow(t, 1.5))/h;
            EXPECT_NEAR(force(t, 1, h)/(unit*mean), 1, 1e-12) << i;
            t += h;
            h *= growth;
        }
    }
}


// int K of a jump at the start, t^-1/2, its mean over a step; once beyond the
// window, the tail
TEST(history, impulsiveStart)
{
    const std::string entries("kernel Basset; window 1; intervals 20; ");
    pulled force(entries), shortened(entries + "tail off;");
    pulled without(entries + "impulsiveStart off;");

    const double h = 0.125;
    for (int i = 0; i < 30; i++)
    {
        const double t = i*h;
        const double basset = 2*(std::sqrt(t + h) - std::sqrt(t))/h;
        const double tail =
            2*std::exp(0.5)*(std::exp(-t/2) - std::exp(-(t + h)/2))/h;

        const bool inside = t < 1;
        EXPECT_NEAR(force(1, 0, h)/unit, inside ? basset : tail, 1e-12) << i;
        EXPECT_NEAR(shortened(1, 0, h)/unit, inside ? basset : 0, 1e-12) << i;
        EXPECT_EQ(without(1, 0, h), 0);
    }
}


// Steady state: pi^1/2 of the slip at 45 degrees ahead, in both parts
// (pi/2)^1/2, and for a window the integrals of windows.csv. The slip is linear
// over a step of 1/200: 1e-3, the window ends half a step off at most
TEST(history, sinusoid)
{
    // Window of four to thirty radians, with its tail: what it costs of Basset's
    const double errors[] = {0.05, 0.08, 0.04, 0.03};

    const double half = std::sqrt(pi/2);
    int k = 0;
    for (const auto& row : readTable("windows.csv"))
    {
        const int perPeriod = row[0] < 10 ? 120 : 36;
        const std::string entries
        (
            "kernel Basset; intervals 140; window " + std::to_string(row[0])
          + "; tail "
        );
        for (const bool tail : {false, true})
        {
            const auto [in, ahead] =
                response(entries + (tail ? "on;" : "off;"), perPeriod, 25);
            EXPECT_NEAR(in, row[tail ? 3 : 1], 0.05) << row[0];
            EXPECT_NEAR(ahead, row[tail ? 4 : 2], 0.05) << row[0];
            if (tail)
            {
                EXPECT_NEAR(in, half, errors[k]) << row[0];
                EXPECT_NEAR(ahead, half, errors[k]) << row[0];
            }
        }
        k++;
    }
}


// Along its path through a fluid with a gradient, a particle at rest in a
// steady flow sees no acceleration: DU/Dt = U.grad U
TEST(history, accelerationAlongThePath)
{
    IStringStream is
    (
        "type history; kernel Basset; window 1; impulsiveStart off;"
    );
    const autoPtr<particleForce> law(particleForce::New(dictionary(is)));
    std::vector<double> memory(law->needs().memory, 0);

    particle p;
    p.d = 2*R;
    p.memory = memory.data();
    carrier c;
    c.U = vector(0.1, 0.2, 0.3);
    c.rho = mu/nu;
    c.mu = mu;
    c.deltaT = 0.1;
    c.motion.gradU = tensor(1, 2, 3, 4, 5, 6, 7, 8, -6);
    c.motion.DUDt = c.U & c.motion.gradU;
    const forceSuSp f(law->force(p, c));
    EXPECT_NEAR(mag(f.Su), 0, 1e-14*f.addedMass*mag(c.motion.DUDt));
}


TEST(history, refused)
{
    for
    (
        const char* entries :
        {
            "kernel Basset;", "kernel Basset; window 0;", "window 1;",
            "kernel Boussinesq; window 1;",
            "kernel MeiAdrian; window 1; tail on;",
            "kernel Basset; window 1; intervals 0;",
            "kernel Basset; window 1; intervals 141;",
            "kernel Basset; window 1; colour red;"
        }
    )
    {
        EXPECT_ANY_THROW(pulled{entries}) << entries;
    }

    // Five steps and the jump are in the window of five and a half
    pulled force("kernel Basset; window 0.55; intervals 5;");
    for (int i = 0; i < 5; i++)
    {
        EXPECT_NO_THROW(force(1, 0, 0.1)) << i;
    }
    EXPECT_ANY_THROW(force(1, 0, 0.1));
}
