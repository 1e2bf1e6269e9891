/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

#include "fixIntegrate.h"
#include "../brownianMotion.H"

#include <cmath>
#include <cstring>

#include "atom.h"
#include "domain.h"
#include "error.h"
#include "fix_property_atom.h"
#include "fix_property_global.h"
#include "force.h"
#include "memory.h"
#include "modify.h"
#include "neighbor.h"
#include "properties.h"
#include "update.h"

using namespace LAMMPS_NS;

// Distance up to which ended contacts are noticed, over the sum of radii;
// without inertia particles may jump a share of their radius in a sub-step
static const double touchShell = 1.01;
static const double wideTouchShell = 1.1;


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::dew::fixIntegrate::checkFinite() const
{
    // One comparison catches NaN and infinity in any component
    const int n = 3*atom->nlocal;
    const double* v = n ? atom->v[0] : nullptr;
    int bad = 0;

    for (int i = 0; i < n; i++)
    {
        bad |= !(std::fabs(v[i]) < 1e150);
    }

    for (int i = 0; bad && i < n; i++)
    {
        if (!(std::fabs(v[i]) < 1e150))
        {
            notFinite e;
            e.id = atom->tag[i/3];
            e.step = long(update->ntimestep);
            std::memcpy(e.x, atom->x[i/3], sizeof(e.x));
            throw e;
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::fixIntegrate::fixIntegrate(LAMMPS* lmp, int narg, char** arg)
:
    Fix(lmp, narg, arg),
    data_(nullptr),
    colloid_(nullptr),
    memory_(nullptr),
    nMemory_(0),
    loaded_(false),
    heated_(false),
    surfaces_(false),
    overdamped_(narg == 4 && std::strcmp(arg[3], "overdamped") == 0),
    seed_(1),
    minGap_(0),
    maxRadius_(0),
    halves_(0),
    temperature_(nullptr),
    heatFlux_(nullptr),
    capacity_(nullptr)
{
    if (narg != 3 && !overdamped_)
    {
        error->fix_error(FLERR, this, "takes no argument but overdamped");
    }

    time_integrate = 1;
    create_attribute = 1;
    restart_peratom = 1;
    restart_pbc = 1;      // positions are wrapped into the box when written

    // Without a shell around touch, where it notes that contacts have ended,
    // the engine forgets a finished contact only when it rebuilds its lists:
    // a second touch before that would start with the first one's tangential
    // spring, and results would depend on when lists are built
    neighbor->register_contact_dist_factor(touchFactor());

    grow_arrays(atom->nmax);
    atom->add_callback(0);
    atom->add_callback(1);

    // Without a restart there is no atom->extra to come later
    for (int i = 0; i < atom->nlocal; i++)
    {
        set_arrays(i);
    }
}


Foam::dew::fixIntegrate::~fixIntegrate()
{
    atom->delete_callback(id, 0);
    atom->delete_callback(id, 1);
    memory->destroy(data_);
    memory->destroy(colloid_);
    memory->destroy(memory_);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

double Foam::dew::fixIntegrate::touchFactor() const
{
    return overdamped_ ? wideTouchShell : touchShell;
}


double* Foam::dew::fixIntegrate::temperature() const
{
    return temperature_ ? temperature_->vector_atom : nullptr;
}


void Foam::dew::fixIntegrate::expect(const double maxRadius, const bool heated)
{
    maxRadius_ = maxRadius;
    heated_ = heated;
}


double Foam::dew::fixIntegrate::elapsed() const
{
    return 0.5*halves_*update->dt;
}


double Foam::dew::fixIntegrate::heatCapacity(const int i) const
{
    return atom->rmass[i]*capacity_->compute_vector(atom->type[i] - 1);
}


void Foam::dew::fixIntegrate::received(const int i, double* J) const
{
    const double* d = data_[i];
    const double t = elapsed();

    for (int k = 0; k < 3; k++)
    {
        J[k] = d[impulse + k] - d[Sn + k]*t;
    }
}


void Foam::dew::fixIntegrate::load(const bool anyTerm, const bool surfaces)
{
    loaded_ = anyTerm;
    surfaces_ = surfaces;
    halves_ = 0;

    const double dt = update->dt;

    for (int i = 0; i < atom->nlocal; i++)
    {
        double* d = data_[i];
        const double m = atom->rmass[i];
        const double R = atom->radius[i];
        const double I = inertiaOf(m, R);

        const double moved = m + d[addedMass];

        d[halfStep] = 0.5*dt/moved*phi1(0.5*dt/moved*d[Sp]);
        d[fullStep] = dt*dt/moved*phi2(dt/moved*d[Sp]);
        d[halfTurn] = 0.5*dt/I*phi1(0.5*dt/I*d[Tp]);
        d[heatStep] = 0;
        for (int k = 0; k < 3; k++)
        {
            d[startVelocity+k] = atom->v[i][k] - d[kick+k];
        }

        if (heated_)
        {
            const double mc = heatCapacity(i);
            d[heatStep] = dt/mc*phi1(dt/mc*d[Qp]);
        }
        if (overdamped_)
        {
            loadOverdamped(i);
        }
        else if (colloid_)
        {
            double* c = colloid_[i];
            const ornsteinUhlenbeck noise(c[kT], moved, d[Sp], dt);
            c[noiseV] = noise.v;
            c[noiseXV] = noise.xv;
            c[noiseX] = noise.x;
        }
    }
}


void Foam::dew::fixIntegrate::needMemory(const int n)
{
    if (n == nMemory_)
    {
        return;
    }
    memory->destroy(memory_);
    nMemory_ = n;
    memory->create(memory_, atom->nmax, n, "dew/integrate:memory");
    for (int i = 0; i < atom->nlocal; i++)
    {
        std::memset(memory_[i], 0, n*sizeof(double));
    }
}


void Foam::dew::fixIntegrate::keepForces()
{
    for (int i = 0; i < atom->nlocal; i++)
    {
        double* d = data_[i];
        std::memcpy(d + keptForce, atom->f[i], 3*sizeof(double));
        std::memcpy(d + keptTorque, atom->torque[i], 3*sizeof(double));
        d[kept] = 1;
    }
}


std::vector<Foam::dew::departedParticle> Foam::dew::fixIntegrate::departed()
{
    std::vector<departedParticle> result;
    result.swap(departed_);
    return result;
}


int Foam::dew::fixIntegrate::setmask()
{
    return
        FixConst::INITIAL_INTEGRATE
      | FixConst::FINAL_INTEGRATE
      | FixConst::PRE_EXCHANGE;
}


void Foam::dew::fixIntegrate::init()
{
    if (!heated_)
    {
        return;
    }

    temperature_ = static_cast<FixPropertyAtom*>
    (
        modify->find_fix_property("Temp", "property/atom", "scalar", 0, 0, style)
    );
    heatFlux_ = static_cast<FixPropertyAtom*>
    (
        modify->find_fix_property
        (
            "heatFlux", "property/atom", "scalar", 0, 0, style
        )
    );
    capacity_ = static_cast<FixPropertyGlobal*>
    (
        modify->find_fix_property
        (
            "thermalCapacity", "property/global", "peratomtype",
            atom->get_properties()->max_type(), 0, style
        )
    );
}


int Foam::dew::fixIntegrate::max_type()
{
    return atom->ntypes;
}


void Foam::dew::fixIntegrate::setup(int)
{
    for (int i = 0; i < atom->nlocal; i++)
    {
        double* d = data_[i];

        if (d[kept] > 0)
        {
            std::memcpy(atom->f[i], d + keptForce, 3*sizeof(double));
            std::memcpy(atom->torque[i], d + keptTorque, 3*sizeof(double));
            d[kept] = 0;
        }
    }
}


void Foam::dew::fixIntegrate::initial_integrate(int)
{
    const int n = atom->nlocal;
    const double dt = update->dt;
    const double dtf = 0.5*dt*force->ftm2v;
    const double dtfRotate = dtf/inertia;

    double** x = atom->x;
    double** v = atom->v;
    double** f = atom->f;
    double** omega = atom->omega;
    double** torque = atom->torque;
    const double* radius = atom->radius;
    const double* rmass = atom->rmass;

    halves_++;

    if (overdamped_)
    {
        moveOverdamped();
        return;
    }
    if (!loaded_)
    {
        for (int i = 0; i < n; i++)
        {
            const double dtfm = dtf/rmass[i];
            const double dtirotate = dtfRotate/(radius[i]*radius[i]*rmass[i]);

            for (int k = 0; k < 3; k++)
            {
                v[i][k] += dtfm*f[i][k];
                x[i][k] += dt*v[i][k];
                omega[i][k] += dtirotate*torque[i][k];
            }
        }

        return;
    }

    if (!planes_.empty())
    {
        for (int i = 0; i < n; i++)
        {
            firstBeside(i);
        }
        return;
    }
    if (surfaces_)
    {
        beforeFirst();
    }

    for (int i = 0; i < n; i++)
    {
        double* d = data_[i];
        const double m = rmass[i];

        for (int k = 0; k < 3; k++)
        {
            const double a = f[i][k] + d[Su+k] + d[Sp]*(d[U+k] - v[i][k]);
            const double dv = a*d[halfStep];
            x[i][k] += dt*v[i][k] + a*d[fullStep];
            v[i][k] += dv;
            d[impulse+k] += m*dv - dtf*f[i][k];
        }
        turn
        (
            d, torque[i], omega[i], inertiaOf(m, radius[i]), dtf
        );
    }

    if (colloid_)
    {
        afterFirst();
    }
}


void Foam::dew::fixIntegrate::final_integrate()
{
    const int n = atom->nlocal;
    const double dt = update->dt;
    const double dtf = 0.5*dt*force->ftm2v;
    const double dtfRotate = dtf/inertia;

    double** v = atom->v;
    double** f = atom->f;
    double** omega = atom->omega;
    double** torque = atom->torque;
    const double* radius = atom->radius;
    const double* rmass = atom->rmass;

    halves_++;

    if (overdamped_)
    {
        // Their velocities are set once, by finish()
    }
    else if (!loaded_)
    {
        for (int i = 0; i < n; i++)
        {
            const double dtfm = dtf/rmass[i];
            const double dtirotate = dtfRotate/(radius[i]*radius[i]*rmass[i]);

            for (int k = 0; k < 3; k++)
            {
                v[i][k] += dtfm*f[i][k];
                omega[i][k] += dtirotate*torque[i][k];
            }
        }
    }
    else if (!planes_.empty())
    {
        for (int i = 0; i < n; i++)
        {
            secondBeside(i);
        }
    }
    else
    {
        const double none[3] = {0, 0, 0};

        if (surfaces_)
        {
            beforeSecond();
        }

        for (int i = 0; i < n; i++)
        {
            double* d = data_[i];
            const double* more = colloid_ ? colloid_[i] + pending : none;
            const double m = rmass[i];

            for (int k = 0; k < 3; k++)
            {
                const double dv =
                    (f[i][k] + d[Su+k] + d[Sp]*(d[U+k] - v[i][k]))*d[halfStep];
                v[i][k] += dv + more[k];
                d[impulse+k] += m*dv - dtf*f[i][k];
            }
            turn
            (
                d, torque[i], omega[i], inertiaOf(m, radius[i]), dtf
            );
        }
    }

    checkFinite();

    if (heated_)
    {
        double* T = temperature_->vector_atom;
        const double* q = heatFlux_->vector_atom;

        for (int i = 0; i < n; i++)
        {
            double* d = data_[i];
            const double mc = heatCapacity(i);
            const double dT =
                (q[i] + d[Qu] + d[Qp]*(d[Tf] - T[i]))*d[heatStep];
            T[i] += dT;
            d[heat] += mc*dT - q[i]*dt;
        }
    }
}


void Foam::dew::fixIntegrate::pre_exchange()
{
    // The engine is about to drop what has left through an open side
    const int* periodic = domain->periodicity;

    for (int i = 0; i < atom->nlocal; i++)
    {
        const double* x = atom->x[i];
        bool out = false;

        for (int k = 0; k < 3; k++)
        {
            out = out
             || (
                    !periodic[k]
                 && (x[k] < domain->boxlo[k] || x[k] >= domain->boxhi[k])
                );
        }

        if (out)
        {
            departedParticle p;
            p.id = atom->tag[i];
            p.mass = atom->rmass[i];
            p.volume = p.mass/atom->density[i];
            std::memcpy(p.x, x, sizeof(p.x));
            std::memcpy(p.v, atom->v[i], sizeof(p.v));
            received(i, p.impulse);
            p.heat = data_[i][heat];
            departed_.push_back(p);
        }
    }
}


void Foam::dew::fixIntegrate::grow_arrays(int nmax)
{
    memory->grow(data_, nmax, int(nColumns), "dew/integrate:data");
    if (colloid_)
    {
        memory->grow
        (
            colloid_, nmax, int(nColloidColumns), "dew/integrate:colloid"
        );
    }
    if (memory_)
    {
        memory->grow(memory_, nmax, nMemory_, "dew/integrate:memory");
    }
}


void Foam::dew::fixIntegrate::copy_arrays(int i, int j, int)
{
    std::memcpy(data_[j], data_[i], nColumns*sizeof(double));
    if (colloid_)
    {
        std::memcpy(colloid_[j], colloid_[i], nColloidColumns*sizeof(double));
    }
    if (memory_)
    {
        std::memcpy(memory_[j], memory_[i], nMemory_*sizeof(double));
    }
}


void Foam::dew::fixIntegrate::set_arrays(int i)
{
    std::memset(data_[i], 0, nColumns*sizeof(double));
    if (colloid_)
    {
        std::memset(colloid_[i], 0, nColloidColumns*sizeof(double));
    }
    if (memory_)
    {
        std::memset(memory_[i], 0, nMemory_*sizeof(double));
    }

    // A particle without bulk terms still steps by dt/m
    const double dt = update->dt;
    const double m = atom->rmass[i];
    const double R = atom->radius[i];

    if (m > 0)
    {
        data_[i][halfStep] = 0.5*dt/m;
        data_[i][fullStep] = 0.5*dt*dt/m;
        data_[i][halfTurn] = 0.5*dt/inertiaOf(m, R);
        data_[i][heatStep] =
            capacity_
          ? dt/(m*capacity_->compute_vector(atom->type[i] - 1))
          : 0;
    }
}


int Foam::dew::fixIntegrate::pack_exchange(int i, double* buf)
{
    int n = nColumns;
    std::memcpy(buf, data_[i], nColumns*sizeof(double));
    if (colloid_)
    {
        std::memcpy(buf + n, colloid_[i], nColloidColumns*sizeof(double));
        n += nColloidColumns;
    }
    if (memory_)
    {
        std::memcpy(buf + n, memory_[i], nMemory_*sizeof(double));
        n += nMemory_;
    }
    return n;
}


int Foam::dew::fixIntegrate::unpack_exchange(int i, double* buf)
{
    int n = nColumns;
    std::memcpy(data_[i], buf, nColumns*sizeof(double));
    if (colloid_)
    {
        std::memcpy(colloid_[i], buf + n, nColloidColumns*sizeof(double));
        n += nColloidColumns;
    }
    if (memory_)
    {
        std::memcpy(memory_[i], buf + n, nMemory_*sizeof(double));
        n += nMemory_;
    }
    return n;
}


int Foam::dew::fixIntegrate::pack_restart(int i, double* buf)
{
    // Bulk terms are given anew, and what was received was handed over
    buf[0] = nKept + 1;
    std::memcpy(buf + 1, data_[i] + keptForce, nKept*sizeof(double));
    return nKept + 1;
}


void Foam::dew::fixIntegrate::unpack_restart(int i, int nth)
{
    const double* extra = atom->extra[i];

    int m = 0;
    for (int k = 0; k < nth; k++)
    {
        m += static_cast<int>(extra[m]);
    }
    set_arrays(i);
    std::memcpy(data_[i] + keptForce, extra + m + 1, nKept*sizeof(double));
}


double Foam::dew::fixIntegrate::memory_usage()
{
    const int n =
        nColumns + (colloid_ ? int(nColloidColumns) : 0) + nMemory_;
    return double(atom->nmax)*n*sizeof(double);
}
