/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
/*
Class
    Foam::dew::fixIntegrate

Description
    fix ID all dew/integrate [overdamped]

    The time integrator of the particles: velocity Verlet in which the bulk
    forces Sp (U - v) + Su, the bulk torques Tp (Omega - omega) + Tu and the
    bulk heat Qp (Tf - T) + Qu are integrated exactly (exponentialRelaxation)
    with the particle's current velocity at every sub-step. Without them it is
    the velocity Verlet step of fix nve/sphere, operation by operation.

    What a particle received from these terms, the impulse m dv - F dt (and
    angular impulse and heat), is accumulated with it and migrates with it. So
    do its velocity at the start, the kick given then (as a velocity), and Sn,
    the part of the force Su that is not counted as received.

    With an added mass ma the particle moves as one of mass m + ma, but what
    it received is counted with m: the momentum of the fluid it carries along
    is the fluid's.

    The memory of laws is any number of columns (needMemory), which the fix
    only keeps and lets migrate.

    Colloids (fixIntegrateColloids.cpp) have more columns, made when they are
    first needed: Brownian motion (brownianMotion) and the force of a liquid's
    surface, of a skin (surfaceSpring) or of a contact line (sphereInSurface,
    or planePull, by its tangent), exact at any sub-step. The surface's impulse
    is not counted as received; the noise is, with the drag that takes it up
    again: what is left of both is the particle's thermal momentum.

    Before the surface there may be a film (filmForces). Its drainage is a
    friction, over a sub-step the mean over the particle's way, with its noise
    and its drift.

    Overdamped, particles have no inertia:

        v = U + (F + Su)/Sp,    omega = Omega + (M + Tu)/Tp

    by one explicit step, without a limit from the drag but with one from the
    contacts, dt < Sp/k. Their impulse is that of the drag on this velocity.
    Without Tp it is that of a sphere in creeping flow, Sp d^2/3, in a fluid
    that does not rotate. Contact laws see the displacement over dt, with the
    noise. There is no noise of rotation.

    Beside plane walls (hinderingWalls) the mobility 1/Sp is less, by that of
    the nearest wall along its normal n and along it (wallMobility). Without
    inertia the step has Ito's drift:

        v = (M/Sp).(F + Su) + kT/Sp dMn/dh n

    With inertia the friction of a sub-step is that at its start, Sp/Mn and
    Sp/Mp, relaxed exactly, with its noise and what such a step lacks of that
    drift (mobilityDrift). The fluid is at rest.

    Force and torque of the last sub-step are written to restarts, because
    damping contact forces depend on the half-step velocity and cannot be
    recomputed: a run continued from a restart, or after an insertion, starts
    from the very forces it was left with.

    Errors: notFinite is thrown for a velocity that is not a number.

SourceFiles
    fixIntegrate.cpp
    fixIntegrateColloids.cpp
    fixIntegrateOverdamped.cpp
    fixIntegrateWalls.cpp
\*---------------------------------------------------------------------------*/

#ifndef dew_fixIntegrate_h
#define dew_fixIntegrate_h

#include <mpi.h>
#include <cstdint>
#include <vector>
#include "fix.h"
#include "departedParticle.H"
#include "../filmForces.H"

namespace LAMMPS_NS { class FixPropertyAtom; class FixPropertyGlobal; }

namespace Foam
{
namespace dew
{

//- Thrown for a particle whose velocity is not a number, engine units
struct notFinite
{
    int id;
    long step;
    double x[3];
};


class fixIntegrate
:
    public LAMMPS_NS::Fix
{
public:

    //- Columns of what is stored with each particle, engine units: first those
    //  of every sub-step, in whole cache lines
    enum column
    {
        // halfStep, fullStep, halfTurn and heatStep are derived at the start
        // of a call: dt/m phi(...); without inertia the first and third are
        // the mobilities of translation and rotation
        Su = 0, Sp = 3, U = 4, halfStep = 7,
        fullStep = 8, impulse = 9, Tu = 12, Tp = 15,
        Omega = 16, halfTurn = 19, angularImpulse = 20, heat = 23,
        Qu = 24, Qp = 25, Tf = 26, heatStep = 27,
        Sn = 28, startVelocity = 31, kick = 34, addedMass = 37,
        keptForce = 38, keptTorque = 41, kept = 44,
        nColumns = 48,
        nKept = 7,      // keptForce, keptTorque, kept
        mobility = halfStep, turning = halfTurn
    };

    //- Columns of colloids, engine units
    enum colloidColumn
    {
        // derived at the start of a call: ornsteinUhlenbeck; without inertia
        // noiseV alone, the speed of diffusionStep
        kT = 0, noiseV = 1, noiseXV = 2, noiseX = 3,
        // within a sub-step: change of v not yet made; normal at the particle
        // (zero without a force) and distance of its first half
        pending = 4, springDistance = 7, springNormal = 8,
        // centre from the moving foot of the surface, normal there
        offset = 11, normal = 14, speed = 17, curvature = 18, stiffness = 19,
        tension = 20, angle = 21, planePull = 22,
        // coefficient of drainage; of this sub-step its friction along
        // springNormal and the speed of filmDrift
        drainage = 23, filmFriction = 24, filmSpeed = 25,
        // of this sub-step, beside walls with inertia: normal of the nearest,
        // mobility relative to 1/Sp along it and across
        wallNormal = 26, wallMn = 29, wallMp = 30,
        // an odd number of cache lines, so that their sets are all used
        nColloidColumns = 40
    };

private:

    //- nColumns values a particle
    double** data_;

    //- nColloidColumns values a particle, null without colloids
    double** colloid_;

    //- nMemory_ values a particle, null without
    double** memory_;
    int nMemory_;

    //- Are there bulk terms at all, heat, a surface of the liquid?
    bool loaded_, heated_, surfaces_;

    //- No inertia; seed of the noise
    const bool overdamped_;
    uint64_t seed_;

    //- Point and normal of plane walls that hinder, least gap for it
    std::vector<double> planes_;
    double minGap_;

    //- Before the surface
    surfaceFilm film_;

    double maxRadius_;

    //- Half sub-steps since load()
    long halves_;

    LAMMPS_NS::FixPropertyAtom *temperature_, *heatFlux_;
    LAMMPS_NS::FixPropertyGlobal* capacity_;

    std::vector<departedParticle> departed_;

    //- Throw notFinite for the first velocity that is not a number
    void checkFinite() const;

    //- Half a sub-step of rotation: columns, torque, spin, moment of inertia
    static void turn
    (
        double* d, const double* torque, double* omega, double I, double dtf
    )
    {
        for (int k = 0; k < 3; k++)
        {
            const double dw =
                (torque[k] + d[Tu+k] + d[Tp]*(d[Omega+k] - omega[k]))
               *d[halfTurn];
            omega[k] += dw;
            d[angularImpulse+k] += I*dw - dtf*torque[k];
        }
    }

    //- Moment of inertia of a sphere, over m R^2 and of a particle
    static constexpr double inertia = 0.4;
    static double inertiaOf(double m, double R) { return inertia*m*R*R; }

    // Colloids

        static double dot(const double* a, const double* b)
        {
            return a[0]*b[0] + a[1]*b[1] + a[2]*b[2];
        }

        //- Is there a surface, that pulls this particle, or a film on a way
        //  from it? How far out is it, normal
        bool surfaced(const double* c) const
        {
            return
                c[stiffness] > 0 || c[tension] > 0
             || (film_.reach() > 0 && dot(c + normal, c + normal) > 0);
        }
        bool pulled
        (
            const double* c, double R, double way, double& delta, double* m
        ) const;

        //- Of the film, thickness h: the friction over the coming sub-step,
        //  filmFriction and filmSpeed
        void drain(int i, double delta, const double* m);

        //- Its force along the normal, and how that falls with delta
        double pull(const double* c, double R, double delta, double& k) const;

        //- Way out of the surface over a time t with a friction of the film;
        //  change of v and of the
        //  received impulse with respect to the relaxation without it
        double spring
        (
            int i, double delta, const double* m, double t, double friction,
            double& dv, double& dJ
        ) const;

        //- Before the relaxation of the first and second half
        void beforeFirst();
        void beforeSecond();

        //- After that of the first half: noise and surfaces
        void afterFirst();

        //- Correction of the noise g along the normal for the film
        void filmNoise(int i, const double* g);

        //- Without inertia: velocity over the coming sub-step without noise,
        //  and its factor for the noise along the normal m. Returns the share
        //  of U that carries the particle; without, it is at rest
        double drift(int i, double* v, double* m, double& along) const;
        void loadOverdamped(int i);
        void spin(int i) const;

        //- Of the nearest plane wall: normal, mobility relative to 1/Sp along
        //  it and across, d/dh of the first
        struct nearWall { const double* n; double normal, parallel, slope; };
        nearWall hindrance(int i) const;

        //- Noise of a sub-step as a velocity; is there any?
        bool noise(int i, double* g) const;

        //- With inertia beside walls: first half with the noise, second half
        void firstBeside(int i);
        void secondBeside(int i);

        //- Relaxation of a velocity over a time: by the friction along the wall's
        //  normal and across it; way, if wanted
        void relaxBeside
        (
            int i, double t, double* dv, double* way
        ) const;

        //- Velocity beside walls
        void hinder(const nearWall&, int i, double* v) const;

        //- Offset from the surface after a sub-step with velocity v
        void follow(int i, const double* v);

        //- One particle, by what is there: nothing else, walls, a surface
        void moveFree(int i);
        void moveHindered(int i);
        void moveSurfaced(int i);
        void moveOverdamped();

public:

    fixIntegrate(LAMMPS_NS::LAMMPS*, int narg, char** arg);

    ~fixIntegrate();

    //- Seed of the noise
    void seed(uint64_t value) { seed_ = value; }

    //- On all ranks
    void hinderingWalls(const std::vector<double>& planes, double minGap)
    {
        planes_ = planes;
        minGap_ = minGap;
        needColloids();
    }

    //- Film before the surface, from the next load() on
    void film(const surfaceFilm& laws) { film_ = laws; }

    bool overdamped() const { return overdamped_; }

    //- Contact distance over the sum of radii that ended contacts need
    double touchFactor() const;

    //- Make the columns of colloids; on all ranks
    void needColloids();

    bool colloids() const { return colloid_; }

    //- Make n columns for the memory of laws; on all ranks
    void needMemory(int n);

    int nMemory() const { return nMemory_; }

    double* memoryOf(int i) { return memory_[i]; }
    const double* memoryOf(int i) const { return memory_[i]; }

    //- Columns of colloids of a particle
    double* colloid(int i) { return colloid_[i]; }

    double* operator[](int i) { return data_[i]; }
    const double* operator[](int i) const { return data_[i]; }

    //- Temperature array of the engine, null without a heat balance
    double* temperature() const;

    void expect(double maxRadius, bool heated);

    //- Is there a heat balance?
    bool heated() const { return heated_; }

    //- Are there bulk terms?
    bool loaded() const { return loaded_; }

    //- Time since load()
    double elapsed() const;

    //- Heat capacity m cp of a particle
    double heatCapacity(int i) const;

    //- Impulse received, without that of Sn
    void received(int i, double* J) const;

    //- Bulk terms have been written, or are gone: set the derived columns,
    //  note the velocities at the start. The same on all ranks
    void load(bool anyTerm, bool surfaces);

    //- The sub-steps of a call are over: velocities as others may see them
    void finish();

    //- Store force and torque so that the next setup returns to them
    void keepForces();

    std::vector<departedParticle> departed();

    // Interface of the engine

        int setmask() override;
        void init() override;
        void setup(int) override;
        void initial_integrate(int) override;
        void final_integrate() override;
        void pre_exchange() override;

        double min_rad(int) override { return maxRadius_; }
        double max_rad(int) override { return maxRadius_; }

        // Types exist before the first particle does
        int min_type() override { return 1; }
        int max_type() override;

        void grow_arrays(int) override;
        void copy_arrays(int i, int j, int) override;
        void set_arrays(int) override;
        int pack_exchange(int, double*) override;
        int unpack_exchange(int, double*) override;
        int pack_restart(int, double*) override;
        void unpack_restart(int, int) override;
        int size_restart(int) override { return nKept + 1; }
        int maxsize_restart() override { return nKept + 1; }
        double memory_usage() override;
};

} // End namespace dew
} // End namespace Foam

#endif
