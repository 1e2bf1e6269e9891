/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// Bulk forces to the engine, state and what was received from it

#include "liggghtsEmbedded.h"
#include "fixConduction.h"
#include "fixGravity.h"
#include "impulseSensitivity.H"

#include <cmath>
#include <cstring>
#include <sstream>
#include <stdexcept>

#include "domain.h"
#include "fix_gravity.h"
#include "modify.h"

using namespace LAMMPS_NS;

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace
{

double finite(const double value, const int id)
{
    if (!std::isfinite(value))
    {
        throw std::runtime_error
        (
            "the bulk force (or torque, or heat) of particle "
          + std::to_string(id) + " is not a finite number: look at"
            " the law and the fields it was computed from"
        );
    }
    return value;
}

// Copy nv values a particle from or to the stored columns, times a factor;
// row(i) is where those of a particle are

template<class Row>
void setColumn
(
    const Row& row,
    const int* id,
    const int n,
    const double* from,
    const int col,
    const int nv,
    const double factor
)
{
    for (int i = 0; i < n; i++)
    {
        for (int k = 0; k < nv; k++)
        {
            row(i)[col + k] = from ? factor*finite(from[nv*i + k], id[i]) : 0;
        }
    }
}

void getColumn
(
    const Foam::dew::fixIntegrate& f,
    const int n,
    double* to,
    const int col,
    const int nv,
    const double factor
)
{
    for (int i = 0; to && i < n; i++)
    {
        for (int k = 0; k < nv; k++)
        {
            to[nv*i + k] = factor*f[i][col + k];
        }
    }
}

void getVectors(double** from, const int n, double* to, const double factor)
{
    for (int i = 0; to && i < n; i++)
    {
        for (int k = 0; k < 3; k++)
        {
            to[3*i + k] = factor*from[i][k];
        }
    }
}

//- Null without conduction
Foam::dew::fixConduction* findConduction(Modify& modify)
{
    return dynamic_cast<Foam::dew::fixConduction*>
    (
        modify.find_fix_style("dew/conduction", 0)
    );
}

} // End anonymous namespace


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::dew::liggghtsEmbedded::checkDrag(const bulkForcesView& b) const
{
    const Atom& atom = *lmp_->atom;

    for (int i = 0; i < atom.nlocal; i++)
    {
        const double R = atom.radius[i]*units_.length;
        const double least = 3*M_PI*viscosity_*R;
        const double Sp = b.Sp ? finite(b.Sp[i], atom.tag[i]) : 0;
        const bool kicked =
            b.kick
         && (b.kick[3*i] != 0 || b.kick[3*i + 1] != 0 || b.kick[3*i + 2] != 0);

        if (Sp >= least && !kicked)
        {
            continue;
        }

        std::ostringstream os;
        os.precision(6);
        os  << "particle " << atom.tag[i] << " at ("
            << atom.x[i][0]*units_.length << ' '
            << atom.x[i][1]*units_.length << ' '
            << atom.x[i][2]*units_.length << ") m ";
        if (kicked)
        {
            os  << "is given momentum at once, but overdamped dynamics know no"
                " inertia. Use 'momentum explicit' or 'none', or dynamics of"
                " type inertial";
        }
        else if (Sp > 0)
        {
            os  << "has the drag coefficient " << Sp << " N s/m, less than half"
                " that of creeping flow in the viscosity of the entry dynamics,"
                " " << 2*least << " N s/m, from which the sub-step was chosen."
                " Lower the entry viscosity";
        }
        else
        {
            os  << "has no drag: overdamped dynamics need Sp > 0. Add a drag"
                " law to coupling.forces, or keep the particle in the fluid";
        }
        throw std::runtime_error(os.str());
    }
}


void Foam::dew::liggghtsEmbedded::setDrainage(const int i, const double share)
{
    const Atom& atom = *lmp_->atom;
    double* c = integrator().colloid(i);
    const double R = atom.radius[i];
    const double kappa = c[fixIntegrate::curvature];

    if (kappa*R >= 1)
    {
        std::ostringstream os;
        os.precision(6);
        os  << "particle " << atom.tag[i] << ", radius " << R*units_.length
            << " m, is as large as the liquid's radius of curvature "
            << units_.length/kappa << " m: there is no film between them."
            " Remove the film, or use smaller particles";
        throw std::runtime_error(os.str());
    }
    // From the viscosity, in engine units
    double& k = c[fixIntegrate::drainage];
    k = filmCoefficient
    (
        k*units_.length*units_.length/(units_.force()*units_.time),
        R, kappa, share
    );
}


void Foam::dew::liggghtsEmbedded::pushColloids(const bulkForcesView& b)
{
    typedef fixIntegrate f;
    fixIntegrate& data = integrator();
    const int n = size();
    const Atom& atom = *lmp_->atom;
    const Domain& box = *lmp_->domain;
    const engineUnits& u = units_;

    const auto set = [&](const double* from, int col, int nv, double factor)
    {
        setColumn
        (
            [&data](int i) { return data.colloid(i); }, atom.tag, n, from, col,
            nv, factor
        );
    };

    set(b.kT, f::kT, 1, 1/(u.force()*u.length));
    set(b.surfaceX, f::offset, 3, 1/u.length);
    set(b.surfaceN, f::normal, 3, 1);
    set(b.surfaceSpeed, f::speed, 1, 1/u.velocity());
    set(b.surfaceCurvature, f::curvature, 1, u.length);
    set(b.surfaceK, f::stiffness, 1, u.length/u.force());
    set(b.surfaceTension, f::tension, 1, u.length/u.force());
    set(b.contactAngle, f::angle, 1, 1);
    set(b.planePull, f::planePull, 1, 1);
    set(b.filmViscosity, f::drainage, 1, 1);

    surfaceFilm film(b.film);
    for (double* length : {&film.hMin, &film.hMax, &film.rangeH, &film.rangeK})
    {
        *length /= u.length;
    }
    for (double* energy : {&film.H, &film.K})
    {
        *energy /= u.force()*u.length;
    }
    data.film(film);

    for (int i = 0; i < n; i++)
    {
        for (int k = 0; k < 3; k++)
        {
            double& y = data.colloid(i)[f::offset + k];
            y = atom.x[i][k] - y;

            // The engine wraps later than the state
            if (box.periodicity[k])
            {
                const double span = box.boxhi[k] - box.boxlo[k];
                y -= span*std::round(y/span);
            }
        }
        if (film.reach() > 0)
        {
            setDrainage(i, film.share);
        }
    }
}


void Foam::dew::liggghtsEmbedded::give
(
    const double* kick,
    const double* heatKick
)
{
    const Atom& atom = *lmp_->atom;
    fixIntegrate& data = integrator();
    const double perImpulse = 1/(units_.force()*units_.time);
    const double perHeat = 1/(units_.power()*units_.time);

    for (int i = 0; i < atom.nlocal; i++)
    {
        for (int k = 0; k < 3; k++)
        {
            const double dv =
                kick
              ? perImpulse*finite(kick[3*i + k], atom.tag[i])/atom.rmass[i]
              : 0;
            atom.v[i][k] += dv;
            data[i][fixIntegrate::kick + k] = dv;
        }
    }

    for (int i = 0; heatKick && i < atom.nlocal; i++)
    {
        const double q = perHeat*finite(heatKick[i], atom.tag[i]);
        if (data.heated())
        {
            data.temperature()[i] += q/data.heatCapacity(i);
        }
    }
}


void Foam::dew::liggghtsEmbedded::gravityImpulse(double* perMass) const
{
    for (int k = 0; k < 3; k++)
    {
        perMass[k] = 0;
    }

    const Modify& modify = *lmp_->modify;

    for (int f = 0; f < modify.nfix; f++)
    {
        double g[3] = {0, 0, 0};

        if (const auto* ours = dynamic_cast<fixGravity*>(modify.fix[f]))
        {
            std::memcpy(g, ours->integral(), sizeof(g));
        }
        else if (auto* native = dynamic_cast<FixGravity*>(modify.fix[f]))
        {
            // Of a native input: as it is now
            native->get_gravity(g);
            for (int k = 0; k < 3; k++)
            {
                g[k] *= integrate_->elapsed();
            }
        }

        for (int k = 0; k < 3; k++)
        {
            perMass[k] += g[k];
        }
    }
}


void Foam::dew::liggghtsEmbedded::sensitivities
(
    double* impulseSp,
    double* heatSp
) const
{
    typedef fixIntegrate f;
    const fixIntegrate& data = *integrate_;
    const Atom& atom = *lmp_->atom;
    const engineUnits& u = units_;
    const double t = data.elapsed();

    double g[3];
    gravityImpulse(g);

    for (int i = 0; impulseSp && i < atom.nlocal; i++)
    {
        const double* d = data[i];
        const double mass = atom.rmass[i];
        const double* dv = d + f::kick;
        const double G[3] =
        {
            mass*(g[0] + dv[0]), mass*(g[1] + dv[1]), mass*(g[2] + dv[2])
        };

        // Without inertia a free particle takes nothing to follow the fluid
        const double m = data.overdamped() ? 0 : mass;

        impulseSp[i] = 0;
        if (d[f::Sp] > 0)
        {
            const double chi = heldShare
            (
                m, d + f::startVelocity, atom.v[i], d + f::impulse, G
            );
            impulseSp[i] =
                u.mass
               *(
                    m > 0
                  ? impulseSensitivity(m, d[f::Sp], t, chi, d[f::addedMass])
                  : chi*d[f::Sp]*t
                );
        }
    }

    for (int i = 0; heatSp && data.heated() && i < atom.nlocal; i++)
    {
        heatSp[i] =
            u.power()*u.time
           *impulseSensitivity(data.heatCapacity(i), data[i][f::Qp], t, 0);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::liggghtsEmbedded::push(const bulkForcesView& b)
{
    typedef fixIntegrate f;
    fixIntegrate& data = integrator();
    const int n = size();
    const int* id = lmp_->atom->tag;
    const engineUnits& u = units_;

    if (data.overdamped())
    {
        checkDrag(b);
    }
    give(b.kick, b.heatKick);

    auto* gravity = dynamic_cast<fixGravity*>
    (
        lmp_->modify->find_fix_style("dew/gravity", 0)
    );
    if (gravity)
    {
        gravity->clear();
    }
    if (auto* conduction = findConduction(*lmp_->modify))
    {
        conduction->clear();
    }

    // Decided together: a particle may migrate to a rank that pushed nothing
    int any[3] =
    {
        b.Su || b.Sn || b.Sp || b.Tu || b.Tp || b.Qu || b.Qp || b.surfaceK
     || b.addedMass,
        b.kT || b.surfaceK,
        b.surfaceK != nullptr
    };
    MPI_Allreduce(MPI_IN_PLACE, any, 3, MPI_INT, MPI_MAX, world_);

    if (b.nMemory > 0)
    {
        data.needMemory(b.nMemory);
        setColumn
        (
            [&data](int i) { return data.memoryOf(i); }, id, n, b.memory, 0,
            b.nMemory, 1
        );
    }

    if (!any[0] && !data.loaded() && !data.heated())
    {
        return;
    }

    const auto set = [&](const double* from, int col, int nv, double factor)
    {
        setColumn
        (
            [&data](int i) { return data[i]; }, id, n, from, col, nv, factor
        );
    };

    set(b.Su, f::Su, 3, 1/u.force());
    set(b.Sp, f::Sp, 1, u.velocity()/u.force());
    set(b.U, f::U, 3, 1/u.velocity());
    set(b.Tu, f::Tu, 3, 1/u.torque());
    set(b.Tp, f::Tp, 1, 1/(u.torque()*u.time));
    set(b.Omega, f::Omega, 3, u.time);
    set(b.Qu, f::Qu, 1, 1/u.power());
    set(b.Qp, f::Qp, 1, 1/u.power());
    set(b.Tf, f::Tf, 1, 1);

    set(b.addedMass, f::addedMass, 1, 1/u.mass);
    set(b.Sn, f::Sn, 3, 1/u.force());

    if (any[1])
    {
        data.needColloids();
    }
    if (data.colloids())
    {
        pushColloids(b);
    }

    for (int i = 0; i < n; i++)
    {
        // The sub-steps know one constant force
        for (int k = 0; k < 3; k++)
        {
            data[i][f::Su + k] += data[i][f::Sn + k];
        }
        for (const int column : {f::impulse, f::angularImpulse})
        {
            std::memset(data[i] + column, 0, 3*sizeof(double));
        }
        data[i][f::heat] = 0;
    }

    data.load(any[0], any[2]);
}


void Foam::dew::liggghtsEmbedded::pull(const stateView& s) const
{
    typedef fixIntegrate f;
    const fixIntegrate& data = *integrate_;
    const Atom& atom = *lmp_->atom;
    const int n = atom.nlocal;
    const engineUnits& u = units_;

    if (s.id) std::memcpy(s.id, atom.tag, n*sizeof(int));
    if (s.type) std::memcpy(s.type, atom.type, n*sizeof(int));

    getVectors(atom.x, n, s.x, u.length);
    getVectors(atom.v, n, s.v, u.velocity());
    getVectors(atom.omega, n, s.omega, 1/u.time);

    for (int i = 0; s.d && i < n; i++)
    {
        s.d[i] = 2*u.length*atom.radius[i];
    }
    for (int i = 0; s.rho && i < n; i++)
    {
        s.rho[i] = u.density()*atom.density[i];
    }
    if (s.T && data.temperature())
    {
        std::memcpy(s.T, data.temperature(), n*sizeof(double));
    }

    for (int i = 0; s.impulse && i < n; i++)
    {
        double J[3];
        data.received(i, J);
        for (int k = 0; k < 3; k++)
        {
            s.impulse[3*i + k] = u.force()*u.time*J[k];
        }
    }
    getColumn(data, n, s.angularImpulse, f::angularImpulse, 3, u.torque()*u.time);
    getColumn(data, n, s.heat, f::heat, 1, u.power()*u.time);
    for (int i = 0; s.memory && data.nMemory() && i < n; i++)
    {
        std::memcpy
        (
            s.memory + i*data.nMemory(), data.memoryOf(i),
            data.nMemory()*sizeof(double)
        );
    }
    sensitivities(s.impulseSp, s.heatSp);
}


std::vector<Foam::dew::departedParticle>
Foam::dew::liggghtsEmbedded::departed()
{
    std::vector<departedParticle> result(integrator().departed());

    for (departedParticle& p : result)
    {
        p.mass *= units_.mass;
        p.volume *= units_.length*units_.length*units_.length;
        p.heat *= units_.power()*units_.time;
        for (int k = 0; k < 3; k++)
        {
            p.x[k] *= units_.length;
            p.v[k] *= units_.velocity();
            p.impulse[k] *= units_.force()*units_.time;
        }
    }

    return result;
}


double Foam::dew::liggghtsEmbedded::wallHeat() const
{
    const fixConduction* conduction = findConduction(*lmp_->modify);
    return
        conduction ? conduction->wallHeat()*units_.power()*units_.time : 0;
}
