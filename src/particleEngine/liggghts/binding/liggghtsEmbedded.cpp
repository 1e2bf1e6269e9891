/*---------------------------------------------------------------------------*\
  DEW: Droplets, Evaporation and Wet grains
  Copyright (C) 2026 The DEW authors
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/

// The embedded engine behind liggghtsBinding.H

#include "liggghtsBinding.H"
#include "engineErrors.h"
#include "fixGravity.h"
#include "fixIntegrate.h"
#include "registerStyles.h"

#include <algorithm>
#include <cfenv>
#include <cstdio>
#include <cmath>
#include <cstring>
#include <fstream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <unordered_map>

#include <fcntl.h>
#include <unistd.h>

#include "atom.h"
#include "atom_vec.h"
#include "comm.h"
#include "domain.h"
#include "fix.h"
#include "fix_property_atom.h"
#include "integrate.h"
#include "lammps.h"
#include "library.h"
#include "modify.h"
#include "output.h"
#include "timer.h"
#include "universe.h"
#include "update.h"
#include "write_restart.h"

using namespace LAMMPS_NS;

namespace Foam
{
namespace dew
{

//- Floating-point traps belong to the host: inside the engine a NaN must be
//  reported with its particle, not end in a signal
class trapsOff
{
    int mask_;

public:

    trapsOff() : mask_(fedisableexcept(FE_ALL_EXCEPT)) {}

    ~trapsOff()
    {
        std::feclearexcept(FE_ALL_EXCEPT);
        feenableexcept(mask_);
    }
};


//- The engine's remarks on standard output are not the solver's
class outputOff
{
    int kept_;

public:

    outputOff()
    :
        kept_(dup(STDOUT_FILENO))
    {
        std::fflush(stdout);
        const int null = open("/dev/null", O_WRONLY);
        dup2(null, STDOUT_FILENO);
        close(null);
    }

    ~outputOff()
    {
        std::fflush(stdout);
        dup2(kept_, STDOUT_FILENO);
        close(kept_);
    }
};


class liggghtsEmbedded
:
    public liggghtsBinding
{
    bool ownMpi_;
    MPI_Comm world_;
    LAMMPS* lmp_;
    engineUnits units_;
    fixIntegrate* integrate_;

    //- Do forces belong to the present particles?
    bool forcesValid_;

    //- The integrator, made by the command "fix ... dew/integrate"
    fixIntegrate& integrator();

    bool outsideBox() const;

public:

    explicit liggghtsEmbedded(const liggghtsOptions&);

    ~liggghtsEmbedded() override;

    std::string version() const override { return lmp_->universe->version; }

    void command(const std::string&) override;
    void units(const engineUnits& u) override { units_ = u; }
    void expect(double maxRadius, bool heat) override;
    double deltaT() const override { return lmp_->update->dt*units_.time; }
    void gravity(std::function<void(double, double*)>) override;
    long add(const newParticles&) override;
    void overlapping
    (
        const newParticles&, double share, std::vector<char>& hit
    ) const override;
    void setup() override;
    void push(const bulkForcesView&) override;
    void run(long nSteps) override;
    int size() const override { return lmp_->atom->nlocal; }
    void pull(const stateView&) const override;
    std::vector<departedParticle> departed() override;
    long step() const override { return long(lmp_->update->ntimestep); }
    long total() const override;
    void writeRestart(const std::string& file) override;
    std::vector<std::string> warnings() override { return engineWarnings(); }
};

} // End namespace dew
} // End namespace Foam


namespace
{

// Copy nv values a particle from or to the stored columns, times a factor

void setColumn
(
    Foam::dew::fixIntegrate& f,
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
            const double value = from ? from[nv*i + k] : 0;

            if (!std::isfinite(value))
            {
                throw std::runtime_error
                (
                    "the bulk force (or torque, or heat) of particle "
                  + std::to_string(id[i]) + " is not a finite number: look at"
                    " the law and the fields it was computed from"
                );
            }
            f[i][col + k] = factor*value;
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

} // End anonymous namespace


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::dew::liggghtsEmbedded::liggghtsEmbedded(const liggghtsOptions& options)
:
    ownMpi_(false),
    world_(MPI_COMM_NULL),
    lmp_(nullptr),
    integrate_(nullptr),
    forcesValid_(false)
{
    int initialised = 0;
    MPI_Initialized(&initialised);

    if (!initialised)
    {
        // A serial OpenFOAM run does not start MPI, the engine needs it
        MPI_Init(nullptr, nullptr);
        ownMpi_ = true;
    }
    MPI_Comm_dup(MPI_COMM_WORLD, &world_);

    // "-screen none" would crash in the engine's regions
    std::vector<std::string> text
    {
        options.caller, "-screen", "/dev/null", "-log", options.logFile
    };
    std::vector<char*> arg;
    for (std::string& s : text)
    {
        arg.push_back(&s[0]);
    }

    trapsOff guard;
    void* handle = nullptr;
    lammps_open(int(arg.size()), arg.data(), world_, &handle);
    lmp_ = static_cast<LAMMPS*>(handle);

    registerStyles(lmp_);
}


Foam::dew::liggghtsEmbedded::~liggghtsEmbedded()
{
    trapsOff guard;
    lammps_close(lmp_);
    MPI_Comm_free(&world_);

    if (ownMpi_)
    {
        MPI_Finalize();
    }
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::dew::fixIntegrate& Foam::dew::liggghtsEmbedded::integrator()
{
    if (!integrate_)
    {
        integrate_ = dynamic_cast<fixIntegrate*>
        (
            lmp_->modify->find_fix_style("dew/integrate", 0)
        );

        if (!integrate_)
        {
            throw std::runtime_error
            (
                "no integrator: the commands lack 'fix <id> all dew/integrate'"
            );
        }

        for (int i = 0; i < lmp_->modify->nfix; i++)
        {
            const Fix* fix = lmp_->modify->fix[i];
            if (fix->time_integrate && fix != integrate_)
            {
                throw std::runtime_error
                (
                    std::string("fix ") + fix->id + " (" + fix->style
                  + ") moves the particles, too: remove it, they are moved by"
                    " dew/integrate"
                );
            }
        }
    }

    return *integrate_;
}


bool Foam::dew::liggghtsEmbedded::outsideBox() const
{
    const Domain& box = *lmp_->domain;
    const Atom& atom = *lmp_->atom;
    int out = 0;

    for (int i = 0; i < atom.nlocal && !out; i++)
    {
        for (int k = 0; k < 3; k++)
        {
            const double x = atom.x[i][k];
            if (!box.periodicity[k] && (x < box.boxlo[k] || x >= box.boxhi[k]))
            {
                out = 1;
            }
        }
    }

    int any = 0;
    MPI_Allreduce(&out, &any, 1, MPI_INT, MPI_MAX, world_);

    return any;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dew::liggghtsEmbedded::command(const std::string& line)
{
    trapsOff guard;
    outputOff quiet;

    // As a library the engine would remember an include and never read it
    std::istringstream words(line);
    std::string first, path;
    words >> first >> std::ws;
    std::getline(words, path);

    if (first == "include")
    {
        path.erase(std::remove(path.begin(), path.end(), '"'), path.end());
        lammps_file(lmp_, &path[0]);
    }
    else
    {
        lammps_command(lmp_, line.c_str());
    }
}


void Foam::dew::liggghtsEmbedded::expect(double maxRadius, bool heat)
{
    integrator().expect(maxRadius/units_.length, heat);
}


void Foam::dew::liggghtsEmbedded::gravity
(
    std::function<void(double, double*)> value
)
{
    fixGravity* fix = dynamic_cast<fixGravity*>
    (
        lmp_->modify->find_fix_style("dew/gravity", 0)
    );

    if (!fix)
    {
        throw std::runtime_error
        (
            "no gravity: the commands lack 'fix <id> all dew/gravity'"
        );
    }

    const double dt = lmp_->update->dt*units_.time;
    const double scale = 1/units_.acceleration();

    fix->value
    (
        [value, dt, scale](long step, double* g)
        {
            value(step*dt, g);
            for (int k = 0; k < 3; k++)
            {
                g[k] *= scale;
            }
        }
    );
}


long Foam::dew::liggghtsEmbedded::add(const newParticles& p)
{
    trapsOff guard;
    Atom& atom = *lmp_->atom;
    Domain& box = *lmp_->domain;
    Modify& modify = *lmp_->modify;
    const int before = atom.nlocal;

    FixPropertyAtom* temperature = static_cast<FixPropertyAtom*>
    (
        modify.find_fix_property
        (
            "Temp", "property/atom", "scalar", 0, 0, "add", false
        )
    );

    // Particles already there go on from the forces they have; those added
    // since the last set-up have none yet
    if (forcesValid_)
    {
        integrator().keepForces();
        forcesValid_ = false;
    }

    // Values of the new ones are set below: the engine's first set-up would
    // return them to their defaults
    for (int f = 0; f < modify.nfix; f++)
    {
        modify.fix[f]->just_created = 0;
    }

    for (size_t i = 0; i < p.id.size(); i++)
    {
        double x[3];
        bool mine = true;

        for (int k = 0; k < 3; k++)
        {
            x[k] = p.x[3*i + k]/units_.length;

            // Wrap after the conversion: one ulp outside is outside
            if (box.periodicity[k])
            {
                const double span = box.boxhi[k] - box.boxlo[k];
                while (x[k] < box.boxlo[k]) x[k] += span;
                while (x[k] >= box.boxhi[k]) x[k] -= span;
            }
            mine = mine && x[k] >= box.sublo[k] && x[k] < box.subhi[k];
        }

        if (!mine)
        {
            continue;
        }

        atom.avec->create_atom(p.type[i], x);
        const int n = atom.nlocal - 1;
        const double R = 0.5*p.d[i]/units_.length;
        const double rho = p.rho[i]/units_.density();

        atom.tag[n] = p.id[i];
        atom.radius[n] = R;
        atom.density[n] = rho;
        atom.rmass[n] = 4.0/3.0*M_PI*R*R*R*rho;

        for (int k = 0; k < 3; k++)
        {
            atom.v[n][k] = p.v[3*i + k]/units_.velocity();
            atom.omega[n][k] = p.omega[3*i + k]*units_.time;
        }

        for (int f = 0; f < modify.nfix; f++)
        {
            if (modify.fix[f]->create_attribute)
            {
                modify.fix[f]->pre_set_arrays();
                modify.fix[f]->set_arrays(n);
            }
        }

        if (temperature)
        {
            temperature->vector_atom[n] = p.T[i];
        }
    }

    long placed = atom.nlocal - before, all = 0;
    MPI_Allreduce(&placed, &all, 1, MPI_LONG, MPI_SUM, world_);
    atom.natoms += all;

    if (atom.map_style)
    {
        atom.nghost = 0;
        atom.map_init();
        atom.map_set();
    }

    return all;
}


void Foam::dew::liggghtsEmbedded::overlapping
(
    const newParticles& p,
    const double share,
    std::vector<char>& hit
) const
{
    const Atom& atom = *lmp_->atom;
    const Domain& box = *lmp_->domain;
    const int n = int(p.id.size());

    hit.assign(n, 0);

    // The new ones in a hashed grid as wide as any contact
    double reach = 0;
    for (int i = 0; i < n; i++)
    {
        reach = std::max(reach, 0.5*p.d[i]/units_.length);
    }
    double old = 0;
    for (int i = 0; i < atom.nlocal; i++)
    {
        old = std::max(old, atom.radius[i]);
    }
    MPI_Allreduce(MPI_IN_PLACE, &old, 1, MPI_DOUBLE, MPI_MAX, world_);
    const double width = reach + old;

    if (n == 0 || width <= 0)
    {
        return;
    }

    const auto cell = [width](const double* x, int di, int dj, int dk)
    {
        const long i = long(std::floor(x[0]/width)) + di;
        const long j = long(std::floor(x[1]/width)) + dj;
        const long k = long(std::floor(x[2]/width)) + dk;
        return
            (i*73856093L) ^ (j*19349663L) ^ (k*83492791L);
    };

    std::unordered_multimap<long, int> grid;
    std::vector<double> x(3*n);
    for (int i = 0; i < n; i++)
    {
        for (int k = 0; k < 3; k++)
        {
            x[3*i + k] = p.x[3*i + k]/units_.length;
        }
        grid.emplace(cell(&x[3*i], 0, 0, 0), i);
    }

    for (int a = 0; a < atom.nlocal; a++)
    {
        // Images across periodic sides
        for (int image = 0; image < 27; image++)
        {
            const int s[3] = {image%3 - 1, (image/3)%3 - 1, image/9 - 1};
            double y[3];
            bool used = true;

            for (int k = 0; k < 3; k++)
            {
                const double span = box.boxhi[k] - box.boxlo[k];
                y[k] = atom.x[a][k] + s[k]*span;
                used = used
                 && (
                        s[k] == 0
                     || (
                            box.periodicity[k]
                         && y[k] > box.boxlo[k] - width
                         && y[k] < box.boxhi[k] + width
                        )
                    );
            }

            for (int c = 0; used && c < 27; c++)
            {
                const auto range = grid.equal_range
                (
                    cell(y, c%3 - 1, (c/3)%3 - 1, c/9 - 1)
                );

                for (auto it = range.first; it != range.second; ++it)
                {
                    const int i = it->second;
                    const double R = 0.5*p.d[i]/units_.length;
                    const double gap =
                        std::sqrt
                        (
                            std::pow(x[3*i] - y[0], 2)
                          + std::pow(x[3*i + 1] - y[1], 2)
                          + std::pow(x[3*i + 2] - y[2], 2)
                        )
                      - R - atom.radius[a];

                    if (gap < -share*std::min(R, atom.radius[a]))
                    {
                        hit[i] = 1;
                    }
                }
            }
        }
    }

    MPI_Allreduce(MPI_IN_PLACE, hit.data(), n, MPI_CHAR, MPI_MAX, world_);
}


void Foam::dew::liggghtsEmbedded::setup()
{
    trapsOff guard;
    Update& update = *lmp_->update;

    // Setting up drops what has left without asking the fixes
    integrator().pre_exchange();

    update.whichflag = 1;
    update.nsteps = MAXSMALLINT;
    update.firststep = update.ntimestep;
    update.laststep = update.ntimestep + update.nsteps;
    update.beginstep = update.firststep;
    update.endstep = update.laststep;

    lmp_->init();
    update.integrate->setup();
    lmp_->timer->init();
    forcesValid_ = true;
}


void Foam::dew::liggghtsEmbedded::push(const bulkForcesView& b)
{
    typedef fixIntegrate f;
    fixIntegrate& data = integrator();
    const int n = size();
    const int* id = lmp_->atom->tag;
    const engineUnits& u = units_;

    // Decided together: a particle may migrate to a rank that pushed nothing
    int any = b.Su || b.Sp || b.Tu || b.Tp || b.Qu || b.Qp;
    MPI_Allreduce(MPI_IN_PLACE, &any, 1, MPI_INT, MPI_MAX, world_);

    if (!any && !data.loaded() && !data.heated())
    {
        return;
    }

    setColumn(data, id, n, b.Su, f::Su, 3, 1/u.force());
    setColumn(data, id, n, b.Sp, f::Sp, 1, u.velocity()/u.force());
    setColumn(data, id, n, b.U, f::U, 3, 1/u.velocity());
    setColumn(data, id, n, b.Tu, f::Tu, 3, 1/u.torque());
    setColumn(data, id, n, b.Tp, f::Tp, 1, 1/(u.torque()*u.time));
    setColumn(data, id, n, b.Omega, f::Omega, 3, u.time);
    setColumn(data, id, n, b.Qu, f::Qu, 1, 1/u.power());
    setColumn(data, id, n, b.Qp, f::Qp, 1, 1/u.power());
    setColumn(data, id, n, b.Tf, f::Tf, 1, 1);

    for (int i = 0; i < n; i++)
    {
        std::memset(data[i] + f::impulse, 0, 7*sizeof(double));
    }

    data.load(any);
}


void Foam::dew::liggghtsEmbedded::run(long nSteps)
{
    trapsOff guard;

    try
    {
        // The forces are those of the last sub-step or of setup()
        lmp_->update->integrate->run(int(nSteps));
    }
    catch (const notFinite& e)
    {
        std::ostringstream os;
        os.precision(9);
        os  << "Particle " << e.id << " is not finite at time "
            << e.step*lmp_->update->dt*units_.time << " s, position ("
            << e.x[0]*units_.length << ' ' << e.x[1]*units_.length << ' '
            << e.x[2]*units_.length << ") m. Look for a sub-step, a force or a"
            " velocity that is too large";
        throw std::runtime_error(os.str());
    }

    if (outsideBox())
    {
        // Let them go now, not when the engine next rebuilds its lists: they
        // would not be found again when a restart is read
        integrator().keepForces();
        setup();
    }
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

    getColumn(data, n, s.impulse, f::impulse, 3, u.force()*u.time);
    getColumn(data, n, s.angularImpulse, f::angularImpulse, 3, u.torque()*u.time);
    getColumn(data, n, s.heat, f::heat, 1, u.power()*u.time);
}


std::vector<Foam::dew::departedParticle>
Foam::dew::liggghtsEmbedded::departed()
{
    std::vector<departedParticle> result(integrator().departed());

    for (departedParticle& p : result)
    {
        p.mass *= units_.mass;
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


long Foam::dew::liggghtsEmbedded::total() const
{
    long n = lmp_->atom->nlocal, all = 0;
    MPI_Allreduce(&n, &all, 1, MPI_LONG, MPI_SUM, world_);
    return all;
}


void Foam::dew::liggghtsEmbedded::writeRestart(const std::string& file)
{
    trapsOff guard;

    integrator().keepForces();
    lmp_->atom->natoms = total();

    // Contact histories from the neighbour lists to their particles
    lmp_->modify->setup_pre_exchange();

    std::vector<char> name(file.begin(), file.end());
    name.push_back('\0');
    WriteRestart(lmp_).write(name.data());
}


// * * * * * * * * * * * * * * * * Entry points  * * * * * * * * * * * * * * //

int dewLiggghtsBindingVersion()
{
    return Foam::dew::liggghtsBindingVersion;
}


Foam::dew::liggghtsBinding* dewLiggghtsNew
(
    const Foam::dew::liggghtsOptions* options,
    const char** error
)
{
    static std::string message;

    try
    {
        return new Foam::dew::liggghtsEmbedded(*options);
    }
    catch (const std::exception& e)
    {
        message = e.what();
        *error = message.c_str();
        return nullptr;
    }
}
